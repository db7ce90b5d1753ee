// SPDX-License-Identifier: BSD-3-Clause
#include "pierced_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

constexpr double cube_size = 0.25; // metres
constexpr float around = 0.3F;     // metres: how far from a ray its points may be
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
          x * x + y * y < around * around)
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

} // namespace pcl::sedr
