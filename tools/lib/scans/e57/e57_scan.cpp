// SPDX-License-Identifier: BSD-3-Clause
#include "e57_scan.h"

#include "e57_tree.h"
#include "plain_text.h"
#include "tool_error.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace pcl::sedr::tools {

namespace {

using Tree = boost::property_tree::ptree;

constexpr auto lowest_integer = std::numeric_limits<std::int64_t>::min();
constexpr auto highest_integer = std::numeric_limits<std::int64_t>::max();

/** @brief Converts a whole text without surrounding blanks to a number; empty means 0,
 * which E57 omits. */
template <typename T>
T
numberOf(const std::string& text, const std::string& what)
{
  const std::size_t begin = text.find_first_not_of(" \t\r\n+");
  if (begin == std::string::npos)
    return T{0};
  const std::size_t end = text.find_last_not_of(" \t\r\n") + 1;
  T value{};
  const auto result = std::from_chars(text.data() + begin, text.data() + end, value);
  if (result.ec != std::errc() || result.ptr != text.data() + end)
    throw ToolError(what + " is " + quotedWord(text) + ", which is no number");
  return value;
}

template <typename T>
T
attribute(const Tree& node, const char* name, T otherwise, const std::string& what)
{
  const auto text = node.get_optional<std::string>(std::string("<xmlattr>.") + name);
  return text ? numberOf<T>(*text, "the " + std::string(name) + " of " + what)
              : otherwise;
}

std::string
typeOf(const Tree& node)
{
  return node.get<std::string>("<xmlattr>.type", "");
}

/** @brief Returns the number of an element: Float, Integer or ScaledInteger. */
double
realOf(const Tree& node, const std::string& what)
{
  const auto value = numberOf<double>(node.data(), what);
  if (typeOf(node) != "ScaledInteger")
    return value;
  return value * attribute<double>(node, "scale", 1, what) +
         attribute<double>(node, "offset", 0, what);
}

/** @brief Returns the number of `node`'s child called `name`, 0 if there is none. */
double
realAt(const Tree& node, const std::string& name, const std::string& of)
{
  const auto child = node.get_child_optional(name);
  return child ? realOf(*child, name + " of " + of) : 0;
}

unsigned
bitsFor(std::uint64_t range)
{
  unsigned bits = 0;
  for (; range > 0; range >>= 1)
    ++bits;
  return bits;
}

void
readInteger(const Tree& node, bool is_scaled, E57Field& field)
{
  const std::string what = quotedWord(field.name);
  field.kind = E57Field::Kind::Integer;
  field.minimum = attribute(node, "minimum", lowest_integer, what);
  const auto maximum = attribute(node, "maximum", highest_integer, what);
  if (field.minimum > maximum)
    throw ToolError("the least value of " + what + " is " +
                    std::to_string(field.minimum) + ", above the greatest, " +
                    std::to_string(maximum));
  field.bits = bitsFor(static_cast<std::uint64_t>(maximum) -
                       static_cast<std::uint64_t>(field.minimum));
  if (is_scaled) {
    field.scale = attribute<double>(node, "scale", 1, what);
    field.offset = attribute<double>(node, "offset", 0, what);
    if (!(field.scale > 0) || !std::isfinite(field.scale) ||
        !std::isfinite(field.offset))
      throw ToolError("the scale of " + what + " is " + std::to_string(field.scale) +
                      " and its offset " + std::to_string(field.offset) +
                      ", a scale above 0 and a finite offset are needed");
  }
  if (node.get_child_optional("<xmlattr>.minimum") &&
      node.get_child_optional("<xmlattr>.maximum")) {
    field.low = static_cast<double>(field.minimum) * field.scale + field.offset;
    field.high = static_cast<double>(maximum) * field.scale + field.offset;
  }
}

void
readFloat(const Tree& node, E57Field& field)
{
  const std::string what = quotedWord(field.name);
  const auto precision = node.get<std::string>("<xmlattr>.precision", "double");
  if (precision != "single" && precision != "double")
    throw ToolError("the precision of " + what + " is " + quotedWord(precision) +
                    ", neither single nor double");
  const bool is_single = precision == "single";
  field.kind = is_single ? E57Field::Kind::Float : E57Field::Kind::Double;
  field.bits = is_single ? 32 : 64;
  constexpr const char* colour = "color"; // no other range is needed
  if (field.name.rfind(colour, 0) != 0)
    return;
  field.low = attribute<double>(node, "minimum", 0, what);
  field.high = attribute<double>(node, "maximum", 0, what);
}

/** @brief Appends the fields below a node of the prototype, which may be nested. */
void
addFields(const Tree& node, std::vector<E57Field>& fields)
{
  for (const auto& child : node) {
    if (child.first == "<xmlattr>" || child.first == "<xmltext>")
      continue;
    const std::string type = typeOf(child.second);
    if (type == "Structure" || type == "Vector") {
      addFields(child.second, fields);
      continue;
    }
    E57Field field;
    field.name = child.first;
    if (type == "Float")
      readFloat(child.second, field);
    else if (type == "Integer" || type == "ScaledInteger")
      readInteger(child.second, type == "ScaledInteger", field);
    else if (type != "String")
      throw ToolError("field " + quotedWord(field.name) + " is of the type " +
                      quotedWord(type) + ", which is unknown");
    fields.push_back(field);
  }
}

void
readPose(const Tree& node, E57Scan& scan)
{
  const auto pose = node.get_child_optional("pose");
  if (!pose)
    return;
  scan.has_pose = true;
  if (const auto turn = pose->get_child_optional("rotation")) {
    const auto part = [&](const char* name) { return realAt(*turn, name, "its pose"); };
    scan.rotation = {part("w"), part("x"), part("y"), part("z")};
    constexpr double worst = 0.01; // deviation from length 1
    const double length = scan.rotation.norm();
    if (!(std::abs(length - 1) <= worst))
      throw ToolError("the quaternion of its pose has the length " +
                      std::to_string(length) + ", not 1");
    scan.rotation.normalize();
  }
  if (const auto shift = pose->get_child_optional("translation"))
    scan.translation = {realAt(*shift, "x", "its pose"),
                        realAt(*shift, "y", "its pose"),
                        realAt(*shift, "z", "its pose")};
  if (!scan.translation.allFinite())
    throw ToolError("the translation of its pose is not finite");
}

void
readColourLimits(const Tree& node, E57Scan& scan)
{
  const auto limits = node.get_child_optional("colorLimits");
  for (const std::string name : {"colorRed", "colorGreen", "colorBlue"}) {
    std::pair<double, double> range{0, 0};
    if (limits)
      range = {realAt(*limits, name + "Minimum", "its colours"),
               realAt(*limits, name + "Maximum", "its colours")};
    const int field = scan.find(name);
    if (field >= 0 && !(range.second > range.first)) {
      constexpr double deepest = 65535; // wider ranges are those of the type
      const E57Field& f = scan.fields[static_cast<std::size_t>(field)];
      if (f.low >= 0 && f.high <= deepest)
        range = {f.low, f.high};
    }
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
  scan.points = attribute<std::uint64_t>(*points, "recordCount", 0, "its points");
  addFields(*prototype, scan.fields);
  readPose(node, scan);
  readColourLimits(node, scan);
  if (scan.points > 0)
    scan.section =
        pages.logical(attribute<std::uint64_t>(*points, "fileOffset", 0, "its points"),
                      "the list of its points");
}

} // namespace

int
E57Scan::find(const std::string& wanted) const
{
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (fields[i].name == wanted)
      return static_cast<int>(i);
  return -1;
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
  const Tree tree = readE57Tree(pages);
  const auto root = tree.get_child_optional("e57Root");
  if (!root)
    throw ToolError("its XML has no element 'e57Root'");
  std::vector<E57Entry> entries;
  const auto data = root->get_child_optional("data3D");
  if (!data)
    return entries;
  for (const auto& child : *data) {
    if (child.first != "vectorChild")
      continue;
    E57Entry entry;
    entry.scan.number = entries.size() + 1;
    try {
      readScan(child.second, pages, entry.scan);
    }
    catch (const ToolError& error) {
      entry.problem = error.what();
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

} // namespace pcl::sedr::tools
