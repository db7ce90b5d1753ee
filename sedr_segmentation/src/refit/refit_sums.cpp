// SPDX-License-Identifier: BSD-3-Clause
#include "refit_sums.h"

#include "square_surfaces.h"
#include "weighted_values.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Width of a bin of distances, metres. */
constexpr double bin = 0.0005;

/** @brief Calls `note(number, place)` for every surface to which a finite point may
 * belong: vertical surfaces nearby, and slabs within `far` metres. */
template <typename Note>
void
findSurfaces(const RefitTargets& targets,
             double far,
             const Eigen::Vector3d& p,
             const Note& note)
{
  const RefitPlaces& places = targets.places();
  const CellGrid& grid = places.stretches_near.grid();
  if (!p.allFinite() || !grid.holds(p.x(), p.y()))
    return;
  const Cell cell = grid.at(p.x(), p.y());
  for (const std::uint32_t s : places.stretches_near.ofCell(cell)) {
    const RefitStretch& stretch = places.stretches[s];
    if (p.z() >= stretch.low && p.z() <= stretch.high &&
        stretch.part.isBeside(p.head<2>()))
      note(stretch.curve, RefitTargets::rowOf(stretch.high, p.z()));
  }
  const auto noteSlab = [&](std::size_t k) {
    const RefitSlab& slab = places.slabs[k];
    const Eigen::Vector4d& plane = slab.slab->plane;
    if (std::abs(plane.head<3>().dot(p) + plane[3]) <= far)
      note(targets.size() - places.slabs.size() + k,
           RefitTargets::patchOf(slab, p.head<2>()));
  };
  for (const std::uint32_t r : places.rooms_near.ofCell(cell))
    for (const std::int32_t slab : places.rooms[r].slabsAt(p.head<2>()))
      if (slab >= 0)
        noteSlab(static_cast<std::size_t>(slab));
  for (const std::uint32_t n : places.niches_near.ofCell(cell)) {
    constexpr double margin = 0.03;
    const RefitNiche& niche = places.niches[n];
    const PlanLoop& boundary = niche.niche->boundary;
    if (!boundary.contains(p.head<2>()) || boundary.distance(p.head<2>()) <= margin)
      continue;
    noteSlab(niche.bottom);
    noteSlab(niche.top);
  }
}

} // namespace

Sightings::Sightings(const RawPoints& raw,
                     const RefitTargets& targets,
                     const Priors& priors)
    : targets_(targets)
    , threads_(raw.threads)
{
  constexpr std::size_t block = std::size_t{1} << 17;
  blocks_.resize((raw.size() + block - 1) / block);
  parallelBlocks(raw.size(), block, threads_, [&](std::size_t begin, std::size_t end) {
    blocks_[begin / block] = lookAt(raw, begin, end);
  });
  parallelBlocks(targets_.curveCount(), 1, threads_,
                 [&](std::size_t c, std::size_t) { dropSquareSurfaces(c, priors); });
}

void
Sightings::dropSquareSurfaces(std::size_t curve, const Priors& priors)
{
  // The other face of a partition may be at every depth, where it is noisy.
  if (std::isfinite(targets_.gap(curve)))
    return;
  std::vector<FacePlace> places;
  targets_.viewCurve(curve, [&](const auto& view) {
    for (const BySurface& block : blocks_)
      for (const Sighting& sighting : block[curve]) {
        const Eigen::Vector3d p = sighting.point.cast<double>();
        places.push_back(
            Eigen::Vector3d(view.along(view.row(p)), p.z(), view.distance(p))
                .cast<float>());
      }
  });
  const std::vector<std::uint8_t> are_dropped =
      areOnSquareSurfaces(places, targets_.reach() + RefitPlaces::step, priors);
  std::size_t k = 0;
  for (BySurface& block : blocks_) {
    std::vector<Sighting>& seen = block[curve];
    seen.erase(std::remove_if(seen.begin(), seen.end(),
                              [&](const Sighting&) { return are_dropped[k++] != 0; }),
               seen.end());
  }
}

Sightings::BySurface
Sightings::lookAt(const RawPoints& raw, std::size_t begin, std::size_t end) const
{
  constexpr double farthest_move = 0.1; // of a slab while it is fitted, metres
  BySurface sightings(targets_.size());
  for (std::size_t k = begin; k < end; ++k) {
    const Eigen::Vector3f p = raw.points[raw.at(k)];
    findSurfaces(targets_, targets_.reach() + farthest_move, p.cast<double>(),
                 [&](std::size_t surface, std::size_t place) {
                   sightings[surface].push_back({p, static_cast<std::uint32_t>(place)});
                 });
  }
  return sightings;
}

/** @brief Calls `see(view, p, d, place)`, with distance `d`, for the points within
 * reach of a surface, in order. */
template <typename See>
void
Sightings::forEach(std::size_t surface, See see) const
{
  targets_.view(surface, [&](const auto& view) {
    for (const BySurface& block : blocks_)
      for (const Sighting& sighting : block[surface]) {
        const Eigen::Vector3d p = sighting.point.cast<double>();
        const double d = view.distance(p);
        if (std::abs(d) <= targets_.reach())
          see(view, p, d, sighting.place);
      }
  });
}

std::vector<Scatter>
Sightings::scatters(double reach) const
{
  const auto bins = static_cast<std::size_t>(std::ceil(2 * reach / bin)) + 1;
  std::vector<Scatter> scatters(targets_.size());
  parallelBlocks(scatters.size(), 1, threads_, [&](std::size_t t, std::size_t) {
    std::vector<Weighted> values(bins);
    for (std::size_t i = 0; i < bins; ++i)
      values[i] = {(static_cast<double>(i) + 0.5) * bin - reach, 0};
    Scatter& scatter = scatters[t];
    forEach(t, [&](const auto&, const Eigen::Vector3d&, double d, std::size_t) {
      if (2 * std::abs(d) > targets_.gap(t))
        return;
      values[std::min(bins - 1, static_cast<std::size_t>((d + reach) / bin))].weight +=
          1;
      scatter.count += 1;
    });
    if (scatter.count == 0)
      return;
    constexpr double quartile = 0.6745; // of the normal distribution
    values.erase(std::remove_if(values.begin(), values.end(),
                                [](const Weighted& v) { return v.weight == 0; }),
                 values.end());
    const Interval half = shortestHalf(std::move(values));
    scatter.centre = half.middle;
    scatter.deviation = std::max(bin, half.width) / 2 / quartile;
  });
  return scatters;
}

std::vector<std::vector<PatchSums>>
Sightings::patchSums(const std::vector<double>& centre,
                     const std::vector<double>& band) const
{
  std::vector<std::vector<PatchSums>> sums(targets_.size());
  parallelBlocks(sums.size(), 1, threads_, [&](std::size_t t, std::size_t) {
    sums[t].resize(targets_.patchCount(t));
    forEach(t, [&](const auto& view, const Eigen::Vector3d& p, double d,
                   std::size_t place) {
      if (std::abs(d - centre[t]) > band[t])
        return;
      const Eigen::Vector3d row = view.row(p);
      sums[t][view.patch(row, place)].add(d, row);
    });
  });
  return sums;
}

} // namespace pcl::sedr
