// SPDX-License-Identifier: BSD-3-Clause
#include "shared_faces.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <cstddef>

namespace pcl::sedr {

namespace {

/** @brief Returns whether two elements are certainly farther apart than `farthest`. */
bool
areApart(const PlanElement& a, const PlanElement& b, double farthest)
{
  const double reach = (a.length() + b.length()) / 2 + farthest;
  return (a.pointAt(a.length() / 2) - b.pointAt(b.length() / 2)).norm() > reach;
}

/** @brief Returns whether a position of a wall is on another wall with its room on the
 * other side, i.e. closer than the minimum partition thickness. Where two rooms share
 * the points of one face, each has the half of the noise on its side. */
bool
isOtherSideOf(const PlanElement& e,
              double s,
              const PlanElement& other,
              const Priors& priors)
{
  constexpr double min_cosine = 0.95;
  const Eigen::Vector2d p = e.pointAt(s);
  return other.distance(p) <= priors.min_wall &&
         e.normalAt(s).dot(other.normalAt(other.project(p))) <= -min_cosine;
}

/** @brief Returns the walls of other rooms, at the same heights, to which a wall comes
 * that close anywhere. */
std::vector<PlanElement>
facesAlong(const PlanElement& e,
           const Floorplan& plan,
           std::size_t room,
           const Priors& priors)
{
  constexpr int samples = 9;
  std::vector<PlanElement> faces;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    if (r == room || !shareHeights(plan.rooms[r], plan.rooms[room]))
      continue;
    for (const auto& other : plan.rooms[r].boundary.elements) {
      if (areApart(e, other, priors.min_wall))
        continue;
      bool meets = false;
      for (int k = 0; k < samples && !meets; ++k)
        meets = isOtherSideOf(e, (k + 0.5) / samples * e.length(), other, priors);
      if (meets)
        faces.push_back(other);
    }
  }
  return faces;
}

} // namespace

std::vector<PlanElement>
facesOfOthers(const Floorplan& plan, std::size_t room, const Priors& priors)
{
  constexpr double times_longer = 1.25;
  std::vector<PlanElement> all;
  for (const auto& e : plan.rooms[room].boundary.elements) {
    if (e.length() < priors.evidence_cell)
      continue;
    const std::vector<PlanElement> faces = facesAlong(e, plan, room, priors);
    double length = 0;
    for (const auto& face : faces)
      length += face.length();
    if (length > times_longer * e.length())
      all.insert(all.end(), faces.begin(), faces.end());
  }
  return all;
}

} // namespace pcl::sedr
