// SPDX-License-Identifier: BSD-3-Clause
#include "opening_leaf.h"

#include <algorithm>
#include <cmath>

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

/** @brief Returns the share of the cells of a rectangle that hold points. */
class Cells {
public:
  Cells(double length, double height)
      : columns_(
            static_cast<std::size_t>(std::max(1.0, length / opening_numbers.leaf_cell)))
      , rows_(
            static_cast<std::size_t>(std::max(1.0, height / opening_numbers.leaf_cell)))
      , cells_(columns_ * rows_)
  {}

  void mark(double out, double up)
  {
    const double c = out / opening_numbers.leaf_cell;
    const double r = up / opening_numbers.leaf_cell;
    if (c >= 0 && r >= 0 && c < static_cast<double>(columns_) &&
        r < static_cast<double>(rows_))
      cells_[static_cast<std::size_t>(c) * rows_ + static_cast<std::size_t>(r)] = true;
  }

  double share() const
  {
    return static_cast<double>(std::count(cells_.begin(), cells_.end(), true)) /
           static_cast<double>(cells_.size());
  }

private:
  std::size_t columns_;
  std::size_t rows_;
  std::vector<bool> cells_;
};

/** @brief Returns the leaf that points beside an opening show best.
 * @param points along from the hinge, towards the other jamb */
Leaf
leafAmong(const std::vector<SidePoint>& points,
          double width,
          double low,
          double high,
          const OpeningSizes& sizes)
{
  Leaf best;
  for (int degrees = 20; degrees <= 165; degrees += 3) {
    const double angle = radians(degrees);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    Cells leaf(width - 2 * sizes.leaf_margin, high - low);
    Cells beyond(2 * sizes.leaf_margin, high - low);
    Cells above(width - 2 * sizes.leaf_margin, 2 * sizes.leaf_margin);
    std::array<Cells, 2> beside{leaf, leaf}; // one side is free: it was seen from there
    Cells end(opening_numbers.leaf_cell, high - low); // all that shows of it edge-on
    std::array<Cells, 2> round{end, end};             // what stands before or behind it
    const double near_end = width - 0.5 * opening_numbers.leaf_cell;
    for (const SidePoint& p : points) {
      const double off = p.along * s - p.offset * c;
      const double out = p.along * c + p.offset * s;
      if (std::abs(off) > 3 * sizes.leaf_band)
        continue;
      if (std::abs(off) < sizes.leaf_band) {
        leaf.mark(out - sizes.leaf_margin, p.height - low);
        end.mark(out - near_end, p.height - low);
      }
      else {
        round[off > 0 ? 1 : 0].mark(out - near_end, p.height - low);
        beside[off > 0 ? 1 : 0].mark(out - sizes.leaf_margin, p.height - low);
      }
      above.mark(out - sizes.leaf_margin, p.height - high - 2 * sizes.leaf_margin);
      beyond.mark(out - width - sizes.leaf_margin, p.height - low);
    }
    const double shown =
        std::max(leaf.share(), end.share() - round[0].share() - round[1].share()) -
        beyond.share() - above.share() - std::min(beside[0].share(), beside[1].share());
    if (shown > best.shown)
      best = {shown, angle};
  }
  return best;
}

/** @brief Returns an opening as the side of a wall, led on beyond both jambs, so that
 * leaves stand before it. */
WallSide
sideOf(const PlanOpening& opening, bool is_left)
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
      sides.push_back(sideOf(o, is_left));
  }
  const auto beside = pointsBeside(sides, points, indices, sizes.leaf_reach, 0);
  for (std::size_t k = 0; k < doors.size(); ++k) {
    PlanOpening& o = *doors[k];
    const Leaves left = leavesBefore(beside[2 * k], o, true, sizes);
    const Leaves right = leavesBefore(beside[2 * k + 1], o, false, sizes);
    const Leaves& best = right.shown > left.shown ? right : left;
    if (best.shown < sizes.min_leaf_share)
      continue;
    o.hinge = best.hinge;
    if (!best.is_left) {
      std::swap(o.start, o.end);
      std::swap(o.rooms[0], o.rooms[1]);
      if (o.hinge != OpeningHinge::Both)
        o.hinge =
            o.hinge == OpeningHinge::Start ? OpeningHinge::End : OpeningHinge::Start;
    }
    o.swing = o.rooms[0];
    o.state = best.angle > sizes.max_ajar ? OpeningState::Open : OpeningState::Ajar;
  }
}

} // namespace pcl::sedr
