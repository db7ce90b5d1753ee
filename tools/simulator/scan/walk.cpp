// SPDX-License-Identifier: BSD-3-Clause
#include "walk.h"

#include <algorithm>

namespace pcl::sedr::sim {

namespace {

/** @brief Returns the point @p s metres along a path, or its end if that is nearer. */
Vec2
alongPath(const std::vector<Vec2>& path, double s)
{
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2 step = path[i + 1] - path[i];
    const double size = length(step);
    if (s <= size)
      return path[i] + s * normalized(step);
    s -= size;
  }
  return path.back();
}

} // namespace

std::vector<Vec3>
walkAlong(const std::vector<Vec2>& path, std::size_t count, double height, double sway)
{
  double total = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    total += length(path[i + 1] - path[i]);
  const auto last = static_cast<double>(std::max<std::size_t>(count, 2) - 1);
  std::vector<Vec3> stations;
  for (std::size_t i = 0; i < count; ++i) {
    const auto step = static_cast<double>(i);
    const Vec2 position = alongPath(path, total * step / last);
    stations.push_back(lifted(position, height + sway * std::sin(2.1 * step)));
  }
  return stations;
}

} // namespace pcl::sedr::sim
