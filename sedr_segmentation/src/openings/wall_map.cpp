// SPDX-License-Identifier: BSD-3-Clause
#include "wall_map.h"

#include "sedr_filters/src/base/middle_value.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::sedr {

namespace {

constexpr double band = 0.06;          ///< of the points that show the noise, metres
constexpr double min_tolerance = 0.02; ///< metres
constexpr double slab = 0.04;    ///< of points of floor and ceiling, metres
constexpr double on_face = 0.05; ///< of boards and casings on a wall, metres
constexpr std::size_t none = static_cast<std::size_t>(-1);

/** @brief Sums over rectangles of cells. */
class SumTable {
public:
  SumTable(std::size_t columns, std::size_t rows)
      : rows_(rows)
      , sums_((columns + 1) * (rows + 1))
  {}

  /** @brief Sets the values column by column. */
  template <typename Value>
  void fill(const Value& value)
  {
    const std::size_t n = rows_ + 1;
    for (std::size_t i = n; i < sums_.size(); ++i)
      if (i % n != 0)
        sums_[i] = value((i / n - 1) * rows_ + i % n - 1) + sums_[i - 1] +
                   sums_[i - n] - sums_[i - n - 1];
  }

  double over(std::size_t c0, std::size_t c1, std::size_t r0, std::size_t r1) const
  {
    const std::size_t n = rows_ + 1;
    return sums_[c1 * n + r1] - sums_[c0 * n + r1] - sums_[c1 * n + r0] +
           sums_[c0 * n + r0];
  }

private:
  std::size_t rows_;
  std::vector<double> sums_;
};

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
  points_.erase(std::remove_if(points_.begin(), points_.end(),
                               [&](const SidePoint& p) {
                                 return p.offset > tolerance_ || p.offset < -depth_;
                               }),
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

/** @brief Finds the floor and the ceiling beside each column; what is above and below is
 * in no room. */
void
WallMap::findExtent(const PlanRoom& room, const WallSide& side)
{
  constexpr double inside = 0.05;
  for (std::size_t c = 0; c < columns_; ++c) {
    const double s = std::min(cell_ * (static_cast<double>(c) + 0.5), length_);
    const Eigen::Vector2d p = side.line.pointAt(s) + inside * side.line.normalAt(s);
    floors_.push_back(room.floorAt(p));
    ceilings_.push_back(room.ceilingAt(p));
  }
}

double
WallMap::seenHeight(double along) const
{
  const auto c = static_cast<std::size_t>(std::max(0.0, along) / cell_);
  if (c >= columns_)
    return 0;
  const auto column = cells_.begin() + static_cast<std::ptrdiff_t>(c * rows_);
  return cell_ * static_cast<double>(
                     std::count(column, column + static_cast<std::ptrdiff_t>(rows_),
                                WallCell::Seen));
}

/** @brief Moves the points so that those of the face have offset 0, and estimates their
 * noise. */
void
WallMap::centreFace()
{
  std::vector<double> offsets;
  for (const SidePoint& p : points_)
    if (std::abs(p.offset) < band)
      offsets.push_back(p.offset);
  constexpr std::size_t few = 50;
  if (offsets.size() < few)
    return;
  const double middle = middleValue(offsets);
  for (double& offset : offsets)
    offset = std::abs(offset - middle);
  constexpr double normal = 1.4826; // standard deviation over median deviation
  tolerance_ = std::clamp(3 * normal * middleValue(std::move(offsets)), min_tolerance,
                          band);
  for (SidePoint& p : points_)
    p.offset -= static_cast<float>(middle);
}

/** @brief Makes cells as small as possible with enough points in those that were
 * seen. */
void
WallMap::chooseCell()
{
  constexpr double enough = 3;
  for (const double size : {0.025, 0.05, 0.1}) {
    cell_ = size;
    columns_ = static_cast<std::size_t>(std::ceil(length_ / cell_));
    rows_ = static_cast<std::size_t>(
        std::max(1.0, std::ceil((top_ - base_) / cell_)));
    std::vector<std::uint32_t> counts(columns_ * rows_);
    for (const SidePoint& p : points_)
      if (const std::size_t i = indexOf(p); i != none && std::abs(p.offset) < tolerance_)
        ++counts[i];
    std::vector<double> filled;
    for (const std::uint32_t n : counts)
      if (n > 0)
        filled.push_back(n);
    if (!filled.empty() && middleValue(std::move(filled)) >= enough)
      return;
  }
}

/** @brief Reduces the depth to where another face begins: points behind cells that were
 * seen. */
void
WallMap::findDepth()
{
  constexpr double bin = 0.01;
  constexpr double share = 0.1;  // of the cells that were seen, in one bin
  constexpr double min_depth = 0.05; // of the thinnest wall
  std::vector<std::uint8_t> is_seen(columns_ * rows_);
  for (const SidePoint& p : points_)
    if (const std::size_t i = indexOf(p); i != none && std::abs(p.offset) < tolerance_)
      is_seen[i] = 1;
  const double n = std::accumulate(is_seen.begin(), is_seen.end(), 0.0);
  std::vector<std::vector<std::size_t>> behind(
      static_cast<std::size_t>(depth_ / bin) + 1);
  for (const SidePoint& p : points_)
    if (const std::size_t i = indexOf(p); i != none && is_seen[i] != 0 &&
                                          p.offset < -std::max(min_depth, 2 * tolerance_) &&
                                          p.offset > -depth_)
      behind[static_cast<std::size_t>(-p.offset / bin)].push_back(i);
  for (std::size_t b = 0; b < behind.size(); ++b) {
    std::sort(behind[b].begin(), behind[b].end());
    const auto cells = std::unique(behind[b].begin(), behind[b].end()) -
                       behind[b].begin();
    if (static_cast<double>(cells) > share * n && cells > 20) {
      depth_ = bin * static_cast<double>(b);
      return;
    }
  }
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
    const double margin = std::max(slab, cell_ / 2);
    const bool is_slab =
        p.height < floors_[c] + margin || p.height > ceilings_[c] - margin;
    if (p.offset > std::max(tolerance_, on_face))
      ++before[i];
    else if (p.offset >= -tolerance_)
      is_slab ? ++before[i] : ++seen[i];
    else if (p.offset > -depth_ + tolerance_)
      ++within[i];
  }
  // A face that was seen has about as many points as others near it; glass has not.
  constexpr double share = 0.25;
  constexpr double least = 0.15; // of the points in a middle cell of the wall
  constexpr double around = 0.5; // metres
  std::vector<double> filled;
  for (const std::uint32_t n : seen)
    if (n > 0)
      filled.push_back(n);
  const double usual = filled.empty() ? 1 : middleValue(std::move(filled));
  SumTable sums(columns_, rows_);
  SumTable numbers(columns_, rows_);
  sums.fill([&](std::size_t i) { return static_cast<double>(seen[i]); });
  numbers.fill([&](std::size_t i) { return seen[i] > 0 ? 1.0 : 0.0; });
  const auto reach = static_cast<std::size_t>(around / cell_);
  cells_.assign(seen.size(), WallCell::Empty);
  for (std::size_t c = 0; c < columns_; ++c)
    for (std::size_t r = 0; r < rows_; ++r) {
      const std::size_t c0 = c - std::min(c, reach);
      const std::size_t c1 = std::min(c + reach + 1, columns_);
      const std::size_t r0 = r - std::min(r, reach);
      const std::size_t r1 = std::min(r + reach + 1, rows_);
      const double mean = sums.over(c0, c1, r0, r1) /
                          std::max(1.0, numbers.over(c0, c1, r0, r1));
      const double expected = std::max(mean, least * usual / share);
      const std::size_t i = c * rows_ + r;
      const double needed = std::max(1.0, share * expected);
      if (heightOf(r) + cell_ < floors_[c] || heightOf(r + 1) > ceilings_[c])
        cells_[i] = WallCell::Beyond;
      else if (seen[i] >= needed)
        cells_[i] = WallCell::Seen;
      else if (within[i] >= std::max(1.0, 0.5 * needed))
        cells_[i] = WallCell::Within;
      else if (before[i] >= needed)
        cells_[i] = WallCell::Hidden;
    }
}

double
faceOffset(const WallSide& side,
           const std::vector<SidePoint>& points,
           const OpeningSizes& sizes)
{
  constexpr double bin = 0.02;       // metres
  constexpr double stretch = 0.1;    // metres along the side
  constexpr double below = 0.5;      // the ceiling: where walls are seen, no furniture
  constexpr double few = 0.25;       // of the length on a line that is no face
  constexpr double most = 0.6;       // of the length on a face
  const auto bins = static_cast<std::size_t>(sizes.max_depth / bin) + 1;
  const auto parts = static_cast<std::size_t>(side.line.length() / stretch) + 1;
  std::vector<std::vector<bool>> shown(bins, std::vector<bool>(parts));
  for (const SidePoint& p : points)
    if (p.offset >= -bin / 2 && p.height > side.ceiling - below &&
        p.height < side.ceiling - slab)
      if (const auto b = static_cast<std::size_t>((p.offset + bin / 2) / bin); b < bins)
        shown[b][std::min(static_cast<std::size_t>(p.along / stretch), parts - 1)] =
            true;
  const auto shareOf = [&](std::size_t b) {
    return static_cast<double>(std::count(shown[b].begin(), shown[b].end(), true)) /
           static_cast<double>(parts);
  };
  std::size_t best = 0;
  for (std::size_t b = 1; b < bins; ++b)
    if (shareOf(b) > shareOf(best))
      best = b;
  const double on_line = std::max(shareOf(0), shareOf(1));
  return on_line < few && shareOf(best) > most ? bin * static_cast<double>(best) : 0;
}

namespace {

/** @brief Which sides are near a place in plan. */
class SideGrid {
public:
  SideGrid(const std::vector<WallSide>& sides, double reach)
  {
    Eigen::AlignedBox2d all;
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const WallSide& side : sides) {
      boxes.push_back(boxAround(side.line));
      boxes.back().extend(boxes.back().min() - Eigen::Vector2d::Constant(reach));
      boxes.back().extend(boxes.back().max() + Eigen::Vector2d::Constant(reach));
      all.extend(boxes.back());
    }
    if (sides.empty())
      return;
    origin_ = all.min();
    columns_ = static_cast<std::size_t>(all.sizes().x() / size) + 1;
    rows_ = static_cast<std::size_t>(all.sizes().y() / size) + 1;
    sides_.resize(columns_ * rows_);
    for (std::uint32_t k = 0; k < sides.size(); ++k)
      for (std::size_t i = 0; i < sides_.size(); ++i) {
        const Eigen::Vector2d middle =
            origin_ + size * Eigen::Vector2d(static_cast<double>(i % columns_) + 0.5,
                                             static_cast<double>(i / columns_) + 0.5);
        if (boxes[k].exteriorDistance(middle) < size &&
            sides[k].line.distance(middle) < reach + size)
          sides_[i].push_back(k);
      }
  }

  const std::vector<std::uint32_t>& near(const Eigen::Vector2d& p) const
  {
    static const std::vector<std::uint32_t> nothing;
    const Eigen::Vector2d at = (p - origin_) / size;
    if (!(at.x() >= 0 && at.y() >= 0 && at.x() < static_cast<double>(columns_) &&
          at.y() < static_cast<double>(rows_)))
      return nothing;
    return sides_[static_cast<std::size_t>(at.y()) * columns_ +
                  static_cast<std::size_t>(at.x())];
  }

private:
  static constexpr double size = 0.5; ///< of a cell, metres
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
             const OpeningSizes& sizes,
             unsigned)
{
  std::vector<std::vector<SidePoint>> beside(sides.size());
  const SideGrid grid(sides, std::max(sizes.before, sizes.max_depth));
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
      if (offset > sizes.before || offset < -sizes.max_depth ||
          !side.line.isBeside(place))
        continue;
      beside[s].push_back({static_cast<float>(side.line.project(place)), p.z(),
                           static_cast<float>(offset)});
    }
  }
  return beside;
}

} // namespace pcl::sedr
