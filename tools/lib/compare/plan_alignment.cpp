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

constexpr double sample_step = 0.1; // metres, along walls
constexpr int rounds = 60;
constexpr double narrowing = 0.85;             // factor of the reach per round
constexpr double last_reach = 0.03;            // metres
const double alike_walls = std::cos(M_PI / 6); // maximum angle between directions

/** @brief A point of a wall, and the direction into its room. */
struct Sample {
  double weight = 1;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  RoomHeights heights; ///< of the room
};

/** @brief Returns whether another room lies behind a wall, within the thickness of
 * partitions. */
bool
isPartition(const Floorplan& plan, const Sample& sample)
{
  for (const double depth : {0.15, 0.3, 0.6})
    for (const auto& room : plan.rooms)
      if (room.contains(sample.place - depth * sample.normal) &&
          shareHeights(heightsOf(room), sample.heights))
        return true;
  return false;
}

/** @brief Samples all walls. Partitions have less weight, as they are rebuilt more
 * often than outer walls. */
std::vector<Sample>
samplesOf(const Floorplan& plan)
{
  constexpr double of_partition = 0.25;
  std::vector<Sample> samples;
  for (const auto& room : plan.rooms) {
    const RoomHeights heights = heightsOf(room);
    for (const auto& wall : room.boundary.elements) {
      const auto count = static_cast<std::size_t>(wall.length() / sample_step);
      for (std::size_t k = 0; k < count; ++k) {
        const double s =
            wall.length() * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
        Sample sample{1, wall.pointAt(s), wall.normalAt(s), heights};
        if (isPartition(plan, sample))
          sample.weight = of_partition;
        samples.push_back(sample);
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
  double least = reach;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    if (!shareHeights(heights[r], sample.heights))
      continue;
    for (const auto& wall : plan.rooms[r].boundary.elements) {
      const double s = wall.project(sample.place);
      const Sample candidate{1, wall.pointAt(s), wall.normalAt(s), heights[r]};
      const double distance = (candidate.place - sample.place).norm();
      if (distance < least && candidate.normal.dot(sample.normal) > alike_walls) {
        least = distance;
        partner = candidate;
      }
    }
  }
  return least < reach;
}

/** @brief Returns a transform followed by a rotation about `pivot` and a shift. */
PlanTransform
after(const PlanTransform& first,
      double angle,
      const Eigen::Vector2d& pivot,
      const Eigen::Vector2d& shift)
{
  const Eigen::Vector2d moved = first.shift.head<2>();
  PlanTransform both;
  both.angle = first.angle + angle;
  both.shift.head<2>() = Eigen::Rotation2Dd(angle) * (moved - pivot) + pivot + shift;
  return both;
}

Eigen::Vector2d
middleOf(const std::vector<Sample>& samples)
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& sample : samples)
    sum += sample.place;
  return sum / static_cast<double>(std::max<std::size_t>(1, samples.size()));
}

/** @brief Returns the minimum number of samples with a partner: a tenth of the smaller
 * plan's. */
std::size_t
fewestPartners(const Floorplan& fixed, std::size_t samples)
{
  constexpr std::size_t share = 10;
  constexpr std::size_t unknowns = 3;
  return std::max(unknowns, std::min(samples, samplesOf(fixed).size()) / share);
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

/** @brief Returns the rooms that contain a place in plan, at any height. */
std::vector<const PlanRoom*>
roomsOver(const Floorplan& plan, const Eigen::Vector2d& place)
{
  std::vector<const PlanRoom*> rooms;
  for (const PlanRoom& room : plan.rooms)
    if (room.contains(place))
      rooms.push_back(&room);
  return rooms;
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
    for (const PlanRoom* b : roomsOver(fixed, inside))
      for (const PlanRoom* a : roomsOver(moving, inside))
        rises.push_back(b->floorAt(inside) - a->floorAt(inside));
  }
  return commonValue(rises);
}

/** @brief Transforms the plane of a slab. */
PlanSlab
transformedSlab(PlanSlab slab, const PlanTransform& transform)
{
  slab.plane.head<2>() = Eigen::Rotation2Dd(transform.angle) * slab.plane.head<2>();
  slab.plane[3] -= slab.plane.head<3>().dot(transform.shift);
  if (slab.curve)
    slab.curve = std::make_shared<const SlabCurve>(
        moved(*slab.curve, transform.angle, transform.shift));
  return slab;
}

PlanLoop
transformedLoop(PlanLoop loop, const PlanTransform& transform)
{
  for (auto& element : loop.elements) {
    element.start = transform(element.start);
    element.end = transform(element.end);
    element.centre = transform(element.centre);
  }
  return loop;
}

} // namespace

Eigen::Vector2d
PlanTransform::operator()(const Eigen::Vector2d& p) const
{
  return Eigen::Rotation2Dd(angle) * p + shift.head<2>();
}

Floorplan
transformed(const Floorplan& plan, const PlanTransform& transform)
{
  Floorplan moved = plan;
  const auto moveSlab = [&](PlanSlab& slab) {
    slab = transformedSlab(slab, transform);
  };
  const auto moveLoop = [&](PlanLoop& loop) {
    loop = transformedLoop(loop, transform);
  };
  for (auto& room : moved.rooms) {
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
  for (auto& storey : moved.storeys) {
    storey.floor += transform.shift.z();
    storey.ceiling += transform.shift.z();
  }
  for (auto& doorway : moved.doorways) {
    doorway.start = transform(doorway.start);
    doorway.end = transform(doorway.end);
    doorway.bottom += transform.shift.z();
    doorway.top += transform.shift.z();
  }
  for (auto& stair : moved.stairs) {
    stair.at = transform(stair.at);
    stair.bottom += transform.shift.z();
    stair.top += transform.shift.z();
  }
  return moved;
}

std::optional<PlanTransform>
alignPlans(const Floorplan& moving, const Floorplan& fixed, double reach)
{
  std::vector<Sample> samples = samplesOf(moving);
  const double rise = riseOf(moving, fixed);
  for (Sample& sample : samples) {
    sample.heights.low += rise;
    sample.heights.high += rise;
  }
  const std::vector<RoomHeights> heights = heightsOf(fixed);
  const Eigen::Vector2d middle = middleOf(samples);
  const std::size_t fewest = fewestPartners(fixed, samples.size());
  PlanTransform transform;
  double scale = reach;
  for (int round = 0; round < rounds;
       ++round, scale = std::max(last_reach, narrowing * scale)) {
    Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
    double weights = 0;
    std::size_t partners = 0;
    const Eigen::Rotation2Dd turn(transform.angle);
    // Rotation about the plan's centre, since a far origin would couple rotation and
    // shift.
    const Eigen::Vector2d pivot = transform(middle);
    for (const auto& sample : samples) {
      const Sample now{sample.weight, transform(sample.place), turn * sample.normal,
                       sample.heights};
      Sample partner;
      if (!findPartner(fixed, heights, now, reach, partner))
        continue;
      // Point to line: sliding along the wall has no cost.
      const double residual = partner.normal.dot(partner.place - now.place);
      const Eigen::Vector2d arm = now.place - pivot;
      const Eigen::Vector3d row(partner.normal.x(), partner.normal.y(),
                                arm.x() * partner.normal.y() -
                                    arm.y() * partner.normal.x());
      const double nearness = scale * scale / (scale * scale + residual * residual);
      const double weight = now.weight * nearness * nearness;
      normal_matrix += weight * row * row.transpose();
      right_side += weight * row * residual;
      weights += weight;
      ++partners;
    }
    if (partners < fewest)
      return std::nullopt;
    // Regularises the direction along a long corridor, which is undetermined.
    normal_matrix += 1e-6 * weights * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d change = normal_matrix.ldlt().solve(right_side);
    transform = after(transform, change.z(), pivot, change.head<2>());
  }
  transform.shift.z() = riseOf(transformed(moving, transform), fixed);
  return transform;
}

} // namespace pcl::sedr::tools
