// SPDX-License-Identifier: BSD-3-Clause
#include "refit_sums.h"

#include "refit_candidates.h"
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
  beyond += other.beyond;
  rows += other.rows;
  return *this;
}

Sightings::Sightings(const RawPoints& raw,
                     const RefitTargets& targets,
                     const EnoughPoints& enough)
    : raw_(raw)
    , targets_(targets)
    , looked_at_(enoughOf(enough))
{
  find();
}

/** @brief What is enough of each surface, by what a few of the points show; of slabs of
 * each patch, as those far from the scanner tell how a slab leans. */
LookedAt
Sightings::enoughOf(const EnoughPoints& enough) const
{
  constexpr std::size_t step = 16;
  const LookedAt few(targets_, EvenShare(1.0 / step));
  LookedAt looked_at(targets_);
  std::vector<std::size_t> of_surface(targets_.size(), 0);
  std::vector<std::size_t> of_patch(targets_.patchCount(), 0);
  const std::size_t first_slab = targets_.size() - targets_.slabCount();
  for (const Block& block : lookAt(raw_, few))
    for (const Part& part : block)
      for (std::size_t t = 0; t < targets_.size(); ++t) {
        of_surface[t] += step * (part.first[t + 1] - part.first[t]);
        for (std::size_t k = part.first[t]; k < part.first[t + 1] && t >= first_slab;
             ++k)
          of_patch[targets_.firstPatch(t) + part.sightings[k].place] += step;
      }
  const auto shareOf = [](std::size_t most, std::size_t all) {
    return EvenShare(static_cast<double>(most) /
                     static_cast<double>(std::max<std::size_t>(1, all)));
  };
  for (std::size_t t = 0; t < targets_.size(); ++t) {
    const std::size_t shown = std::max<std::size_t>(1, targets_.shownPatches(t));
    const std::size_t most = std::max(enough.of_surface, enough.of_patch * shown);
    if (t < first_slab)
      looked_at.of_surface[t] = shareOf(most, of_surface[t]);
    for (std::size_t p = targets_.firstPatch(t);
         p < targets_.firstPatch(t + 1) && t >= first_slab; ++p)
      looked_at.of_patch[p] = shareOf(most / shown, of_patch[p]);
  }
  return looked_at;
}

void
Sightings::find()
{
  slabs_were_.clear();
  for (std::size_t k = 0; k < targets_.slabCount(); ++k)
    slabs_were_.push_back(targets_.slab(k));
  blocks_ = lookAt(raw_, looked_at_);
  shares_.clear();
  for (std::size_t t = 0; t < targets_.size(); ++t)
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      if (std::any_of(blocks_[b].begin(), blocks_[b].end(),
                      [&](const Part& part) { return part.shows(t); }))
        shares_.push_back({t, b});
}

/** @brief In blocks whose number does not depend on that of the threads, so that no sum
 * over them does. */
std::vector<Sightings::Block>
Sightings::lookAt(const RawPoints& raw, const LookedAt& looked_at) const
{
  constexpr std::size_t most_blocks = 8;
  constexpr std::size_t least_block = std::size_t{1} << 16;
  const std::size_t n = raw.size();
  const std::size_t block = std::max(least_block, n / most_blocks + 1);
  std::vector<Block> blocks((n + block - 1) / block);
  // A slab that leans otherwise than before is a little farther from a point.
  const RefitCandidates candidates(targets_, targets_.reach() + 2 * farthest_slab,
                                   looked_at);
  parallelBlocks(n, block, raw.threads, [&](std::size_t begin, std::size_t end) {
    blocks[begin / block] = lookAt(raw, candidates, begin, end);
  });
  return blocks;
}

Sightings::Block
Sightings::lookAt(const RawPoints& raw,
                  const RefitCandidates& candidates,
                  std::size_t begin,
                  std::size_t end) const
{
  constexpr std::size_t points_at_once = std::size_t{1} << 15;
  std::vector<Seen> seen;
  Block block;
  for (std::size_t k = begin; k < end; k += points_at_once) {
    seen.clear();
    for (std::size_t i = k; i < std::min(end, k + points_at_once); ++i) {
      const Eigen::Vector3f p = raw.points[raw.at(i)];
      candidates.find(p, [&](std::size_t t, std::size_t place) {
        seen.push_back(
            {{p, static_cast<std::uint32_t>(place)}, static_cast<std::uint32_t>(t)});
      });
    }
    block.emplace_back(seen, targets_.size());
  }
  return block;
}

Sightings::Part::Part(const std::vector<Seen>& seen, std::size_t surfaces)
    : sightings(new Sighting[seen.size()])
    , first(surfaces + 1, 0)
{
  for (const Seen& s : seen)
    ++first[s.surface + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> next = first;
  for (const Seen& s : seen)
    sightings[next[s.surface]++] = s.sighting;
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
    std::vector<Sum> own(sizeOf(t));
    const double reach = targets_.reach();
    targets_.view(t, [&](const auto& view) {
      for (const Part& part : blocks_[shares_[s].block])
        for (std::size_t k = part.first[t]; k < part.first[t + 1]; ++k) {
          const Sighting& sighting = part.sightings[k];
          const Eigen::Vector3d p = sighting.point.cast<double>();
          const double d = view.distance(p);
          if (std::abs(d) <= reach)
            add(own, t, view, p, d, sighting.place);
        }
    });
    parts[s] = std::move(own);
  });
  std::vector<std::vector<Sum>> sums(targets_.size());
  parallelBlocks(sums.size(), 1, raw_.threads, [&](std::size_t t, std::size_t) {
    sums[t].resize(sizeOf(t));
    auto share =
        std::partition_point(shares_.begin(), shares_.end(),
                             [&](const Share& other) { return other.surface < t; });
    for (; share != shares_.end() && share->surface == t; ++share) {
      const auto& part = parts[static_cast<std::size_t>(share - shares_.begin())];
      for (std::size_t i = 0; i < part.size(); ++i)
        sums[t][i] += part[i];
    }
  });
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
        const bool is_within = std::abs(d - centre[t]) <= band[t];
        if (!is_within && 2 * std::abs(d) > targets_.gap(t))
          return;
        const Eigen::Vector3d row = view.row(p);
        PatchSums& patch = own[view.patch(row, place)];
        if (is_within)
          patch.add(d, row);
        else
          patch.beyond += 1;
      });
}

} // namespace sedr
} // namespace pcl
