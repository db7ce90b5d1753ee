// SPDX-License-Identifier: BSD-3-Clause
#include "refit_sums.h"

#include "weighted_values.h"

#include <pcl/sedr_filters/parallel.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

/** @brief Width of a bin of distances, metres. */
constexpr double bin = 0.0005;

/** @brief A slab that moves farther may be shown by points that were not seen before,
 * metres. */
constexpr double farthest_slab = 0.05;

} // namespace

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
  slabs_were_.clear();
  for (std::size_t k = 0; k < targets_.slabCount(); ++k)
    slabs_were_.push_back(targets_.slab(k));
  const std::size_t n = raw_.size();
  const std::size_t block = std::max(least_block, n / most_blocks + 1);
  blocks_.assign((n + block - 1) / block, {});
  parallelBlocks(n, block, raw_.threads, [&](std::size_t begin, std::size_t end) {
    blocks_[begin / block] = lookAt(begin, end);
  });
  shares_.clear();
  for (std::size_t t = 0; t < targets_.size(); ++t)
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      if (blocks_[b].first[t] < blocks_[b].first[t + 1])
        shares_.push_back({t, b});
}

Sightings::Block
Sightings::lookAt(std::size_t begin, std::size_t end) const
{
  // A slab that leans otherwise than before is a little farther from a point.
  const double far = targets_.reach() + 2 * farthest_slab;
  std::vector<std::pair<std::uint32_t, Sighting>> seen; // and the surface
  seen.reserve(end - begin);
  Block block;
  block.first.assign(targets_.size() + 1, 0);
  for (std::size_t k = begin; k < end; ++k) {
    const std::size_t i = raw_.at(k);
    if (!raw_.points.isFinite(i))
      continue;
    const Eigen::Vector3f p = raw_.points[i];
    targets_.candidates(p.cast<double>(), far, [&](std::size_t t, std::size_t place) {
      ++block.first[t + 1];
      seen.push_back(
          {static_cast<std::uint32_t>(t), {p, static_cast<std::uint32_t>(place)}});
    });
  }
  std::partial_sum(block.first.begin(), block.first.end(), block.first.begin());
  std::vector<std::size_t> next = block.first;
  block.sightings.resize(seen.size());
  for (const auto& [t, sighting] : seen)
    block.sightings[next[t]++] = sighting;
  return block;
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

/** @brief For each surface `sizeOf(surface)` sums, to which `add(own, view, p, d,
 * place)` adds what a point `p` within reach of it, at distance `d`, shows: over each
 * block in the order of the points, then over the blocks. */
template <typename Sum, typename SizeOf, typename Add>
std::vector<std::vector<Sum>>
Sightings::bySurface(SizeOf sizeOf, Add add) const
{
  std::vector<std::vector<Sum>> parts(shares_.size());
  parallelBlocks(shares_.size(), 1, raw_.threads, [&](std::size_t s, std::size_t) {
    const std::size_t t = shares_[s].surface;
    const Block& block = blocks_[shares_[s].block];
    std::vector<Sum> own(sizeOf(t));
    const double reach = targets_.reach();
    targets_.view(t, [&](const auto& view) {
      for (std::size_t k = block.first[t]; k < block.first[t + 1]; ++k) {
        const Sighting& sighting = block.sightings[k];
        const Eigen::Vector3d p = sighting.point.cast<double>();
        const double d = view.distance(p);
        if (std::abs(d) <= reach)
          add(own, t, view, p, d, sighting.place);
      }
    });
    parts[s] = std::move(own);
  });
  std::vector<std::vector<Sum>> sums;
  for (std::size_t t = 0; t < targets_.size(); ++t)
    sums.emplace_back(sizeOf(t));
  for (std::size_t s = 0; s < shares_.size(); ++s)
    for (std::size_t i = 0; i < parts[s].size(); ++i)
      sums[shares_[s].surface][i] += parts[s][i];
  return sums;
}

std::vector<Scatter>
Sightings::scatters(double reach) const
{
  const auto bins = static_cast<std::size_t>(std::ceil(2 * reach / bin)) + 1;
  const auto counts = bySurface<std::uint32_t>(
      [&](std::size_t) { return bins; },
      [&](std::vector<std::uint32_t>& own, std::size_t t, const auto&,
          const Eigen::Vector3d&, double d, std::size_t) {
        if (2 * std::abs(d) <= targets_.gap(t))
          ++own[std::min(bins - 1, static_cast<std::size_t>((d + reach) / bin))];
      });
  std::vector<Scatter> scatters;
  for (const auto& own : counts) {
    std::vector<Weighted> values;
    Scatter scatter;
    for (std::size_t i = 0; i < bins; ++i) {
      const auto count = static_cast<double>(own[i]);
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

std::vector<std::vector<PatchSums>>
Sightings::patchSums(const std::vector<double>& centre,
                     const std::vector<double>& band) const
{
  return bySurface<PatchSums>(
      [&](std::size_t t) {
        return targets_.firstPatch(t + 1) - targets_.firstPatch(t);
      },
      [&](std::vector<PatchSums>& own, std::size_t t, const auto& view,
          const Eigen::Vector3d& p, double d, std::size_t place) {
        if (std::abs(d - centre[t]) > band[t])
          return;
        const Eigen::Vector3d row = view.row(p);
        own[view.patch(row, place)].add(d, row);
      });
}

} // namespace sedr
} // namespace pcl
