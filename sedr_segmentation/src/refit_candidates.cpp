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
    rooms_.push_back({heightsOf(map.ceilings, map), heightsOf(map.floors, map)});
  tellParts();
}

/** @brief As many as any surface asks for that points of the cell may show: most points
 * are passed over without looking up which that are. */
void
RefitCandidates::tellParts()
{
  const CellBox box = places_.box();
  parts_ = CellMask(box);
  low_ = RefitPlaces::table_cell * Eigen::Vector2d(box.low.x, box.low.y);
  for (std::int32_t y = box.low.y; y <= box.high.y; ++y)
    for (std::int32_t x = box.low.x; x <= box.high.x; ++x) {
      for (const std::uint32_t u : places_.stretches_near.ofCell({x, y}))
        raiseParts({x, y}, uprights_[u].share);
      for (const std::uint32_t n : places_.niches_near.ofCell({x, y})) {
        raiseParts({x, y},
                   looked_at_.of_surface[first_slab_ + places_.niches[n].bottom]);
        raiseParts({x, y}, looked_at_.of_surface[first_slab_ + places_.niches[n].top]);
      }
    }
  for (const RefitRoomMap& map : places_.rooms)
    tellPartsOf(map);
}

void
RefitCandidates::tellPartsOf(const RefitRoomMap& map)
{
  for (std::int32_t y = 0; y < map.height; ++y)
    for (std::int32_t x = 0; x < map.width; ++x) {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                     static_cast<std::size_t>(x);
      const Eigen::Vector2d low = map.low + map.cell * Eigen::Vector2d(x, y);
      const Eigen::Vector2d high = low + Eigen::Vector2d::Constant(map.cell);
      const CellBox box =
          overlapOf(places_.rooms_near.boxAround(low, high), parts_.box());
      for (const std::int32_t slab : {map.ceiling[i], map.floor[i]})
        if (slab >= 0)
          tellPartsOf(static_cast<std::size_t>(slab), {low, high}, box);
    }
}

/** @brief Those of the patches of a slab in a rectangle. */
void
RefitCandidates::tellPartsOf(std::size_t slab,
                             const std::array<Eigen::Vector2d, 2>& corners,
                             const CellBox& box)
{
  for (const Eigen::Vector2d& p :
       {corners[0], corners[1], Eigen::Vector2d(corners[0].x(), corners[1].y()),
        Eigen::Vector2d(corners[1].x(), corners[0].y())}) {
    const std::size_t patch = RefitTargets::patchOf(places_.slabs[slab], p);
    for (std::int32_t v = box.low.y; v <= box.high.y; ++v)
      for (std::int32_t u = box.low.x; u <= box.high.x; ++u)
        raiseParts({u, v}, looked_at_.of_patch[first_patches_[slab] + patch]);
  }
}

void
RefitCandidates::raiseParts(Cell cell, const EvenShare& share)
{
  parts_.set(cell, std::max(parts_.at(cell), share.parts()));
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
