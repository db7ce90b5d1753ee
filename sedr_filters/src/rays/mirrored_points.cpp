// SPDX-License-Identifier: BSD-3-Clause
#include "mirrored_points.h"

#include "../base/parallel.h"
#include "panes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
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

/** @brief Moves a pane, whose normal points away from the scanner, to where it mirrors
 * most: it may stand behind its wall's face.
 * @param behind places that rays through the pane met behind it
 * @param filled cubes that hold points
 * @return whether the pane is a mirror: a good part of the places has its like in front
 * of it, more than planes beside it have by chance, at several depths */
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

using Flags = std::vector<std::uint8_t>; ///< 1 for yes

constexpr std::size_t items_a_block = 4096;

/** @brief Returns some rays of a scan: of each cube that it fills, one from each of the
 * first positions that saw it. O(n) for n points. */
std::vector<ScanRay>
raysOf(const PointView& points,
       std::size_t step,
       const ScanPositions& positions,
       const CubeTable& cubes)
{
  constexpr unsigned max_a_cube = 4; // positions
  constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
  struct Seen {
    std::size_t last = nowhere; ///< position
    unsigned rays = 0;
  };
  std::vector<Seen> seen(cubes.size());
  std::vector<ScanRay> rays;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t position = positionOfRow(positions, i * step);
    if (position == positions.size() || !positions[position].isKnown() ||
        !points.isFinite(i))
      continue;
    const Eigen::Vector3f to = points[i];
    const std::uint32_t cube = cubes.findAt(to.cast<double>());
    if (cube == CubeTable::none || seen[cube].last == position ||
        seen[cube].rays == max_a_cube)
      continue;
    seen[cube].last = position;
    ++seen[cube].rays;
    rays.push_back({positions[position].place, to, cube});
  }
  return rays;
}

/** @brief Returns positions of which some places are not known. */
ScanPositions
without(const std::vector<Eigen::Vector3f>& places, ScanPositions positions)
{
  for (ScanPosition& position : positions)
    if (std::find(places.begin(), places.end(), position.place) != places.end())
      position.place.setConstant(std::numeric_limits<float>::quiet_NaN());
  return positions;
}

/** @brief Finds the panes that rays go through, and the first one of each ray. */
PaneRays
throughPanes(std::vector<ScanRay> rays,
             const PiercedSurfaces& surfaces,
             unsigned threads)
{
  constexpr double depth = 0.2; // metres behind a pane
  std::vector<std::uint32_t> pierced(rays.size());
  parallelFor(rays.size(), items_a_block / 4, threads,
              [&](std::size_t r) { pierced[r] = surfaces.firstPierced(rays[r]); });
  PaneRays through{std::move(rays), panesOf(surfaces, pierced), {}};
  const std::vector<Pane>& panes = through.panes;
  std::vector<std::size_t> pane_of(surfaces.cubes().size(), panes.size());
  for (std::size_t k = 0; k < panes.size(); ++k)
    for (const std::uint32_t cube : panes[k].cubes)
      pane_of[cube] = k;
  through.before.assign(pierced.size(), panes.size());
  for (std::size_t r = 0; r < pierced.size(); ++r) {
    const std::size_t k =
        pierced[r] == CubeTable::none ? panes.size() : pane_of[pierced[r]];
    if (k < panes.size() && panes[k].parts(through.rays[r], depth))
      through.before[r] = k;
  }
  return through;
}

/** @brief Returns the panes that mirror, moved to where they do. */
std::vector<Pane>
mirrorsAmong(const PaneRays& all, const CubeTable& filled, unsigned threads)
{
  const std::vector<ScanRay>& rays = all.rays;
  const std::vector<Pane>& panes = all.panes;
  const std::vector<std::size_t>& before = all.before;
  constexpr double min_depth = 0.6;    // metres: nearer to a pane all is like itself
  constexpr std::size_t enough = 3000; // places behind a pane
  std::vector<std::vector<const ScanRay*>> through(panes.size());
  for (std::size_t r = 0; r < rays.size(); ++r)
    if (before[r] < panes.size() && panes[before[r]].parts(rays[r], min_depth))
      through[before[r]].push_back(&rays[r]);
  std::vector<Pane> moved = panes;
  Flags is_mirror(panes.size(), 0);
  parallelBlocks(panes.size(), 1, threads, [&](std::size_t k, std::size_t) {
    long away = 0; // rays along the normal less those against it
    std::vector<Eigen::Vector3d> behind;
    for (std::size_t i = 0; i < through[k].size(); ++i) {
      const ScanRay& ray = *through[k][i];
      away += panes[k].normal.dot((ray.to - ray.from).cast<double>()) > 0 ? 1 : -1;
      if (i % (through[k].size() / enough + 1) == 0)
        behind.push_back(ray.to.cast<double>());
    }
    if (away < 0) {
      moved[k].normal = -moved[k].normal;
      moved[k].offset = -moved[k].offset;
    }
    is_mirror[k] = moveToMirror(moved[k], behind, filled) ? 1 : 0;
  });
  std::vector<Pane> mirrors;
  for (std::size_t k = 0; k < panes.size(); ++k)
    if (is_mirror[k] != 0)
      mirrors.push_back(std::move(moved[k]));
  return mirrors;
}

/** @brief Tells which rays meet reflections. */
class MirroredRays {
public:
  MirroredRays(const std::vector<Pane>& mirrors,
               const CubeTable& cubes,
               const CubeTable& filled)
      : mirrors_(mirrors)
      , cubes_(cubes)
      , filled_(filled)
      , mirrors_at_(cubes.size())
      , boxes_(mirrors.size())
  {
    for (std::uint32_t k = 0; k < mirrors.size(); ++k)
      for (const std::uint32_t cube : mirrors[k].cubes) {
        mirrors_at_[cube].push_back(k);
        boxes_[k].extend(Cube(cubes[cube] - Cube::Ones()));
        boxes_[k].extend(Cube(cubes[cube] + Cube::Ones()));
      }
  }

  bool isMirrored(const ScanRay& ray) const
  {
    const Eigen::Vector3d to = ray.to.cast<double>();
    for (std::uint32_t k = 0; k < mirrors_.size(); ++k)
      if (goesThrough(k, ray) && filled_.isNear(mirrors_[k].imageOf(to)))
        return true;
    return false;
  }

private:
  bool goesThrough(std::uint32_t k, const ScanRay& ray) const
  {
    constexpr double least = 0.2; // metres: nearer to a mirror all is like itself
    if (!mirrors_[k].parts(ray, least))
      return false;
    const Cube there = cubes_.at(mirrors_[k].placeOn(ray));
    return boxes_[k].contains(there) &&
           cubes_.anyAround(there, [&](std::uint32_t cube) {
             return std::find(mirrors_at_[cube].begin(), mirrors_at_[cube].end(), k) !=
                    mirrors_at_[cube].end();
           });
  }

  const std::vector<Pane>& mirrors_;
  const CubeTable& cubes_;
  const CubeTable& filled_;
  std::vector<std::vector<std::uint32_t>> mirrors_at_; ///< of each cube
  std::vector<Eigen::AlignedBox3i> boxes_;             ///< of each mirror, and its rim
};

/** @brief Returns what is sure of a ray: behind a pane it may have been mirrored. */
SightLine
sureLine(const ScanRay& ray, const Pane* pane)
{
  constexpr float behind = 0.3F; // metres
  if (!pane)
    return {ray.from, ray.to};
  const Eigen::Vector3f at = pane->placeOn(ray).cast<float>();
  const Eigen::Vector3f direction = (ray.to - ray.from).normalized();
  return {ray.from, at + std::min(behind, (ray.to - at).norm()) * direction};
}

/** @brief Returns the cubes that some rays end in, and all of these rays are chosen. */
Flags
cubesOfOnly(const Flags& chosen, const std::vector<ScanRay>& rays, std::size_t cubes)
{
  Flags only(cubes, 0);
  for (const ScanRay& ray : rays)
    only[ray.cube] = 1;
  for (std::size_t r = 0; r < rays.size(); ++r)
    if (chosen[r] == 0)
      only[rays[r].cube] = 0;
  return only;
}

/** @brief Returns the points that are in one of the chosen cubes. */
Flags
pointsIn(const CubeTable& cubes,
         const Flags& chosen,
         const PointView& points,
         unsigned threads)
{
  Flags is_in(points.size(), 0);
  parallelFor(points.size(), items_a_block, threads, [&](std::size_t i) {
    if (!points.isFinite(i))
      return;
    const std::uint32_t cube = cubes.findAt(points[i].cast<double>());
    is_in[i] = cube != CubeTable::none ? chosen[cube] : 0;
  });
  return is_in;
}

} // namespace

MirroredPoints
findMirroredPoints(const PointView& thinned,
                   const PointView& rows,
                   std::size_t step,
                   const ScanPositions& positions,
                   unsigned threads)
{
  constexpr double cube_size = 0.1; // metres
  CubeTable filled(cube_size);
  for (std::size_t i = 0; i < thinned.size(); ++i)
    if (thinned.isFinite(i))
      filled.add(filled.at(thinned[i].cast<double>()));
  const PiercedSurfaces surfaces(thinned);
  MirroredPoints found;
  PaneRays through =
      throughPanes(raysOf(rows, step, positions, filled), surfaces, threads);
  found.untrue = untruePlaces(surfaces, through, rows, step, positions, threads);
  if (!found.untrue.empty()) // again: they must not count among those of a cube
    through = throughPanes(raysOf(rows, step, without(found.untrue, positions), filled),
                           surfaces, threads);
  const auto& rays = through.rays;
  const auto& panes = through.panes;
  const auto& before = through.before;
  const std::vector<Pane> mirrors = mirrorsAmong(through, filled, threads);
  const MirroredRays mirrored(mirrors, surfaces.cubes(), filled);
  Flags is_mirrored(rays.size(), 0);
  parallelFor(rays.size(), items_a_block, threads, [&](std::size_t r) {
    is_mirrored[r] = mirrored.isMirrored(rays[r]) ? 1 : 0;
  });
  Flags is_behind(rays.size(), 0);
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const Pane* const pane = before[r] < panes.size() ? &panes[before[r]] : nullptr;
    is_behind[r] = pane ? 1 : 0;
    if (is_mirrored[r] == 0)
      found.lines.push_back(sureLine(rays[r], pane));
  }
  found.rays = rays.size();
  found.mirrors = mirrors.size();
  const Flags reflections = cubesOfOnly(is_mirrored, rays, filled.size());
  found.of_thinned = pointsIn(filled, reflections, thinned, threads);
  found.of_rows = pointsIn(filled, reflections, rows, threads);
  found.behind =
      pointsIn(filled, cubesOfOnly(is_behind, rays, filled.size()), thinned, threads);
  return found;
}

} // namespace pcl::sedr
