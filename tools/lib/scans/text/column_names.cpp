// SPDX-License-Identifier: BSD-3-Clause
#include "column_names.h"

#include "plain_text.h"
#include "tool_error.h"

#include "bytes/text_lines.h"

#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <cctype>
#include <map>

namespace pcl::sedr::tools {

namespace {

const std::string name_blanks = " \t\r";

/** @brief Replaces units in brackets, quotes and marks of comments by blanks. */
std::string
withoutUnits(std::string_view line)
{
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
  return text;
}

/** @brief Splits a text at any of the separators; what is empty is left out, and blanks
 * within a name become underscores. */
std::vector<std::string>
split(const std::string& text, const std::string& separators)
{
  std::vector<std::string> names;
  boost::split(names, text, boost::is_any_of(separators));
  for (std::string& name : names) {
    boost::trim(name);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ' ' || c == '\t'; }, '_');
  }
  names.erase(std::remove(names.begin(), names.end(), ""), names.end());
  return names;
}

/** @brief Returns PCL's field for a name that other programs write; empty if the name
 * is unknown. */
std::string
fieldOf(const std::string& name)
{
  static const std::map<std::string, std::string> known = [] {
    std::map<std::string, std::string> all;
    const auto add = [&](const std::string& field, const std::string& names) {
      for (const std::string_view name : wordsOf(names))
        all[std::string(name)] = field;
    };
    add("x", "e east easting rechtswert points:0");
    add("y", "n north northing hochwert points:1");
    add("z", "h height elev elevation alt altitude h\xc3\xb6he hoehe points:2");
    add("red", "r red");
    add("green", "g green");
    add("blue", "b blue");
    add("intensity", "i int reflectance intensity");
    add("normal_x", "nx");
    add("normal_y", "ny");
    add("normal_z", "nz");
    // Angles are no coordinates in metres, but show that a line holds names.
    for (const std::string_view angle : wordsOf("lat latitude lon long longitude"))
      all[std::string(angle)] = angle;
    for (const char* axis : {"x", "y", "z"})
      for (const std::string form :
           {"", "_coord", "coord", "_coordinate", "-coordinate"})
        all[axis + form] = axis;
    return all;
  }();
  const auto it = known.find(name);
  return it == known.end() ? std::string() : it->second;
}

bool
isComment(std::string_view line)
{
  const std::size_t first = line.find_first_not_of(name_blanks);
  return first != line.npos && (line[first] == '#' || line[first] == '/');
}

/** @brief Returns whether a comment is a line of names rather than a sentence. */
bool
isLikeNames(std::string_view comment, std::size_t columns)
{
  const std::vector<std::string> names = columnNames(comment);
  const std::vector<std::string> words = split(withoutUnits(comment), " \t\r,;");
  return names.size() == columns &&
         (comment.find_first_of(",;\t") != comment.npos ||
          std::any_of(words.begin(), words.end(),
                      [](const std::string& word) { return !fieldOf(word).empty(); }));
}

} // namespace

std::vector<std::string>
columnNames(std::string_view line)
{
  const std::string separators = ",;\t";
  const std::string text = withoutUnits(line);
  const bool has_separators = text.find_first_of(separators) != text.npos;
  std::vector<std::string> names =
      split(text, has_separators ? separators : name_blanks);
  for (std::string& name : names) {
    const std::string field = fieldOf(name);
    if (!field.empty() && std::find(names.begin(), names.end(), field) == names.end())
      name = field;
  }
  return names;
}

bool
namesCoordinates(const std::vector<std::string>& names)
{
  return std::all_of(std::begin("xyz"), std::end("xyz") - 1, [&](char axis) {
    return std::count(names.begin(), names.end(), std::string(1, axis)) == 1;
  });
}

std::vector<std::string>
namesBefore(const std::vector<std::string>& lines,
            std::size_t columns,
            const std::string& path)
{
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    std::vector<std::string> names = columnNames(*line);
    names.resize(std::min(names.size(), columns));
    if (namesCoordinates(names))
      return names;
  }
  for (const std::string& line : lines)
    if (!isComment(line) || isLikeNames(line, columns))
      throw ToolError("the line " + quotedWord(line) + " before the numbers of '" +
                      path + "' does not name x, y and z of its " +
                      std::to_string(columns) +
                      " columns: --columns names them, such as --columns x,y,z");
  return {};
}

} // namespace pcl::sedr::tools
