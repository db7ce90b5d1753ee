// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_evidence.h>
#include <pcl/sedr_filters/structure_fields.h>
#include <pcl/sedr_segmentation/ceiling_slits.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>
#include <pcl/sedr_segmentation/niche_panes.h>
#include <pcl/sedr_segmentation/plan_refit.h>
#include <pcl/sedr_segmentation/plan_regularisation.h>
#include <pcl/sedr_segmentation/room_separation.h>

#include <cmath>
#include <string>
#include <vector>

namespace pcl {

template <typename PointT>
bool
FloorplanFitting<PointT>::checkPart(const char* name,
                                    const IndicesConstPtr& indices,
                                    bool is_needed)
{
  if (!indices || indices->empty())
    return !is_needed ||
           fail("FloorplanFitting", std::string("no ") + name + " points were set");
  const std::string problem = sedr::indicesProblem(*indices, input_->size());
  return problem.empty() || fail("FloorplanFitting", std::string(name) + " " + problem);
}

template <typename PointT>
bool
FloorplanFitting<PointT>::validate()
{
  constexpr const char* name = "FloorplanFitting";
  const auto& p = parameters_;
  const auto isPositive = [&](const char* what, double value) {
    return (value > 0 && std::isfinite(value)) ||
           fail(name, std::string(what) + " must be above 0 m, it is " +
                          std::to_string(value));
  };
  if (!isPositive("the distance threshold", p.loop.tolerance) ||
      !isPositive("the grid size", p.cell_size) ||
      !isPositive("the minimum length", p.loop.minimum_length) ||
      !isPositive("the minimum radius", p.loop.minimum_radius))
    return false;
  if (!(p.minimum_detail_area > 0))
    return fail(name, "the minimum detail area must be above 0 square metres, it is " +
                          std::to_string(p.minimum_detail_area));
  if (p.loop.tolerance > 1)
    return fail(name, "the distance threshold must be at most 1 m, it is " +
                          std::to_string(p.loop.tolerance));
  if (!(p.loop.maximum_radius > p.loop.minimum_radius))
    return fail(name, "the maximum radius " + std::to_string(p.loop.maximum_radius) +
                          " m must be above the minimum radius " +
                          std::to_string(p.loop.minimum_radius) + " m");
  const std::string problem = sedr::indicesProblem(*indices_, input_->size());
  if (!problem.empty())
    return fail(name, problem);
  if (!rooms_.empty() && rooms_.size() != input_->size())
    return fail(name, "the cloud has " + std::to_string(input_->size()) +
                          " points, but rooms of " + std::to_string(rooms_.size()) +
                          " were set");
  if (raw_ && raw_indices_) {
    const std::string raw_problem = sedr::indicesProblem(*raw_indices_, raw_().size());
    if (!raw_problem.empty())
      return fail(name, "raw cloud: " + raw_problem);
  }
  return checkPart("ceiling", ceiling_, true) && checkPart("floor", floor_, true) &&
         checkPart("detail", details_, false) && checkPart("wall", walls_, false) &&
         checkPart("sheet", sheets_, false);
}

template <typename PointT>
void
FloorplanFitting<PointT>::fitToRaw(sedr::Floorplan& plan)
{
  if (!raw_ || raw_().size() == 0 || (raw_indices_ && raw_indices_->empty()))
    return;
  sedr::RefitParameters parameters;
  parameters.threads = parameters_.threads;
  const Indices all; // by none are all meant there; a temporary would copy the others
  const Indices& indices = raw_indices_ ? *raw_indices_ : all;
  sedr::leaveOutBelowSlits(plan, raw_(), indices, parameters_.threads);
  sedr::leaveOutPanes(plan, raw_(), indices, parameters_.threads);
  const sedr::RefitReport report = sedr::refitToRaw(plan, raw_(), indices, parameters);
  if (!report.problem.empty())
    warnings_.push_back("the plan is not fitted to the raw cloud: " + report.problem);
  sedr::regularisePlan(plan);
}

template <typename PointT>
void
FloorplanFitting<PointT>::levelRawPoints(const sedr::Levelling& levelling)
{
  if (!raw_)
    return;
  const sedr::PointView raw = raw_();
  const std::size_t size = raw_indices_ ? raw_indices_->size() : raw.size();
  const std::size_t step = sedr::rawStep(size, sedr::RefitParameters().most_points);
  const auto level = std::make_shared<std::vector<Eigen::Vector3f>>();
  level->reserve(size / step + 1);
  for (std::size_t k = 0; k < size; k += step) {
    const std::size_t i =
        raw_indices_ ? static_cast<std::size_t>((*raw_indices_)[k]) : k;
    if (i < raw.size())
      level->push_back(
          levelling.level(raw[i].template cast<double>()).template cast<float>());
  }
  setRawPoints(level);
}

template <typename PointT>
bool
FloorplanFitting<PointT>::run(sedr::Floorplan& plan)
{
  if (!validate())
    return false;
  sedr::PlanEvidence evidence;
  evidence.all = *indices_;
  evidence.ceiling = *ceiling_;
  evidence.floor = *floor_;
  if (details_)
    evidence.details = *details_;
  if (walls_)
    evidence.walls = *walls_;
  evidence.room = rooms_.empty() ? sedr::roomsOf(*input_) : rooms_;
  if (sheets_)
    evidence.sheets = *sheets_;
  std::string problem;
  std::vector<sedr::RoomSheet> sheets;
  plan = sedr::fitPlan(sedr::PointView(*input_), evidence, parameters_, problem,
                       warnings_, &boundaries_, &sheets);
  if (!problem.empty())
    return fail("FloorplanFitting", problem);
  fitToRaw(plan);
  constexpr double tolerance = 0.05; // metres, of what lies on a wall
  const sedr::PointView points(*input_);
  const std::vector<std::string> cuts = sedr::separateRooms(plan, points, *indices_);
  const bool has_raw =
      raw_ && raw_().size() > 0 && !(raw_indices_ && raw_indices_->empty());
  const sedr::PointView raw = has_raw ? raw_() : points;
  sedr::giveCeilings(sheets, has_raw ? &raw : nullptr,
                     has_raw && raw_indices_ ? *raw_indices_ : Indices(),
                     parameters_.threads, plan);
  sedr::measureEvidence(plan, points, *indices_, tolerance, parameters_.threads);
  warnings_.insert(warnings_.end(), cuts.begin(), cuts.end());
  return true;
}

template <typename PointT>
bool
FloorplanFitting<PointT>::segment(sedr::Floorplan& plan)
{
  plan.rooms.clear();
  warnings_.clear();
  boundaries_.clear();
  this->clearError();
  if (!this->initCompute())
    return fail("FloorplanFitting", "no input cloud was set");
  const bool is_done = run(plan);
  this->deinitCompute();
  return is_done;
}

} // namespace pcl

#define PCL_INSTANTIATE_FloorplanFitting(T)                                            \
  template class PCL_EXPORTS pcl::FloorplanFitting<T>;
