// SPDX-License-Identifier: BSD-3-Clause
#include "panes.h"

#include "../base/parallel.h"
#include "sight_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace pcl::sedr {
namespace {

/** @brief What is said to be taken from one place. */
struct Taken {
  Eigen::Vector3f from;
  std::vector<std::uint32_t> rows;
  std::vector<std::size_t> rays;
  bool is_true = true;
};

/** @brief Whether a place is on a surface, as the corner of a room that is taken for
 * the origin. A scanner stands free, and gets no points from itself. */
bool
isOnSurface(const Eigen::Vector3f& place, const PiercedSurfaces& surfaces)
{
  constexpr float nearest = 0.12F; // metres
  constexpr float around = 0.25F;  // metres: returns of no range are no surface
  std::size_t near = 0;
  std::size_t beyond = 0;
  const CubeTable& cubes = surfaces.cubes();
  cubes.anyAround(cubes.at(place.cast<double>()), [&](std::uint32_t cube) {
    for (const Eigen::Vector3f& p : surfaces.pointsOf(cube)) {
      const float distance = (p - place).norm();
      if (distance < around)
        ++(distance < nearest ? near : beyond);
    }
    return false;
  });
  return near >= 3 && beyond >= 8;
}

SightLines
linesOf(const Taken& taken, const PointView& rows)
{
  constexpr std::size_t enough = 1000000;
  const std::size_t stride = taken.rows.size() / enough + 1;
  std::vector<SightLine> lines;
  for (std::size_t k = 0; k < taken.rows.size(); k += stride)
    lines.push_back({taken.from, rows[taken.rows[k]]});
  return SightLines(lines);
}

/** @brief Returns how many of some rays from a place there are in a steradian where
 * there are any: a scan may have been cut. */
double
raysInSteradian(std::size_t rays, const Taken& taken, const PointView& rows)
{
  constexpr int around = 72;
  constexpr int upwards = 36; // of the sine: all bins have one solid angle
  std::vector<std::uint8_t> is_filled(static_cast<std::size_t>(around) * upwards, 0);
  for (const std::uint32_t row : taken.rows) {
    const Eigen::Vector3f way = (rows[row] - taken.from).normalized();
    const double turn = std::atan2(way.y(), way.x()) / (2 * M_PI) + 0.5;
    const int k = std::min(static_cast<int>(around * turn), around - 1);
    const int j = std::min(static_cast<int>(upwards * (way.z() + 1) / 2), upwards - 1);
    is_filled[static_cast<std::size_t>(j * around + k)] = 1;
  }
  const auto filled = std::count(is_filled.begin(), is_filled.end(), 1);
  return static_cast<double>(rays) * around * upwards /
         (4 * M_PI * static_cast<double>(std::max<std::ptrdiff_t>(filled, 1)));
}

/** @brief Whether few of the rays from a place contradict it. */
bool
isTrue(const Taken& taken, const PaneRays& through, const PointView& rows)
{
  constexpr std::size_t enough = 1000;    // rays
  constexpr double most = 0.1;            // of them, wrong
  constexpr std::size_t fewest = 5;       // wrong rays: fewer may be strays
  constexpr float shortest = 1.2F;        // metres, of a ray that tells something
  constexpr double clear = 0.4;           // metres before a pane and behind it
  constexpr double most_returned = 0.5;   // share of the rays; a wall returns more
  constexpr double fullest = 2.5;         // times as many rays as elsewhere
  constexpr double telling = 100;         // rays
  constexpr double least_returned = 0.02; // share of the rays that tells a pane
  constexpr double least_of_pane = 0.005; // that any pane returns
  const SightLines lines = linesOf(taken, rows);
  const double usual_density = raysInSteradian(lines.size(), taken, rows);
  std::size_t looked_at = 0;
  std::size_t too_full = 0;
  std::size_t bare = 0;
  double bare_ended = 0; // together, as one pane has too few rays
  double bare_all = 0;
  const std::size_t stride = taken.rays.size() / enough + 1;
  for (std::size_t k = 0; k < taken.rays.size(); k += stride) {
    const ScanRay& ray = through.rays[taken.rays[k]];
    if ((ray.to - ray.from).norm() < shortest)
      continue;
    ++looked_at;
    if (through.before[taken.rays[k]] == through.panes.size())
      continue;
    const Pane& pane = through.panes[through.before[taken.rays[k]]];
    const double start =
        std::abs(pane.normal.dot(taken.from.cast<double>()) - pane.offset);
    if (start < clear || !pane.parts(ray, clear))
      continue;
    const Eigen::Vector3d place = pane.placeOn(ray);
    const double distance = (place - taken.from.cast<double>()).norm();
    const double radius = std::max(0.15, 0.01 * distance); // metres
    const SightLines::Crossings seen = lines.across(place, pane.normal, radius);
    const auto ended = static_cast<double>(seen.on);
    const auto all = static_cast<double>(seen.on + seen.through);
    // As many as there would be if all directions that have any had the same.
    const double usual =
        usual_density * M_PI * radius * radius * start / std::pow(distance, 3);
    if (ended > most_returned * all || all > fullest * usual + telling)
      ++too_full;
    else if (all >= telling && ended < least_returned * all) {
      ++bare;
      bare_ended += ended;
      bare_all += all;
    }
  }
  const bool are_panes = bare_ended >= least_of_pane * bare_all;
  const std::size_t wrong = too_full + (are_panes ? 0 : bare);
  return wrong < fewest ||
         static_cast<double>(wrong) <= most * static_cast<double>(looked_at);
}

} // namespace

std::vector<Eigen::Vector3f>
untruePlaces(const PiercedSurfaces& surfaces,
             const PaneRays& through,
             const PointView& rows,
             std::size_t step,
             const ScanPositions& positions,
             unsigned threads)
{
  std::map<std::tuple<float, float, float>, std::size_t> number;
  std::vector<Taken> all;
  const auto takenFrom = [&](const Eigen::Vector3f& from) -> Taken& {
    const auto [at, is_new] =
        number.emplace(std::tuple(from.x(), from.y(), from.z()), all.size());
    if (is_new)
      all.push_back({from, {}, {}});
    return all[at->second];
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t position = positionOfRow(positions, i * step);
    if (position < positions.size() && positions[position].isKnown() &&
        rows.isFinite(i))
      takenFrom(positions[position].place)
          .rows.push_back(static_cast<std::uint32_t>(i));
  }
  for (std::size_t r = 0; r < through.rays.size(); ++r)
    takenFrom(through.rays[r].from).rays.push_back(r);
  parallelBlocks(all.size(), 1, threads, [&](std::size_t k, std::size_t) {
    all[k].is_true =
        !isOnSurface(all[k].from, surfaces) && isTrue(all[k], through, rows);
  });
  std::vector<Eigen::Vector3f> untrue;
  for (const Taken& taken : all)
    if (!taken.is_true)
      untrue.push_back(taken.from);
  return untrue;
}

} // namespace pcl::sedr
