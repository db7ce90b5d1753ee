// SPDX-License-Identifier: BSD-3-Clause
#include "refit_candidates.h"

#include <pcl/sedr_filters/plane_fit.h>

#include <algorithm>

namespace pcl {
namespace sedr {

RefitCandidates::Upright::Upright(const RefitStretch& stretch, EvenShare share_of_it)
    : heights{stretch.low, stretch.high}
    , start(stretch.part.start)
    , way(stretch.part.end - stretch.part.start)
    , squared_length(way.squaredNorm())
    , arc(stretch.part.isArc() ? &stretch.part : nullptr)
    , curve(stretch.curve)
    , share(share_of_it)
{}

RefitCandidates::RefitCandidates(const RefitTargets& targets,
                                 double far,
                                 const LookedAt& looked_at)
    : places_(targets.places())
    , far_(far)
    , looked_at_(looked_at)
    , first_slab_(targets.size() - places_.slabs.size())
{
  for (const RefitStretch& stretch : places_.stretches)
    uprights_.emplace_back(stretch, looked_at.of_surface[stretch.curve]);
  for (const RefitSlab& slab : places_.slabs)
    planes_.push_back(slab.slab->plane);
  for (std::size_t k = 0; k < places_.slabs.size(); ++k)
    first_patches_.push_back(targets.firstPatch(first_slab_ + k));
  for (const RefitRoomMap& map : places_.rooms)
    rooms_.push_back(
        {&map, 1 / map.cell, heightsOf(map.ceilings, map), heightsOf(map.floors, map)});
  tellCells();
}

/** @brief The surfaces near each cell, and as many of its points as any of them asks
 * for: most points are passed over without looking up which that are. */
void
RefitCandidates::tellCells()
{
  const CellBox box = places_.box();
  low_ = RefitPlaces::table_cell * Eigen::Vector2d(box.low.x, box.low.y);
  width_ = box.high.x - box.low.x + 1;
  height_ = box.high.y - box.low.y + 1;
  heres_.assign(1, Here());
  cells_.reserve(box.count());
  for (std::int32_t y = box.low.y; y <= box.high.y; ++y)
    for (std::int32_t x = box.low.x; x <= box.high.x; ++x) {
      Here here;
      here.stretches = places_.stretches_near.ofCell({x, y});
      here.rooms = places_.rooms_near.ofCell({x, y});
      here.niches = places_.niches_near.ofCell({x, y});
      for (const std::uint32_t u : here.stretches) {
        here.heights.unite(uprights_[u].heights.low, uprights_[u].heights.high);
        here.raiseParts(uprights_[u].share);
      }
      cells_.push_back(here.isNothing() ? 0
                                        : static_cast<std::uint32_t>(heres_.size()));
      if (!here.isNothing())
        heres_.push_back(here);
    }
  for (std::size_t k = 0; k < places_.slabs.size(); ++k)
    tellPartsOf(k);
  for (const Here& here : heres_)
    most_parts_ = std::max(most_parts_, here.parts);
}

/** @brief Those of the patches of a slab, wherever it may be shown. */
void
RefitCandidates::tellPartsOf(std::size_t slab)
{
  const RefitSlab& s = places_.slabs[slab];
  const CellBox all = places_.box();
  for (std::size_t patch = 0; patch < s.along * s.rows; ++patch) {
    const auto [low, high] = RefitTargets::boundsOfPatch(s, patch);
    const CellBox box = overlapOf(places_.rooms_near.boxAround(low, high), all);
    for (std::int32_t y = box.low.y; y <= box.high.y; ++y)
      for (std::int32_t x = box.low.x; x <= box.high.x; ++x)
        heres_[cells_[static_cast<std::size_t>(y - all.low.y) *
                          static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(x - all.low.x)]]
            .raiseParts(looked_at_.of_patch[first_patches_[slab] + patch]);
  }
}

/** @brief Over the whole map, and a little more than is needed. */
RefitCandidates::Heights
RefitCandidates::heightsOf(const RefitSlabRange& slabs, const RefitRoomMap& map) const
{
  constexpr double slack = 1e-6;
  const Eigen::Vector2d extent = map.cell * Eigen::Vector2d(map.width, map.height);
  Heights heights;
  for (std::size_t k = slabs.first; k < slabs.end; ++k) {
    const double far = far_ / std::abs(planes_[k][2]) + slack;
    for (const double x : {0.0, 1.0})
      for (const double y : {0.0, 1.0}) {
        const double z = places_.slabs[k].slab->heightAt(
            map.low + extent.cwiseProduct(Eigen::Vector2d(x, y)));
        heights.unite(z - far, z + far);
      }
  }
  return heights;
}

} // namespace sedr
} // namespace pcl
