// SPDX-License-Identifier: BSD-3-Clause
#include "panes.h"

#include "../grids/disjoint_sets.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <random>

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

/** @brief Takes planes out of the cubes of a region, the largest first. */
class PaneSearch {
public:
  PaneSearch(const PiercedSurfaces& surfaces, std::vector<std::uint32_t> region)
      : surfaces_(surfaces)
      , left_(std::move(region))
  {}

  std::vector<Pane> run()
  {
    std::vector<Pane> panes;
    while (left_.size() >= fewest_cubes) {
      Pane best;
      constexpr int trials = 60;
      for (int k = 0; k < trials; ++k) {
        Pane pane;
        if (!throughThree(pane))
          continue;
        pane.cubes = cubesOf(pane);
        if (pane.cubes.size() > best.cubes.size())
          best = std::move(pane);
      }
      if (best.cubes.size() < fewest_cubes)
        return panes;
      refine(best);
      std::vector<std::uint32_t> rest;
      std::set_difference(left_.begin(), left_.end(), best.cubes.begin(),
                          best.cubes.end(), std::back_inserter(rest));
      left_ = std::move(rest);
      panes.push_back(std::move(best));
    }
    return panes;
  }

private:
  /** @brief A point of a cube of the region, which the random number chooses. */
  Eigen::Vector3d anyPointOf(std::uint32_t cube)
  {
    const auto& places = surfaces_.pointsOf(cube);
    return places[random_() % places.size()].cast<double>();
  }

  /** @brief The plane through three points that are 0.4 to 1.5 m apart.
   * @return false where chance has found none */
  bool throughThree(Pane& pane)
  {
    constexpr double nearest = 0.4;
    constexpr double farthest = 1.5;
    constexpr int tries = 30;
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < tries && points.size() < 3; ++k) {
      const Eigen::Vector3d p = anyPointOf(left_[random_() % left_.size()]);
      const bool fits = std::all_of(points.begin(), points.end(), [&](const auto& q) {
        return (p - q).norm() > nearest && (p - q).norm() < farthest;
      });
      if (fits)
        points.push_back(p);
    }
    if (points.size() < 3)
      return false;
    const Eigen::Vector3d normal = (points[1] - points[0]).cross(points[2] - points[0]);
    if (normal.norm() < nearest * nearest / 2)
      return false;
    pane.normal = normal.normalized();
    pane.offset = pane.normal.dot(points[0]);
    return true;
  }

  std::vector<std::uint32_t> cubesOf(const Pane& pane) const
  {
    std::vector<std::uint32_t> cubes;
    std::copy_if(left_.begin(), left_.end(), std::back_inserter(cubes),
                 [&](std::uint32_t cube) {
                   const auto& places = surfaces_.pointsOf(cube);
                   return std::any_of(places.begin(), places.end(),
                                      [&](const auto& p) { return isOn(pane, p); });
                 });
    return cubes;
  }

  static bool isOn(const Pane& pane, const Eigen::Vector3f& p)
  {
    return std::abs(pane.normal.dot(p.cast<double>()) - pane.offset) < thickness;
  }

  /** @brief Least squares through the points on a pane. */
  void refine(Pane& pane) const
  {
    std::vector<Eigen::Vector3d> points;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const std::uint32_t cube : pane.cubes)
      for (const Eigen::Vector3f& p : surfaces_.pointsOf(cube))
        if (isOn(pane, p)) {
          points.push_back(p.cast<double>());
          mean += points.back();
        }
    mean /= static_cast<double>(points.size());
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& p : points)
      squares += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
    pane.normal = solver.eigenvectors().col(0);
    pane.offset = pane.normal.dot(mean);
  }

  const PiercedSurfaces& surfaces_;
  std::vector<std::uint32_t> left_; ///< cubes, increasing
  std::mt19937 random_{1};
};

} // namespace

std::vector<Pane>
panesOf(const PiercedSurfaces& surfaces, const std::vector<std::uint32_t>& pierced)
{
  std::vector<Pane> panes;
  for (auto& region : piercedRegions(surfaces.cubes(), pierced))
    for (Pane& pane : PaneSearch(surfaces, std::move(region)).run())
      panes.push_back(std::move(pane));
  return panes;
}

} // namespace pcl::sedr
