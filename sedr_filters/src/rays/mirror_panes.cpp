// SPDX-License-Identifier: BSD-3-Clause
#include "mirror_panes.h"

#include "../base/parallel.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::sedr {

namespace {

/** @brief What was met behind a pane at places that say something: their like elsewhere
 * is not there by chance, as that of a floor behind a vertical pane would be. */
std::vector<Eigen::Vector3d>
tellingPlaces(const Pane& pane,
              const std::vector<Eigen::Vector3d>& behind,
              const CubeTable& filled)
{
  constexpr double aside = 0.5; // metres
  std::vector<Eigen::Vector3d> telling;
  for (const Eigen::Vector3d& p : behind)
    if (!filled.isNear(p + aside * pane.normal) &&
        !filled.isNear(p - aside * pane.normal))
      telling.push_back(p);
  return telling;
}

/** @brief How much of what is met behind a pane has its like in front of it. */
struct Likeness {
  double share = 0;  ///< at best
  double chance = 0; ///< the same of planes beside it, on average
  bool is_at_several_depths = false;

  /** @brief 0 where it is what planes beside the pane have too, 1 where it is all. */
  double beyondChance() const
  {
    return chance < 1 ? (share - chance) / (1 - chance) : 0;
  }
};

/** @brief Places behind a pane at about one depth. */
struct Layer {
  std::size_t places = 0;
  std::size_t mirrored = 0; ///< those that have their like in front of it

  double share() const
  {
    return static_cast<double>(mirrored) / static_cast<double>(places);
  }
};

/** @brief Layers by their depth behind a pane in half metres. */
std::map<long, Layer>
layersOf(const Pane& pane,
         const std::vector<Eigen::Vector3d>& places,
         const CubeTable& filled)
{
  constexpr double thickness = 0.5; // metres
  std::map<long, Layer> layers;
  for (const Eigen::Vector3d& p : places) {
    Layer& at = layers[std::lround((pane.normal.dot(p) - pane.offset) / thickness)];
    ++at.places;
    at.mirrored += filled.isNear(pane.imageOf(p)) ? 1 : 0;
  }
  return layers;
}

/** @brief Share of places that have their like in front of a pane: the mean of those of
 * the layers, so that one wall of many points does not decide. */
double
mirroredShare(const std::map<long, Layer>& layers)
{
  constexpr std::size_t fewest = 8; // places of a layer
  double sum = 0;
  std::size_t counted = 0;
  for (const auto& [depth, layer] : layers)
    if (layer.places >= fewest) {
      sum += layer.share();
      ++counted;
    }
  return counted > 0 ? sum / static_cast<double>(counted) : 0;
}

/** @brief Whether layers that are apart are mirrored. One wall there that happens to be
 * as far from the pane as one here is in one layer, or in two side by side. */
bool
isMirroredAtSeveralDepths(const std::map<long, Layer>& layers)
{
  constexpr std::size_t fewest = 4; // mirrored places of a layer
  constexpr double least = 0.5;     // share of its places
  std::vector<long> depths;
  for (const auto& [depth, layer] : layers)
    if (layer.mirrored >= fewest && layer.share() >= least)
      depths.push_back(depth);
  return !depths.empty() && depths.back() - depths.front() > 1;
}

/** @brief Moves a pane, whose normal points away from the scanner, to where it mirrors
 * most: it may stand behind its wall's face. */
Likeness
moveToMirror(Pane& pane,
             const std::vector<Eigen::Vector3d>& behind,
             const CubeTable& filled)
{
  constexpr std::size_t fewest = 30;
  constexpr double step = 0.05; // metres
  constexpr int before = -1;    // steps
  constexpr int after = 6;
  constexpr int beside = 10; // too far for the same pane
  constexpr int farthest = 20;
  const std::vector<Eigen::Vector3d> telling = tellingPlaces(pane, behind, filled);
  Likeness likeness;
  if (telling.size() < fewest)
    return likeness;
  const double offset = pane.offset;
  const auto layersAt = [&](int k) {
    Pane moved = pane;
    moved.offset = offset + k * step;
    return layersOf(moved, telling, filled);
  };
  for (int k = before; k <= after; ++k) {
    const std::map<long, Layer> layers = layersAt(k);
    const double share = mirroredShare(layers);
    if (share <= likeness.share)
      continue;
    likeness.share = share;
    likeness.is_at_several_depths = isMirroredAtSeveralDepths(layers);
    pane.offset = offset + k * step;
  }
  for (int k = beside; k <= farthest; ++k)
    for (const int side : {-1, 1})
      likeness.chance +=
          mirroredShare(layersAt(side * k)) / (2 * (farthest - beside + 1));
  return likeness;
}

/** @brief What the rays through each pane met far behind it; the normals of the panes
 * are turned away from the scanner. */
std::vector<std::vector<Eigen::Vector3d>>
placesBehind(std::vector<Pane>& panes,
             const PiercedSurfaces& surfaces,
             const std::vector<ScanRay>& rays,
             const std::vector<std::uint32_t>& pierced)
{
  constexpr double min_depth = 0.6; // metres: nearer to a pane all is like itself
  std::vector<std::uint32_t> pane_of(surfaces.cubes().size(), CubeTable::none);
  for (std::uint32_t k = 0; k < panes.size(); ++k)
    for (const std::uint32_t cube : panes[k].cubes)
      pane_of[cube] = k;
  std::vector<std::vector<Eigen::Vector3d>> behind(panes.size());
  std::vector<long> away(panes.size(),
                         0); // rays along the normal less those against it
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const std::uint32_t k =
        pierced[r] == CubeTable::none ? CubeTable::none : pane_of[pierced[r]];
    if (k == CubeTable::none || !panes[k].parts(rays[r], min_depth))
      continue;
    behind[k].push_back(rays[r].to.cast<double>());
    away[k] +=
        panes[k].normal.dot((rays[r].to - rays[r].from).cast<double>()) > 0 ? 1 : -1;
  }
  for (std::size_t k = 0; k < panes.size(); ++k)
    if (away[k] < 0) {
      panes[k].normal = -panes[k].normal;
      panes[k].offset = -panes[k].offset;
    }
  return behind;
}

} // namespace

std::vector<Pane>
mirrorsAmong(std::vector<Pane> panes,
             const PiercedSurfaces& surfaces,
             const std::vector<ScanRay>& rays,
             const std::vector<std::uint32_t>& pierced,
             const CubeTable& filled,
             unsigned threads)
{
  constexpr double min_likeness = 0.5;
  constexpr std::size_t enough = 3000; // places behind a pane
  const auto behind = placesBehind(panes, surfaces, rays, pierced);
  std::vector<Likeness> likeness(panes.size());
  parallelBlocks(panes.size(), 1, threads, [&](std::size_t k, std::size_t) {
    std::vector<Eigen::Vector3d> some;
    for (std::size_t i = 0; i < behind[k].size(); i += behind[k].size() / enough + 1)
      some.push_back(behind[k][i]);
    likeness[k] = moveToMirror(panes[k], some, filled);
  });
  std::vector<Pane> mirrors;
  for (std::size_t k = 0; k < panes.size(); ++k)
    if (likeness[k].is_at_several_depths && likeness[k].beyondChance() >= min_likeness)
      mirrors.push_back(std::move(panes[k]));
  return mirrors;
}

} // namespace pcl::sedr
