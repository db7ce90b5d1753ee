// SPDX-License-Identifier: BSD-3-Clause
#include "wall_map.h"

#include "sedr_filters/src/base/middle_value.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::sedr {

namespace {

const std::size_t none = static_cast<std::size_t>(-1);

} // namespace

WallMap::WallMap(const PlanRoom& room,
                 const WallSide& side,
                 std::vector<SidePoint> points,
                 double depth,
                 const OpeningSizes& sizes)
    : length_(side.line.length())
    , base_(side.floor)
    , top_(side.ceiling)
    , depth_(std::min(depth, sizes.max_depth))
    , before_(sizes.before)
    , points_(std::move(points))
{
  centreFace();
  chooseCell();
  base_ = side.floor - cell_ / 2;
  columns_ = static_cast<std::size_t>(std::ceil(length_ / cell_));
  rows_ = static_cast<std::size_t>(
      std::max(1.0, std::ceil((side.ceiling - base_) / cell_)));
  findDepth();
  findExtent(room, side);
  count();
  closeGaps();
  points_.erase(std::remove_if(points_.begin(), points_.end(),
                               [&](const SidePoint& p) { return p.offset < -depth_; }),
                points_.end());
}

std::size_t
WallMap::indexOf(const SidePoint& p) const
{
  const double c = std::floor(p.along / cell_);
  const double r = std::floor((p.height - base_) / cell_);
  if (!(c >= 0 && r >= 0 && c < static_cast<double>(columns_) &&
        r < static_cast<double>(rows_)))
    return none;
  return static_cast<std::size_t>(c) * rows_ + static_cast<std::size_t>(r);
}

WallCell
WallMap::at(double along, double height) const
{
  const std::size_t i =
      indexOf({static_cast<float>(along), static_cast<float>(height), 0});
  return i == none ? WallCell::Beyond : cells_[i];
}

/** @brief Finds the floor and the ceiling beside each column; what is above and below
 * is in no room. */
void
WallMap::findExtent(const PlanRoom& room, const WallSide& side)
{
  for (std::size_t c = 0; c < columns_; ++c) {
    const double s = std::min(cell_ * (static_cast<double>(c) + 0.5), length_);
    const Eigen::Vector2d p =
        side.line.pointAt(s) + opening_numbers.inside * side.line.normalAt(s);
    floors_.push_back(room.floorAt(p));
    ceilings_.push_back(room.ceilingAt(p));
  }
}

double
WallMap::shareOf(WallCell state, double from, double to, double bottom, double top)
    const
{
  std::size_t count = 0;
  std::size_t all = 0;
  for (double s = from + cell_ / 2; s < to; s += cell_)
    for (double z = bottom + cell_ / 2; z < top; z += cell_) {
      ++all;
      count += at(s, z) == state ? 1 : 0;
    }
  return all > 0 ? static_cast<double>(count) / static_cast<double>(all) : 0;
}

double
WallMap::seenHeight(double along) const
{
  const auto c = static_cast<std::size_t>(std::max(0.0, along) / cell_);
  if (c >= columns_)
    return 0;
  const auto column = cells_.begin() + static_cast<std::ptrdiff_t>(c * rows_);
  return cell_ *
         static_cast<double>(std::count(
             column, column + static_cast<std::ptrdiff_t>(rows_), WallCell::Seen));
}

/** @brief Moves the points so that those of the face have offset 0, and estimates their
 * noise. */
void
WallMap::centreFace()
{
  std::vector<double> offsets;
  for (const SidePoint& p : points_)
    if (std::abs(p.offset) < opening_numbers.noise_band)
      offsets.push_back(p.offset);
  if (offsets.size() < opening_numbers.min_points)
    return;
  const double middle = middleValue(offsets);
  for (double& offset : offsets)
    offset = std::abs(offset - middle);
  tolerance_ = std::clamp(3 * 1.4826 * middleValue(std::move(offsets)),
                          opening_numbers.min_tolerance, opening_numbers.noise_band);
  for (SidePoint& p : points_)
    p.offset -= static_cast<float>(middle);
}

/** @brief Makes cells as small as possible with enough points in those that were
 * seen. */
void
WallMap::chooseCell()
{
  const double height = top_ - base_;
  const double finest = std::max(height / opening_numbers.max_rows,
                                 length_ / opening_numbers.max_columns);
  for (const double size : {0.025, 0.05, 0.1}) {
    cell_ = std::max(size, finest);
    columns_ = static_cast<std::size_t>(std::ceil(length_ / cell_));
    rows_ = static_cast<std::size_t>(std::max(1.0, std::ceil(height / cell_)));
    std::vector<std::uint32_t> counts(columns_ * rows_);
    for (const SidePoint& p : points_)
      if (const std::size_t i = indexOf(p);
          i != none && std::abs(p.offset) < tolerance_)
        ++counts[i];
    std::vector<double> filled;
    for (const std::uint32_t n : counts)
      if (n > 0)
        filled.push_back(n);
    if (!filled.empty() &&
        middleValue(std::move(filled)) >= opening_numbers.cell_points)
      return;
  }
}

/** @brief Reduces the depth to where another face begins: points behind cells that were
 * seen. */
void
WallMap::findDepth()
{
  std::vector<std::uint8_t> is_seen(columns_ * rows_);
  for (const SidePoint& p : points_)
    if (const std::size_t i = indexOf(p); i != none && std::abs(p.offset) < tolerance_)
      is_seen[i] = 1;
  // Cells at the rim of an opening show both the face and what is within the wall.
  const std::vector<std::uint8_t> all = is_seen;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const std::size_t step : {std::size_t{1}, rows_})
      if (i < step || i + step >= all.size() || all[i - step] == 0 ||
          all[i + step] == 0)
        is_seen[i] = 0;
  const double n = std::accumulate(is_seen.begin(), is_seen.end(), 0.0);
  std::vector<std::vector<std::size_t>> behind(
      static_cast<std::size_t>(depth_ / opening_numbers.depth_bin) + 1);
  for (const SidePoint& p : points_)
    if (const std::size_t i = indexOf(p);
        i != none && is_seen[i] != 0 &&
        p.offset < -std::max(opening_numbers.min_depth, 2 * tolerance_) &&
        p.offset > -depth_)
      behind[static_cast<std::size_t>(-p.offset / opening_numbers.depth_bin)].push_back(
          i);
  for (std::size_t b = 0; b < behind.size(); ++b) {
    std::sort(behind[b].begin(), behind[b].end());
    const auto cells =
        std::unique(behind[b].begin(), behind[b].end()) - behind[b].begin();
    if (static_cast<double>(cells) > opening_numbers.back_share * n && cells > 20) {
      depth_ = opening_numbers.depth_bin * static_cast<double>(b);
      return;
    }
  }
}

/** @brief Finds the cells around which the points of the face lie behind it on
 * average, farther than is usual on this wall: a closed leaf shows by its relief. */
std::vector<bool>
WallMap::recessedCells() const
{
  std::vector<double> offsets(columns_ * rows_);
  std::vector<double> counts(offsets.size());
  for (const SidePoint& p : points_)
    if (const std::size_t i = indexOf(p);
        i != none && std::abs(p.offset) < tolerance_) {
      offsets[i] += p.offset;
      ++counts[i];
    }
  const auto reach =
      static_cast<std::size_t>(std::ceil(opening_numbers.relief_reach / cell_));
  std::vector<double> means(offsets.size());
  std::vector<double> usual;
  for (std::size_t c = 0; c < columns_; ++c)
    for (std::size_t r = 0; r < rows_; ++r) {
      double sum = 0;
      double n = 0;
      for (std::size_t o = c - std::min(c, reach);
           o <= std::min(c + reach, columns_ - 1); ++o)
        for (std::size_t i = o * rows_ + r - std::min(r, reach);
             i <= o * rows_ + std::min(r + reach, rows_ - 1); ++i) {
          sum += offsets[i];
          n += counts[i];
        }
      means[c * rows_ + r] = sum / std::max(1.0, n);
      if (n > 0)
        usual.push_back(std::abs(means[c * rows_ + r]));
    }
  const double limit =
      std::max(opening_numbers.min_relief,
               usual.empty() ? 0 : 4 * 1.4826 * middleValue(std::move(usual)));
  std::vector<bool> is_recessed(means.size());
  for (std::size_t i = 0; i < means.size(); ++i)
    is_recessed[i] = means[i] < -limit;
  return is_recessed;
}

void
WallMap::count()
{
  std::vector<std::uint32_t> seen(columns_ * rows_);
  std::vector<std::uint32_t> within(seen.size());
  std::vector<std::uint32_t> before(seen.size());
  for (const SidePoint& p : points_) {
    const std::size_t i = indexOf(p);
    if (i == none)
      continue;
    const std::size_t c = i / rows_;
    const double margin = std::max(opening_numbers.slab_band, cell_ / 2);
    const bool is_slab =
        p.height < floors_[c] + margin || p.height > ceilings_[c] - margin;
    if (p.offset > before_)
      continue; // so far away it hides something else
    if (p.offset > std::max(tolerance_, opening_numbers.on_face))
      ++before[i];
    else if (p.offset >= -tolerance_)
      is_slab ? ++before[i] : ++seen[i];
    else if (p.offset > -depth_ + tolerance_)
      ++within[i];
  }
  const std::vector<bool> is_recessed = recessedCells();
  std::vector<double> filled;
  for (const std::uint32_t n : seen)
    if (n > 0)
      filled.push_back(n);
  const double needed =
      filled.empty() ? 1 : opening_numbers.least_share * middleValue(std::move(filled));
  cells_.assign(seen.size(), WallCell::Empty);
  for (std::size_t c = 0; c < columns_; ++c)
    for (std::size_t r = 0; r < rows_; ++r) {
      const std::size_t i = c * rows_ + r;
      if (heightOf(r) + cell_ < floors_[c] || heightOf(r + 1) > ceilings_[c])
        cells_[i] = WallCell::Beyond;
      else if (seen[i] > needed)
        cells_[i] = is_recessed[i] ? WallCell::Within : WallCell::Seen;
      else if (within[i] > 0)
        cells_[i] = WallCell::Within;
      else if (before[i] > 0)
        cells_[i] = WallCell::Hidden;
    }
}

/** @brief Makes empty cells between seen ones of a row seen where the gap is narrower
 * than any opening: points are sparse there. */
void
WallMap::closeGaps()
{
  const auto widest =
      static_cast<std::size_t>(std::round(opening_numbers.sparse_gap / cell_));
  for (std::size_t r = 0; r < rows_; ++r)
    for (std::size_t c = 0, last = none; c < columns_; ++c) {
      if (at(c, r) != WallCell::Seen)
        continue;
      for (std::size_t k = last != none && c - last <= widest + 1 ? last + 1 : c; k < c;
           ++k)
        if (WallCell& cell = cells_[k * rows_ + r]; cell == WallCell::Empty)
          cell = WallCell::Seen;
      last = c;
    }
}

namespace {

/** @brief Which sides are near a place in plan. */
class SideGrid {
public:
  SideGrid(const std::vector<WallSide>& sides, double reach)
  {
    if (sides.empty())
      return;
    Eigen::AlignedBox2d all;
    for (const WallSide& side : sides)
      all.extend(boxAround(side.line));
    origin_ = all.min() - Eigen::Vector2d::Constant(reach);
    const double cell = opening_numbers.grid_cell;
    const Eigen::Vector2d size = all.sizes() + Eigen::Vector2d::Constant(2 * reach);
    columns_ = static_cast<std::size_t>(size.x() / cell) + 1;
    rows_ = static_cast<std::size_t>(size.y() / cell) + 1;
    sides_.resize(columns_ * rows_);
    for (std::size_t r = 0; r < rows_; ++r)
      for (std::size_t c = 0; c < columns_; ++c) {
        const Eigen::Vector2d middle =
            origin_ + cell * Eigen::Vector2d(static_cast<double>(c) + 0.5,
                                             static_cast<double>(r) + 0.5);
        for (std::uint32_t k = 0; k < sides.size(); ++k)
          if (sides[k].line.distance(middle) < reach + cell)
            sides_[r * columns_ + c].push_back(k);
      }
  }

  const std::vector<std::uint32_t>& near(const Eigen::Vector2d& p) const
  {
    static const std::vector<std::uint32_t> nothing;
    const Eigen::Vector2d at = (p - origin_) / opening_numbers.grid_cell;
    if (!(at.x() >= 0 && at.y() >= 0 && at.x() < static_cast<double>(columns_) &&
          at.y() < static_cast<double>(rows_)))
      return nothing;
    return sides_[static_cast<std::size_t>(at.y()) * columns_ +
                  static_cast<std::size_t>(at.x())];
  }

private:
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::vector<std::uint32_t>> sides_;
};

} // namespace

std::vector<std::vector<SidePoint>>
pointsBeside(const std::vector<WallSide>& sides,
             const PointView& points,
             const pcl::Indices* indices,
             double before,
             double behind)
{
  std::vector<std::vector<SidePoint>> beside(sides.size());
  const SideGrid grid(sides, std::max(before, behind));
  const std::size_t n = indices ? indices->size() : points.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Eigen::Vector3f p =
        points[indices ? static_cast<std::size_t>((*indices)[k]) : k];
    if (!p.allFinite())
      continue;
    const Eigen::Vector2d place = p.head<2>().cast<double>();
    for (const std::uint32_t s : grid.near(place)) {
      const WallSide& side = sides[s];
      if (p.z() < side.floor - 0.1 || p.z() > side.ceiling + 0.1)
        continue;
      const double offset = side.offset(place);
      if (offset > before || offset < -behind || !side.line.isBeside(place))
        continue;
      beside[s].push_back({static_cast<float>(side.line.project(place)), p.z(),
                           static_cast<float>(offset)});
    }
  }
  return beside;
}

} // namespace pcl::sedr
