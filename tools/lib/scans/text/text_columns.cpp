// SPDX-License-Identifier: BSD-3-Clause
#include "text_columns.h"

#include "cloud_readers.h"
#include "column_names.h"
#include "plain_text.h"
#include "tool_error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace pcl::sedr::tools {

namespace {

constexpr std::size_t max_columns = 64;
constexpr std::size_t max_lines_before = 20; // that are neither empty nor comments
using Numbers = std::array<double, max_columns>;

bool
partsColumns(char c, bool has_decimal_comma)
{
  return c == ' ' || c == '\t' || c == '\r' || c == ';' || c == '"' ||
         (c == ',' && !has_decimal_comma);
}

/** @brief Returns whether a word is a number such as 12,5. */
bool
isCommaNumber(std::string_view word)
{
  const std::size_t comma = word.find(',');
  const auto isDigit = [&](std::size_t at) {
    return std::isdigit(static_cast<unsigned char>(word[at])) != 0;
  };
  return comma != word.npos && comma > 0 && comma + 1 < word.size() &&
         isDigit(comma - 1) && isDigit(comma + 1) &&
         word.find_first_of(",.", comma + 1) == word.npos;
}

/** @brief Returns whether a line uses decimal commas: its columns are separated by
 * semicolons, or by blanks with commas inside of the first three words only, or the
 * first number in quotes has one. */
bool
hasDecimalComma(std::string_view line)
{
  const std::size_t quote = line.find('"');
  if (quote != line.npos &&
      isCommaNumber(line.substr(quote + 1, line.find('"', quote + 1) - quote - 1)))
    return true;
  if (line.find(';') != line.npos)
    return line.find(',') != line.npos;
  const std::vector<std::string_view> words = wordsOf(line);
  return words.size() >= 3 &&
         std::any_of(words.begin(), words.begin() + 3, isCommaNumber) &&
         std::all_of(words.begin(), words.begin() + 3, [](std::string_view word) {
           return word.find(',') == word.npos || isCommaNumber(word);
         });
}

/** @brief Returns whether any of the first lines from a byte on uses decimal commas. A
 * whole number has none. */
bool
linesHaveDecimalComma(const MappedFile& file, std::size_t begin)
{
  constexpr int looked_at = 100;
  TextCursor cursor(file, begin);
  std::string_view line;
  for (int k = 0; k < looked_at && cursor.nextLine(line); ++k)
    if (mayHoldNumbers(line) && hasDecimalComma(line))
      return true;
  return false;
}

/** @brief Returns the bytes of the mark that some programs write before UTF-8. */
std::size_t
sizeOfMark(const MappedFile& file)
{
  TextCursor cursor(file, 0);
  std::string_view line;
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return cursor.nextLine(line) && line.substr(0, mark.size()) == mark ? mark.size() : 0;
}

/** @brief Returns whether a text is PTX: columns and rows, scanner position and axes,
 * pose matrix, then the points. Further scans follow in the same form. */
bool
isPtx(const MappedFile& file)
{
  constexpr std::array<std::size_t, 10> head{1, 1, 3, 3, 3, 3, 4, 4, 4, 4};
  TextCursor cursor(file, 0);
  std::string_view line;
  return std::all_of(head.begin(), head.end(), [&](std::size_t expected) {
    Numbers numbers{};
    return cursor.nextLine(line) &&
           readColumns(line, false, max_columns, numbers.data()) == expected;
  });
}

/** @brief The first line with at least three numbers. */
struct FirstLine {
  std::size_t begin = 0; ///< bytes
  std::string_view text;
  std::vector<double> numbers;
  std::vector<std::string_view> before; ///< the last lines before, but empty ones
};

FirstLine
findFirstLine(const MappedFile& file)
{
  FirstLine first;
  TextCursor cursor(file, sizeOfMark(file));
  for (std::size_t others = 0; others < max_lines_before;) {
    first.begin = cursor.position();
    if (!cursor.nextLine(first.text))
      break;
    constexpr std::size_t longest = 1 << 14;
    if (first.text.size() > longest || first.text.find('\0') != first.text.npos)
      break;
    const bool may_hold_numbers = mayHoldNumbers(first.text);
    others += may_hold_numbers ? 1 : 0;
    Numbers numbers{};
    const std::size_t n = may_hold_numbers
                              ? readColumns(first.text, hasDecimalComma(first.text),
                                            max_columns, numbers.data())
                              : 0;
    first.numbers.assign(numbers.begin(),
                         numbers.begin() + static_cast<std::ptrdiff_t>(n));
    if (n >= 3)
      return first;
    if (first.text.find_first_not_of(" \t") == first.text.npos)
      continue;
    if (first.before.size() == max_lines_before)
      first.before.erase(first.before.begin());
    first.before.push_back(first.text);
  }
  return {};
}

std::vector<std::string>
usualNames(const std::vector<double>& numbers)
{
  std::vector<std::string> names{"x", "y", "z"};
  constexpr std::size_t with_intensity = 4, with_colour = 6, with_both = 7;
  const std::size_t n = numbers.size();
  if (n == with_intensity || n == with_both)
    names.emplace_back("intensity");
  const auto isByte = [](double v) { return v >= 0 && v <= 255 && v == std::floor(v); };
  if ((n == with_colour || n == with_both) &&
      std::all_of(numbers.end() - 3, numbers.end(), isByte))
    names.insert(names.end(), {"red", "green", "blue"});
  return names;
}

/** @brief Takes the number of points, if a line before them is one, as in PTS. */
void
takeCount(std::vector<std::string_view>& before, TextColumns& columns)
{
  const auto line = std::find_if(before.rbegin(), before.rend(), [&](auto text) {
    return readCount(text, columns.promised);
  });
  if (line == before.rend())
    return;
  columns.has_counts = true;
  before.erase(std::next(line).base());
}

} // namespace

bool
readCount(std::string_view line, std::uint64_t& count)
{
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == line.npos)
    return false;
  line = line.substr(first, line.find_last_not_of(" \t") + 1 - first);
  std::uint64_t number = 0;
  const auto result = std::from_chars(line.data(), line.data() + line.size(), number);
  if (result.ec != std::errc() || result.ptr != line.data() + line.size())
    return false;
  count = number;
  return true;
}

bool
mayHoldNumbers(std::string_view line)
{
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first != line.npos && line[first] != '#' && line[first] != '/';
}

std::size_t
readColumns(std::string_view line,
            bool has_decimal_comma,
            std::size_t most,
            double* numbers)
{
  const char* c = line.data();
  const char* const end = c + line.size();
  std::size_t read = 0;
  for (; read < most; ++read) {
    while (c != end && partsColumns(*c, has_decimal_comma))
      ++c;
    if (c != end && *c == '+')
      ++c;
    const char* const begin = c;
    while (c != end && !partsColumns(*c, has_decimal_comma))
      ++c;
    std::from_chars_result result{};
    if (has_decimal_comma) {
      std::string number(begin, c);
      std::replace(number.begin(), number.end(), ',', '.');
      result =
          std::from_chars(number.data(), number.data() + number.size(), numbers[read]);
      result.ptr = begin + (result.ptr - number.data());
    }
    else
      result = std::from_chars(begin, c, numbers[read]);
    if (begin == c || result.ec != std::errc() || result.ptr != c)
      return read;
  }
  return read;
}

bool
looksLikeColumns(const MappedFile& file)
{
  return findFirstLine(file).numbers.size() >= 3;
}

TextColumns
findColumns(const MappedFile& file, const std::string& path, const std::string& asked)
{
  if (isPtx(file))
    throw ToolError("'" + path +
                    "' is PTX, whose points are not in one frame, and which is not "
                    "read here: export E57, which keeps the positions of the scanner "
                    "too");
  FirstLine first = findFirstLine(file);
  TextColumns columns;
  columns.begin = first.begin;
  columns.has_decimal_comma = linesHaveDecimalComma(file, first.begin);
  Numbers numbers{};
  const std::size_t n =
      readColumns(first.text, columns.has_decimal_comma, max_columns, numbers.data());
  first.numbers.assign(numbers.begin(),
                       numbers.begin() + static_cast<std::ptrdiff_t>(n));
  takeCount(first.before, columns);
  columns.names =
      asked.empty() ? namesBefore(first.before, n, path) : columnNames(asked);
  if (asked.empty() && columns.names.empty())
    columns.names = usualNames(first.numbers);
  if (!namesCoordinates(columns.names))
    throw ToolError("the columns " + quotedWord(asked) +
                    " do not hold each of x, y and z once");
  if (columns.names.size() > first.numbers.size())
    throw ToolError("the first line of numbers of '" + path + "' has " +
                    std::to_string(first.numbers.size()) + " of the " +
                    std::to_string(columns.names.size()) +
                    " columns that are asked for");
  return columns;
}

} // namespace pcl::sedr::tools
