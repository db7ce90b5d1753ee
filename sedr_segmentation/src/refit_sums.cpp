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

/** @brief A slab that moves farther may be shown by points that were not seen before,
 * metres. */
constexpr double farthest_slab = 0.05;

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

Sightings::Sightings(const RawPoints& raw, const RefitTargets& targets)
    : raw_(raw)
    , targets_(targets)
{
  find();
}

/** @brief In blocks whose number does not depend on that of the threads, so that no sum
 * over them does. */
void
Sightings::find()
{
  constexpr std::size_t most_blocks = 8;
  constexpr std::size_t least_block = std::size_t{1} << 16;
  // A slab that leans otherwise than before is a little farther from a point.
  const double far = targets_.reach() + 2 * farthest_slab;
  slabs_were_.clear();
  for (std::size_t k = 0; k < targets_.slabCount(); ++k)
    slabs_were_.push_back(targets_.slab(k));
  const std::size_t n = raw_.size();
  const std::size_t block = std::max(least_block, n / most_blocks + 1);
  blocks_.assign((n + block - 1) / block, {});
  parallelBlocks(n, block, raw_.threads, [&](std::size_t begin, std::size_t end) {
    std::vector<Sighting> own;
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = raw_.at(k);
      if (raw_.points.isFinite(i))
        targets_.candidates(raw_.points[i].cast<double>(), far,
                            [&](std::size_t candidate) {
                              own.push_back({static_cast<std::uint32_t>(i),
                                             static_cast<std::uint32_t>(candidate)});
                            });
    }
    blocks_[begin / block] = std::move(own);
  });
}

bool
Sightings::areAll() const
{
  return targets_.farthestMove(slabs_were_) <= farthest_slab;
}

void
Sightings::update()
{
  if (!areAll())
    find();
}

/** @brief Adds up what `see(sums, number, patch, distance, row)` makes of all points
 * within reach of a surface. */
template <typename Sum, typename See>
std::vector<Sum>
Sightings::overAll(std::size_t size, See see) const
{
  std::vector<std::vector<Sum>> blocks(blocks_.size());
  parallelBlocks(blocks.size(), 1, raw_.threads, [&](std::size_t b, std::size_t) {
    std::vector<Sum> own(size);
    for (const Sighting& s : blocks_[b])
      targets_.look(s.candidate, raw_.points[s.point].cast<double>(),
                    [&](std::size_t t, std::size_t patch, double d,
                        const Eigen::Vector3d& row) { see(own, t, patch, d, row); });
    blocks[b] = std::move(own);
  });
  std::vector<Sum> sums(size);
  for (const auto& own : blocks)
    for (std::size_t i = 0; i < own.size(); ++i)
      sums[i] += own[i];
  return sums;
}

std::vector<Scatter>
Sightings::scatters(double reach) const
{
  const auto bins = static_cast<std::size_t>(std::ceil(2 * reach / bin)) + 1;
  const auto counts = overAll<std::uint32_t>(
      targets_.size() * bins, [&](std::vector<std::uint32_t>& own, std::size_t t,
                                  std::size_t, double d, const Eigen::Vector3d&) {
        if (2 * std::abs(d) > targets_.gap(t))
          return;
        const auto at = static_cast<std::size_t>((d + reach) / bin);
        ++own[t * bins + std::min(bins - 1, at)];
      });
  std::vector<Scatter> scatters;
  for (std::size_t t = 0; t < targets_.size(); ++t) {
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
Sightings::patchSums(const std::vector<double>& centre,
                     const std::vector<double>& band) const
{
  return overAll<PatchSums>(targets_.patchCount(),
                            [&](std::vector<PatchSums>& own, std::size_t t,
                                std::size_t patch, double d,
                                const Eigen::Vector3d& row) {
                              if (std::abs(d - centre[t]) <= band[t])
                                own[patch].add(d, row);
                            });
}

} // namespace sedr
} // namespace pcl
