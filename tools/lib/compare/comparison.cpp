// SPDX-License-Identifier: BSD-3-Clause
#include "comparison.h"

#include "element_changes.h"

#include "sedr_filters/src/base/number_text.h"

#include <boost/algorithm/string/join.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;

/** @brief Formats a length with its sign: "+0.30". */
std::string
signedText(double metres)
{
  const std::string text = decimalText(metres, 2);
  return text[0] == '-' ? text : "+" + text;
}

std::string
shiftText(const Eigen::Vector3d& shift)
{
  constexpr double nothing = 0.005; // metres; shown as 0 with two digits
  std::string parts;
  for (int k = 0; k < 3; ++k)
    if (std::abs(shift[k]) >= nothing)
      parts += std::string(parts.empty() ? "" : ", ") + "xyz"[k] + " " +
               signedText(shift[k]);
  return decimalText(shift.norm(), 2) + " m" +
         (parts.empty() ? "" : " (" + parts + ")");
}

/** @brief Rounds to millimetres. */
double
rounded(double value)
{
  return std::round(value * 1000) / 1000;
}

} // namespace

const char*
toString(ChangeKind kind)
{
  constexpr const char* names[] = {"appeared", "vanished", "moved"};
  return names[static_cast<std::size_t>(kind)];
}

Change
changeOf(const Element& element, ChangeKind kind)
{
  Change change{kind, element.what};
  (kind == ChangeKind::Appeared ? change.after : change.before) = {element.name};
  change.size = element.size;
  change.outlines = {element.outline};
  return change;
}

Change
moveOf(const Element& before, const Element& after)
{
  Change change = changeOf(before, ChangeKind::Moved);
  change.after = {after.name};
  change.shift = after.middle - before.middle;
  change.outlines = {after.outline};
  return change;
}

std::vector<Change>
comparePlans(const Floorplan& before,
             const Floorplan& after,
             const CompareSettings& given)
{
  constexpr double rounding = 1e-6; // metres: what is off by the tolerance is within it
  CompareSettings settings = given;
  settings.tolerance += rounding;
  const std::vector<Change> rooms = roomChanges(before, after);
  std::vector<Change> changes = rooms;
  const auto add = [&](const std::vector<Change>& more) {
    changes.insert(changes.end(), more.begin(), more.end());
  };
  add(wallChanges(before, after, settings, rooms));
  add(columnChanges(before, after, settings));
  add(slabChanges(before, after, settings));
  add(openingChanges(before, after, settings));
  return changes;
}

std::string
describe(const Change& change)
{
  const bool is_opening =
      (change.before.empty() ? change.after : change.before)[0].rfind("opening_", 0) ==
      0;
  std::string text = std::string(!is_opening ? toString(change.kind)
                                 : change.kind == ChangeKind::Appeared ? "cut"
                                                                       : "bricked up") +
                     " " + change.what;
  if (change.kind == ChangeKind::Moved)
    text += " by " + shiftText(change.shift);
  text += ", " + decimalText(change.size, change.is_length ? 1 : 2) +
          (change.is_length ? " m" : " m2") + ": ";
  text += boost::join(change.before, ", ");
  if (!change.before.empty() && !change.after.empty())
    text += " -> ";
  return text + boost::join(change.after, ", ");
}

std::string
changesToJson(const std::vector<Change>& changes, const CompareSettings& settings)
{
  Json list = Json::array();
  for (const auto& change : changes) {
    Json json{{"change", toString(change.kind)},
              {"what", change.what},
              {"before", change.before},
              {"after", change.after}};
    json[change.is_length ? "length" : "area"] = rounded(change.size);
    if (change.kind == ChangeKind::Moved)
      json["shift"] = {rounded(change.shift.x()), rounded(change.shift.y()),
                       rounded(change.shift.z())};
    list.push_back(json);
  }
  const Json json{{"format", "sedr-changes"},
                  {"version", 1},
                  {"unit", "m"},
                  {"tolerance", settings.tolerance},
                  {"minimum_length", settings.minimum_length},
                  {"minimum_area", settings.minimum_area},
                  {"farthest", settings.farthest},
                  {"changes", list}};
  return json.dump(1) + "\n";
}

} // namespace pcl::sedr::tools
