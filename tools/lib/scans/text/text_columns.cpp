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
isBlankInLine(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

/** @brief Moves behind what separates two columns: blanks with one comma or semicolon
 * at most, or one tab. Empty cells are missing numbers. */
bool
passesSeparator(const char*& c, const char* end, bool has_decimal_comma)
{
  int marks = 0;
  int tabs = 0;
  const char* const begin = c;
  for (; c != end; ++c)
    if (*c == ';' || (*c == ',' && !has_decimal_comma))
      ++marks;
    else if (isBlankInLine(*c))
      tabs += *c == '\t' ? 1 : 0;
    else
      break;
  return c != begin && c != end && (marks == 1 || (marks == 0 && tabs <= 1));
}

/** @brief Reads a cell, which may be in quotes, and moves behind it if it is a number.
 * @return whether it is a number as a whole */
bool
readCell(const char*& c, const char* end, bool has_decimal_comma, double& number)
{
  const bool is_quoted = c != end && *c == '"';
  const char* const begin = is_quoted ? c + 1 : c;
  const char* const cell_end = std::find_if(begin, end, [&](char sign) {
    return is_quoted ? sign == '"'
                     : isBlankInLine(sign) || sign == ';' ||
                           (sign == ',' && !has_decimal_comma);
  });
  if (is_quoted && cell_end == end)
    return false;
  std::string_view text(begin, static_cast<std::size_t>(cell_end - begin));
  if (!text.empty() && text.front() == '+')
    text.remove_prefix(1);
  std::string with_point;
  if (has_decimal_comma) {
    with_point = text;
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    text = with_point;
  }
  const auto result = readNumber(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size())
    return false;
  c = cell_end + (is_quoted ? 1 : 0);
  return true;
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
            double* numbers,
            bool* is_all)
{
  const char* c = line.data();
  const char* const end = c + line.size();
  c = std::find_if_not(c, end, isBlankInLine);
  std::size_t read = 0;
  while (read < most && readCell(c, end, has_decimal_comma, numbers[read])) {
    ++read;
    if (!passesSeparator(c, end, has_decimal_comma))
      break;
  }
  if (is_all)
    *is_all =
        c == end && line.find_last_not_of(" \t\r,;") == line.find_last_not_of(" \t\r");
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
  const std::size_t n = readColumns(first.text, columns.has_decimal_comma, max_columns,
                                    numbers.data(), &columns.is_nothing_else);
  columns.numbers = n;
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
