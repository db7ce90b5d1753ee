// SPDX-License-Identifier: BSD-3-Clause
#include "refit_sums.h"

#include "weighted_values.h"

#include <pcl/sedr_filters/parallel.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief Width of a bin of distances, metres. */
constexpr double bin = 0.0005;

/** @brief Adds up what `see(sums, number, patch, distance, row)` makes of all points,
 * in blocks whose number does not depend on that of the threads, so that neither does
 * the result. */
template <typename Sum, typename See>
std::vector<Sum>
overAll(const RawPoints& raw, const RefitTargets& targets, std::size_t size, See see)
{
  constexpr std::size_t most_blocks = 8;
  constexpr std::size_t least_block = std::size_t{1} << 16;
  const std::size_t n = raw.size();
  const std::size_t block = std::max(least_block, n / most_blocks + 1);
  std::vector<std::vector<Sum>> blocks((n + block - 1) / block);
  parallelBlocks(n, block, raw.threads, [&](std::size_t begin, std::size_t end) {
    std::vector<Sum> own(size);
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = raw.at(k);
      if (raw.points.isFinite(i))
        targets.visit(raw.points[i].cast<double>(),
                      [&](std::size_t t, std::size_t patch, double d,
                          const Eigen::Vector3d& row) { see(own, t, patch, d, row); });
    }
    blocks[begin / block] = std::move(own);
  });
  std::vector<Sum> sums(size);
  for (const auto& own : blocks)
    for (std::size_t i = 0; i < own.size(); ++i)
      sums[i] += own[i];
  return sums;
}

} // namespace

void
PatchSums::add(double distance, const Eigen::Vector3d& row)
{
  count += 1;
  sum += distance;
  squares += distance * distance;
  rows += row;
}

PatchSums&
PatchSums::operator+=(const PatchSums& other)
{
  count += other.count;
  sum += other.sum;
  squares += other.squares;
  rows += other.rows;
  return *this;
}

std::vector<Scatter>
scatterOf(const RawPoints& raw, const RefitTargets& targets, double reach)
{
  const auto bins = static_cast<std::size_t>(std::ceil(2 * reach / bin)) + 1;
  const auto counts =
      overAll<std::uint32_t>(raw, targets, targets.size() * bins,
                             [&](std::vector<std::uint32_t>& own, std::size_t t,
                                 std::size_t, double d, const Eigen::Vector3d&) {
                               if (2 * std::abs(d) > targets.gap(t))
                                 return;
                               const auto at =
                                   static_cast<std::size_t>((d + reach) / bin);
                               ++own[t * bins + std::min(bins - 1, at)];
                             });
  std::vector<Scatter> scatters;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    std::vector<Weighted> values;
    Scatter scatter;
    for (std::size_t i = 0; i < bins; ++i) {
      const auto count = static_cast<double>(counts[t * bins + i]);
      scatter.count += count;
      if (count > 0)
        values.push_back({(static_cast<double>(i) + 0.5) * bin - reach, count});
    }
    if (!values.empty()) {
      constexpr double quartile = 0.6745; // of the normal distribution
      const Interval half = shortestHalf(std::move(values));
      scatter.centre = half.middle;
      scatter.deviation = std::max(bin, half.width) / 2 / quartile;
    }
    scatters.push_back(scatter);
  }
  return scatters;
}

std::vector<PatchSums>
patchSums(const RawPoints& raw,
          const RefitTargets& targets,
          const std::vector<double>& centre,
          const std::vector<double>& band)
{
  return overAll<PatchSums>(raw, targets, targets.patchCount(),
                            [&](std::vector<PatchSums>& own, std::size_t t,
                                std::size_t patch, double d,
                                const Eigen::Vector3d& row) {
                              if (std::abs(d - centre[t]) <= band[t])
                                own[patch].add(d, row);
                            });
}

} // namespace sedr
} // namespace pcl
