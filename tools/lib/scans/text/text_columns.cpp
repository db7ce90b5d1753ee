// SPDX-License-Identifier: BSD-3-Clause
#include "text_columns.h"

#include "column_names.h"
#include "plain_text.h"
#include "tool_error.h"

#include "bytes/text_lines.h"
#include "formats/scan_formats.h"

#include <array>
#include <cctype>
#include <cmath>
#include <numeric>

namespace pcl::sedr::tools {

namespace {

constexpr std::size_t max_columns = 64;
constexpr std::size_t max_lines_before = 20; // that are neither empty nor comments
using Numbers = std::array<double, max_columns>;

bool
isBlank(char c)
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
    else if (isBlank(*c))
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
    return is_quoted
               ? sign == '"'
               : isBlank(sign) || sign == ';' || (sign == ',' && !has_decimal_comma);
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
 * first number in quotes has one. A line of whole numbers has none. */
bool
hasDecimalComma(std::string_view line)
{
  const std::size_t quote = line.find('"');
  if (quote != line.npos &&
      isCommaNumber(line.substr(quote + 1, line.find('"', quote + 1) - quote - 1)))
    return true;
  if (line.find(';') != line.npos)
    return line.find(',') != line.npos;
  std::vector<std::string_view> words = wordsOf(line);
  if (words.size() < 3)
    return false;
  words.resize(3);
  return std::any_of(words.begin(), words.end(), isCommaNumber) &&
         std::all_of(words.begin(), words.end(), [](std::string_view word) {
           return word.find(',') == word.npos || isCommaNumber(word);
         });
}

bool
linesHaveDecimalComma(const InputFile& file, std::size_t begin)
{
  constexpr int looked_at = 100;
  LineReader lines(file, begin);
  std::string_view line;
  for (int k = 0; k < looked_at && lines.next(line); ++k)
    if (mayHoldNumbers(line) && hasDecimalComma(line))
      return true;
  return false;
}

/** @brief Returns whether a text is PTX: columns and rows, scanner position and axes,
 * pose matrix, then the points. Further scans follow in the same form. */
bool
isPtx(const InputFile& file)
{
  constexpr std::array<std::size_t, 10> head{1, 1, 3, 3, 3, 3, 4, 4, 4, 4};
  LineReader lines(file);
  std::string_view line;
  Numbers numbers{};
  return std::all_of(head.begin(), head.end(), [&](std::size_t expected) {
    return lines.next(line) &&
           readColumns(line, false, max_columns, numbers.data()) == expected;
  });
}

/** @brief The first line with at least three numbers. */
struct FirstLine {
  std::size_t begin = 0; ///< bytes
  std::string text;
  std::vector<std::string> before; ///< the last lines before, but empty ones
};

std::optional<FirstLine>
findFirstLine(const InputFile& file)
{
  constexpr std::string_view mark = "\xEF\xBB\xBF"; // some programs begin UTF-8 with it
  constexpr std::size_t longest = 1 << 14;
  FirstLine first;
  LineReader lines(file, file.beginsWith(mark) ? mark.size() : 0);
  std::string_view line;
  Numbers numbers{};
  for (std::size_t others = 0; others < max_lines_before;) {
    first.begin = lines.position();
    if (!lines.next(line) || line.size() > longest || line.find('\0') != line.npos)
      return std::nullopt;
    if (mayHoldNumbers(line)) {
      ++others;
      if (readColumns(line, hasDecimalComma(line), max_columns, numbers.data()) >= 3) {
        first.text = line;
        return first;
      }
    }
    if (wordsOf(line).empty())
      continue;
    if (first.before.size() == max_lines_before)
      first.before.erase(first.before.begin());
    first.before.emplace_back(line);
  }
  return std::nullopt;
}

std::vector<std::string>
usualNames(const Numbers& numbers, std::size_t n)
{
  constexpr std::size_t with_intensity = 4, with_colour = 6, with_both = 7;
  std::vector<std::string> names{"x", "y", "z"};
  if (n == with_intensity || n == with_both)
    names.emplace_back("intensity");
  const auto isByte = [](double v) { return v >= 0 && v <= 255 && v == std::floor(v); };
  if ((n == with_colour || n == with_both) &&
      std::all_of(numbers.begin() + n - 3, numbers.begin() + n, isByte))
    names.insert(names.end(), {"red", "green", "blue"});
  return names;
}

/** @brief Takes the number of points, if a line before them is one, as in PTS. */
void
takeCount(std::vector<std::string>& before, TextColumns& columns)
{
  const auto line =
      std::find_if(before.rbegin(), before.rend(), [&](const std::string& text) {
        return readCount(text, columns.promised);
      });
  if (line == before.rend())
    return;
  columns.has_counts = true;
  before.erase(std::next(line).base());
}

/** @brief Lays the row of these columns: x, y, z, then the others, at last colours. */
void
layRow(const std::vector<std::string>& names, TextColumns& columns)
{
  const auto add = [&](const std::string& name, std::uint8_t type, std::size_t column) {
    columns.row.add(name, type);
    columns.columns.push_back(column);
  };
  const auto columnOf = [&](const char* name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                    names.begin());
  };
  std::vector<std::size_t> taken;
  for (const char* axis : {"x", "y", "z"}) {
    taken.push_back(columnOf(axis));
    add(axis, pcl::PCLPointField::FLOAT64, taken.back());
  }
  std::vector<std::size_t> colour;
  for (const char* name : {"red", "green", "blue"})
    if (columnOf(name) < names.size())
      colour.push_back(columnOf(name));
  columns.row.joins_colours = colour.size() == 3;
  if (columns.row.joins_colours)
    taken.insert(taken.end(), colour.begin(), colour.end());
  for (std::size_t c = 0; c < names.size(); ++c)
    if (names[c] != "_" && std::find(taken.begin(), taken.end(), c) == taken.end())
      add(names[c], pcl::PCLPointField::FLOAT32, c);
  for (std::size_t k = 0; columns.row.joins_colours && k < colour.size(); ++k)
    add(names[colour[k]], pcl::PCLPointField::UINT8, colour[k]);
}

} // namespace

bool
readCount(std::string_view line, std::uint64_t& count)
{
  const auto words = wordsOf(line);
  std::uint64_t number = 0;
  if (words.size() != 1 || !isNumber(words.front(), number))
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
  c = std::find_if_not(c, end, isBlank);
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
looksLikeColumns(const InputFile& file)
{
  return findFirstLine(file).has_value();
}

TextColumns
TextColumns::ofHeader(const std::string& format,
                      const StoredRow& row,
                      std::size_t begin,
                      std::uint64_t points,
                      bool are_last)
{
  TextColumns columns;
  columns.format = format;
  columns.begin = begin;
  columns.row.joins_colours = row.joins_colours;
  for (const StoredField& field : row.fields) {
    // Doubles, so that an origin is subtracted before a float rounds.
    std::uint8_t type = field.datatype;
    if ((field.name == "x" || field.name == "y" || field.name == "z") &&
        type == pcl::PCLPointField::FLOAT32)
      type = pcl::PCLPointField::FLOAT64;
    columns.row.add(field.name, type, field.count);
    columns.numbers += field.count;
  }
  columns.columns.resize(columns.numbers);
  std::iota(columns.columns.begin(), columns.columns.end(), std::size_t{0});
  columns.is_exact = true;
  columns.points = points;
  columns.are_last = are_last;
  return columns;
}

TextColumns
TextColumns::find(const InputFile& file, const std::string& asked)
{
  if (isPtx(file))
    throw ToolError("'" + file.path() +
                    "' is PTX, whose points are not in one frame, and which is not "
                    "read here: export E57, which keeps the positions of the scanner "
                    "too");
  FirstLine first = findFirstLine(file).value_or(FirstLine());
  TextColumns columns;
  columns.begin = first.begin;
  columns.has_decimal_comma = linesHaveDecimalComma(file, first.begin);
  Numbers numbers{};
  const std::size_t n = readColumns(first.text, columns.has_decimal_comma, max_columns,
                                    numbers.data(), &columns.is_exact);
  takeCount(first.before, columns);
  std::vector<std::string> names =
      asked.empty() ? namesBefore(first.before, n, file.path()) : columnNames(asked);
  if (names.empty())
    names = usualNames(numbers, n);
  if (!namesCoordinates(names))
    throw ToolError("the columns " + quotedWord(asked) +
                    " do not hold each of x, y and z once");
  if (names.size() > n)
    throw ToolError("the first line of numbers of '" + file.path() + "' has " +
                    std::to_string(n) + " of the " + std::to_string(names.size()) +
                    " columns that are asked for");
  columns.numbers = columns.is_exact ? n : names.size();
  layRow(names, columns);
  return columns;
}

} // namespace pcl::sedr::tools
