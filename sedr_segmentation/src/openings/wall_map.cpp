// SPDX-License-Identifier: BSD-3-Clause
#include "wall_map.h"
#include "ajar_leaves.h"

#include "sedr_filters/src/base/quantiles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace pcl::sedr {

namespace {

const std::size_t none = static_cast<std::size_t>(-1);

} // namespace

WallMap::WallMap(const PlanRoom& room,
                 const WallSide& side,
                 std::vector<SidePoint> points,
                 const OpeningSizes& sizes,
                 const std::vector<SightLine>& rays,
                 const std::function<double(double, double)>& thickness)
    : length_(side.line.length())
    , base_(side.floor)
    , top_(side.ceiling)
    , before_(sizes.before)
    , points_(std::move(points))
{
  centreFace();
  chooseCell();
  base_ = side.floor - cell_ / 2;
  columns_ = static_cast<std::size_t>(std::ceil(length_ / cell_));
  rows_ = static_cast<std::size_t>(
      std::max(1.0, std::ceil((side.ceiling - base_) / cell_)));
  findExtent(room, side);
  for (std::size_t c = 0; c < columns_; ++c)
    for (std::size_t r = 0; r < rows_; ++r)
      faces_.push_back(static_cast<float>(
          thickness(cell_ * (static_cast<double>(c) + 0.5), heightOf(r) + cell_ / 2)));
  const float nearest = *std::min_element(faces_.begin(), faces_.end());
  for (const float face : faces_)
    depths_.push_back(
        std::min(std::isfinite(face) ? face : nearest,
                 static_cast<float>(std::min(sizes.shallow, sizes.max_depth))));
  count(side, rays, takeAjarLeaves(points_, side, cell_, sizes));
  closeGaps();
  findOffsets(side.line);
  points_.erase(std::remove_if(points_.begin(), points_.end(),
                               [&](const SidePoint& p) {
                                 return p.offset < -depthAt(p.along, p.height);
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

double
WallMap::depthAt(double along, double height) const
{
  const auto c =
      std::min(static_cast<std::size_t>(std::max(along / cell_, 0.0)), columns_ - 1);
  const auto r = std::min(
      static_cast<std::size_t>(std::max((height - base_) / cell_, 0.0)), rows_ - 1);
  return depths_[c * rows_ + r];
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

bool
WallMap::reachesCeiling(double along, double distance) const
{
  const auto c = static_cast<std::size_t>(std::max(0.0, along) / cell_);
  if (c >= columns_)
    return false;
  const double low = std::max(0.0, ceilings_[c] - distance - base_) / cell_;
  const auto first = std::min(static_cast<std::size_t>(low), rows_);
  const auto column = cells_.begin() + static_cast<std::ptrdiff_t>(c * rows_);
  const auto end = column + static_cast<std::ptrdiff_t>(rows_);
  return std::find(column + static_cast<std::ptrdiff_t>(first), end, WallCell::Seen) !=
         end;
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
  centre_ = middle;
}

/** @brief Makes cells as small as possible with enough points in those that were
 * seen. */
void
WallMap::chooseCell()
{
  const double height = top_ - base_;
  const double finest = std::max(height / opening_numbers.max_rows,
                                 length_ / opening_numbers.max_columns);
  for (const double size : {0.05, 0.1}) {
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

/** @brief Finds the cells around which the points of the face lie behind it on
 * average, farther than is usual on this wall: a closed leaf shows by its relief. */
std::vector<bool>
WallMap::recessedCells() const
{
  const auto reach =
      static_cast<std::size_t>(std::ceil(opening_numbers.relief_reach / cell_));
  std::vector<double> sums(columns_ * rows_); // of each cell and those around it
  std::vector<double> counts(sums.size());
  for (const SidePoint& p : points_)
    if (const std::size_t i = indexOf(p);
        i != none && std::abs(p.offset) < tolerance_) {
      const std::size_t c = i / rows_;
      const std::size_t r = i % rows_;
      for (std::size_t o = c - std::min(c, reach);
           o <= std::min(c + reach, columns_ - 1); ++o)
        for (std::size_t k = r - std::min(r, reach);
             k <= std::min(r + reach, rows_ - 1); ++k) {
          sums[o * rows_ + k] += p.offset;
          ++counts[o * rows_ + k];
        }
    }
  std::vector<double> usual;
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (counts[i] > 0)
      usual.push_back(std::abs(sums[i] /= counts[i]));
  const double limit =
      std::max(opening_numbers.min_relief,
               usual.empty() ? 0 : 4 * 1.4826 * middleValue(std::move(usual)));
  std::vector<bool> is_recessed(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    is_recessed[i] = sums[i] < -limit;
  return is_recessed;
}

/** @brief Counts a ray where it, or its continuation, meets the face: it went through,
 * or what it ended on hides the cell. */
void
WallMap::follow(const WallSide& side,
                const SightLine& ray,
                std::vector<std::uint32_t>& through,
                std::vector<std::uint32_t>& before) const
{
  const Eigen::Vector3d from = ray.from.cast<double>();
  const Eigen::Vector3d way = ray.to.cast<double>() - from;
  const double start = side.offset(from);
  const double end = side.offset(Eigen::Vector3d(from + way));
  if (std::min(std::abs(start), std::abs(end)) < opening_numbers.clear ||
      (start > 0) == (end > start))
    return; // it leads away from the face, or touches it
  double share = start / (start - end);
  for (int k = 0; k < 3 && side.line.isArc(); ++k)
    share *= start / (start - side.offset(Eigen::Vector3d(from + share * way)));
  const Eigen::Vector3d hit = from + share * way;
  const Eigen::Vector2d place = hit.head<2>();
  if (!side.line.isBeside(place))
    return;
  if (const std::size_t i = indexOf({static_cast<float>(side.line.project(place)),
                                     static_cast<float>(hit.z()), 0});
      i != none)
    ++(share < 1 ? through : before)[i];
}

/** @brief Spreads the shades of things: one shades as far beside it as it stands before
 * the face. */
void
WallMap::spread(std::vector<float>& shade) const
{
  const auto cell = static_cast<float>(cell_);
  const auto take = [&](std::size_t i, std::size_t c, std::size_t r, float way) {
    if (c < columns_ && r < rows_)
      shade[i] = std::max(shade[i], shade[c * rows_ + r] - way * cell);
  };
  const auto takeFrom = [&](std::size_t i, std::size_t step) { // 1 or -1
    const std::size_t c = i / rows_;
    const std::size_t r = i % rows_;
    take(i, c - step, r, 1);
    take(i, c, r - step, 1);
    take(i, c - step, r - step, 1.4142F);
    take(i, c - step, r + step, 1.4142F);
  };
  for (std::size_t i = 0; i < shade.size(); ++i)
    takeFrom(i, 1);
  for (std::size_t i = shade.size(); i-- > 0;)
    takeFrom(i, static_cast<std::size_t>(-1));
}

void
WallMap::count(const WallSide& side,
               const std::vector<SightLine>& rays,
               const std::vector<SidePoint>& of_leaves)
{
  std::vector<std::uint32_t> seen(columns_ * rows_);
  std::vector<std::uint32_t> within(seen.size());
  std::vector<std::uint32_t> through(seen.size());
  std::vector<std::uint32_t> before(seen.size());
  std::vector<std::uint32_t> leaf(seen.size());
  std::vector<float> shade(seen.size());
  for (const SightLine& ray : rays)
    follow(side, ray, through, before);
  for (const SidePoint& p : of_leaves)
    if (const std::size_t i = indexOf(p); i != none)
      ++leaf[i];
  for (const SidePoint& p : points_) {
    const std::size_t i = indexOf(p);
    if (i == none)
      continue;
    const std::size_t c = i / rows_;
    const double margin = slabBand();
    const bool is_slab =
        p.height < floors_[c] + margin || p.height > ceilings_[c] - margin;
    if (p.offset > before_)
      continue; // so far away it hides something else
    if (p.offset > std::max(tolerance_, opening_numbers.on_face)) {
      ++before[i];
      const bool is_wall = p.along < margin || p.along > length_ - margin;
      if (!is_slab && !is_wall)
        shade[i] = std::max(shade[i], p.offset);
    }
    else if (p.offset >= -tolerance_)
      is_slab ? ++before[i] : ++seen[i];
    else if (p.offset > -depths_[i] + tolerance_)
      ++within[i];
  }
  spread(shade);
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
      else if (leaf[i] > std::max({seen[i], within[i], through[i]}))
        cells_[i] = WallCell::Leaf;
      else if (seen[i] > std::max(needed, static_cast<double>(through[i])))
        cells_[i] = is_recessed[i] ? WallCell::Within : WallCell::Seen;
      else if (within[i] > 0)
        cells_[i] = WallCell::Within;
      else if (through[i] > 0)
        cells_[i] = WallCell::Through;
      else if (before[i] > 0)
        cells_[i] = WallCell::Hidden;
      else if (shade[i] > 0)
        cells_[i] = WallCell::Shaded;
    }
}

void
WallMap::findOffsets(const PlanElement& line)
{
  const double noise = 3 * line.residual;
  const double on = std::max(opening_numbers.on_model, noise);
  const double edge = std::max(opening_numbers.off_edge, noise);
  constexpr float nothing = -std::numeric_limits<float>::infinity();
  offsets_.assign(cells_.size(), nothing);
  farthest_.assign(cells_.size(), 0);
  ceiling_ = CeilingBeside(columns_, edge);
  for (const SidePoint& p : points_) {
    const float offset = p.offset + static_cast<float>(centre_);
    const auto c = static_cast<std::size_t>(std::max(p.along, 0.0F) / cell_);
    if (c >= columns_ || p.height < floors_[c] + opening_numbers.on_face ||
        p.height > ceilings_[c] + opening_numbers.on_face)
      continue;
    if (p.height > ceilings_[c] - opening_numbers.on_face) {
      ceiling_.add(c, offset);
      continue;
    }
    const std::size_t i = indexOf(p);
    if (i == none)
      continue;
    if (p.offset > tolerance_ - faces_[i])
      farthest_[i] = std::min(farthest_[i], offset);
    float& nearest = offsets_[i];
    if (std::abs(offset) <= on)
      nearest = 0;
    else if (offset > 0 ? nearest < 0 || nearest > offset : nearest < offset)
      nearest = offset;
  }
  ceiling_.measure(noise);
}

/** @brief Makes cells without points between seen ones of a row seen where the gap is
 * narrower than any opening: points are sparse there. */
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
        if (WallCell& cell = cells_[k * rows_ + r]; isNothing(cell))
          cell = WallCell::Seen;
      last = c;
    }
}

} // namespace pcl::sedr
