// SPDX-License-Identifier: BSD-3-Clause
#include "panes.h"

#include "../base/parallel.h"
#include "../grids/disjoint_sets.h"
#include "sight_lines.h"

#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_plane.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <tuple>

namespace pcl::sedr {
namespace {

constexpr double cube_size = 0.25; // metres
constexpr float ray_reach = 0.3F;  // metres: how far from a ray its points may be
constexpr float before_end = 0.4F; // metres of a ray in which it meets what it ends on

/** @brief Returns in which eighth of a turn a direction is. */
unsigned
eighthOf(float x, float y)
{
  const unsigned half = y < 0 ? 4 : 0;
  const unsigned quarter = (x < 0) != (y < 0) ? 2 : 0;
  const bool is_second = (std::abs(y) > std::abs(x)) != (quarter != 0);
  return half + quarter + (is_second ? 1 : 0);
}

/** @brief Checks that no three eighths side by side are empty: no half of a turn is. */
bool
surrounds(unsigned eighths)
{
  const unsigned empty = ~eighths & 0xffU;
  const unsigned twice = empty | empty << 8;
  return (twice & twice >> 1 & twice >> 2 & 0xffU) == 0;
}

/** @brief Goes along a ray from cube to cube. */
class CubeWalk {
public:
  CubeWalk(const CubeTable& cubes,
           const Eigen::Vector3d& from,
           const Eigen::Vector3d& direction)
      : cube_(cubes.at(from))
  {
    for (int axis = 0; axis < 3; ++axis) {
      const double speed = std::abs(direction[axis]);
      step_[axis] = direction[axis] < 0 ? -1 : 1;
      stride_[axis] =
          speed > 1e-9 ? cubes.edge() / speed : std::numeric_limits<double>::infinity();
      const double wall = cubes.edge() * (cube_[axis] + (step_[axis] > 0 ? 1 : 0));
      next_[axis] = speed > 1e-9 ? std::abs(wall - from[axis]) / speed
                                 : std::numeric_limits<double>::infinity();
    }
  }

  const Cube& cube() const { return cube_; }

  /** @brief Where the ray leaves the cube, metres. */
  double end() const { return next_.minCoeff(); }

  void goOn()
  {
    Eigen::Index axis = 0;
    next_.minCoeff(&axis);
    cube_[axis] += step_[axis];
    next_[axis] += stride_[axis];
  }

private:
  Cube cube_;
  Cube step_;
  Eigen::Vector3d stride_;
  Eigen::Vector3d next_;
};

} // namespace

PiercedSurfaces::PiercedSurfaces(const PointView& points)
    : points_(points, cube_size)
{
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.isFinite(i))
      box_.extend(points[i]);
  if (!box_.isEmpty()) {
    const Eigen::Vector3f rim = Eigen::Vector3f::Constant(cube_size);
    box_ = Eigen::AlignedBox3f(box_.min() - rim, box_.max() + rim);
  }
}

bool
PiercedSurfaces::isSurrounded(const Eigen::Vector3f& from,
                              const Eigen::Vector3f& direction,
                              float along,
                              const Cube& cube) const
{
  constexpr auto depth = static_cast<float>(1.5 * cube_size);
  const Eigen::Vector3f u = direction.unitOrthogonal();
  const Eigen::Vector3f v = direction.cross(u);
  unsigned eighths = 0;
  return cubes().anyAround(cube, [&](std::uint32_t near_cube) {
    for (const Eigen::Vector3f& p : pointsOf(near_cube)) {
      const Eigen::Vector3f to = p - from;
      const float x = to.dot(u);
      const float y = to.dot(v);
      if (std::abs(to.dot(direction) - along) <= depth &&
          x * x + y * y < ray_reach * ray_reach)
        eighths |= 1U << eighthOf(x, y);
    }
    return surrounds(eighths);
  });
}

float
PiercedSurfaces::entryOf(const ScanRay& ray) const
{
  const Eigen::Vector3f whole = ray.to - ray.from;
  float share = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (whole[axis] != 0) {
      const float side = whole[axis] > 0 ? box_.min()[axis] : box_.max()[axis];
      share = std::max(share, (side - ray.from[axis]) / whole[axis]);
    }
  return std::min(share, 1.0F) * whole.norm();
}

std::uint32_t
PiercedSurfaces::firstPierced(const ScanRay& ray) const
{
  const Eigen::Vector3f whole = ray.to - ray.from;
  const float length = whole.norm() - before_end;
  if (!(length > before_end))
    return CubeTable::none;
  const Eigen::Vector3f direction = whole.normalized();
  const float entry = entryOf(ray);
  const Eigen::Vector3f start = ray.from + entry * direction;
  CubeWalk walk(cubes(), start.cast<double>(), direction.cast<double>());
  float begin = entry;
  while (begin < length) {
    const auto end = entry + static_cast<float>(walk.end());
    const std::uint32_t cube = cubes().find(walk.cube());
    if (cube != CubeTable::none && end > before_end &&
        isSurrounded(ray.from, direction, (begin + end) / 2, walk.cube()))
      return cube;
    begin = end;
    walk.goOn();
  }
  return CubeTable::none;
}

namespace {

constexpr double thickness = 0.03;      // metres, of a pane to either side
constexpr std::size_t fewest_rays = 3;  // through a cube
constexpr std::size_t fewest_cubes = 6; // of a pane: a third of a square metre

/** @brief The cubes that several rays went through, by the regions that they make, the
 * numbers in each increasing. */
std::vector<std::vector<std::uint32_t>>
piercedRegions(const CubeTable& cubes, const std::vector<std::uint32_t>& pierced)
{
  std::vector<std::size_t> rays(cubes.size(), 0);
  for (const std::uint32_t cube : pierced)
    if (cube != CubeTable::none)
      ++rays[cube];
  DisjointSets<> sets(cubes.size());
  for (std::uint32_t k = 0; k < cubes.size(); ++k)
    if (rays[k] >= fewest_rays)
      cubes.anyAround(cubes[k], [&](std::uint32_t other) {
        if (rays[other] >= fewest_rays)
          sets.join(k, other);
        return false;
      });
  std::map<std::uint32_t, std::vector<std::uint32_t>> regions;
  for (std::uint32_t k = 0; k < cubes.size(); ++k)
    if (rays[k] >= fewest_rays)
      regions[sets.find(k)].push_back(k);
  std::vector<std::vector<std::uint32_t>> all;
  all.reserve(regions.size());
  for (auto& region : regions)
    all.push_back(std::move(region.second));
  return all;
}

/** @brief Takes planes out of the cubes of a region, the largest first, by RANSAC.
 * @param left cubes, increasing */
void
addPanes(const PiercedSurfaces& surfaces,
         std::vector<std::uint32_t> left,
         std::vector<Pane>& panes)
{
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  constexpr int trials = 300;
  constexpr double farthest = 1.5; // metres between the points of a trial
  while (left.size() >= fewest_cubes) {
    const Cloud::Ptr points(new Cloud);
    std::vector<std::uint32_t> cube_of;
    for (const std::uint32_t cube : left)
      for (const Eigen::Vector3f& p : surfaces.pointsOf(cube)) {
        points->push_back({p.x(), p.y(), p.z()});
        cube_of.push_back(cube);
      }
    const auto model =
        pcl::make_shared<pcl::SampleConsensusModelPlane<pcl::PointXYZ>>(points);
    const auto tree = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
    tree->setInputCloud(points);
    model->setSamplesMaxDist(farthest, tree);
    pcl::RandomSampleConsensus<pcl::PointXYZ> search(model, thickness);
    search.setMaxIterations(trials);
    pcl::Indices inliers;
    Eigen::VectorXf plane;
    if (!search.computeModel())
      return;
    search.getInliers(inliers);
    search.getModelCoefficients(plane);
    model->optimizeModelCoefficients(inliers, plane, plane);
    Pane pane;
    pane.normal = plane.head<3>().cast<double>();
    pane.offset = -plane[3];
    for (const int i : inliers) // increasing
      if (const auto cube = cube_of[static_cast<std::size_t>(i)];
          pane.cubes.empty() || pane.cubes.back() != cube)
        pane.cubes.push_back(cube);
    if (pane.cubes.size() < fewest_cubes)
      return;
    std::vector<std::uint32_t> rest;
    std::set_difference(left.begin(), left.end(), pane.cubes.begin(), pane.cubes.end(),
                        std::back_inserter(rest));
    left = std::move(rest);
    panes.push_back(std::move(pane));
  }
}

} // namespace

std::vector<Pane>
panesOf(const PiercedSurfaces& surfaces, const std::vector<std::uint32_t>& pierced)
{
  std::vector<Pane> panes;
  for (auto& region : piercedRegions(surfaces.cubes(), pierced))
    addPanes(surfaces, std::move(region), panes);
  return panes;
}

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
    // As many as there would be if all directions had the same.
    const double usual = static_cast<double>(lines.size()) * radius * radius * start /
                         (4 * std::pow(distance, 3));
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
