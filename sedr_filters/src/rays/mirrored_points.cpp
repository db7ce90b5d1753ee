// SPDX-License-Identifier: BSD-3-Clause
#include "mirror_panes.h"

#include "../base/parallel_for.h"
#include "mirrored_points.h"
#include "true_places.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Which rays meet reflections. */
class MirroredRays {
public:
  MirroredRays(const std::vector<Pane>& mirrors,
               const CubeTable& cubes,
               const CubeTable& filled)
      : mirrors_(mirrors)
      , cubes_(cubes)
      , filled_(filled)
      , mirrors_at_(cubes.size())
  {
    boxes_.resize(mirrors.size());
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
    const Pane& mirror = mirrors_[k];
    if (!mirror.parts(ray, least))
      return false;
    const Cube there = cubes_.at(mirror.placeOn(ray));
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

/** @brief Which rays are mirrored: 1. */
std::vector<std::uint8_t>
mirroredAmong(const std::vector<ScanRay>& rays,
              const MirroredRays& mirrored,
              unsigned threads)
{
  constexpr std::size_t rays_a_block = 4096;
  std::vector<std::uint8_t> is_mirrored(rays.size(), 0);
  parallelFor(rays.size(), rays_a_block, threads, [&](std::size_t r) {
    is_mirrored[r] = mirrored.isMirrored(rays[r]) ? 1 : 0;
  });
  return is_mirrored;
}

/** @brief The panes that rays go through first, null for those that go through none. */
std::vector<const Pane*>
panesBefore(const std::vector<Pane>& panes,
            const std::vector<ScanRay>& rays,
            const std::vector<std::uint32_t>& pierced,
            std::size_t cubes)
{
  constexpr double depth = 0.2; // metres behind it
  std::vector<const Pane*> pane_of(cubes, nullptr);
  for (const Pane& pane : panes)
    for (const std::uint32_t cube : pane.cubes)
      pane_of[cube] = &pane;
  std::vector<const Pane*> before(rays.size(), nullptr);
  for (std::size_t r = 0; r < rays.size(); ++r)
    if (pierced[r] != CubeTable::none && pane_of[pierced[r]] &&
        pane_of[pierced[r]]->parts(rays[r], depth))
      before[r] = pane_of[pierced[r]];
  return before;
}

/** @brief What is sure of a ray: behind a pane it may have been mirrored. */
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

/** @brief Positions of which some places are not known. */
ScanPositions
without(const std::vector<Eigen::Vector3f>& places, ScanPositions positions)
{
  for (ScanPosition& position : positions)
    if (std::find(places.begin(), places.end(), position.place) != places.end())
      position.place.setConstant(std::numeric_limits<float>::quiet_NaN());
  return positions;
}

/** @brief The cubes all of whose rays are among some: 1. */
std::vector<std::uint8_t>
cubesOfOnly(const std::vector<std::uint8_t>& chosen,
            const std::vector<ScanRay>& rays,
            std::size_t cubes)
{
  std::vector<std::uint8_t> only(cubes, 0);
  for (const ScanRay& ray : rays)
    only[ray.cube] = 1;
  for (std::size_t r = 0; r < rays.size(); ++r)
    if (chosen[r] == 0)
      only[rays[r].cube] = 0;
  return only;
}

/** @brief The points that are in one of the chosen cubes: 1. */
std::vector<std::uint8_t>
pointsIn(const CubeTable& cubes,
         const std::vector<std::uint8_t>& chosen,
         const PointView& points,
         unsigned threads)
{
  constexpr std::size_t points_a_block = 16384;
  std::vector<std::uint8_t> is_in(points.size(), 0);
  parallelFor(points.size(), points_a_block, threads, [&](std::size_t i) {
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
  constexpr double cube_size = 0.1;  // metres
  constexpr unsigned max_a_cube = 4; // positions
  CubeTable filled(cube_size);
  for (std::size_t i = 0; i < thinned.size(); ++i)
    if (thinned.isFinite(i))
      filled.add(filled.at(thinned[i].cast<double>()));
  std::vector<ScanRay> rays = raysOf(rows, step, positions, filled, max_a_cube);
  const PiercedSurfaces surfaces(thinned);
  MirroredPoints found;
  found.untrue = untruePlaces(surfaces, rays, rows, step, positions, threads);
  // Again, as untrue positions must not count among those of a cube.
  if (!found.untrue.empty())
    rays = raysOf(rows, step, without(found.untrue, positions), filled, max_a_cube);
  const std::vector<std::uint32_t> pierced = surfaces.firstPierced(rays, threads);
  const std::vector<Pane> panes = panesOf(surfaces, pierced);
  const std::vector<const Pane*> before =
      panesBefore(panes, rays, pierced, surfaces.cubes().size());
  std::vector<std::uint8_t> is_behind(rays.size(), 0);
  for (std::size_t r = 0; r < rays.size(); ++r)
    is_behind[r] = before[r] ? 1 : 0;
  const std::vector<Pane> mirrors =
      mirrorsAmong(panes, surfaces, rays, pierced, filled, threads);
  const std::vector<std::uint8_t> is_mirrored =
      mirroredAmong(rays, MirroredRays(mirrors, surfaces.cubes(), filled), threads);
  found.rays = rays.size();
  found.mirrors = mirrors.size();
  const auto chosen = cubesOfOnly(is_mirrored, rays, filled.size());
  found.of_thinned = pointsIn(filled, chosen, thinned, threads);
  found.of_rows = pointsIn(filled, chosen, rows, threads);
  found.behind =
      pointsIn(filled, cubesOfOnly(is_behind, rays, filled.size()), thinned, threads);
  for (std::size_t r = 0; r < rays.size(); ++r)
    if (is_mirrored[r] == 0)
      found.lines.push_back(sureLine(rays[r], before[r]));
  return found;
}

} // namespace pcl::sedr
