// SPDX-License-Identifier: BSD-3-Clause
#include "e57_reader.h"

#include "tool_error.h"

#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace pcl::sedr::tools {

namespace {

using Tree = boost::property_tree::ptree;

/** @brief Returns the byte behind a tag, comment or the like that begins at `at`, also
 * if its quotes hold brackets; the size of the text if it has no end. */
std::size_t
endOfTag(const std::string& xml, std::size_t at)
{
  for (const auto& [begin, end] :
       {std::pair("<!--", "-->"), {"<![CDATA[", "]]>"}, {"<?", "?>"}})
    if (xml.compare(at, std::strlen(begin), begin) == 0)
      return std::min(xml.find(end, at), xml.size() - 1) + 1;
  for (char quote = 0; at < xml.size(); ++at)
    if (quote != 0)
      quote = xml[at] == quote ? char{0} : quote;
    else if (xml[at] == '"' || xml[at] == '\'')
      quote = xml[at];
    else if (xml[at] == '>')
      return at + 1;
  return at;
}

/** @brief Refuses XML that would take the parser too deep, or too much memory. */
void
checkXml(const std::string& xml)
{
  constexpr std::size_t deepest = 64;
  constexpr std::size_t most = std::size_t{1} << 18; // each may take 400 bytes
  std::size_t depth = 0;
  std::size_t elements = 0;
  std::size_t end = 0;
  for (std::size_t at = xml.find('<'); at != xml.npos; at = xml.find('<', end)) {
    end = endOfTag(xml, at);
    const std::string kind = xml.substr(at + 1, 2);
    if (kind == "!D" || kind == "!d")
      throw ToolError("its XML defines a document type, which E57 does not have");
    if (kind[0] == '/')
      depth -= depth > 0 ? 1 : 0;
    else if (kind[0] != '!' && kind[0] != '?' && ++elements > 0 && end >= 2 &&
             xml[end - 2] != '/')
      ++depth;
    if (depth > deepest)
      throw ToolError("the elements of its XML are nested deeper than " +
                      std::to_string(deepest));
  }
  if (elements + static_cast<std::size_t>(std::count(xml.begin(), xml.end(), '=')) >
      most)
    throw ToolError("its XML has more than " + std::to_string(most) +
                    " elements and attributes");
}

/** @brief Parses the XML of a file; attributes are below "<xmlattr>". */
Tree
readTree(const E57Pages& pages)
{
  namespace xml_parser = boost::property_tree::xml_parser;
  constexpr std::uint64_t largest = std::uint64_t{1} << 26;
  if (pages.xmlSize() > largest)
    throw ToolError("its XML is said to have " + std::to_string(pages.xmlSize()) +
                    " bytes, more than the " + std::to_string(largest) +
                    " that are taken for sane");
  std::string xml(static_cast<std::size_t>(pages.xmlSize()), '\0');
  pages.read(pages.xmlBegin(), xml.size(), xml.data());
  // Some writers include the padding of the last page.
  xml.erase(xml.find_last_not_of(std::string("\0 \t\r\n", 5)) + 1);
  checkXml(xml);
  std::istringstream stream(xml);
  Tree tree;
  try {
    xml_parser::read_xml(stream, tree,
                         xml_parser::no_comments | xml_parser::trim_whitespace);
  }
  catch (const xml_parser::xml_parser_error& error) {
    throw ToolError("line " + std::to_string(error.line()) +
                    " of its XML cannot be read: " + error.message());
  }
  return tree;
}

/** @brief Returns the number at a path below `node`; what E57 omits is `otherwise`.
 * Throws boost::property_tree::ptree_bad_data for anything but a number. */
template <typename T>
T
numberAt(const Tree& node, const std::string& path, T otherwise)
{
  const auto child = node.get_child_optional(path);
  return child && !child->data().empty() ? child->get_value<T>() : otherwise;
}

template <typename T>
T
attribute(const Tree& node, const std::string& name, T otherwise)
{
  return numberAt(node, "<xmlattr>." + name, otherwise);
}

std::string
typeOf(const Tree& node)
{
  return node.get<std::string>("<xmlattr>.type", "");
}

/** @brief Returns the number below `node`, a Float, Integer or ScaledInteger; 0 if
 * there is none. */
double
realAt(const Tree& node, const std::string& path)
{
  const auto child = node.get_child_optional(path);
  const double value = numberAt(node, path, 0.0);
  if (!child || typeOf(*child) != "ScaledInteger")
    return value;
  return value * attribute(*child, "scale", 1.0) + attribute(*child, "offset", 0.0);
}

void
readInteger(const Tree& node, bool is_scaled, E57Field& field)
{
  constexpr auto lowest = std::numeric_limits<std::int64_t>::min();
  constexpr auto highest = std::numeric_limits<std::int64_t>::max();
  field.kind = E57Field::Kind::Integer;
  field.minimum = attribute(node, "minimum", lowest);
  const auto maximum = attribute(node, "maximum", highest);
  if (field.minimum > maximum)
    throw ToolError("the least value of " + quotedWord(field.name) + " is " +
                    std::to_string(field.minimum) + ", above the greatest, " +
                    std::to_string(maximum));
  for (std::uint64_t range = static_cast<std::uint64_t>(maximum) -
                             static_cast<std::uint64_t>(field.minimum);
       range > 0; range >>= 1)
    ++field.bits;
  if (is_scaled) {
    field.scale = attribute(node, "scale", 1.0);
    field.offset = attribute(node, "offset", 0.0);
  }
  if (!(field.scale > 0) || !std::isfinite(field.scale) || !std::isfinite(field.offset))
    throw ToolError("the scale of " + quotedWord(field.name) + " is " +
                    std::to_string(field.scale) + " and its offset " +
                    std::to_string(field.offset) +
                    ", a scale above 0 and a finite offset are needed");
  if (node.get_child_optional("<xmlattr>.minimum") &&
      node.get_child_optional("<xmlattr>.maximum")) {
    field.low = static_cast<double>(field.minimum) * field.scale + field.offset;
    field.high = static_cast<double>(maximum) * field.scale + field.offset;
  }
}

void
readFloat(const Tree& node, E57Field& field)
{
  const auto precision = node.get<std::string>("<xmlattr>.precision", "double");
  if (precision != "single" && precision != "double")
    throw ToolError("the precision of " + quotedWord(field.name) + " is " +
                    quotedWord(precision) + ", neither single nor double");
  const bool is_single = precision == "single";
  field.kind = is_single ? E57Field::Kind::Float : E57Field::Kind::Double;
  field.bits = is_single ? 32 : 64;
  if (field.name.rfind("color", 0) != 0) // no other range is needed
    return;
  field.low = attribute(node, "minimum", 0.0);
  field.high = attribute(node, "maximum", 0.0);
}

/** @brief Appends the fields below a node of the prototype, which may be nested. */
void
addFields(const Tree& node, std::vector<E57Field>& fields)
{
  for (const auto& [name, child] : node) {
    if (name == "<xmlattr>" || name == "<xmltext>")
      continue;
    const std::string type = typeOf(child);
    if (type == "Structure" || type == "Vector") {
      addFields(child, fields);
      continue;
    }
    E57Field field;
    field.name = name;
    if (type == "Float")
      readFloat(child, field);
    else if (type == "Integer" || type == "ScaledInteger")
      readInteger(child, type == "ScaledInteger", field);
    else if (type != "String")
      throw ToolError("field " + quotedWord(field.name) + " is of the type " +
                      quotedWord(type) + ", which is unknown");
    fields.push_back(field);
  }
}

void
readPose(const Tree& node, E57Scan& scan)
{
  scan.has_pose = node.get_child_optional("pose").has_value();
  if (node.get_child_optional("pose.rotation")) {
    scan.rotation = {realAt(node, "pose.rotation.w"), realAt(node, "pose.rotation.x"),
                     realAt(node, "pose.rotation.y"), realAt(node, "pose.rotation.z")};
    constexpr double worst = 0.01; // deviation from length 1
    const double length = scan.rotation.norm();
    if (!(std::abs(length - 1) <= worst))
      throw ToolError("the quaternion of its pose has the length " +
                      std::to_string(length) + ", not 1");
    scan.rotation.normalize();
  }
  scan.translation = {realAt(node, "pose.translation.x"),
                      realAt(node, "pose.translation.y"),
                      realAt(node, "pose.translation.z")};
  if (!scan.translation.allFinite())
    throw ToolError("the translation of its pose is not finite");
}

void
readColourLimits(const Tree& node, E57Scan& scan)
{
  for (const std::string name : {"colorRed", "colorGreen", "colorBlue"}) {
    std::pair<double, double> range{realAt(node, "colorLimits." + name + "Minimum"),
                                    realAt(node, "colorLimits." + name + "Maximum")};
    constexpr double deepest = 65535; // wider ranges are those of the type
    const E57Field* const field = scan.find(name);
    if (field && !(range.second > range.first) && field->low >= 0 &&
        field->high <= deepest)
      range = {field->low, field->high};
    scan.colour_limits.push_back(range);
  }
}

void
readScan(const Tree& node, const E57Pages& pages, E57Scan& scan)
{
  scan.name = node.get<std::string>("name", "");
  const auto points = node.get_child_optional("points");
  if (!points || typeOf(*points) != "CompressedVector")
    throw ToolError("it has no points");
  const auto prototype = points->get_child_optional("prototype");
  if (!prototype)
    throw ToolError("it does not tell the fields of its points");
  scan.points = attribute<std::uint64_t>(*points, "recordCount", 0);
  addFields(*prototype, scan.fields);
  readPose(node, scan);
  readColourLimits(node, scan);
  if (scan.points > 0)
    scan.section = pages.logical(attribute<std::uint64_t>(*points, "fileOffset", 0),
                                 "the list of its points");
}

} // namespace

const E57Field*
E57Scan::find(const std::string& wanted) const
{
  const auto field = std::find_if(fields.begin(), fields.end(),
                                  [&](const auto& one) { return one.name == wanted; });
  return field == fields.end() ? nullptr : &*field;
}

std::string
E57Scan::title() const
{
  return "scan " + std::to_string(number) +
         (name.empty() ? "" : " (" + quotedWord(name) + ")");
}

std::vector<E57Entry>
readE57Scans(const E57Pages& pages)
{
  const Tree tree = readTree(pages);
  const auto root = tree.get_child_optional("e57Root");
  if (!root)
    throw ToolError("its XML has no element 'e57Root'");
  std::vector<E57Entry> entries;
  static const Tree no_scans;
  for (const auto& [name, node] : root->get_child("data3D", no_scans)) {
    if (name != "vectorChild")
      continue;
    E57Entry entry;
    entry.scan.number = entries.size() + 1;
    try {
      readScan(node, pages, entry.scan);
    }
    catch (const ToolError& error) {
      entry.problem = error.what();
    }
    catch (const boost::property_tree::ptree_bad_data& error) {
      entry.problem = "its XML has " + quotedWord(error.data<std::string>()) +
                      " in the place of a number";
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

} // namespace pcl::sedr::tools
