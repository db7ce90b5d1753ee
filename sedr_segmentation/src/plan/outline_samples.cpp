// SPDX-License-Identifier: BSD-3-Clause
#include "energy_fit.h"

#include "../curves/contour.h"
#include "../curves/fitted_curve.h"
#include "../curves/plan_points.h"

#include "sedr_filters/src/base/quantiles.h"
#include "sedr_filters/src/walls/plan_walls.h"
#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the deviations of places from the straight stretches on which they
 * lie, stretch by stretch; stretches that are not straight are left out. */
std::vector<std::vector<double>>
stretchDeviations(const std::vector<FittedBoundary>& boundaries)
{
  constexpr double straight = 0.05; // metres: what is farther off is no noise
  constexpr double along = 0.99;    // cosine
  constexpr std::size_t length = 24;
  std::vector<std::vector<double>> all;
  for (const FittedBoundary& boundary : boundaries)
    for (std::size_t s = 0; s + length <= boundary.samples.size(); s += length / 2) {
      std::vector<Eigen::Vector2d> seen; // not around a corner
      for (std::size_t k = s; k < s + length; ++k) {
        const ContourSample& sample = boundary.samples[k];
        if (sample.isSupported() &&
            std::abs(sample.tangent.dot(boundary.samples[s].tangent)) > along)
          seen.push_back(sample.position);
      }
      if (seen.size() < length)
        continue;
      const PlanCurve line = fitCurve(false, seen, straight / 4);
      std::vector<double> off;
      for (const Eigen::Vector2d& p : seen)
        off.push_back(line.signedDistance(p));
      const auto isFar = [&](double d) { return std::abs(d) > straight; };
      if (std::none_of(off.begin(), off.end(), isFar))
        all.push_back(std::move(off));
    }
  return all;
}

/** @brief Returns the variance of deviations, and that over their correlation: the sum
 * of the autocovariance up to its first zero. */
std::pair<double, double>
variances(const std::vector<double>& off)
{
  const auto covariance = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t k = 0; k + lag < off.size(); ++k)
      sum += off[k] * off[k + lag];
    return sum / static_cast<double>(off.size() - lag);
  };
  const double variance = covariance(0);
  double sum = variance;
  for (std::size_t lag = 1; lag < off.size() / 2; ++lag) {
    const double c = covariance(lag);
    if (!(c > 0))
      break;
    sum += 2 * c;
  }
  return {variance, sum};
}

} // namespace

std::vector<FittedBoundary>
outlineSamples(const PlanRoom& room,
               const RoomCells& cells,
               double spacing,
               double near)
{
  const PlanPoints points(cells.wall_points, 0.2);
  std::vector<FittedBoundary> boundaries;
  const auto add = [&](const PlanLoop& loop, StructureLabel label) {
    FittedBoundary& boundary = boundaries.emplace_back();
    boundary.room = room.id;
    boundary.label = label;
    for (const PlanElement& element : loop.elements) {
      const PlanCurve curve = carrierOf(element);
      const double length = element.length();
      const auto count = static_cast<std::size_t>(std::ceil(length / spacing));
      for (std::size_t k = 0; k < count; ++k) {
        ContourSample sample;
        sample.place = element.pointAt((static_cast<double>(k) + 0.5) /
                                       static_cast<double>(count) * length);
        sample.tangent = curve.tangentAt(sample.place);
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        points.forEachWithin(
            sample.place, std::hypot(near, spacing / 2), [&](const Eigen::Vector2d& p) {
              if (std::abs(sample.tangent.dot(p - sample.place)) > spacing / 2 ||
                  curve.distance(p) > near)
                return;
              ++sample.points;
              sum += p;
            });
        constexpr double enough = 3; // points, for a clear wall
        sample.support = std::min(1.0, static_cast<double>(sample.points) / enough);
        sample.position = sample.points > 0
                              ? (sum / static_cast<double>(sample.points)).eval()
                              : sample.place;
        boundary.samples.push_back(sample);
      }
    }
  };
  add(room.boundary, StructureLabel::Wall);
  for (const PlanLoop& column : room.columns)
    add(column, StructureLabel::Column);
  return boundaries;
}

WallNoise
wallNoise(const std::vector<FittedBoundary>& boundaries, double spacing)
{
  constexpr std::size_t enough = 4; // stretches
  WallNoise noise;
  const auto stretches = stretchDeviations(boundaries);
  if (stretches.size() < enough)
    return noise;
  std::vector<double> off;
  double variance = 0;
  double sum = 0;
  for (const auto& stretch : stretches) {
    for (const double d : stretch)
      off.push_back(std::abs(d));
    const auto [of_place, of_wave] = variances(stretch);
    variance += of_place;
    sum += of_wave;
  }
  // The quartile of a normal distribution is 1.15 sigma.
  const auto rank = off.begin() + static_cast<std::ptrdiff_t>(off.size() * 3 / 4);
  std::nth_element(off.begin(), rank, off.end());
  noise.measured = *rank / 1.15;
  noise.correlation = variance > 0 ? spacing * sum / variance : spacing;
  noise.stretches = stretches.size();
  return noise;
}

OutlineCover
coverOf(const PlanRoom& room,
        const std::vector<const PlanRoom*>& others,
        const RoomCells& cells,
        const CellGrid& grid,
        double max_wall)
{
  const CellMask near = dilated(cells.seen, 1);
  double inside = 0;
  double outside = 0;
  for (std::size_t i = 0; i < near.values().size(); ++i) {
    if (!near.values()[i])
      continue;
    const Cell cell = near.cellAt(i);
    const Eigen::Vector2d p = grid.centre(cell);
    const auto isIn = [&](const PlanRoom* other) { return other->contains(p); };
    if (room.contains(p))
      ++inside;
    else if (cells.seen.at(cell) && room.boundary.distance(p) > max_wall &&
             std::none_of(others.begin(), others.end(), isIn))
      ++outside;
  }
  const double area = grid.size() * grid.size();
  return {area * outside, std::max(0.0, room.area() - area * inside)};
}

namespace {

constexpr double patch_size = WallSlopes::patch_size;
constexpr std::size_t min_patches = 9;

/** @brief Finds the plane of a wall among the patches that meet the ceiling there.
 * @param[out] normal of the plane, to the left of the wall
 * @param[out] offset normal . p of its points
 * @return false if there is none that leans and stands near the floor */
bool
leaningPlane(const PlanElement& wall,
             double floor,
             const WallSlopes& slopes,
             const CellGrid& grid,
             const RoomCells& cells,
             Eigen::Vector3d& normal,
             double& offset)
{
  constexpr double near = 0.1; // of a patch from the wall at the ceiling, metres
  constexpr double min_cosine = 0.97;
  constexpr double on_plane = 0.04;
  constexpr double max_turn = radians(6);
  constexpr double min_run = 0.026; // 1.5 degrees
  constexpr double min_height = 1.5;
  constexpr double max_above_floor = 1;
  const Eigen::Vector2d way = (wall.end - wall.start).normalized();
  const Eigen::Vector2d left(-way.y(), way.x());
  const auto isOn = [&](const PlanePatch& patch) {
    if (std::abs(patch.normal.head<2>().normalized().dot(left)) < min_cosine)
      return false;
    const Eigen::Vector2d to =
        atCeiling(patch.middle, runOf(patch.normal), grid, cells) - wall.start;
    return std::abs(to.dot(left)) < near && to.dot(way) > 0 &&
           to.dot(way) < wall.length();
  };
  std::size_t leaning = 0;
  for (const std::size_t k : slopes.leaning())
    leaning += isOn(slopes.patches()[k]) ? 1 : 0;
  if (leaning < min_patches)
    return false;
  std::vector<const PlanePatch*> members;
  std::vector<Weighted> runs;
  for (const PlanePatch& patch : slopes.patches())
    if (isOn(patch)) {
      members.push_back(&patch);
      runs.emplace_back(runOf(patch.normal).dot(left), patch.count);
    }
  const double run = weightedQuantile(std::move(runs), 0.5);
  normal = Eigen::Vector3d(left.x(), left.y(), -run).normalized();
  for (int round = 0; round < 2; ++round) {
    const auto alike = [&](const PlanePatch& patch) {
      return std::abs(patch.normal.dot(normal)) > std::cos(max_turn);
    };
    std::vector<Weighted> offsets;
    for (const PlanePatch* const patch : members)
      if (alike(*patch))
        offsets.emplace_back(normal.dot(patch->middle), patch->count);
    offset = weightedQuantile(std::move(offsets), 0.5);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::vector<double> heights;
    for (const PlanePatch* const patch : members)
      if (alike(*patch) && std::abs(normal.dot(patch->middle) - offset) < on_plane) {
        sum += (patch->normal.dot(normal) < 0 ? -patch->count : patch->count) *
               patch->normal;
        heights.push_back(patch->middle.z());
      }
    if (heights.size() < min_patches)
      return false;
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    if (*high - *low + patch_size < min_height ||
        *low - patch_size / 2 - floor > max_above_floor)
      return false;
    normal = sum.normalized();
  }
  return runOf(normal).norm() > min_run;
}

/** @brief Removes the pieces into which the outline at the ceiling parts a wall that
 * leans, as it is aslant there below a slope.
 * @param heads the elements before they moved to their feet */
void
joinPieces(const std::vector<PlanElement>& heads,
           std::vector<PlanElement>& walls,
           std::vector<bool>& is_moved)
{
  constexpr double on_line = 0.3; // metres, of a short piece from its wall
  constexpr double same_foot = 0.05;
  const std::size_t n = walls.size();
  std::vector<bool> is_part(n, false); // of a wall beside it
  const auto isNear = [](const PlanElement& piece, const PlanElement& of, double most) {
    const Eigen::Vector2d way = (of.end - of.start).normalized();
    const Eigen::Vector2d left(-way.y(), way.x());
    return !piece.isArc() && std::abs((piece.start - of.start).dot(left)) < most &&
           std::abs((piece.end - of.start).dot(left)) < most;
  };
  for (const std::size_t step : {std::size_t{1}, n - 1}) // onwards, back
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = (i + step) % n; is_moved[i] && !is_part[i] && j != i;
           j = (j + step) % n) {
        if (is_part[j] || !(is_moved[j] ? isNear(walls[j], walls[i], same_foot)
                                        : 2 * heads[j].length() < heads[i].length() &&
                                              isNear(heads[j], heads[i], on_line)))
          break;
        is_part[j] = true;
      }
  for (std::size_t i = n; i-- > 0;)
    if (is_part[i]) {
      walls.erase(walls.begin() + static_cast<std::ptrdiff_t>(i));
      is_moved.erase(is_moved.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

} // namespace

void
moveToFeet(const WallSlopes& slopes,
           const CellGrid& grid,
           const RoomCells& cells,
           PlanRoom& room)
{
  std::vector<PlanElement>& walls = room.boundary.elements;
  const std::vector<PlanElement> heads = walls;
  std::vector<bool> is_moved(walls.size(), false);
  for (std::size_t i = 0; i < walls.size() && !slopes.areNone(); ++i) {
    PlanElement& wall = walls[i];
    const double floor = room.floor.heightAt(wall.pointAt(wall.length() / 2));
    Eigen::Vector3d normal;
    double offset = 0;
    if (wall.isArc() || !leaningPlane(wall, floor, slopes, grid, cells, normal, offset))
      continue;
    const double across = normal.head<2>().norm();
    const Eigen::Vector2d left = normal.head<2>() / across;
    const double foot = (offset - normal.z() * floor) / across;
    for (Eigen::Vector2d* const end : {&wall.start, &wall.end})
      *end += (foot - left.dot(*end)) * left;
    wall.tilt = std::atan(-normal.z() / across);
    is_moved[i] = true;
  }
  joinPieces(heads, walls, is_moved);
  rejoin(room.boundary, is_moved);
  if (walls.size() < 3 || crossesItself(room.boundary.polygon(0.05)))
    walls = heads;
}

} // namespace pcl::sedr
