// SPDX-License-Identifier: BSD-3-Clause
#include "comparison.h"
#include "element_changes.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <Eigen/Cholesky>
#include <boost/algorithm/string/join.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
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

std::vector<Element>
columnsOf(const Floorplan& plan)
{
  std::vector<Element> columns;
  for (const auto& room : plan.rooms)
    for (const PlanLoop& column : room.columns) {
      const Eigen::Vector2d centre = boundsOf(column).center();
      const std::size_t number = static_cast<std::size_t>(&column - &room.columns[0]);
      columns.push_back(
          {"column",
           "room_" + std::to_string(room.id) + "_column_" + std::to_string(number + 1),
           column,
           std::abs(column.area()),
           {centre.x(), centre.y(), 0},
           heightsOf(room)});
    }
  return columns;
}

/** @brief Returns the distance of two columns; infinite if they are not alike. */
double
columnsApart(const Element& a, const Element& b)
{
  constexpr double max_ratio = 2; // of areas; hidden sides are inferred
  const bool is_alike = a.size < max_ratio * b.size && b.size < max_ratio * a.size &&
                        shareHeights(a.heights, b.heights);
  return is_alike ? (a.middle - b.middle).norm() : never;
}

/** @brief Returns the openings of a plan; the heights are their own. */
std::vector<Element>
openingsOf(const Floorplan& plan)
{
  std::vector<Element> openings;
  for (const PlanOpening& o : plan.openings) {
    const Eigen::Vector2d place = (o.start + o.end) / 2;
    const std::size_t number = static_cast<std::size_t>(&o - &plan.openings[0]);
    openings.push_back({nameOf(o.kind),
                        "opening_" + std::to_string(number + 1),
                        {{segment(o.start, o.end)}},
                        o.width() * o.height(),
                        {place.x(), place.y(), (o.bottom + o.top) / 2},
                        {o.bottom, o.top}});
  }
  return openings;
}

/** @brief Returns the distance of the middles of two openings; infinite if they do not
 * share a part of a wall. */
double
openingsApart(const Element& a, const Element& b)
{
  constexpr double max_sine = 0.26;  // between their walls: 15 degrees
  constexpr double max_across = 0.5; // metres, between walls that face each other
  constexpr double max_moved = 0.8;  // of a wall; the other side of a corridor is more
  const PlanElement& o = a.outline.elements[0];
  const PlanElement& p = b.outline.elements[0];
  const Eigen::Vector2d normal = o.normalAt(0);
  const Eigen::Vector2d other = p.normalAt(0);
  const Eigen::Vector3d off = b.middle - a.middle;
  const double across = std::abs(normal.dot(off.head<2>()));
  const double along = std::abs(cross(normal, off.head<2>()));
  const bool share =
      std::abs(cross(normal, other)) < max_sine &&
      across < (normal.dot(other) > 0 ? max_moved : max_across) &&
      2 * along < o.length() + p.length() &&
      std::max(a.heights.low, b.heights.low) < std::min(a.heights.high, b.heights.high);
  return share ? off.norm() : never;
}

/** @brief Returns whether a plan has a wall where an opening of known kind is. */
bool
hasWallOf(const Element& opening, const Floorplan& plan)
{
  constexpr double near = 0.5; // of the middle of the wall, metres
  const double height = opening.middle.z();
  return opening.what != nameOf(OpeningKind::Unknown) &&
         std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& room) {
           const RoomHeights heights = heightsOf(room);
           return heights.low < height && height < heights.high &&
                  room.boundary.distance(opening.middle.head<2>()) < near;
         });
}

/** @brief Returns whether a plan has a room where a column is. */
bool
hasRoomOf(const Element& column, const Floorplan& plan)
{
  const auto rooms = roomsAt(plan, column.heights);
  return std::any_of(rooms.begin(), rooms.end(), [&](const PlanRoom* room) {
    return room->contains(column.middle.head<2>());
  });
}

/** @brief Pairs elements of two plans; of the others those count whose places the
 * other plan has.
 * @param apart distance of two elements
 * @param has_place whether a plan has the place of an element
 * @param tolerance distance beyond which an element has moved */
template <typename ApartT, typename HasPlaceT>
std::vector<Change>
thingChanges(std::vector<Element> gone,
             std::vector<Element> come,
             const Floorplan& before,
             const Floorplan& after,
             const ApartT& apart,
             const HasPlaceT& has_place,
             double farthest,
             double tolerance)
{
  std::vector<Change> changes;
  for (const auto& [a, b] : takePairs(gone, come, farthest, apart))
    if (apart(a, b) > tolerance)
      changes.push_back(moveOf(a, b));
  for (const Element& element : gone)
    if (has_place(element, after))
      changes.push_back(changeOf(element, ChangeKind::Vanished));
  for (const Element& element : come)
    if (has_place(element, before))
      changes.push_back(changeOf(element, ChangeKind::Appeared));
  return changes;
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
  std::vector<Change> changes;
  const std::vector<Change> slabs = slabChanges(before, after, settings, changes);
  const auto add = [&](const std::vector<Change>& more) {
    changes.insert(changes.end(), more.begin(), more.end());
  };
  add(wallChanges(before, after, settings, changes));
  // Whatever its size, a column or opening at the place of another one is the same.
  add(thingChanges(columnsOf(before), columnsOf(after), before, after, columnsApart,
                   hasRoomOf, settings.farthest, settings.tolerance));
  add(slabs);
  if (!before.openings.empty() && !after.openings.empty()) // else nobody looked for any
    add(thingChanges(openingsOf(before), openingsOf(after), before, after,
                     openingsApart, hasWallOf, settings.farthest, never));
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

std::optional<Eigen::Vector2d>
commonShift(const Floorplan& before,
            const std::vector<Change>& changes,
            const CompareSettings& settings)
{
  Eigen::Matrix2d normals = 1e-9 * Eigen::Matrix2d::Identity();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> shifts; // of each wall that moved
  for (const Change& change : changes) {
    const Eigen::Vector2d by = change.shift.head<2>();
    if (change.kind != ChangeKind::Moved || !change.is_length || by.norm() == 0)
      continue;
    const Eigen::Vector2d n = by.normalized();
    normals += change.size * n * n.transpose();
    sum += change.size * by;
    shifts.insert(shifts.end(), change.before.size(), by);
  }
  const Eigen::Vector2d shift = normals.ldlt().solve(sum);
  const auto explained =
      std::count_if(shifts.begin(), shifts.end(), [&](const Eigen::Vector2d& by) {
        return std::abs(shift.dot(by.normalized()) - by.norm()) < settings.tolerance;
      });
  std::ptrdiff_t would_move = 0;
  for (const PlanRoom& room : before.rooms)
    for (const PlanElement& wall : room.boundary.elements)
      would_move += !wall.isArc() && wall.length() > settings.minimum_length &&
                            std::abs(shift.dot(wall.normalAt(0))) > settings.tolerance
                        ? 1
                        : 0;
  const std::ptrdiff_t most = would_move - would_move / 5; // others changed as well
  if (would_move == 0 || explained < most)
    return {};
  return shift;
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
