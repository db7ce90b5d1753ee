// SPDX-License-Identifier: BSD-3-Clause
#include "mirror_panes.h"

#include <pcl/sedr_filters/mirrored_points.h>
#include <pcl/sedr_filters/parallel.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl {
namespace sedr {

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
    const Eigen::Vector3d from = ray.from.cast<double>();
    const Eigen::Vector3d whole = ray.to.cast<double>() - from;
    const double share =
        (mirror.offset - mirror.normal.dot(from)) / mirror.normal.dot(whole);
    const Eigen::Vector3d at = from + share * whole;
    const Cube there = cubes_.at(at);
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

/** @brief The cubes to which all rays are mirrored: 1. */
std::vector<std::uint8_t>
mirroredCubes(const std::vector<ScanRay>& rays,
              const MirroredRays& mirrored,
              std::size_t cubes,
              unsigned threads)
{
  constexpr std::size_t rays_a_block = 4096;
  std::vector<std::uint8_t> is_mirrored(rays.size(), 0);
  parallelBlocks(rays.size(), rays_a_block, threads,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t r = begin; r < end; ++r)
                     is_mirrored[r] = mirrored.isMirrored(rays[r]) ? 1 : 0;
                 });
  std::vector<std::uint8_t> is_seen(cubes, 0); // freely
  for (std::size_t r = 0; r < rays.size(); ++r)
    is_seen[rays[r].cube] |= is_mirrored[r] == 0 ? 1 : 0;
  std::vector<std::uint8_t> all(cubes, 0);
  for (std::size_t r = 0; r < rays.size(); ++r)
    all[rays[r].cube] = is_seen[rays[r].cube] == 0 ? 1 : 0;
  return all;
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
  parallelBlocks(points.size(), points_a_block, threads,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     if (!points.isFinite(i))
                       continue;
                     const std::uint32_t cube = cubes.findAt(points[i].cast<double>());
                     is_in[i] = cube != CubeTable::none ? chosen[cube] : 0;
                   }
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
  constexpr double cube_size = 0.1;   // metres
  constexpr unsigned most_a_cube = 4; // positions
  CubeTable filled(cube_size);
  for (std::size_t i = 0; i < thinned.size(); ++i)
    if (thinned.isFinite(i))
      filled.add(filled.at(thinned[i].cast<double>()));
  const std::vector<ScanRay> rays = raysOf(rows, step, positions, filled, most_a_cube);
  const PiercedSurfaces surfaces(thinned);
  const std::vector<std::uint32_t> pierced = surfaces.firstPierced(rays, threads);
  const std::vector<Pane> mirrors = mirrorsAmong(panesOf(surfaces, pierced), surfaces,
                                                 rays, pierced, filled, threads);
  MirroredPoints found;
  found.rays = rays.size();
  found.mirrors = mirrors.size();
  const std::vector<std::uint8_t> chosen = mirroredCubes(
      rays, MirroredRays(mirrors, surfaces.cubes(), filled), filled.size(), threads);
  found.of_thinned = pointsIn(filled, chosen, thinned, threads);
  found.of_rows = pointsIn(filled, chosen, rows, threads);
  return found;
}

} // namespace sedr
} // namespace pcl
