// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A line of a ceiling or floor in plan. */
struct SurfaceLine {
  PlanElement element;
  bool is_crease = false; ///< two surfaces meet in it; otherwise it is a step
  std::string text{};     ///< "ridge 4.35" or "valley 2.90"; usually empty
};

/** @brief Calls `use(part, value)` for the parts of an element along which `value(s)`
 * of the distance from its start is the same; in order.
 *
 * The value is asked for at the middle of steps of at most 2 cm, as the ends may lie on
 * a wall; where it changes, the place is found to a thousandth of a step. */
template <typename Value, typename Use>
void
forEachPart(const PlanElement& element, Value value, Use use)
{
  constexpr double max_step = 0.02;
  constexpr double max_steps = 10000;
  const double length = element.length();
  const double steps = std::clamp(std::ceil(length / max_step), 1.0, max_steps);
  const auto middle = [&](double k) { return (k + 0.5) * length / steps; };
  double start = 0;
  auto current = value(middle(0));
  for (double k = 1; k <= steps; ++k) {
    double to = length;
    auto next = current;
    if (k < steps) {
      next = value(middle(k));
      if (next == current)
        continue;
      double from = middle(k - 1);
      to = middle(k);
      for (int halving = 0; halving < 10; ++halving) {
        const double between = (from + to) / 2;
        (value(between) == current ? from : to) = between;
      }
    }
    use(start == 0 && to == length ? element : element.part(start, to), current);
    start = to;
    current = next;
  }
}

/** @brief Returns the parts of an element along which `is_so(s)`, as above. */
template <typename IsSo>
std::vector<PlanElement>
partsWhere(const PlanElement& element, IsSo is_so)
{
  std::vector<PlanElement> parts;
  forEachPart(element, is_so, [&](const PlanElement& part, bool holds) {
    if (holds)
      parts.push_back(part);
  });
  return parts;
}

/** @brief Joins segments that share ends, to 0.1 mm, to polylines; a closed one ends
 * where it starts. Where more than two meet, lines end. */
std::vector<std::vector<Eigen::Vector2d>>
chained(const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& segments);

/** @brief The faces of a room's solid: exact, but for chords of arcs and curves. None
 * if the plan cannot be built. */
struct RoomFaces {
  /** @param of must outlive this object */
  explicit RoomFaces(const PlanRoom& of);

  /** @brief Returns the triangles of parts of the room, in their order: "floor",
   * "wall_3", see SolidElement::name. */
  std::vector<std::size_t> trianglesOf(const std::vector<std::string>& names) const;

  const PlanRoom& room;
  TriangleMesh solid;
  std::vector<SolidElement> elements; ///< of the solid
  RoomSolidReport report;
  std::map<std::string, std::vector<std::size_t>> parts; ///< triangles, by name
  /** Triangles of the main ceiling, then of each detail. */
  std::vector<std::vector<std::size_t>> faces;

  /** @brief Returns the area of a face of the ceiling in space, square metres. */
  double area(std::size_t face) const;

  /** @brief Returns the area of all faces. */
  double area() const;
};

/** @brief Returns the lines in plan along which the ceiling of a room is `height`
 * metres above its floor, as under a roof; those that extend over less than 0.5 m are
 * left out. One element of each has the height as text, "h 1.50". Empty if the ceiling
 * is level. */
std::vector<SurfaceLine> heightLines(const RoomFaces& ceiling, double height);

/** @brief Returns the contour lines of vaults, domes and free forms, at most eight a
 * room, every 5, 10, 25 or 50 cm or every metre above the room's main floor; one
 * element of each has its height as text. */
std::vector<SurfaceLine> contourLines(const RoomFaces& ceiling);

/** @brief Returns the minimum and maximum height of the ceiling above the floor,
 * metres: at eaves and ridge. Faces below a fiftieth of the largest do not count. */
std::pair<double, double> heightRange(const RoomFaces& ceiling);

/** @brief Returns "eaves 1.05" for a wall from which a sloping ceiling rises, if level
 * along the wall; empty for others. The height is above the floor beside the wall. */
std::string eavesText(const PlanRoom& room, const PlanElement& wall);

/** @brief Which surface of a room: above or below. */
enum class SurfaceSide { Ceiling, Floor };

/** @brief A part of a ceiling or floor that carries a note, where none of others is. */
struct NotedPart {
  const PlanSlab& slab;
  const PlanLoop& outline;
  std::vector<PlanLoop> others;
};

/** @brief The lines of a ceiling or floor, and the parts between them. */
struct SurfaceLines {
  std::vector<SurfaceLine> lines;
  /** Of the main slab, then of each detail: a number that those of one part have in
   * common; that of the main slab for parts without a line. */
  std::vector<std::size_t> part;

  /** @brief Returns what carries a note: the main slab, and the largest detail of each
   * other part. It refers to the room. */
  std::vector<NotedPart> noted(const PlanRoom& room, SurfaceSide side) const;
};

/** @brief Returns the lines between the parts of a room's ceiling or floor: along most
 * of the border of two details, or of the main slab and one, they differ by a step of
 * 3 cm or an angle of 6 degrees (of a floor 2, as ramps are flatter than roofs), else
 * they are of one part.
 *
 * A line is where the upper one of both details in the room's list has its edge.
 * Segments are straightened, arcs stay arcs.
 * @param finest metres that a millimetre of paper stands for: lines are straightened by
 * that much, and those that extend over less than eight of them are left out */
SurfaceLines surfaceLines(const PlanRoom& room, SurfaceSide side, double finest);

} // namespace pcl::sedr
