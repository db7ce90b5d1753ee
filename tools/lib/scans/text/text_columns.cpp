// SPDX-License-Identifier: BSD-3-Clause
#include "text_reader.h"

#include "tool_error.h"

#include "bytes/input_file.h"
#include "formats/scan_formats.h"

#include <boost/algorithm/string.hpp>

#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>

namespace pcl::sedr::tools {

namespace {

constexpr std::size_t max_columns = 64;
constexpr std::size_t max_lines_before = 20; // that are neither empty nor comments
using Numbers = std::array<double, max_columns>;
using Names = std::vector<std::string>;

bool
isBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

/** @brief Moves behind what separates two columns: blanks with one comma or semicolon
 * at most, or one tab. Empty cells are missing numbers. */
bool
passesSeparator(const char*& c, const char* end)
{
  int marks = 0;
  int tabs = 0;
  const char* const begin = c;
  for (; c != end && (isBlank(*c) || *c == ';' || *c == ','); ++c)
    isBlank(*c) ? tabs += *c == '\t' ? 1 : 0 : ++marks;
  return c != begin && c != end && (marks == 1 || (marks == 0 && tabs <= 1));
}

/** @brief Reads a cell, and moves behind it if it is a number. */
bool
readCell(const char*& c, const char* end, double& number)
{
  const char* const begin = c != end && *c == '+' ? c + 1 : c;
  const auto result = readNumber(begin, end, number);
  const bool is_end = result.ptr == end || isBlank(*result.ptr) || *result.ptr == ',' ||
                      *result.ptr == ';';
  if (result.ec != std::errc() || !is_end)
    return false;
  c = result.ptr;
  return true;
}

/** @brief Returns the names of columns in a line such as "//X [m],Y [m],Z [m],R,G,B",
 * or an option's value: in lower case, without units, quotes and marks of comments, and
 * those that other programs use as PCL's fields, such as easting as x. */
Names
columnNames(std::string_view line)
{
  static const std::map<std::string, std::string> known{
      {"x", " e east easting rechtswert ostwert "},
      {"y", " n north northing hochwert nordwert "},
      {"z", " h height elev elevation höhe hoehe "},
      {"red", " r rot "},
      {"green", " g grün gruen "},
      {"blue", " b blau "},
      {"intensity", " i reflectance intensität intensitaet "},
      {"normal_x", " nx "},
      {"normal_y", " ny "},
      {"normal_z", " nz "}};
  std::string text;
  int depth = 0;
  for (const char c : line) {
    depth += c == '[' || c == '(' ? 1 : 0;
    const bool is_left_out = depth > 0 || c == '"' || c == '\'' || c == '#' || c == '/';
    text += is_left_out
                ? ' '
                : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    depth -= (c == ']' || c == ')') && depth > 0 ? 1 : 0;
  }
  const bool has_marks = text.find_first_of(",;\t") != text.npos;
  Names names;
  boost::split(names, text, boost::is_any_of(has_marks ? ",;\t" : " \t\r"));
  for (std::string& name : names) {
    boost::trim(name);
    boost::replace_all(name, " ", "_");
  }
  names.erase(std::remove(names.begin(), names.end(), ""), names.end());
  for (std::string& name : names)
    for (const auto& [field, words] : known)
      if (words.find(" " + name + " ") != words.npos &&
          std::find(names.begin(), names.end(), field) == names.end()) {
        name = field;
        break;
      }
  return names;
}

/** @brief Returns whether each of x, y and z is there once. */
bool
namesCoordinates(const Names& names)
{
  return std::all_of(std::begin("xyz"), std::end("xyz") - 1, [&](char axis) {
    return std::count(names.begin(), names.end(), std::string(1, axis)) == 1;
  });
}

/** @brief Returns whether commas are decimal marks in a line: semicolons, tabs or
 * blanks part it into three cells or more, with one comma at most, within digits. */
bool
hasDecimalCommas(std::string_view line)
{
  std::vector<std::string> cells;
  boost::split(cells, boost::trim_copy(std::string(line)), boost::is_any_of("; \t\r"),
               boost::token_compress_on);
  const auto isWithinDigits = [](const std::string& cell) {
    const std::size_t comma = cell.find_first_of(",.");
    return comma == cell.npos ||
           (cell[comma] == ',' && comma > 0 && comma + 1 < cell.size() &&
            cell.find_first_of(",.", comma + 1) == cell.npos);
  };
  return cells.size() >= 3 && line.find(',') != line.npos &&
         std::all_of(cells.begin(), cells.end(), isWithinDigits);
}

/** @brief The first line with at least three numbers. */
struct FirstLine {
  std::size_t begin = 0; ///< bytes
  std::string text;      ///< with decimal points
  bool has_decimal_commas = false;
  Names before; ///< the last lines before that are neither empty nor a count
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
      first.text = line;
      first.has_decimal_commas = hasDecimalCommas(line);
      if (first.has_decimal_commas)
        std::replace(first.text.begin(), first.text.end(), ',', '.');
      if (readColumns(first.text, max_columns, numbers.data()) >= 3)
        return first;
    }
    if (wordsOf(line).empty() || isCount(line))
      continue;
    if (first.before.size() == max_lines_before)
      first.before.erase(first.before.begin());
    first.before.emplace_back(line);
  }
  return std::nullopt;
}

/** @brief Returns the names that the lines before the numbers give to `columns`
 * columns; else x, y, z and what stands in so many columns usually. Throws ToolError if
 * a line can only be names, but not of x, y and z. */
Names
namesOf(const FirstLine& first,
        const Numbers& numbers,
        std::size_t columns,
        const std::string& path)
{
  for (auto line = first.before.rbegin(); line != first.before.rend(); ++line) {
    Names names = columnNames(*line);
    const bool are_all = names.size() == columns;
    names.resize(std::min(names.size(), columns));
    if (namesCoordinates(names))
      return names;
    const bool is_comment = !mayHoldNumbers(*line);
    if (!is_comment || (are_all && line->find_first_of(",;\t") != line->npos))
      throw ToolError("the line " + quotedWord(*line) + " before the numbers of '" +
                      path + "' does not name x, y and z of its " +
                      std::to_string(columns) +
                      " columns: --columns names them, such as --columns x,y,z");
  }
  constexpr std::size_t with_intensity = 4, with_colour = 6, with_both = 7;
  Names names{"x", "y", "z"};
  if (columns == with_intensity || columns == with_both)
    names.emplace_back("intensity");
  const auto isByte = [](double v) { return v >= 0 && v <= 255 && v == std::floor(v); };
  if ((columns == with_colour || columns == with_both) &&
      std::all_of(numbers.begin() + columns - 3, numbers.begin() + columns, isByte))
    names.insert(names.end(), {"red", "green", "blue"});
  return names;
}

/** @brief Lays the row of these columns: x, y, z, then the others, at last colours. */
void
layRow(const Names& names, TextColumns& columns)
{
  const auto columnOf = [&](const char* name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                    names.begin());
  };
  const std::array<const char*, 3> colours{"red", "green", "blue"};
  columns.row.joins_colours =
      std::all_of(colours.begin(), colours.end(),
                  [&](const char* name) { return columnOf(name) < names.size(); });
  std::vector<std::size_t> taken;
  const auto take = [&](const std::array<const char*, 3>& three, std::uint8_t type) {
    for (const char* name : three) {
      columns.row.add(name, type);
      columns.columns.push_back(columnOf(name));
    }
  };
  take({"x", "y", "z"}, pcl::PCLPointField::FLOAT64);
  for (std::size_t c = 0; c < names.size(); ++c) {
    const bool is_colour =
        std::find(colours.begin(), colours.end(), names[c]) != colours.end();
    if (names[c] == "_" || names[c] == "x" || names[c] == "y" || names[c] == "z" ||
        (is_colour && columns.row.joins_colours))
      continue;
    columns.row.add(names[c], pcl::PCLPointField::FLOAT32);
    columns.columns.push_back(c);
  }
  if (columns.row.joins_colours)
    take(colours, pcl::PCLPointField::UINT8);
}

} // namespace

bool
mayHoldNumbers(std::string_view line)
{
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first != line.npos && line[first] != '#' && line[first] != '/';
}

bool
isCount(std::string_view line)
{
  const std::size_t digits = line.find_first_not_of(" \t\r0123456789");
  return digits == line.npos && wordsOf(line).size() == 1;
}

std::size_t
readColumns(std::string_view line, std::size_t most, double* numbers, bool* is_all)
{
  const char* c = line.data();
  const char* const end = c + line.size();
  c = std::find_if_not(c, end, isBlank);
  std::size_t read = 0;
  while (read < most && readCell(c, end, numbers[read])) {
    ++read;
    if (!passesSeparator(c, end))
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
  const FirstLine first = findFirstLine(file).value_or(FirstLine());
  TextColumns columns;
  columns.begin = first.begin;
  columns.has_decimal_commas = first.has_decimal_commas;
  Numbers numbers{};
  const std::size_t n =
      readColumns(first.text, max_columns, numbers.data(), &columns.is_exact);
  const Names names =
      asked.empty() ? namesOf(first, numbers, n, file.path()) : columnNames(asked);
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
