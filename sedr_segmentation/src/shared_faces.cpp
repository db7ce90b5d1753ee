// SPDX-License-Identifier: BSD-3-Clause
#include "shared_faces.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace pcl {
namespace sedr {

namespace {

/** @brief Whether a place of a wall is on another one, with its room on the other side.
 */
bool
isOtherSideOf(const PlanElement& e, double s, const PlanElement& other)
{
  constexpr double farthest = 0.025;
  constexpr double least_cosine = 0.95;
  const Eigen::Vector2d p = e.pointAt(s);
  return other.distance(p) <= farthest &&
         e.normalAt(s).dot(other.normalAt(other.project(p))) <= -least_cosine;
}

/** @brief The walls of other rooms that most of a wall runs along, one after the other
 * perhaps: between two of them it may cross a partition. */
std::vector<PlanElement>
facesAlong(const PlanElement& e, const Floorplan& plan, std::size_t room)
{
  constexpr std::size_t samples = 9;
  std::array<bool, samples> is_shared{};
  std::vector<PlanElement> faces;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    for (const auto& other : plan.rooms[r].boundary.elements) {
      bool meets = false;
      for (std::size_t k = 0; r != room && k < samples; ++k) {
        const double share =
            (static_cast<double>(k) + 0.5) / static_cast<double>(samples);
        if (!isOtherSideOf(e, share * e.length(), other))
          continue;
        is_shared[k] = true;
        meets = true;
      }
      if (meets)
        faces.push_back(other);
    }
  const auto shared = std::count(is_shared.begin(), is_shared.end(), true);
  return 10 * shared >= 6 * static_cast<std::ptrdiff_t>(samples)
             ? faces
             : std::vector<PlanElement>();
}

} // namespace

std::vector<PlanElement>
facesOfOthers(const Floorplan& plan, std::size_t room)
{
  constexpr double shortest = 0.1;
  constexpr double times_longer = 1.25;
  std::vector<PlanElement> all;
  for (const auto& e : plan.rooms[room].boundary.elements) {
    if (e.length() < shortest)
      continue;
    const std::vector<PlanElement> faces = facesAlong(e, plan, room);
    double length = 0;
    for (const auto& face : faces)
      length += face.length();
    if (length > times_longer * e.length())
      all.insert(all.end(), faces.begin(), faces.end());
  }
  return all;
}

} // namespace sedr
} // namespace pcl
