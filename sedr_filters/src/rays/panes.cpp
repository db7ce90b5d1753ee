// SPDX-License-Identifier: BSD-3-Clause
#include "panes.h"

#include "../grids/disjoint_sets.h"

#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_plane.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

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

} // namespace pcl::sedr
