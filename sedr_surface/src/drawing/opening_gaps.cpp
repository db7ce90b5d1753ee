// SPDX-License-Identifier: BSD-3-Clause
#include "plan_drawing.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_segmentation/src/curves/plan_curve.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::sedr {
namespace {

/** @brief Returns the thickness of the wall of an opening that leads outside; the depth
 * of others. */
double
depthOf(const Floorplan& plan,
        const std::vector<PlanWall>& walls,
        const PlanOpening& opening)
{
  if (!opening.leadsOutside())
    return opening.depth;
  const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
  for (const PlanWall& wall : walls)
    for (const OpeningWall& in : opening.walls) {
      const double s = elementOf(plan, wall.face).project(middle);
      if (!wall.other && wall.face.loop == 0 && wall.face.element == in.element &&
          plan.rooms[wall.face.room].id == in.room && s >= wall.stretch.from &&
          s <= wall.stretch.to)
        return wall.thickness;
    }
  return opening.depth;
}

/** @brief Returns whether an opening has no lintel in any of its rooms. */
bool
reachesCeiling(const Floorplan& plan, const PlanOpening& opening)
{
  constexpr double beside = 0.05; // metres
  const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
  return std::none_of(
      opening.walls.begin(), opening.walls.end(), [&](const OpeningWall& in) {
        const PlanRoom* const room = findRoom(plan, in.room);
        if (!room || in.element >= room->boundary.elements.size())
          return false;
        const auto [face, inward] =
            faceAt(room->boundary.elements[in.element],
                   room->boundary.elements[in.element].project(middle));
        return opening.top < room->ceilingAt(face + beside * inward) - beside;
      });
}

/** @brief Returns the gap of an opening, from the face that was seen on. */
OpeningGap
gapOf(const Floorplan& plan, const PlanOpening& opening, double depth)
{
  const Eigen::Vector2d way = (opening.end - opening.start) / opening.width();
  const Eigen::Vector2d left = leftOf(way);
  const double beyond = depth - opening.depth / 2; // from the middle of the wall
  const Eigen::Vector2d to_left =
      (opening.rooms[0] == 0 ? beyond : opening.depth / 2) * left;
  const Eigen::Vector2d to_right =
      (opening.rooms[0] == 0 ? opening.depth / 2 : beyond) * left;
  OpeningGap gap;
  gap.corners = {opening.start + to_left, opening.end + to_left, opening.end - to_right,
                 opening.start - to_right};
  gap.mark = markOf(opening);
  gap.width = opening.width();
  gap.is_rough = isRough(opening);
  gap.height = opening.height();
  gap.kind = opening.kind;
  gap.has_faces = opening.kind == OpeningKind::Window;
  gap.sill = sillOf(plan, opening);
  for (const OpeningLeaf& door : leavesOf(opening)) {
    PlanElement swing = segment(door.open, door.shut);
    swing.centre = door.hinge;
    swing.radius = (door.open - door.hinge).norm();
    const Eigen::Vector2d to_shut = door.shut - door.hinge;
    const Eigen::Vector2d to_open = door.open - door.hinge;
    swing.counter_clockwise = to_open.x() * to_shut.y() > to_open.y() * to_shut.x();
    gap.leaf.insert(gap.leaf.end(), {segment(door.hinge, door.open), swing});
  }
  return gap;
}

} // namespace

std::vector<GapLine>
linesOf(const OpeningGap& gap)
{
  const auto& c = gap.corners;
  std::vector<GapLine> lines{{segment(c[0], c[3]), looks::jamb},
                             {segment(c[1], c[2]), looks::jamb}};
  const auto addAlong = [&](std::initializer_list<double> shares_of_depth,
                            const SheetLook& look) {
    for (const double share : shares_of_depth)
      lines.push_back(
          {segment(c[0] + share * (c[3] - c[0]), c[1] + share * (c[2] - c[1])), look});
  };
  if (gap.has_faces)
    addAlong({0, 1}, looks::thin);
  if (gap.has_filling && gap.kind == OpeningKind::Window)
    addAlong({0.4, 0.6}, looks::thin);
  if (gap.has_filling && gap.kind == OpeningKind::Door && gap.leaf.empty())
    addAlong({0.5}, looks::leaf);
  for (const PlanElement& line : gap.leaf)
    lines.push_back({line, looks::thin});
  return lines;
}

std::vector<PlanElement>
cutAtGaps(const PlanElement& element, const std::vector<OpeningGap>& gaps)
{
  constexpr double on_face = 0.05; // metres from the end of a jamb
  constexpr double shortest = 1e-4;
  if (element.length() < shortest)
    return {element};
  const PlanCurve face = carrierOf(element);
  // Where a jamb ends on the face, along it; an arc bows out of the chord between both.
  const auto endOf = [&](const PlanElement& jamb,
                         double width) -> std::optional<double> {
    const double bow = element.isArc() ? width * width / (8 * element.radius) : 0;
    for (const Eigen::Vector2d& p : intersections(face, carrierOf(jamb)))
      if (jamb.distance(p) < on_face + bow)
        return element.project(p);
    return std::nullopt;
  };
  std::vector<std::pair<double, double>> cuts;
  for (const OpeningGap& gap : gaps) {
    const auto& c = gap.corners;
    const double width = (c[1] - c[0]).norm();
    const auto a = endOf(segment(c[0], c[3]), width);
    const auto b = endOf(segment(c[1], c[2]), width);
    if (!a || !b)
      continue;
    const auto [from, to] = std::minmax({*a, *b});
    if (element.start == element.end && to - from > element.length() / 2) {
      cuts.emplace_back(0, from); // across the ends of a circle
      cuts.emplace_back(to, element.length());
    }
    else
      cuts.emplace_back(from, to);
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.emplace_back(element.length(), element.length());
  std::vector<PlanElement> parts;
  double from = 0;
  for (const auto& [start, end] : cuts) {
    if (start - from > shortest)
      parts.push_back(
          from == 0 && start == element.length() ? element : element.part(from, start));
    from = std::max(from, end);
  }
  return parts;
}

std::vector<OpeningGap>
openingGaps(const Floorplan& plan, const std::vector<PlanWall>& walls, DrawingView view)
{
  std::vector<OpeningGap> gaps;
  for (const PlanOpening& opening : plan.openings) {
    OpeningGap& gap =
        gaps.emplace_back(gapOf(plan, opening, depthOf(plan, walls, opening)));
    if (view == DrawingView::Floor)
      continue;
    gap.leaf.clear();
    gap.has_filling = false;
    gap.has_faces = !reachesCeiling(plan, opening);
  }
  return gaps;
}

std::string
levelText(double level)
{
  constexpr double half_a_unit = 0.005;
  return std::abs(level) < half_a_unit ? "±0.00"
                                       : (level < 0 ? "" : "+") + decimalText(level, 2);
}

std::string
titleOf(const PlanRoom& room)
{
  const std::string number = std::to_string(room.id);
  return room.name.empty() ? "Room " + number : number + " " + room.name;
}

std::vector<std::string>
roomTexts(const RoomFaces& ceiling, DrawingView view, double zero)
{
  const PlanRoom& room = ceiling.room;
  const double usual = clearHeight(room).usual;
  std::string height = usual > 0 ? decimalText(usual, 2) : "";
  if (room.hasFacets())
    if (const auto [eaves, ridge] = heightRange(ceiling); eaves > 0)
      height = decimalText(eaves, 2) + " - " + decimalText(ridge, 2);
  std::vector<std::string> lines{titleOf(room)};
  const bool is_floor = view == DrawingView::Floor;
  lines.push_back(is_floor ? decimalText(room.area(), 2) + " m²"
                           : "ceiling " + decimalText(ceiling.area(), 2) + " m²");
  if (!height.empty() && (is_floor || room.hasFacets()))
    lines.push_back("h " + height + " m");
  if (is_floor)
    lines.push_back("▼ " + levelText(heightsOf(room).low - zero));
  return lines;
}

std::string
columnText(const PlanLoop& column)
{
  constexpr double same = 0.02;
  const std::vector<PlanElement>& e = column.elements;
  const auto isRound = [&](const PlanElement& part) {
    return part.isArc() && std::abs(part.radius - e.front().radius) < same;
  };
  if (!e.empty() && std::all_of(e.begin(), e.end(), isRound))
    return "Ø " + decimalText(2 * e.front().radius, 2);
  const bool is_quad =
      e.size() == 4 && std::none_of(e.begin(), e.end(), [](const PlanElement& part) {
        return part.isArc();
      });
  return is_quad ? decimalText(e[0].length(), 2) + " x " + decimalText(e[1].length(), 2)
                 : "";
}

std::string
textOf(const OpeningGap& opening)
{
  return opening.mark + (opening.is_rough ? " ~" : " ") +
         decimalText(opening.width, 2) + " x " + decimalText(opening.height, 2) +
         (opening.kind == OpeningKind::Window ? " sill " + decimalText(opening.sill, 2)
                                              : "");
}

} // namespace pcl::sedr
