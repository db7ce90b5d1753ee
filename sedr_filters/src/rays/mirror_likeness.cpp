// SPDX-License-Identifier: BSD-3-Clause
#include "mirror_likeness.h"

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

/** @brief Places behind a pane at about one depth. */
struct Layer {
  std::size_t places = 0;
  std::size_t mirrored = 0; ///< those that have their like in front of it

  double share() const
  {
    return static_cast<double>(mirrored) / static_cast<double>(places);
  }
};

using Layers = std::map<long, Layer>; ///< by depth in half metres

/** @brief Returns the layers behind a pane. */
Layers
layersOf(const Pane& pane,
         const std::vector<Eigen::Vector3d>& places,
         const CubeTable& filled)
{
  constexpr double thickness = 0.5; // metres
  Layers layers;
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
mirroredShare(const Layers& layers)
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
isMirroredAtSeveralDepths(const Layers& layers)
{
  constexpr std::size_t fewest = 4; // mirrored places of a layer
  constexpr double least = 0.5;     // share of its places
  std::vector<long> depths;
  for (const auto& [depth, layer] : layers)
    if (layer.mirrored >= fewest && layer.share() >= least)
      depths.push_back(depth);
  return !depths.empty() && depths.back() - depths.front() > 1;
}

} // namespace

bool
moveToMirror(Pane& pane,
             const std::vector<Eigen::Vector3d>& behind,
             const CubeTable& filled)
{
  constexpr double min_likeness = 0.5; // 0: what planes beside have, too; 1: all
  constexpr std::size_t fewest = 30;
  constexpr double step = 0.05; // metres
  constexpr int before = -1;    // steps
  constexpr int after = 6;
  constexpr int beside = 10; // too far for the same pane
  constexpr int farthest = 20;
  const std::vector<Eigen::Vector3d> telling = tellingPlaces(pane, behind, filled);
  if (telling.size() < fewest)
    return false;
  const double offset = pane.offset;
  const auto layersAt = [&](int k) {
    Pane moved = pane;
    moved.offset = offset + k * step;
    return layersOf(moved, telling, filled);
  };
  double best = 0;
  bool is_at_several_depths = false;
  for (int k = before; k <= after; ++k) {
    const Layers layers = layersAt(k);
    const double share = mirroredShare(layers);
    if (share <= best)
      continue;
    best = share;
    is_at_several_depths = isMirroredAtSeveralDepths(layers);
    pane.offset = offset + k * step;
  }
  double chance = 0;
  for (int k = beside; k <= farthest; ++k)
    for (const int side : {-1, 1})
      chance += mirroredShare(layersAt(side * k)) / (2 * (farthest - beside + 1));
  return is_at_several_depths && chance < 1 &&
         best - chance >= min_likeness * (1 - chance);
}

} // namespace pcl::sedr
