// SPDX-License-Identifier: BSD-3-Clause
#include "../adjust/plan_adjustment.h"
#include "../niches/ceiling_slits.h"
#include "../niches/niche_panes.h"
#include "../refit/plan_refit.h"
#include "../refit/plan_regularisation.h"
#include "energy_fit.h"
#include "plan_fit.h"
#include "room_separation.h"
#include "rooms_above.h"
#include "short_elements.h"

#include "sedr_filters/src/plan/plan_evidence.h"
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/impl/floorplan_fitting.hpp>

#include <cmath>

namespace pcl::sedr {

namespace {

std::string
problemOf(const RoomFitParameters& p)
{
  struct {
    const char* what;
    double value;
  } const positive[] = {
      {"the distance threshold", p.loop.tolerance},
      {"the grid size", p.cell_size},
      {"the minimum length", p.loop.minimum_length},
      {"the minimum radius", p.loop.minimum_radius},
  };
  for (const auto& [what, value] : positive)
    if (!(value > 0) || !std::isfinite(value))
      return std::string(what) + " must be above 0 m, it is " + std::to_string(value);
  if (!(p.minimum_detail_area > 0))
    return "the minimum detail area must be above 0 square metres, it is " +
           std::to_string(p.minimum_detail_area);
  if (p.loop.tolerance > 1)
    return "the distance threshold must be at most 1 m, it is " +
           std::to_string(p.loop.tolerance);
  if (!(p.loop.maximum_radius > p.loop.minimum_radius))
    return "the maximum radius " + std::to_string(p.loop.maximum_radius) +
           " m must be above the minimum radius " +
           std::to_string(p.loop.minimum_radius) + " m";
  return problemOf(p.loop.priors);
}

std::string
problemOf(const PlanInput& input)
{
  const std::size_t size = input.points.size();
  std::string problem = indicesProblem(input.indices, size);
  if (problem.empty())
    problem = indicesProblem("raw cloud:", input.raw_indices, input.raw.size());
  if (problem.empty() && (!input.ceiling || input.ceiling->empty()))
    problem = "no ceiling points were set";
  if (problem.empty())
    problem = indicesProblem("ceiling", input.ceiling, size);
  if (problem.empty() && (!input.floor || input.floor->empty()))
    problem = "no floor points were set";
  const std::pair<const char*, const pcl::IndicesConstPtr&> parts[] = {
      {"floor", input.floor},
      {"detail", input.details},
      {"wall", input.walls},
      {"sheet", input.sheets}};
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

/** @brief Moves the plan to the points of the raw scan.
 * @return why it was not moved, a sentence; else empty */
std::string
fitToRaw(const PointView& raw,
         const pcl::Indices& indices,
         const RoomFitParameters& parameters,
         Floorplan& plan)
{
  const Priors& priors = parameters.loop.priors;
  if (parameters.by_energy) {
    leaveOutPanes(plan, raw, indices, parameters.threads, priors);
    AdjustmentParameters adjustment;
    adjustment.threads = parameters.threads;
    return adjustPlan(plan, raw, indices, adjustment).problem;
  }
  leaveOutBelowSlits(plan, raw, indices, parameters.threads, priors);
  leaveOutPanes(plan, raw, indices, parameters.threads, priors);
  RefitParameters refit;
  refit.priors = priors;
  refit.threads = parameters.threads;
  const RefitReport report = refitToRaw(plan, raw, indices, refit);
  RegularisationParameters regular;
  regular.priors = priors;
  regularisePlan(plan, regular);
  return report.problem;
}

} // namespace

std::string
fitFloorplan(const PlanInput& input,
             const RoomFitParameters& parameters,
             Floorplan& plan,
             std::vector<std::string>& warnings,
             std::vector<FittedBoundary>& boundaries)
{
  std::string problem = problemOf(parameters);
  if (problem.empty())
    problem = problemOf(input);
  if (!problem.empty())
    return problem;
  PlanEvidence evidence;
  evidence.all = input.indices;
  evidence.ceiling = *input.ceiling;
  evidence.floor = *input.floor;
  evidence.details = orNone(input.details);
  evidence.walls = orNone(input.walls);
  evidence.sheets = orNone(input.sheets);
  evidence.finds_sheets = !input.sheets;
  evidence.room = input.rooms;
  std::vector<RoomSheet> sheets;
  // Null indices mean all points of the raw cloud, an empty list means none.
  const bool has_raw =
      input.raw.size() > 0 && !(input.raw_indices && input.raw_indices->empty());
  const pcl::Indices all;
  const Priors& priors = parameters.loop.priors;
  const pcl::Indices& raw_indices =
      has_raw && input.raw_indices ? *input.raw_indices : all;
  plan = parameters.by_energy
             ? fitPlanByEnergy(input.points, evidence,
                               has_raw ? input.raw : PointView(), raw_indices,
                               parameters, problem, warnings, &boundaries, &sheets)
             : fitPlan(input.points, evidence, parameters, problem, warnings,
                       &boundaries, &sheets);
  if (!problem.empty())
    return problem;
  if (has_raw)
    problem = fitToRaw(input.raw, raw_indices, parameters, plan);
  if (!problem.empty())
    warnings.push_back("the plan is not fitted to the raw cloud: " + problem);
  const std::vector<std::string> cuts =
      separateRooms(plan, input.points, input.indices, priors);
  removeShortElements(plan, priors);
  giveCeilings(sheets, has_raw ? &input.raw : nullptr, raw_indices, parameters.threads,
               plan);
  endBelowRoomsAbove(plan, priors);
  measureEvidence(plan, input.points, input.indices, priors.wall_band,
                  parameters.threads);
  warnings.insert(warnings.end(), cuts.begin(), cuts.end());
  return {};
}

std::shared_ptr<const std::vector<Eigen::Vector3f>>
movedPoints(const PointView& raw,
            const pcl::IndicesConstPtr& indices,
            const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map)
{
  const std::size_t size = indices ? indices->size() : raw.size();
  const std::size_t step = rawStep(size, RefitParameters().max_points);
  const auto moved = std::make_shared<std::vector<Eigen::Vector3f>>();
  moved->reserve(size / step + 1);
  for (std::size_t k = 0; k < size; k += step) {
    const std::size_t i = indices ? static_cast<std::size_t>((*indices)[k]) : k;
    if (i < raw.size())
      moved->push_back(map(raw[i].cast<double>()).cast<float>());
  }
  return moved;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(FloorplanFitting, SEDR_POINT_TYPES)
