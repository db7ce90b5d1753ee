// SPDX-License-Identifier: BSD-3-Clause
#include "refit_candidates.h"

#include <pcl/sedr_filters/plane_fit.h>

namespace pcl {
namespace sedr {

RefitCandidates::Upright::Upright(const RefitStretch& stretch)
    : heights{stretch.low, stretch.high}
    , start(stretch.part.start)
    , way(stretch.part.end - stretch.part.start)
    , squared_length(way.squaredNorm())
    , arc(stretch.part.isArc() ? &stretch.part : nullptr)
    , curve(stretch.curve)
{}

RefitCandidates::RefitCandidates(const RefitTargets& targets, double far)
    : places_(targets.places())
    , far_(far)
    , first_slab_(targets.size() - places_.slabs.size())
{
  for (const RefitStretch& stretch : places_.stretches)
    uprights_.emplace_back(stretch);
  for (const RefitSlab& slab : places_.slabs)
    planes_.push_back(slab.slab->plane);
  for (const RefitRoomMap& map : places_.rooms)
    rooms_.push_back({heightsOf(map.ceilings, map), heightsOf(map.floors, map)});
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

void
RefitCandidates::enter(Cell cell)
{
  cell_ = cell;
  stretches_here_ = places_.stretches_near.ofCell(cell);
  rooms_here_ = places_.rooms_near.ofCell(cell);
  niches_here_ = places_.niches_near.ofCell(cell);
  uprights_here_ = Heights();
  for (const std::uint32_t k : stretches_here_)
    uprights_here_.unite(uprights_[k].heights.low, uprights_[k].heights.high);
}

} // namespace sedr
} // namespace pcl
