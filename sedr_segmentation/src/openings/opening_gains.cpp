// SPDX-License-Identifier: BSD-3-Clause
#include "opening_gains.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

/** @brief What both sides of a wall show of a cell. */
struct BothSides {
  WallCell here = WallCell::Beyond;
  WallCell behind = WallCell::Beyond;
  bool is_known = false; ///< that there is a side behind

  bool isWithin() const
  {
    return here == WallCell::Within || (is_known && behind == WallCell::Within);
  }
};

/** @brief Returns a state; what rays went through is as open as what shows the inside
 * of the wall. */
WallCell
openOr(WallCell state)
{
  return state == WallCell::Through ? WallCell::Within : state;
}

class GainsOfMap {
public:
  GainsOfMap(const WallMap& map,
             const std::vector<MapBehind>& behind,
             const std::vector<bool>& is_wall,
             const OpeningWeights& weights)
      : weights_(weights)
      , columns_(map.columns())
      , rows_(map.rows())
      , cell_(map.cell())
  {
    cells_.resize(columns_ * rows_);
    for (std::size_t c = 0; c < columns_; ++c)
      for (std::size_t r = 0; r < rows_; ++r) {
        BothSides& cell = cells_[c * rows_ + r];
        if (is_wall[c])
          cell.here = openOr(map.at(c, r));
        const MapBehind& other = behind[c * rows_ + r];
        cell.is_known = other.map != nullptr;
        if (cell.is_known)
          cell.behind = openOr(other.map->at(other.along, map.heightOf(r) + cell_ / 2));
      }
  }

  double inside(std::size_t i) const
  {
    const BothSides& cell = cells_[i];
    const bool a = cell.here == WallCell::Seen;
    const bool b = cell.is_known && cell.behind == WallCell::Seen;
    double gain = 0; // a square metre
    if (cell.here == WallCell::Beyond)
      gain = opening_numbers.beyond;
    else if (a && (b || !cell.is_known))
      gain = weights_.seen;
    else if (a || b) {
      const WallCell other = a ? cell.behind : cell.here;
      gain = isHidden(other)             ? weights_.seen / 2
             : other == WallCell::Within ? weights_.within / 4
                                         : weights_.half_seen;
    }
    else if (cell.isWithin())
      gain = weights_.within;
    else if (cell.here == WallCell::Leaf ||
             (cell.is_known && cell.behind == WallCell::Leaf))
      gain = weights_.empty;
    else if (isNothing(cell.here))
      gain = !cell.is_known           ? weights_.empty_outside
             : isNothing(cell.behind) ? 2 * weights_.empty
                                      : weights_.empty;
    else if (cell.is_known && isNothing(cell.behind))
      gain = weights_.empty;
    return gain * cell_ * cell_;
  }

  /** @brief Returns the gain of an edge between two cells, `in` inside the opening. */
  double edge(const BothSides& out, const BothSides& in) const
  {
    const auto gainOf = [&](WallCell o, WallCell i) {
      if (o == WallCell::Seen && i == WallCell::Within)
        return weights_.reveal;
      if (o == WallCell::Seen && i == WallCell::Empty)
        return weights_.rim;
      if (o == WallCell::Seen && (isHidden(i) || i == WallCell::Shaded))
        return 0.0;
      if ((o == i && o != WallCell::Hidden) || (isNothing(o) && isNothing(i)))
        return weights_.no_edge;
      return weights_.unseen_edge;
    };
    double gain = gainOf(out.here, in.here);
    if (in.is_known && out.is_known)
      gain = std::max(gain, gainOf(out.behind, in.behind));
    return gain * cell_;
  }

  void addTo(CellGains& gains) const
  {
    const BothSides corner; // beyond the map: another wall
    const std::size_t n = rows_ + 1;
    gains.columns = columns_;
    gains.rows = rows_;
    for (std::size_t i = 0; i < cells_.size(); ++i)
      gains.inside.push_back(inside(i));
    for (std::size_t c = 0; c <= columns_; ++c)
      for (std::size_t r = 0; r < rows_; ++r) {
        const BothSides& before = c > 0 ? cells_[(c - 1) * rows_ + r] : corner;
        const BothSides& after = c < columns_ ? cells_[c * rows_ + r] : corner;
        gains.left.push_back(edge(before, after));
        gains.right.push_back(edge(after, before));
      }
    gains.lower.resize(columns_ * n);
    gains.upper.resize(columns_ * n);
    for (std::size_t c = 0; c < columns_; ++c) {
      for (std::size_t r = 0; r <= rows_; ++r) {
        const BothSides& below = r > 0 ? cells_[c * rows_ + r - 1] : corner;
        const BothSides& above = r < rows_ ? cells_[c * rows_ + r] : corner;
        const bool on_floor = below.here == WallCell::Beyond;
        gains.lower[c * n + r] = on_floor ? 0 : edge(below, above);
        gains.upper[c * n + r] = edge(above, below);
      }
    }
  }

private:
  const OpeningWeights& weights_;
  std::size_t columns_;
  std::size_t rows_;
  double cell_;
  std::vector<BothSides> cells_;
};

} // namespace

CellGains
openingGains(const WallMap& map,
             const std::vector<MapBehind>& behind,
             const std::vector<bool>& is_wall,
             const OpeningWeights& weights,
             const OpeningSizes& sizes)
{
  CellGains gains;
  GainsOfMap(map, behind, is_wall, weights).addTo(gains);
  const double cell = map.cell();
  const auto cellsIn = [cell](double length) {
    return static_cast<std::size_t>(std::max(1.0, std::round(length / cell)));
  };
  gains.min_columns = cellsIn(sizes.min_width);
  gains.min_rows = cellsIn(sizes.min_height);
  const double floor = map.heightOf(0) + cell / 2;
  gains.prior = [weights, sizes, floor, &map](std::size_t a, std::size_t b) {
    const double edges = 4 * (map.heightOf(b) - map.heightOf(a)); // metres, of a square
    const bool is_on_floor = map.heightOf(a) < floor + sizes.on_floor;
    const bool is_low = map.heightOf(b) - map.heightOf(a) < sizes.min_head;
    const double free_edges = is_on_floor ? 3 : 4;
    return free_edges * weights.edge * std::log(edges / opening_numbers.edge_bin) +
           (is_on_floor && is_low ? weights.low_head : 0);
  };
  return gains;
}

} // namespace pcl::sedr
