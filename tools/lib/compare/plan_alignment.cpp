// SPDX-License-Identifier: BSD-3-Clause
#include "plan_alignment.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::sedr::tools {

namespace {

/** @brief A point of a wall, and the direction into its room. */
struct Sample {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  RoomHeights heights; ///< of the room
  double weight = 1;
};

/** @brief Returns whether another room lies behind a wall, within the thickness of
 * partitions. */
bool
isPartition(const std::vector<const PlanRoom*>& rooms, const Sample& sample)
{
  for (const PlanRoom* room : rooms)
    for (const double depth : {0.15, 0.3, 0.6}) // metres
      if (room->contains(sample.place - depth * sample.normal))
        return true;
  return false;
}

/** @brief Samples all walls. Partitions have less weight, as they are rebuilt more
 * often than outer walls. */
std::vector<Sample>
samplesOf(const Floorplan& plan)
{
  constexpr double step = 0.1; // metres, along walls
  constexpr double of_partition = 0.25;
  std::vector<Sample> samples;
  for (const auto& room : plan.rooms) {
    const RoomHeights heights = heightsOf(room);
    const auto beside = roomsAt(plan, heights);
    for (const auto& wall : room.boundary.elements) {
      const auto count = static_cast<std::size_t>(wall.length() / step);
      for (std::size_t k = 0; k < count; ++k) {
        const double s =
            wall.length() * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
        samples.push_back({wall.pointAt(s), wall.normalAt(s), heights});
        if (isPartition(beside, samples.back()))
          samples.back().weight = of_partition;
      }
    }
  }
  return samples;
}

/** @brief Finds the nearest point of a plan's walls with the same orientation, in rooms
 * at the sample's heights.
 * @param heights of the plan's rooms
 * @return false if there is none within `reach` */
bool
findPartner(const Floorplan& plan,
            const std::vector<RoomHeights>& heights,
            const Sample& sample,
            double reach,
            Sample& partner)
{
  const double alike = std::cos(M_PI / 6); // between directions
  double least = reach;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    if (!shareHeights(heights[r], sample.heights))
      continue;
    for (const auto& wall : plan.rooms[r].boundary.elements) {
      const double s = wall.project(sample.place);
      const double distance = (wall.pointAt(s) - sample.place).norm();
      if (distance < least && wall.normalAt(s).dot(sample.normal) > alike) {
        least = distance;
        partner = {wall.pointAt(s), wall.normalAt(s), sample.heights};
      }
    }
  }
  return least < reach;
}

/** @brief Returns the centre of the densest interval of half a metre, less than the
 * distance of storeys; the smaller one of equals. 0 without values. */
double
commonValue(std::vector<double> values)
{
  constexpr double near = 0.5; // metres
  std::sort(values.begin(), values.end());
  double common = 0;
  std::size_t most = 0;
  std::size_t first = 0;
  for (std::size_t end = 1; end <= values.size(); ++end) {
    while (values[end - 1] - values[first] > near)
      ++first;
    const double middle = values[first + (end - first) / 2];
    if (end - first < most ||
        (end - first == most && std::abs(middle) >= std::abs(common)))
      continue;
    most = end - first;
    common = middle;
  }
  return common;
}

/** @brief Returns the height offset of a plan's floors from another one's: the
 * difference that most places support. Where rooms lie above each other, all pairs of
 * floors contribute. */
double
riseOf(const Floorplan& moving, const Floorplan& fixed)
{
  std::vector<double> rises;
  for (const auto& sample : samplesOf(moving)) {
    const Eigen::Vector2d inside = sample.place + 0.3 * sample.normal;
    for (const PlanRoom& b : fixed.rooms)
      for (const PlanRoom& a : moving.rooms)
        if (b.contains(inside) && a.contains(inside))
          rises.push_back(b.floorAt(inside) - a.floorAt(inside));
  }
  return commonValue(rises);
}

/** @brief Least squares of a small turn about a pivot and a shift, x and y first. */
struct Step {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
  double weights = 0;
  std::size_t partners = 0;

  /** @brief Adds the distance of a point from a line: sliding along the wall has no
   * cost. Distances beyond `scale` hardly count. */
  void add(const Sample& now,
           const Sample& partner,
           const Eigen::Vector2d& pivot,
           double scale)
  {
    const double residual = partner.normal.dot(partner.place - now.place);
    const Eigen::Vector2d arm = now.place - pivot;
    const Eigen::Vector3d row(partner.normal.x(), partner.normal.y(),
                              arm.x() * partner.normal.y() -
                                  arm.y() * partner.normal.x());
    const double nearness = scale * scale / (scale * scale + residual * residual);
    const double weight = now.weight * nearness * nearness;
    matrix += weight * row * row.transpose();
    right_side += weight * row * residual;
    weights += weight;
    ++partners;
  }

  Eigen::Vector3d solve() const
  {
    // Regularises the direction along a long corridor, which is undetermined.
    const Eigen::Matrix3d regular =
        matrix + 1e-6 * weights * Eigen::Matrix3d::Identity();
    return regular.ldlt().solve(right_side);
  }
};

} // namespace

Eigen::Vector2d
PlanTransform::operator()(const Eigen::Vector2d& p) const
{
  return Eigen::Rotation2Dd(angle) * p + shift.head<2>();
}

Floorplan
transformed(const Floorplan& plan, const PlanTransform& transform)
{
  Floorplan moved_plan = plan;
  const double rise = transform.shift.z();
  const auto moveSlab = [&](PlanSlab& slab) {
    slab.plane.head<2>() = Eigen::Rotation2Dd(transform.angle) * slab.plane.head<2>();
    slab.plane[3] -= slab.plane.head<3>().dot(transform.shift);
    if (slab.curve)
      slab.curve = std::make_shared<const SlabCurve>(
          moved(*slab.curve, transform.angle, transform.shift));
  };
  const auto moveLoop = [&](PlanLoop& loop) {
    for (auto& element : loop.elements)
      for (auto* place : {&element.start, &element.end, &element.centre})
        *place = transform(*place);
  };
  for (auto& room : moved_plan.rooms) {
    moveLoop(room.boundary);
    moveSlab(room.floor);
    moveSlab(room.ceiling);
    for (auto& column : room.columns)
      moveLoop(column);
    for (auto* details : {&room.details, &room.floor_details})
      for (auto& detail : *details) {
        moveLoop(detail.boundary);
        moveSlab(detail.slab);
        for (auto& hole : detail.holes)
          moveLoop(hole);
      }
    for (auto& niche : room.niches) {
      moveLoop(niche.boundary);
      moveSlab(niche.bottom);
      moveSlab(niche.top);
    }
  }
  for (auto& storey : moved_plan.storeys) {
    storey.floor += rise;
    storey.ceiling += rise;
  }
  for (auto& doorway : moved_plan.doorways) {
    doorway.start = transform(doorway.start);
    doorway.end = transform(doorway.end);
    doorway.bottom += rise;
    doorway.top += rise;
  }
  for (auto& stair : moved_plan.stairs) {
    stair.at = transform(stair.at);
    stair.bottom += rise;
    stair.top += rise;
  }
  return moved_plan;
}

std::optional<PlanTransform>
alignPlans(const Floorplan& moving, const Floorplan& fixed, double reach)
{
  constexpr int rounds = 60;
  constexpr double narrowing = 0.85;  // factor of the scale per round
  constexpr double last_scale = 0.03; // metres
  std::vector<Sample> samples = samplesOf(moving);
  const std::vector<RoomHeights> heights = heightsOf(fixed);
  const double rise = riseOf(moving, fixed);
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (Sample& sample : samples) {
    sample.heights.low += rise;
    sample.heights.high += rise;
    middle += sample.place / static_cast<double>(samples.size());
  }
  const std::size_t fewest =
      std::max<std::size_t>(3, std::min(samples.size(), samplesOf(fixed).size()) / 10);
  PlanTransform transform;
  double scale = reach;
  for (int round = 0; round < rounds; ++round) {
    // The pivot is the plan's centre: a far origin would couple turn and shift.
    const Eigen::Vector2d pivot = transform(middle);
    Step step;
    Sample partner;
    for (Sample now : samples) {
      now.place = transform(now.place);
      now.normal = Eigen::Rotation2Dd(transform.angle) * now.normal;
      if (findPartner(fixed, heights, now, reach, partner))
        step.add(now, partner, pivot, scale);
    }
    if (step.partners < fewest)
      return std::nullopt;
    const Eigen::Vector3d change = step.solve();
    const Eigen::Vector2d place = transform.shift.head<2>();
    transform.angle += change.z();
    transform.shift.head<2>() =
        Eigen::Rotation2Dd(change.z()) * (place - pivot) + pivot + change.head<2>();
    scale = std::max(last_scale, narrowing * scale);
  }
  transform.shift.z() = riseOf(transformed(moving, transform), fixed);
  return transform;
}

} // namespace pcl::sedr::tools
