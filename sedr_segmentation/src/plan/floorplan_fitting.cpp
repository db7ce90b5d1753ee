// SPDX-License-Identifier: BSD-3-Clause
#include "../adjust/plan_adjustment.h"
#include "../curves/plan_curve.h"
#include "../scan/scan_excerpt.h"
#include "energy_fit.h"
#include "rooms_above.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/plan/plan_check.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/impl/floorplan_fitting.hpp>

#include <pcl/impl/instantiate.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Whether two elements follow one curve, or one of them is a step of no length
 * that is left between two lines that became one. */
bool
areOfOneCurve(const PlanElement& a, const PlanElement& b)
{
  if ((a.start - a.end).norm() < same_place || (b.start - b.end).norm() < same_place)
    return !a.isArc() && !b.isArc();
  if (a.isArc() != b.isArc())
    return false;
  if (a.isArc())
    return (a.centre - b.centre).norm() < same_line &&
           std::abs(a.radius - b.radius) < same_line &&
           a.counter_clockwise == b.counter_clockwise;
  const PlanCurve line = carrierOf(a);
  return line.distance(b.end) < same_line && line.direction.dot(b.end - b.start) > 0;
}

/** @brief Makes one element of neighbours that follow one line or circle the same
 * way, with the inliers of that curve. O(n squared) at most. */
void
joinNeighbours(PlanLoop& loop)
{
  std::vector<PlanElement>& elements = loop.elements;
  for (std::size_t k = 0; k < elements.size() && elements.size() > 2;) {
    const std::size_t next = (k + 1) % elements.size();
    if (!areOfOneCurve(elements[k], elements[next])) {
      ++k;
      continue;
    }
    elements[k].end = elements[next].end;
    elements[k].inliers = std::max(elements[k].inliers, elements[next].inliers);
    elements[k].accuracy = worse(elements[k].accuracy, elements[next].accuracy);
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(next));
    k = next == 0 ? elements.size() : k;
  }
}

std::string
problemOf(const RoomFitParameters& p)
{
  std::string problem = positiveProblem({{"the distance threshold", p.tolerance},
                                         {"the grid size", p.cell_size},
                                         {"the minimum radius", p.minimum_radius}});
  if (problem.empty())
    problem = positiveProblem({{"the minimum detail area", p.minimum_detail_area}},
                              "square metres");
  if (!problem.empty())
    return problem;
  if (p.tolerance > 1)
    return "the distance threshold must be at most 1 m, it is " +
           std::to_string(p.tolerance);
  if (!(p.maximum_radius > p.minimum_radius))
    return "the maximum radius " + std::to_string(p.maximum_radius) +
           " m must be above the minimum radius " + std::to_string(p.minimum_radius) +
           " m";
  return problemOf(p.priors);
}

std::string
problemOf(const PlanInput& input)
{
  const std::size_t size = input.points.size();
  std::string problem = input.indices.empty() ? "there are no points"
                                              : indicesProblem(input.indices, size);
  if (problem.empty())
    problem = indicesProblem("raw cloud:", input.raw_indices, input.raw.size());
  const auto isMissing = [&](const pcl::IndicesConstPtr& seen, auto hidden) {
    return (!seen || seen->empty()) &&
           std::all_of(input.hidden.begin(), input.hidden.end(),
                       [&](const auto& room) { return (room.second.*hidden).empty(); });
  };
  if (problem.empty() && isMissing(input.ceiling, &HiddenCells::ceiling))
    problem = "no ceiling points were set";
  if (problem.empty() && isMissing(input.floor, &HiddenCells::floor))
    problem = "no floor points were set";
  const auto isFinite = [](const Eigen::Vector3f& p) {
    return p.cwiseAbs().maxCoeff() < 1e6F;
  };
  for (const auto& [room, cells] : input.hidden)
    if (problem.empty() &&
        (room == 0 ||
         !std::all_of(cells.ceiling.begin(), cells.ceiling.end(), isFinite) ||
         !std::all_of(cells.floor.begin(), cells.floor.end(), isFinite)))
      problem =
          "hidden cells of room " + std::to_string(room) +
          (room == 0 ? ": rooms are numbered from 1" : " are not within 1,000 km");
  const std::pair<const char*, const pcl::IndicesConstPtr&> parts[] = {
      {"ceiling", input.ceiling},
      {"floor", input.floor},
      {"detail", input.details},
      {"wall", input.walls}};
  for (const auto& [name, indices] : parts)
    if (problem.empty())
      problem = indicesProblem(name, indices, size);
  return problem;
}

pcl::Indices
orNone(const pcl::IndicesConstPtr& indices)
{
  return indices ? *indices : pcl::Indices();
}

} // namespace

std::string
fitFloorplan(const PlanInput& input,
             const RoomFitParameters& parameters,
             Floorplan& plan,
             std::vector<PlanWarning>& warnings,
             std::vector<FittedBoundary>& boundaries,
             std::vector<WallNoise>& noise)
{
  std::string problem = problemOf(parameters);
  if (problem.empty())
    problem = problemOf(input);
  if (!problem.empty())
    return problem;
  PlanEvidence evidence;
  evidence.all = input.indices;
  evidence.ceiling = orNone(input.ceiling);
  evidence.floor = orNone(input.floor);
  evidence.details = orNone(input.details);
  evidence.walls = orNone(input.walls);
  evidence.room = input.rooms;
  evidence.hidden = input.hidden;
  evidence.owners = input.owners;
  // Null indices mean all points of the raw cloud, an empty list means none.
  const bool has_raw =
      input.raw.size() > 0 && !(input.raw_indices && input.raw_indices->empty());
  const pcl::Indices all;
  const Priors& priors = parameters.priors;
  const pcl::Indices& raw_indices =
      has_raw && input.raw_indices ? *input.raw_indices : all;
  FittedPlan fitted =
      fitPlanByEnergy(input.points, evidence, has_raw ? input.raw : PointView(),
                      raw_indices, parameters);
  plan = std::move(fitted.plan);
  warnings = std::move(fitted.warnings);
  boundaries = std::move(fitted.boundaries);
  noise = std::move(fitted.noise);
  if (!fitted.problem.empty())
    return fitted.problem;
  const PointView scan = has_raw ? input.raw : input.points;
  const pcl::Indices& of_scan = has_raw ? raw_indices : input.indices;
  AdjustmentParameters adjustment;
  adjustment.threads = parameters.threads;
  problem = adjustPlan(plan, scan, of_scan, adjustment).problem;
  if (!problem.empty())
    warnings.push_back({WarningKind::NotAdjusted, {}, 0, 0, problem});
  for (PlanRoom& room : plan.rooms) {
    joinNeighbours(room.boundary);
    for (PlanLoop& column : room.columns)
      joinNeighbours(column);
  }
  giveCeilings(std::move(fitted.sheets), scan, of_scan, parameters.threads, plan);
  stateSlabs(plan, scan, of_scan, adjustment);
  endBelowRoomsAbove(plan, priors);
  for (PlanRoom& room : plan.rooms)
    if (const std::string wrong = mendTilts(room); !wrong.empty())
      warnings.push_back({WarningKind::Contradiction, {}, room.id, 0, wrong});
  for (const PlanRoom& room : plan.rooms)
    for (std::size_t e = 0; e < room.boundary.elements.size(); ++e)
      if (const double tilt = room.boundary.elements[e].tilt; tilt != 0)
        warnings.push_back({WarningKind::Tilted, {tilt * 180 / M_PI}, room.id, e + 1});
  return {};
}

std::shared_ptr<const std::vector<Eigen::Vector3f>>
movedPoints(const PointView& raw,
            const pcl::IndicesConstPtr& indices,
            unsigned threads,
            const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map)
{
  const std::size_t size = indices ? indices->size() : raw.size();
  const std::size_t step = rawStep(size, AdjustmentParameters().max_points);
  const auto moved = std::make_shared<std::vector<Eigen::Vector3f>>(
      (size + step - 1) / step, Eigen::Vector3f::Constant(std::nanf("")));
  parallelFor(moved->size(), points_a_block, threads, [&](std::size_t k) {
    const std::size_t i =
        indices ? static_cast<std::size_t>((*indices)[k * step]) : k * step;
    if (i < raw.size())
      (*moved)[k] = map(raw[i].cast<double>()).cast<float>();
  });
  return moved;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(FloorplanFitting, SEDR_POINT_TYPES)
