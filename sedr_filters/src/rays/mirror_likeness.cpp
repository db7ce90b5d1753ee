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
tellingPlaces(const Pane& pane, const Places& behind, const CubeTable& all)
{
  constexpr double aside = 0.5; // metres
  std::vector<Eigen::Vector3d> telling;
  for (const Eigen::Vector3d& p : behind)
    if (!all.isNear(p + aside * pane.normal) && !all.isNear(p - aside * pane.normal))
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
moveToMirror(Pane& pane,
             const Places& behind,
             const CubeTable& all,
             const CubeTable& before)
{
  constexpr std::size_t fewest = 30;
  constexpr double step = 0.05; // metres
  constexpr int nearest = -1;   // steps
  constexpr int deepest = 6;
  constexpr int beside = 10; // too far for the same pane
  constexpr int farthest = 20;
  MirrorLikeness best;
  const std::vector<Eigen::Vector3d> telling = tellingPlaces(pane, behind, all);
  if (telling.size() < fewest)
    return best;
  const double offset = pane.offset;
  const auto layersAt = [&](int k) {
    Pane moved = pane;
    moved.offset = offset + k * step;
    return layersOf(moved, telling, before);
  };
  for (int k = nearest; k <= deepest; ++k) {
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
    const double half_length = wall.half_length;
    wall = lineThrough(near);
    wall.half_length = half_length;
  }
  double depth = 0;
  for (const Eigen::Vector3d& p : behind)
    depth += wall.depth(p);
  if (depth < 0)
    wall.normal = -wall.normal;
  return wall;
}

using WallCell = std::pair<long, long>; ///< along it and up

/** @brief Returns the cell of a wall that a place is at. */
WallCell
cellOf(const WallLine& wall, const Eigen::Vector3d& p)
{
  constexpr double cell = 0.2; // metres
  return {std::lround(wall.along(p) / cell), std::lround(p.z() / cell)};
}

/** @brief Returns the cells of a wall that there are places at, from a depth on. */
std::set<WallCell>
cellsAt(const WallLine& wall, const Places& places, double depth, double reach)
{
  std::set<WallCell> cells;
  for (const Eigen::Vector3d& p : places)
    if (wall.isNear(p, depth, reach))
      cells.insert(cellOf(wall, p));
  return cells;
}

constexpr double face_noise = 0.05; // metres, of a face and its noise

/** @brief Returns the share of a wall of which there is another face behind it. */
double
faceBehind(const WallLine& wall, const Places& before, const Places& behind)
{
  constexpr int nearest = 2; // times, to the face of a thin wall
  constexpr int farthest = 10;
  std::size_t face = 0;
  for (int k = nearest; k <= farthest; ++k)
    face = std::max(face, cellsAt(wall, behind, k * face_noise, face_noise).size());
  const std::size_t cells = cellsAt(wall, before, 0, face_noise).size();
  return face < cells ? static_cast<double>(face) / static_cast<double>(cells) : 1;
}

/** @brief Returns the share of a wall that is a thin partition: its two faces are so
 * near that they look like one, with more spread than the noise of one explains. */
double
thinShare(const WallLine& wall, const Places& before, const PointView& points)
{
  constexpr double thickest = 0.1; // metres
  constexpr double noise = 0.01;   // metres, of points of one face
  constexpr double fewest = 5;     // points of a cell
  struct Depths {
    double count = 0;
    double sum = 0;
    double squares = 0;
  };
  std::map<WallCell, Depths> cells;
  for (const WallCell& cell : cellsAt(wall, before, 0, face_noise))
    cells[cell];
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = points[i].cast<double>();
    if (!points.isFinite(i) || !wall.isNear(p, 0, thickest))
      continue;
    const auto at = cells.find(cellOf(wall, p));
    if (at == cells.end())
      continue;
    ++at->second.count;
    at->second.sum += wall.depth(p);
    at->second.squares += wall.depth(p) * wall.depth(p);
  }
  double thin = 0;
  double all = 0;
  for (const auto& [cell, depths] : cells)
    if (depths.count >= fewest) {
      const double mean = depths.sum / depths.count;
      ++all;
      thin += depths.squares / depths.count - mean * mean > noise * noise ? 1 : 0;
    }
  return all > 0 ? thin / all : 1;
}

/** @brief Whether a wall or pane is there: what lies behind is not just beyond an edge.
 */
bool
isSurface(const WallLine& wall, const Places& before, const Places& behind)
{
  constexpr double shortest = 0.5; // metres
  constexpr double least = 0.5;    // of the cells before what lies behind
  constexpr double anywhere = 100; // metres
  return 2 * wall.half_length >= shortest &&
         static_cast<double>(cellsAt(wall, before, 0, face_noise).size()) >
             least *
                 static_cast<double>(cellsAt(wall, behind, anywhere, anywhere).size());
}

} // namespace

bool
isReflection(const Places& border,
             const SeenPart& before,
             const SeenPart& behind,
             const CubeTable& all,
             const PointView& points)
{
  constexpr double most = 0.3;  // of a wall with two faces: of mirrors' up to 0.26
  constexpr double least = 0.7; // of mirrors 0.9 and more
  constexpr double nearest =
      0.3; // metres behind: nearer to a mirror all is like itself
  if (border.empty() || behind.places.empty())
    return false;
  const WallLine wall = wallAt(border, before.places, behind.places);
  if (!isSurface(wall, before.places, behind.places) ||
      faceBehind(wall, before.places, behind.places) > most ||
      faceBehind(wallAt(border, behind.places, before.places), behind.places,
                 before.places) > most ||
      thinShare(wall, before.places, points) > most)
    return false;
  Pane pane;
  pane.normal << wall.normal, 0;
  pane.offset = wall.normal.dot(wall.middle);
  Places deep;
  std::copy_if(behind.places.begin(), behind.places.end(), std::back_inserter(deep),
               [&](const Eigen::Vector3d& p) { return wall.depth(p) > nearest; });
  const MirrorLikeness found = moveToMirror(pane, deep, all, before.cubes);
  return found.isMirror() && found.share >= least;
}

} // namespace pcl::sedr
