// SPDX-License-Identifier: BSD-3-Clause
#include "../drawing/plan_drawing.h"
#include "../overhead/room_faces.h"
#include "cut_drawing.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief The unrolled walls of a room, one beside the other, in rows. */
class Elevations {
public:
  Elevations(const Floorplan& plan,
             const PlanRoom& room,
             const DrawingSettings& settings)
      : plan_(plan)
      , room_(room)
      , settings_(settings)
      , faces_(room)
  {
    const Rows found = bestRows(faces_.solid.bounds().sizes().z());
    for (const std::vector<std::size_t>& row : found.walls) {
      double left = 0;
      const auto first = static_cast<std::ptrdiff_t>(drawing.outlines.size());
      for (const std::size_t e : row) {
        addWall(e, left);
        left += room.boundary.elements[e].length();
      }
      rows.emplace_back(drawing.outlines.begin() + first, drawing.outlines.end());
      up_ -= found.step;
    }
  }

  CutDrawing drawing{};
  std::vector<std::vector<PlanLoop>> rows{}; ///< the outlines of each

private:
  /** @brief Walls in rows, from left to right. */
  struct Rows {
    std::vector<std::vector<std::size_t>> walls;
    double width = 0; ///< of the longest row, metres
    double step = 0;  ///< from row to row, metres
  };

  /** @brief Returns the walls in rows shorter than a width, but for longer walls. */
  Rows rowsWithin(double width) const
  {
    const std::vector<PlanElement>& elements = room_.boundary.elements;
    Rows rows;
    double length = 0;
    for (std::size_t e = elements.size(); e-- > 0;) { // to the right
      if (rows.walls.empty() || length + elements[e].length() >= width) {
        rows.walls.emplace_back();
        length = 0;
      }
      rows.walls.back().push_back(e);
      length += elements[e].length();
      rows.width = std::max(rows.width, length);
    }
    return rows;
  }

  /** @brief Returns the fewest rows with the largest scale, then the smallest paper. */
  Rows bestRows(double height) const
  {
    Rows best;
    std::pair<double, double> least; // scale and area of the paper
    double width = std::numeric_limits<double>::max();
    while (true) {
      Rows rows = rowsWithin(width);
      if (rows.width >= width || rows.walls.empty())
        return best;
      Eigen::AlignedBox2d space = dimensionSpace();
      const double between = space.min().y() + space.max().y(); // millimetres
      const auto count = static_cast<double>(rows.walls.size());
      space.max().y() += (count - 1) * between;
      const SheetLayout layout = layoutOf(
          {Eigen::Vector2d::Zero(), Eigen::Vector2d(rows.width, count * height)}, space,
          settings_);
      rows.step = height + between * layout.scale / 1000;
      width = rows.width;
      const std::pair<double, double> cost(layout.scale, layout.size.prod());
      if (best.walls.empty() || cost < least) {
        least = cost;
        best = std::move(rows);
      }
    }
  }

  void addWall(std::size_t e, double left)
  {
    const PlanElement& wall = room_.boundary.elements[e];
    std::vector<PlanLoop> openings;
    for (const PlanOpening& opening : plan_.openings)
      if (std::any_of(opening.walls.begin(), opening.walls.end(),
                      [&](const OpeningWall& in) {
                        return in.room == room_.id && in.element == e;
                      })) {
        const double end = left + wall.length();
        const auto [a, b] = std::minmax(
            {end - wall.project(opening.start), end - wall.project(opening.end)});
        if (wall.start == wall.end && b - a > wall.length() / 2) {
          openings.push_back(
              addOpening(opening, left, a)); // across the ends of a circle
          openings.push_back(addOpening(opening, b, end));
        }
        else
          openings.push_back(addOpening(opening, a, b));
      }
    for (const PlanLoop& loop : unrolled(e, left)) {
      const bool is_niche = loop.area() > 0; // triangles face out of the room
      for (const PlanElement& part : loop.elements)
        drawing.lines.push_back(
            {part, is_niche ? PlanLayer::Niche : PlanLayer::Wall, room_.id});
      if (is_niche)
        continue;
      drawing.outlines.push_back(reversed(loop));
      if (settings_.is_unseen)
        addHatch(e, left, openings);
      drawing.labels.push_back(
          {PlanLayer::Number,
           drawing.outlines.back(),
           {std::to_string(room_.id) + "." + std::to_string(e + 1)},
           openings});
    }
  }

  /** @brief Hatches what nobody saw within the last outline, but for openings. */
  void addHatch(std::size_t e, double left, const std::vector<PlanLoop>& openings)
  {
    constexpr double step = 0.15; // metres, along the wall
    const PlanLoop outline = drawing.outlines.back();
    const Eigen::AlignedBox2d box = boundsOf(outline);
    const double right = left + room_.boundary.elements[e].length();
    const auto isUnseen = [&](const Eigen::Vector2d& p) {
      return outline.contains(p) &&
             std::none_of(openings.begin(), openings.end(),
                          [&](const PlanLoop& loop) { return loop.contains(p); }) &&
             settings_.is_unseen(room_.id, e, right - p.x(), p.y() - up_);
    };
    const double height = box.sizes().y();
    for (double x = box.min().x() - height + step / 2; x < box.max().x(); x += step) {
      const PlanElement line = segment({x, box.min().y()}, {x + height, box.max().y()});
      for (const PlanElement& part :
           partsWhere(line, [&](double s) { return isUnseen(line.pointAt(s)); }))
        drawing.lines.push_back({part, PlanLayer::Unseen, room_.id});
    }
  }

  /** @brief Returns the outlines of a wall's triangles; of a round one in two halves.
   */
  std::vector<PlanLoop> unrolled(std::size_t e, double left) const
  {
    const PlanElement& wall = room_.boundary.elements[e];
    const double length = wall.length();
    const bool is_round = wall.isArc() && std::abs(wall.sweep()) > 2 * M_PI - 1e-6;
    const TriangleMesh& solid = faces_.solid;
    std::array<std::vector<std::size_t>, 2> halves;
    for (const std::size_t t : faces_.trianglesOf({"wall_" + std::to_string(e + 1)})) {
      const Eigen::Vector3d middle =
          (solid.corner(t, 0) + solid.corner(t, 1) + solid.corner(t, 2)) / 3;
      const bool is_second = is_round && alongOf(wall, middle.head<2>()) > length / 2;
      halves[is_second ? 1 : 0].push_back(t);
    }
    std::vector<PlanLoop> loops;
    for (const std::size_t half : {0U, 1U})
      for (const PlanLoop& loop :
           outlinesOf(solid, halves[half], [&](const Eigen::Vector3d& p) {
             // Seen from the room, an element that runs counter-clockwise runs to the
             // left. A round one ends where it starts.
             double along = alongOf(wall, p.head<2>());
             if (is_round &&
                 std::abs(along - length * (half == 0 ? 0 : 1)) > 0.75 * length)
               along += half == 0 ? -length : length;
             return Eigen::Vector2d(left + length - along, p.z() + up_);
           }))
        loops.push_back(loop);
    return loops;
  }

  /** @brief Returns the distance from the start of an element, chords of an arc too. */
  static double alongOf(const PlanElement& wall, const Eigen::Vector2d& p)
  {
    return wall.isArc() ? wall.project(p)
                        : (p - wall.start).dot((wall.end - wall.start).normalized());
  }

  /** @return its outline */
  PlanLoop addOpening(const PlanOpening& opening, double left, double right)
  {
    const PlanLoop outline =
        rectangleOf(left, right, opening.bottom + up_, opening.top + up_);
    const PlanLayer layer =
        opening.kind == OpeningKind::Window ? PlanLayer::Window : PlanLayer::Door;
    for (const PlanElement& part : outline.elements)
      drawing.lines.push_back({part, layer, room_.id});
    drawing.labels.push_back(
        {PlanLayer::Note,
         outline,
         {markOf(opening), (isRough(opening) ? "~" : "") +
                               decimalText(opening.width(), 2) + " x " +
                               decimalText(opening.height(), 2)}});
    return outline;
  }

  const Floorplan& plan_;
  const PlanRoom& room_;
  const DrawingSettings& settings_;
  RoomFaces faces_;
  double up_ = 0; ///< of the present row, metres
};

CutDrawing
elevationsOf(const Floorplan& plan, std::uint32_t id, const DrawingSettings& settings)
{
  const PlanRoom* const room = findRoom(plan, id);
  if (!room)
    return {};
  Elevations elevations(plan, *room, settings);
  CutDrawing drawing = std::move(elevations.drawing);
  drawing.title = {
      "Interior elevations",
      "Room",
      titleOf(*room),
      "Walls",
      std::to_string(room->boundary.elements.size()),
      "Dimensions in metres. Walls as seen from the room, unrolled, numbered "
      "as on the plan. Openings and niches in their outlines." +
          std::string(settings.is_unseen ? " Hatched: not seen." : ""),
      false};
  complete(elevations.rows, settings, drawing);
  return drawing;
}

} // namespace

std::vector<std::string>
drawElevations(const Floorplan& plan,
               std::uint32_t room,
               const std::vector<DrawingFormat>& formats,
               const DrawingSettings& settings)
{
  Floorplan numbered = plan;
  numberOpenings(numbered);
  return written(elevationsOf(numbered, room, settings), formats, settings);
}

} // namespace pcl::sedr
