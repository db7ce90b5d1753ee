// SPDX-License-Identifier: BSD-3-Clause
#include "ceiling_meeting.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

constexpr double border_error = 0.1; ///< of facets, by their cells, metres

Eigen::Vector2d
slopeAt(const PlanSlab& slab, const Eigen::Vector2d& place)
{
  const Eigen::Vector3d up = slab.normalAt(place);
  return -up.head<2>() / up.z();
}

} // namespace

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
  // Where one surface falls steeply, such a step may be a border that is a cell off.
  const double off = std::abs(left[0] - right[0]);
  const bool do_meet = off < std::max(step, border_error * std::abs(a + b));
  Meeting meeting;
  meeting.is_step = !do_meet;
  meeting.is_ridge = do_meet && a < -falls && b < -falls;
  meeting.is_crease = meeting.is_ridge || (do_meet && a > falls && b > falls);
  meeting.is_seen = meeting.is_crease || !do_meet || std::abs(a + b) > bends;
  return meeting;
}

Eigen::Vector2d
placeOfMeeting(const std::vector<Limit>& limits, const Eigen::Vector2d& start)
{
  constexpr double reach = 2 * border_error; // where lines cross at a slant
  constexpr double certain = 0.1; // slopes, or ways of lines, that differ by less say
                                  // nothing of a place
  constexpr int rounds = 8;
  using Squares = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>;
  Eigen::Vector2d place = start;
  for (int round = 0; round < rounds; ++round) {
    Eigen::Matrix2d fixed = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d meeting = Eigen::Matrix2d::Zero();
    Eigen::Vector2d off = Eigen::Vector2d::Zero();
    for (const Limit& limit : limits) {
      Eigen::Vector2d slope = Eigen::Vector2d::Zero();
      if (limit.left)
        slope = slopeAt(*limit.left, place) - slopeAt(*limit.right, place);
      if (!(slope.norm() > certain)) {
        fixed += limit.normal * limit.normal.transpose();
        continue;
      }
      const double height = limit.left->heightAt(place) - limit.right->heightAt(place);
      meeting += slope * slope.transpose() / slope.squaredNorm();
      off += height / slope.squaredNorm() * slope;
    }
    const Squares held(fixed);
    Eigen::Matrix2d free = Eigen::Matrix2d::Zero();
    for (int k = 0; k < 2; ++k)
      if (held.eigenvalues()[k] <= certain * certain)
        free += held.eigenvectors().col(k) * held.eigenvectors().col(k).transpose();
    const Squares met(free * meeting * free);
    for (int k = 0; k < 2; ++k)
      if (met.eigenvalues()[k] > certain * certain)
        place -= met.eigenvectors().col(k).dot(free * off) / met.eigenvalues()[k] *
                 met.eigenvectors().col(k);
    if (!((place - start).norm() < reach))
      return start;
  }
  return place;
}

} // namespace pcl::sedr
