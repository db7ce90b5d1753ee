// SPDX-License-Identifier: BSD-3-Clause
#include "mirror_likeness.h"

#include "../base/symmetric_eigen.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief What was met behind a pane at places that say something: their like elsewhere
 * is not there by chance, as that of a floor behind a vertical pane would be. */
std::vector<Eigen::Vector3d>
tellingPlaces(const Pane& pane, const Places& behind, const CubeTable& filled)
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

MirrorLikeness
moveToMirror(Pane& pane, const Places& behind, const CubeTable& filled)
{
  constexpr std::size_t fewest = 30;
  constexpr double step = 0.05; // metres
  constexpr int before = -1;    // steps
  constexpr int after = 6;
  constexpr int beside = 10; // too far for the same pane
  constexpr int farthest = 20;
  MirrorLikeness best;
  const std::vector<Eigen::Vector3d> telling = tellingPlaces(pane, behind, filled);
  if (telling.size() < fewest)
    return best;
  const double offset = pane.offset;
  const auto layersAt = [&](int k) {
    Pane moved = pane;
    moved.offset = offset + k * step;
    return layersOf(moved, telling, filled);
  };
  for (int k = before; k <= after; ++k) {
    const Layers layers = layersAt(k);
    const double share = mirroredShare(layers);
    if (share <= best.share)
      continue;
    best = {share, 0, isMirroredAtSeveralDepths(layers)};
    pane.offset = offset + k * step;
  }
  if (!best.is_at_several_depths)
    return best;
  for (int k = beside; k <= farthest; ++k)
    for (const int side : {-1, 1})
      best.chance += mirroredShare(layersAt(side * k)) / (2 * (farthest - beside + 1));
  return best;
}

namespace {

/** @brief An upright wall in plan. */
struct WallLine {
  Eigen::Vector2d middle;
  Eigen::Vector2d normal;
  double half_length;

  double along(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector2d to = p.head<2>() - middle;
    return normal.x() * to.y() - normal.y() * to.x();
  }

  double depth(const Eigen::Vector3d& p) const
  {
    return normal.dot(p.head<2>() - middle);
  }

  bool isNear(const Eigen::Vector3d& p, double from, double reach) const
  {
    return std::abs(along(p)) < half_length && std::abs(depth(p) - from) < reach;
  }
};

/** @brief Returns the line of least squares through places. */
WallLine
lineThrough(const Places& places)
{
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& p : places)
    middle += p.head<2>() / static_cast<double>(places.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3d& p : places) {
    const Eigen::Vector2d to = p.head<2>() - middle;
    spread += to * to.transpose() / static_cast<double>(places.size());
  }
  const auto axes = symmetricEigen(spread);
  return {middle, axes.vectors.col(0), std::sqrt(3 * axes.values[1])};
}

/** @brief Returns the wall at a border by the places on its face, whose normal points
 * to those behind. */
WallLine
wallAt(const Places& border, const Places& before, const Places& behind)
{
  WallLine wall = lineThrough(border);
  for (double band = 0.3; band > 0.05; band /= 2) { // metres
    Places near;
    std::copy_if(before.begin(), before.end(), std::back_inserter(near),
                 [&](const Eigen::Vector3d& p) { return wall.isNear(p, 0, band); });
    if (near.size() < 2)
      break;
    wall = {lineThrough(near).middle, lineThrough(near).normal, wall.half_length};
  }
  double depth = 0;
  for (const Eigen::Vector3d& p : behind)
    depth += wall.depth(p);
  if (depth < 0)
    wall.normal = -wall.normal;
  return wall;
}

/** @brief Returns how many cells of a wall there are places at, from a depth on. */
double
cellsAt(const WallLine& wall, const Places& places, double depth, double reach)
{
  constexpr double cell = 0.2; // metres
  std::set<std::pair<long, long>> cells;
  for (const Eigen::Vector3d& p : places)
    if (wall.isNear(p, depth, reach))
      cells.insert({std::lround(wall.along(p) / cell), std::lround(p.z() / cell)});
  return static_cast<double>(cells.size());
}

constexpr double face_noise = 0.05; // metres, of a face and its noise

/** @brief Returns the share of a wall of which there is another face behind it. */
double
faceBehind(const WallLine& wall, const Places& before, const Places& behind)
{
  constexpr int nearest = 2; // times, to the face of a thin wall
  constexpr int farthest = 10;
  double face = 0;
  for (int k = nearest; k <= farthest; ++k)
    face = std::max(face, cellsAt(wall, behind, k * face_noise, face_noise));
  return std::min(face / std::max(cellsAt(wall, before, 0, face_noise), 1.0), 1.0);
}

/** @brief Whether a wall or pane is there: what lies behind is not just beyond an edge.
 */
bool
isSurface(const WallLine& wall, const Places& before, const Places& behind)
{
  constexpr double least = 0.5;    // of the cells before what lies behind
  constexpr double anywhere = 100; // metres
  return cellsAt(wall, before, 0, face_noise) >=
         least * cellsAt(wall, behind, anywhere, anywhere);
}

} // namespace

double
mirroredBehind(const Places& border, const Places& before, const Places& behind)
{
  constexpr double least = 0.3; // metres behind: nearer to a mirror all is like itself
  constexpr std::size_t enough = 1500;
  if (border.empty() || behind.empty())
    return 0;
  const WallLine wall = wallAt(border, before, behind);
  Pane pane;
  pane.normal << wall.normal, 0;
  pane.offset = wall.normal.dot(wall.middle);
  Places some;
  for (std::size_t k = 0; k < behind.size(); k += behind.size() / enough + 1)
    if (wall.depth(behind[k]) > least)
      some.push_back(behind[k]);
  CubeTable filled(mirror_cube);
  for (const Eigen::Vector3d& p : before)
    filled.add(filled.at(p));
  const MirrorLikeness found = moveToMirror(pane, some, filled);
  const auto face = [&] {
    return std::max(faceBehind(wall, before, behind),
                    faceBehind(wallAt(border, behind, before), behind, before));
  };
  return found.isMirror() && isSurface(wall, before, behind)
             ? found.share * (1 - face())
             : 0;
}

} // namespace pcl::sedr
