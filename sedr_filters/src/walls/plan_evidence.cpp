// SPDX-License-Identifier: BSD-3-Clause
#include "../rays/cube_points.h"

#include "plan_evidence.h"

#include "../base/parallel.h"
#include "../plan/plan_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::sedr {

namespace {

// Metres.
constexpr double cell_size = 0.1;
constexpr double rim = 0.03; ///< edge of a wall where points may belong to a slab
constexpr double fill_reach = 0.08;    ///< reach of a point that fills a place
constexpr double beside_corner = 0.06; ///< points in it may belong to the next wall
constexpr double reach_before = 1.0;   ///< reach of objects that hide a cell
constexpr double off_slab = 0.07;  ///< points nearer to floor or ceiling hide nothing
constexpr double low_cell = 1.0;   ///< below it furniture may cast shadows
constexpr double foot_from = 0.15; ///< start of the floor at the foot of a wall
constexpr double foot_to = 0.55;
constexpr double min_seen = 0.05; ///< share; with less, a wall was not in view

/** @brief Numbers of seen, hidden, open and proved open cells of a surface. */
struct CellCount : ElementEvidence {
  double proved = 0;
};

/** @brief A cell of a vertical surface. */
struct Cell {
  Eigen::Vector3d middle;
  Eigen::Vector3d normal; ///< into the room
  double floor = 0;       ///< z at its foot
  VerticalSpan span;
};

class RoomEvidence {
public:
  RoomEvidence(const PlanRoom& room,
               const CubePoints& points,
               double tolerance,
               const SightLines* sight)
      : room_(room)
      , points_(points)
      , tolerance_(tolerance)
      , sight_(sight)
  {}

  /** @brief Counts the seen, hidden and open cells of a surface. */
  CellCount countOf(const VerticalSurface& surface) const
  {
    CellCount count;
    const double margin = std::min(beside_corner, surface.element->length() / 4);
    const double length = surface.element->length() - 2 * margin;
    const auto columns = partsOf(length);
    for (std::size_t c = 0; c < columns; ++c) {
      const double s = margin + length * (static_cast<double>(c) + 0.5) /
                                    static_cast<double>(columns);
      const VerticalSpan span = surface.spanAt(s);
      if (!(span.high > span.low))
        continue;
      const auto rows = partsOf(span.high - span.low);
      const Eigen::Vector3d normal = surface.normalAt(s);
      const double floor = room_.floorAt(surface.element->pointAt(s));
      for (std::size_t r = 0; r < rows; ++r) {
        const double z = span.low + (span.high - span.low) *
                                        (static_cast<double>(r) + 0.5) /
                                        static_cast<double>(rows);
        add({surface.pointAt(s, z), normal, floor, span}, count);
      }
    }
    return count;
  }

private:
  static std::size_t partsOf(double length)
  {
    return std::max<std::size_t>(
        1, static_cast<std::size_t>(std::lround(length / cell_size)));
  }

  /** @brief Counts a cell. A ray through it proves an opening. A ray that ends before
   * it proves nothing, because other rays may have passed without an echo. */
  void add(const Cell& cell, CellCount& count) const
  {
    const bool is_seen = isSeen(cell);
    const bool is_proved =
        !is_seen && sight_ && sight_->pierce(cell.middle, cell.normal, cell_size / 2);
    const bool is_hidden = !is_seen && !is_proved && isHidden(cell);
    (is_seen ? count.seen : is_hidden ? count.hidden : count.opening) += 1;
    count.proved += is_proved ? 1 : 0;
  }

  bool isSeen(const Cell& cell) const
  {
    return points_.anyNear(cell.middle, [&](const Eigen::Vector3d& p) {
      const Eigen::Vector3d off = p - cell.middle;
      const double across = off.dot(cell.normal);
      const double along = (off - across * cell.normal).head<2>().norm();
      return std::abs(across) <= tolerance_ && along <= cell_size / 2 &&
             std::abs(off.z()) <= cell_size / 2 && p.z() > cell.span.low + rim &&
             p.z() < cell.span.high - rim;
    });
  }

  bool isHidden(const Cell& cell) const
  {
    for (double d = tolerance_ + fill_reach; d < reach_before; d += cell_size) {
      const Eigen::Vector3d before = cell.middle + d * cell.normal;
      if (!room_.holds(before))
        break;
      if (points_.anyNear(before, [&](const Eigen::Vector3d& p) {
            return (p - before).norm() <= fill_reach && p.z() > cell.floor + off_slab &&
                   p.z() < cell.span.high - off_slab;
          }))
        return true;
    }
    return cell.middle.z() < cell.floor + low_cell && !seesFloorAtFoot(cell);
  }

  bool seesFloorAtFoot(const Cell& cell) const
  {
    for (double d = foot_from; d < foot_to; d += cell_size) {
      Eigen::Vector3d foot = cell.middle + d * cell.normal;
      foot.z() = room_.floorAt(foot.head<2>());
      if (points_.anyNear(foot, [&](const Eigen::Vector3d& p) {
            return (p - foot).head<2>().norm() <= fill_reach &&
                   std::abs(p.z() - foot.z()) <= tolerance_;
          }))
        return true;
    }
    return false;
  }

  RoomLookup room_;
  const CubePoints& points_;
  double tolerance_;
  const SightLines* sight_; ///< may be null
};

CellCount
sumOf(const CellCount& a, const CellCount& b)
{
  return {{a.seen + b.seen, a.hidden + b.hidden, a.opening + b.opening},
          a.proved + b.proved};
}

/** @brief Returns the shares of counted cells. If the surface was not in view, all
 * cells that no ray passed through are hidden. */
ElementEvidence
sharesOf(const CellCount& count)
{
  const double all = count.seen + count.hidden + count.opening;
  if (all == 0)
    return {};
  const double seen = count.seen / all;
  if (seen >= min_seen)
    return {seen, count.hidden / all, count.opening / all};
  const double open = count.proved / all;
  return {seen, std::max(0.0, 1 - seen - open), open};
}

using Counts = std::map<const PlanElement*, CellCount>;

void
note(const Counts& counts, PlanLoop& loop)
{
  for (PlanElement& element : loop.elements) {
    const auto count = counts.find(&element);
    element.evidence =
        count == counts.end() ? ElementEvidence() : sharesOf(count->second);
  }
}

void
measureRoom(PlanRoom& room,
            const CubePoints& cubes,
            double tolerance,
            unsigned threads,
            const SightLines* sight)
{
  const RoomEvidence evidence(room, cubes, tolerance, sight);
  const std::vector<VerticalSurface> surfaces = verticalSurfaces(room);
  std::vector<CellCount> count_of(surfaces.size());
  parallelBlocks(surfaces.size(), 1, threads, [&](std::size_t k, std::size_t) {
    count_of[k] = evidence.countOf(surfaces[k]);
  });
  Counts counts;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    CellCount& sum = counts[surfaces[k].element];
    sum = sumOf(sum, count_of[k]);
  }
  note(counts, room.boundary);
  for (PlanLoop& column : room.columns)
    note(counts, column);
  for (auto* details : {&room.details, &room.floor_details})
    for (PlanDetail& detail : *details) {
      note(counts, detail.boundary);
      for (PlanLoop& hole : detail.holes)
        note(counts, hole);
    }
  for (PlanNiche& niche : room.niches)
    note(counts, niche.boundary);
}

} // namespace

void
measureEvidence(Floorplan& plan,
                const PointView& points,
                const std::vector<int>& indices,
                double tolerance,
                unsigned threads,
                const SightLines* sight)
{
  const CubePoints cubes(points, cell_size, &indices);
  parallelBlocks(plan.rooms.size(), 1, threads, [&](std::size_t r, std::size_t) {
    measureRoom(plan.rooms[r], cubes, tolerance, threads, sight);
  });
}

} // namespace pcl::sedr
