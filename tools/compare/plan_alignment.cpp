// SPDX-License-Identifier: BSD-3-Clause
#include "compare/plan_alignment.h"

#include <pcl/sedr_filters/middle_value.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

constexpr double step = 0.1; // between samples of walls, metres
constexpr int rounds = 60;
constexpr double narrowing = 0.85;       // of the reach, a round
constexpr double last_reach = 0.03;      // metres
const double alike = std::cos(M_PI / 6); // of directions

/** @brief A place of a wall, and the way into its room. */
struct Sample {
  double weight = 1;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
};

/** @brief Whether another room lies behind a wall, up to the thickness of partitions.
 */
bool
isPartition(const Floorplan& plan, const Sample& sample)
{
  for (const double depth : {0.15, 0.3, 0.6})
    for (const auto& room : plan.rooms)
      if (room.contains(sample.place - depth * sample.normal))
        return true;
  return false;
}

/** @brief Places along all walls. What is rebuilt is a partition rather than an outer
 * wall, so those count less. */
std::vector<Sample>
samplesOf(const Floorplan& plan)
{
  constexpr double of_partition = 0.25;
  std::vector<Sample> samples;
  for (const auto& room : plan.rooms)
    for (const auto& wall : room.boundary.elements) {
      const auto count = static_cast<std::size_t>(wall.length() / step);
      for (std::size_t k = 0; k < count; ++k) {
        const double s =
            wall.length() * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
        Sample sample{1, wall.pointAt(s), wall.normalAt(s)};
        if (isPartition(plan, sample))
          sample.weight = of_partition;
        samples.push_back(sample);
      }
    }
  return samples;
}

/** @brief The nearest place of a plan's walls that faces the same way.
 * @return false where there is none within `reach` */
bool
findPartner(const Floorplan& plan, const Sample& sample, double reach, Sample& partner)
{
  double least = reach;
  for (const auto& room : plan.rooms)
    for (const auto& wall : room.boundary.elements) {
      const double s = wall.project(sample.place);
      const Sample candidate{1, wall.pointAt(s), wall.normalAt(s)};
      const double distance = (candidate.place - sample.place).norm();
      if (distance < least && candidate.normal.dot(sample.normal) > alike) {
        least = distance;
        partner = candidate;
      }
    }
  return least < reach;
}

/** @brief A transform, then a turn about `pivot` and a shift. */
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

/** @brief How many places have to have a partner: a tenth of the smaller plan's. */
std::size_t
fewestPartners(const Floorplan& fixed, std::size_t samples)
{
  constexpr std::size_t share = 10;
  constexpr std::size_t unknowns = 3;
  return std::max(unknowns, std::min(samples, samplesOf(fixed).size()) / share);
}

/** @brief How much the floors of the rooms that lie over each other differ. */
double
riseOf(const Floorplan& moving, const Floorplan& fixed)
{
  std::vector<double> rises;
  for (const auto& sample : samplesOf(moving)) {
    const Eigen::Vector2d inside = sample.place + 0.3 * sample.normal;
    const auto holds = [&](const PlanRoom& room) { return room.contains(inside); };
    const auto a = std::find_if(moving.rooms.begin(), moving.rooms.end(), holds);
    const auto b = std::find_if(fixed.rooms.begin(), fixed.rooms.end(), holds);
    if (a != moving.rooms.end() && b != fixed.rooms.end())
      rises.push_back(b->floorAt(inside) - a->floorAt(inside));
  }
  return rises.empty() ? 0 : middleValue(rises);
}

/** @brief The plane of a slab that has been turned about the vertical and shifted. */
PlanSlab
transformedSlab(PlanSlab slab, const PlanTransform& transform)
{
  slab.plane.head<2>() = Eigen::Rotation2Dd(transform.angle) * slab.plane.head<2>();
  slab.plane[3] -= slab.plane.head<3>().dot(transform.shift);
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
  return moved;
}

std::optional<PlanTransform>
alignPlans(const Floorplan& moving, const Floorplan& fixed, double reach)
{
  const std::vector<Sample> samples = samplesOf(moving);
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
    // Turning about the plan itself: about a far origin it would bend its own way.
    const Eigen::Vector2d pivot = transform(middle);
    for (const auto& sample : samples) {
      const Sample now{sample.weight, transform(sample.place), turn * sample.normal};
      Sample partner;
      if (!findPartner(fixed, now, reach, partner))
        continue;
      // Point to line: sliding along the wall costs nothing.
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
    // A long corridor says nothing of the way along it: then that stays as it was.
    normal_matrix += 1e-6 * weights * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d change = normal_matrix.ldlt().solve(right_side);
    transform = after(transform, change.z(), pivot, change.head<2>());
  }
  transform.shift.z() = riseOf(transformed(moving, transform), fixed);
  return transform;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
