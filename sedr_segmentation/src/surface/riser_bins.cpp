// SPDX-License-Identifier: BSD-3-Clause
#include "riser_bins.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

RiserBins::RiserBins(const SheetGrid& grid,
                     const std::vector<std::uint8_t>& domain,
                     const std::vector<Eigen::Vector3d>& points,
                     double low,
                     double high)
    : bottom_(low)
{
  constexpr double bins = 64;
  bin_ = std::max(bin_, (high - low) / (bins - 1));
  own_.assign(grid.count(), 0);
  for (const Eigen::Vector3d& p : points)
    if (const std::size_t cell = grid.at(p.head<2>());
        cell < own_.size() && p.z() >= low && p.z() <= high)
      own_[cell] |= std::uint64_t{1} << static_cast<int>((p.z() - bottom_) / bin_);
  is_at_wall_.assign(grid.count(), 0);
  for (std::size_t cell = 0; cell < own_.size(); ++cell)
    grid.forAllWithin(cell, to_wall, [&](std::size_t next) {
      is_at_wall_[cell] = is_at_wall_[cell] | !domain[next];
    });
  seen_.assign(grid.count(), 0);
  for (std::size_t cell = 0; cell < own_.size(); ++cell) {
    const auto add = [&](std::size_t near) {
      if (!domain[cell] || !is_at_wall_[near])
        seen_[cell] |= own_[near];
    };
    add(cell);
    grid.forAllSides(cell, add);
  }
}

double
RiserBins::share(std::size_t cell, std::size_t next, double low, double high) const
{
  if (high - low < min_step)
    return 0;
  const double middle = std::floor(((low + high) / 2 - bottom_) / bin_);
  const double first = std::min(middle, std::ceil((low + margin - bottom_) / bin_));
  const double last =
      std::max(middle, std::floor((high - margin - bottom_) / bin_) - 1);
  const auto from = static_cast<int>(std::clamp(first, 0.0, 63.0));
  const auto count = static_cast<int>(std::clamp(last, 0.0, 63.0)) - from + 1;
  const std::uint64_t between = (~std::uint64_t{0} >> (64 - count)) << from;
  return static_cast<double>(
             __builtin_popcountll((seen_[cell] | seen_[next]) & between)) /
         count;
}

bool
RiserBins::isSeen(std::size_t cell, double low, double high) const
{
  const auto from =
      static_cast<int>(std::clamp(std::ceil((low - bottom_) / bin_), 0.0, 64.0));
  const auto to =
      static_cast<int>(std::clamp(std::floor((high - bottom_) / bin_), 0.0, 64.0));
  return from < to &&
         (own_[cell] & (~std::uint64_t{0} >> (64 - to + from)) << from) != 0;
}

} // namespace pcl::sedr
