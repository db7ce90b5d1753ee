// SPDX-License-Identifier: BSD-3-Clause
#include "ceiling_meeting.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

Meeting
meetingOf(const Eigen::Vector2d& left,
          const Eigen::Vector2d& right,
          double beside,
          double roughness)
{
  constexpr double certain = 3;                            // times the roughness
  const double step = std::max(0.03, certain * roughness); // higher ones are no creases
  constexpr double falls = 0.02;                           // slope beside the line: 2 %
  constexpr double facet = 1; // metre; on one of that length a slope is known as well
                              // as its height
  const double bends = std::max(0.1, certain * roughness / facet); // 6 degrees
  const double a = (left[1] - left[0]) / beside;
  const double b = (right[1] - right[0]) / beside;
  const bool do_meet = std::abs(left[0] - right[0]) < step;
  Meeting meeting;
  meeting.is_ridge = do_meet && a < -falls && b < -falls;
  meeting.is_crease = meeting.is_ridge || (do_meet && a > falls && b > falls);
  meeting.is_seen = meeting.is_crease || !do_meet || std::abs(a + b) > bends;
  return meeting;
}

std::optional<Eigen::Vector2d>
placeOfMeeting(const PlanSlab& left, const PlanSlab& right, Eigen::Vector2d place)
{
  constexpr double reach = 0.3;      // metres
  constexpr double same = 0.001;     // metres of height
  constexpr double min_slope = 0.05; // of one against the other
  constexpr int max_steps = 8;
  const auto slopeOf = [&](const PlanSlab& slab) -> Eigen::Vector2d {
    const Eigen::Vector3d up = slab.normalAt(place);
    return -up.head<2>() / up.z();
  };
  const Eigen::Vector2d start = place;
  for (int k = 0; k < max_steps; ++k) {
    const double off = left.heightAt(place) - right.heightAt(place);
    if (std::abs(off) < same)
      return place;
    const Eigen::Vector2d slope = slopeOf(left) - slopeOf(right);
    if (!(slope.norm() > min_slope))
      return std::nullopt;
    place -= off / slope.squaredNorm() * slope;
    if (!((place - start).norm() < reach))
      return std::nullopt;
  }
  return std::nullopt;
}

} // namespace pcl::sedr
