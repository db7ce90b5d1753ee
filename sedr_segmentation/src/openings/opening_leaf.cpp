// SPDX-License-Identifier: BSD-3-Clause
#include "opening_leaf.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

/** @brief A leaf that stands open before a side, and how well the scan shows it. */
struct Leaf {
  double shown = 0; ///< share of its cells
  double angle = 0; ///< radians from shut
  bool is_at_from = true;
};

/** @brief Cells of a vertical sheet from a hinge outwards. */
class SheetCells {
public:
  SheetCells(double length, double height)
      : columns_(
            static_cast<std::size_t>(std::max(1.0, length / opening_numbers.leaf_cell)))
      , rows_(
            static_cast<std::size_t>(std::max(1.0, height / opening_numbers.leaf_cell)))
      , cells_(columns_ * rows_)
  {}

  /** @brief Marks a place `out` from the beginning, `up` from the lower edge. */
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

/** @brief Returns the leaf that a side shows best. */
Leaf
leafBefore(const WallMap& map, const WallRectangle& door, const OpeningSizes& sizes)
{
  const double width = door.to - door.from;
  const double low = door.bottom + sizes.leaf_margin;
  const double high = door.top - sizes.leaf_margin;
  std::vector<SidePoint> near;
  for (const SidePoint& p : map.points())
    if (p.offset > sizes.on_floor && p.height > low && p.height < high &&
        p.along > door.from - 1.5 * width && p.along < door.to + 1.5 * width)
      near.push_back(p);
  Leaf best;
  for (const bool is_at_from : {true, false})
    for (int degrees = 20; degrees <= 165; degrees += 5) {
      const double angle = radians(degrees);
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      SheetCells leaf(width - 2 * sizes.leaf_margin, high - low);
      SheetCells beyond(2 * sizes.leaf_margin, high - low);
      for (const SidePoint& p : near) {
        const double along = is_at_from ? p.along - door.from : door.to - p.along;
        if (std::abs(along * s - p.offset * c) > sizes.leaf_band)
          continue;
        const double out = along * c + p.offset * s;
        leaf.mark(out - sizes.leaf_margin, p.height - low);
        beyond.mark(out - width - sizes.leaf_margin, p.height - low);
      }
      const double shown = leaf.share() - beyond.share();
      if (shown > best.shown)
        best = {shown, angle, is_at_from};
    }
  return best;
}

} // namespace

void
findLeaves(const Floorplan& plan,
           OpeningSearch& search,
           const OpeningParameters& parameters)
{
  const OpeningSizes& sizes = parameters.sizes;
  for (FoundOpening& found : search.found) {
    PlanOpening& o = found.opening;
    if (o.kind != OpeningKind::Door || o.width() > sizes.max_leaf)
      continue;
    if (found.features[9] > sizes.min_leaf_share) {
      o.state = OpeningState::Closed;
      continue;
    }
    Leaf leaf = leafBefore(search.maps[found.side], found.rectangle, sizes);
    bool is_before = true; // the side on whose map the opening was found
    if (found.behind < search.sides.size()) {
      const WallSide& other = search.sides[found.behind];
      WallRectangle door = found.rectangle;
      door.from = other.line.project(o.end);
      door.to = other.line.project(o.start);
      const Leaf behind = leafBefore(search.maps[found.behind], door, sizes);
      if (behind.shown > leaf.shown) {
        leaf = behind;
        leaf.is_at_from = !behind.is_at_from; // it runs the other way
        is_before = false;
      }
    }
    if (leaf.shown < sizes.min_leaf_share)
      continue;
    o.hinge = leaf.is_at_from ? OpeningHinge::Start : OpeningHinge::End;
    o.swing = is_before ? plan.rooms[search.sides[found.side].room].id : o.rooms[1];
    o.state = leaf.angle > sizes.max_ajar ? OpeningState::Open : OpeningState::Ajar;
  }
}

} // namespace pcl::sedr
