// SPDX-License-Identifier: BSD-3-Clause
#include "opening_search.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl::sedr {
namespace {

/** @brief One leaf, and how well the scan shows it. */
struct Leaf {
  double shown = 0; ///< share of its cells, less those of what it is a part of
  double angle = 0; ///< radians from shut
};

/** @brief The leaves of an opening that stand open on one of its sides. */
struct Leaves : Leaf {
  OpeningHinge hinge = OpeningHinge::Unknown;
  bool is_left = true; ///< of the direction of the opening
};

/** @brief Returns the leaf that points beside an opening show best. It may be some
 * centimetres off the jamb's corner: leaves are thick, and hang before or behind it.
 * @param points along from the hinge, towards the other jamb */
Leaf
leafAmong(const std::vector<SidePoint>& points,
          double width,
          double low,
          double high,
          const OpeningSizes& sizes)
{
  const double cell = opening_numbers.leaf_cell;
  // The last column lies beyond the leaf, behind one that may hold its edge; the last
  // row lies above it.
  const double end = width + cell;
  const auto columns = static_cast<std::size_t>(end / cell) + 1;
  const auto leaf_rows = static_cast<std::size_t>((high - low) / cell);
  const auto rows =
      static_cast<std::size_t>((high - low + 2 * sizes.leaf_margin) / cell) + 1;
  Leaf best;
  for (int degrees = 6; degrees <= 166; degrees += 2) {
    const double angle = radians(degrees);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    // Of each cell a bit a strip that holds points, by the distance from the hinge.
    std::vector<std::uint16_t> strips(columns * rows);
    for (const SidePoint& p : points) {
      const double strip =
          8 + std::floor((p.along * s - p.offset * c) / sizes.leaf_strip);
      const double x =
          (p.along * c + p.offset * s - end) / cell + static_cast<double>(columns - 1);
      const double z = (p.height - low) / cell;
      if (strip >= 0 && strip < 16 && x >= 0 && z >= 0 &&
          x < static_cast<double>(columns) && z < static_cast<double>(rows))
        strips[static_cast<std::size_t>(x) * rows + static_cast<std::size_t>(z)] |=
            static_cast<std::uint16_t>(1U << static_cast<unsigned>(strip));
    }
    for (unsigned at = 3; at <= 11; ++at) {
      const auto share = [&](unsigned mask, std::size_t first_column,
                             std::size_t last_column, std::size_t first_row,
                             std::size_t last_row) {
        double n = 0;
        for (std::size_t x = first_column; x < last_column; ++x)
          for (std::size_t z = first_row; z < last_row; ++z)
            n += (strips[x * rows + z] & mask) != 0 ? 1 : 0;
        return n / static_cast<double>((last_column - first_column) *
                                       (last_row - first_row));
      };
      const unsigned on = 3U << at;
      const auto ofLeaf = [&](unsigned mask) {
        return share(mask, 1, columns - 2, 0, leaf_rows);
      };
      const auto ofColumn = [&](unsigned mask, std::size_t column) {
        return share(mask, column, column + 1, 0, leaf_rows);
      };
      // It reaches its end and ends there, and on one side it is free: it was seen from
      // there.
      const double shown = std::min(ofLeaf(on), std::max(ofColumn(on, columns - 4),
                                                         ofColumn(on, columns - 3))) -
                           std::min(ofLeaf(on << 3U), ofLeaf(on >> 3U)) -
                           ofColumn(on << 2U | on | on >> 2U, columns - 1) -
                           share(on, 1, columns - 2, rows - 1, rows);
      if (shown > best.shown)
        best = {shown, angle};
    }
  }
  return best;
}

/** @brief Returns an opening as the side of a wall, led on beyond both jambs, so that
 * leaves stand before it. */
WallSide
sideOf(const Floorplan& plan,
       const PlanOpening& opening,
       bool is_left,
       const OpeningSizes& sizes)
{
  const Eigen::Vector2d way = opening.end - opening.start;
  const Eigen::Vector2d left = Eigen::Vector2d(-way.y(), way.x()).normalized();
  WallSide side;
  side.line.start =
      opening.start - 1.5 * way + (is_left ? 0.5 : -0.5) * opening.depth * left;
  side.line.end = side.line.start + 4 * way;
  if (!is_left)
    std::swap(side.line.start, side.line.end);
  side.floor = opening.bottom;
  side.ceiling = opening.top + 0.5;
  const Eigen::Vector2d before =
      (opening.start + opening.end) / 2 + (is_left ? 1 : -1) * opening.depth * left;
  for (const PlanRoom& room : plan.rooms)
    if (room.id == opening.rooms[is_left ? 0 : 1])
      side.ceiling =
          std::min(side.ceiling, room.ceilingAt(before) - 2 * sizes.leaf_margin);
  return side;
}

/** @brief Returns the leaves that points before a side of an opening show best: one as
 * wide as it, or two. */
Leaves
leavesBefore(const std::vector<SidePoint>& points,
             const PlanOpening& opening,
             bool is_left,
             const OpeningSizes& sizes)
{
  const double width = opening.width();
  const double low = opening.bottom + sizes.leaf_margin;
  const double high = opening.top - sizes.leaf_margin;
  Leaves best;
  best.is_left = is_left;
  std::array<Leaf, 2> halves;
  for (const bool is_first : {true, false}) { // jamb of the side's direction
    std::vector<SidePoint> from_hinge;
    for (SidePoint p : points)
      if (p.offset > sizes.on_floor && p.height > low) {
        p.along = static_cast<float>(is_first ? p.along - 1.5 * width
                                              : 2.5 * width - p.along);
        if (std::hypot(p.along, p.offset) < width + 2 * sizes.leaf_margin)
          from_hinge.push_back(p);
      }
    if (width < sizes.max_leaf)
      if (const Leaf leaf = leafAmong(from_hinge, width, low, high, sizes);
          leaf.shown > best.shown) {
        static_cast<Leaf&>(best) = leaf;
        best.hinge = is_first == is_left ? OpeningHinge::Start : OpeningHinge::End;
      }
    if (width > sizes.min_double)
      halves[is_first ? 0 : 1] = leafAmong(from_hinge, width / 2, low, high, sizes);
  }
  if (const Leaf& worse =
          std::min(halves[0], halves[1],
                   [](const Leaf& a, const Leaf& b) { return a.shown < b.shown; });
      worse.shown > best.shown) {
    static_cast<Leaf&>(best) = worse;
    best.hinge = OpeningHinge::Both;
  }
  return best;
}

} // namespace

void
findLeaves(const Floorplan& plan,
           const PointView& points,
           const pcl::Indices* indices,
           const OpeningSizes& sizes,
           unsigned threads,
           std::vector<FoundOpening>& found)
{
  std::vector<PlanOpening*> doors;
  std::vector<WallSide> sides;
  for (FoundOpening& each : found) {
    PlanOpening& o = each.opening;
    if (each.filled > sizes.min_leaf_share || o.width() < sizes.min_double / 2 ||
        o.width() > 2 * sizes.max_leaf || o.height() < sizes.min_head ||
        o.bottom - highestFloor(plan, o) > sizes.on_floor)
      continue;
    doors.push_back(&o);
    for (const bool is_left : {true, false})
      sides.push_back(sideOf(plan, o, is_left, sizes));
  }
  const auto beside = pointsBeside(sides, points, indices, sizes.leaf_reach, 0);
  parallelFor(doors.size(), 1, threads, [&](std::size_t k) {
    PlanOpening& o = *doors[k];
    const Leaves left = leavesBefore(beside[2 * k], o, true, sizes);
    const Leaves right = leavesBefore(beside[2 * k + 1], o, false, sizes);
    const Leaves& best = right.shown > left.shown ? right : left;
    if (best.shown < sizes.min_leaf_share)
      return;
    o.hinge = best.hinge;
    if (!best.is_left) {
      std::swap(o.start, o.end);
      std::swap(o.rooms[0], o.rooms[1]);
      std::swap(o.edges[0], o.edges[1]);
      if (o.hinge != OpeningHinge::Both)
        o.hinge =
            o.hinge == OpeningHinge::Start ? OpeningHinge::End : OpeningHinge::Start;
    }
    o.swing = o.rooms[0];
    o.state = best.angle > sizes.max_ajar ? OpeningState::Open : OpeningState::Ajar;
  });
}

} // namespace pcl::sedr
