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

} // namespace pcl::sedr
