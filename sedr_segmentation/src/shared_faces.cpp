// SPDX-License-Identifier: BSD-3-Clause
#include "shared_faces.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief Whether a wall runs along another one, with its room on the other side. */
bool
isOtherSideOf(const PlanElement& e, const PlanElement& other)
{
  constexpr double farthest = 0.025;
  constexpr double least_cosine = 0.95;
  for (const double share : {0.2, 0.5, 0.8}) {
    const double s = share * e.length();
    const Eigen::Vector2d p = e.pointAt(s);
    if (other.distance(p) > farthest ||
        e.normalAt(s).dot(other.normalAt(other.project(p))) > -least_cosine)
      return false;
  }
  return true;
}

} // namespace

std::vector<PlanElement>
facesOfOthers(const Floorplan& plan, std::size_t room)
{
  constexpr double shortest = 0.1;
  constexpr double times_longer = 2;
  std::vector<PlanElement> faces;
  for (const auto& e : plan.rooms[room].boundary.elements) {
    if (e.length() < shortest)
      continue;
    for (std::size_t r = 0; r < plan.rooms.size(); ++r)
      for (const auto& other : plan.rooms[r].boundary.elements)
        if (r != room && other.length() > times_longer * e.length() &&
            isOtherSideOf(e, other))
          faces.push_back(other);
  }
  return faces;
}

} // namespace sedr
} // namespace pcl
