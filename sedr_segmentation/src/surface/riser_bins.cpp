// SPDX-License-Identifier: BSD-3-Clause
#include "riser_bins.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

RiserBins::RiserBins(const SheetGrid& grid,
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
  seen_ = own_;
  for (std::size_t cell = 0; cell < own_.size(); ++cell)
    grid.forAllSides(cell, [&](std::size_t next) { seen_[cell] |= own_[next]; });
}

double
RiserBins::share(std::size_t cell, std::size_t next, double low, double high) const
{
  constexpr double margin = 0.03; // metres: noise of the surfaces
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
RiserBins::isBelow(std::size_t cell, double height) const
{
  const double end = std::floor((height - min_step - bottom_) / bin_);
  const auto bins = static_cast<int>(std::clamp(end, 0.0, 64.0));
  return bins > 0 && (own_[cell] & (~std::uint64_t{0} >> (64 - bins))) != 0;
}

} // namespace pcl::sedr
