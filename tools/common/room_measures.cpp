// SPDX-License-Identifier: BSD-3-Clause
#include "room_measures.h"

#include <Eigen/Geometry>

#include <cstddef>

namespace pcl {
namespace sedr {
namespace tools {

double
meanHeight(const PlanRoom& room)
{
  constexpr double step = 0.1;
  Eigen::AlignedBox2d box;
  for (const auto& corner : room.boundary.polygon(0.01))
    box.extend(corner);
  double sum = 0;
  std::size_t count = 0;
  for (double y = box.min().y() + step / 2; y < box.max().y(); y += step)
    for (double x = box.min().x() + step / 2; x < box.max().x(); x += step) {
      const Eigen::Vector2d p(x, y);
      if (!room.contains(p))
        continue;
      sum += room.ceilingAt(p) - room.floorAt(p);
      ++count;
    }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

double
volumeOf(const PlanRoom& room, double mean_height)
{
  double volume = mean_height * room.area();
  for (const PlanNiche& niche : room.niches) {
    const Eigen::Vector2d somewhere = niche.boundary.elements.front().pointAt(0);
    volume += niche.boundary.area() *
              (niche.top.heightAt(somewhere) - niche.bottom.heightAt(somewhere));
  }
  return volume;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
