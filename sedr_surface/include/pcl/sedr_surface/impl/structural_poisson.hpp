// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/point_tests.h>
#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_surface/impl/mesh_reconstruction.hpp>
#include <pcl/sedr_surface/plan_samples.h>
#include <pcl/sedr_surface/room_threads.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl {

template <typename PointNT>
bool
StructuralPoisson<PointNT>::checkParameters()
{
  const sedr::PoissonParameters& solver = parameters_.solver;
  const auto check = [this](bool right, const char* rule, double value) {
    if (right)
      return true;
    std::string number = std::to_string(value);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.')
      number.pop_back();
    return fail("StructuralPoisson", std::string(rule) + ", it is " + number);
  };
  return check(solver.depth >= 3 && solver.depth <= 14,
               "the depth must lie from 3 to 14", solver.depth) &&
         check(solver.min_depth >= 0 && solver.min_depth <= solver.depth,
               "the least depth must lie from 0 to the depth", solver.min_depth) &&
         check(solver.point_weight >= 0 && std::isfinite(solver.point_weight),
               "the point weight must be 0 or more", solver.point_weight) &&
         check(solver.scale > 1 && solver.scale <= 10,
               "the scale must lie above 1 and up to 10", solver.scale) &&
         check(solver.samples_per_node > 0 && std::isfinite(solver.samples_per_node),
               "the samples per node must be above 0", solver.samples_per_node) &&
         check(solver.threads >= 1, "the number of solver threads must be 1 or more",
               solver.threads) &&
         check(parameters_.cell_ratio >= 0.1 && parameters_.cell_ratio <= 10,
               "the cell ratio must lie from 0.1 to 10", parameters_.cell_ratio) &&
         check(parameters_.support_distance > 0,
               "the support distance must be above 0 m",
               parameters_.support_distance) &&
         check(parameters_.min_points >= 10,
               "the least number of points must be 10 or more",
               static_cast<double>(parameters_.min_points));
}

template <typename PointNT>
std::uint32_t
StructuralPoisson<PointNT>::roomOf(pcl::index_t index) const
{
  if (!room_labels_.empty())
    return room_labels_[static_cast<std::size_t>(index)];
  if constexpr (pcl::traits::has_field<PointNT, pcl::fields::room>::value)
    return (*input_)[index].room;
  else
    return 0;
}

template <typename PointNT>
void
StructuralPoisson<PointNT>::gather(
    std::map<std::uint32_t, sedr::RoomSamples>& rooms) const
{
  for (const auto index : *indices_) {
    const PointNT& point = (*input_)[index];
    sedr::RoomSamples& room = rooms[roomOf(index)];
    room.room = roomOf(index);
    const Eigen::Vector3f normal = point.getNormalVector3fMap();
    const float length = normal.norm();
    if (!pcl::isXYZFinite(point) || !std::isfinite(length) || length < 1e-6f) {
      ++room.skipped;
      continue;
    }
    room.scaled += std::abs(length - 1) > 1e-3f;
    room.points.push_back({point.getVector3fMap(), normal / length});
    if constexpr (pcl::traits::has_field<PointNT, pcl::fields::label>::value)
      room.labels.push_back(point.label);
  }
  if (rooms.size() > 1)
    rooms.erase(0); // no room's points
}

template <typename PointNT>
void
StructuralPoisson<PointNT>::addRooms(
    const std::vector<std::size_t>& sizes,
    const std::function<sedr::RoomSamples(std::size_t)>& samples,
    const sedr::RoomPoissonParameters& parameters)
{
  const auto add = [this](const sedr::RoomSurface& surface) {
    mesh_.append(surface.mesh);
    reports_.push_back(surface.report);
  };
  // pcl::Poisson keeps what it works on in one place for all.
  const bool go_side_by_side = parameters.method == Solver::Sedr && sizes.size() > 1 &&
                               sedr::resolveThreads(parameters.threads) > 1;
  std::shared_ptr<sedr::RoomWorkers> workers = workers_;
  if (!workers && go_side_by_side)
    workers = std::make_shared<sedr::RoomThreads>(parameters.threads);
  if (!workers) {
    for (std::size_t i = 0; i < sizes.size(); ++i)
      add(sedr::surfaceOf(samples(i), parameters));
    return;
  }
  std::vector<std::optional<sedr::RoomSurface>> surfaces(sizes.size());
  std::vector<std::uint32_t> rooms(sizes.size());
  std::size_t next = 0;
  workers->work(
      sizes,
      [&](std::size_t i) {
        sedr::SurfaceJob job{samples(i), parameters};
        rooms[i] = job.samples.room;
        return job;
      },
      [&](std::size_t i, sedr::RoomResult result) {
        surfaces[i].emplace();
        if (auto* surface = std::get_if<sedr::RoomSurface>(&result))
          *surfaces[i] = std::move(*surface);
        else {
          surfaces[i]->report.room = rooms[i];
          surfaces[i]->report.problem = std::get<sedr::LostRoom>(result).reason;
        }
        for (; next < surfaces.size() && surfaces[next]; ++next) {
          add(*surfaces[next]);
          *surfaces[next] = {};
        }
      });
}

template <typename PointNT>
void
StructuralPoisson<PointNT>::summarize()
{
  closed_ = true;
  std::vector<std::string> sentences;
  for (const sedr::RoomPoissonReport& report : reports_) {
    const std::size_t all = report.points + report.skipped_points;
    if (report.skipped_points > 0)
      PCL_WARN("[pcl::StructuralPoisson] room %u: %zu of %zu points are not finite or "
               "have no "
               "normal\n",
               report.room, report.skipped_points, all);
    if (report.scaled_normals > 0)
      PCL_WARN("[pcl::StructuralPoisson] room %u: %zu of %zu normals were not of unit "
               "length\n",
               report.room, report.scaled_normals, all);
    closed_ = closed_ && report.closed;
    const std::string room = "room " + std::to_string(report.room);
    if (!report.problem.empty())
      sentences.push_back(
          room +
          (report.topology.triangles > 0 ? " is not closed: " : " has no surface: ") +
          report.problem);
    if (!report.warning.empty())
      sentences.push_back(room + ": " + report.warning);
  }
  std::string all;
  for (const std::string& sentence : sentences)
    all += (all.empty() ? "" : "; ") + sentence;
  if (!all.empty())
    fail("StructuralPoisson", all);
}

template <typename PointNT>
bool
StructuralPoisson<PointNT>::run()
{
  this->clearError();
  reports_.clear();
  mesh_ = sedr::TriangleMesh();
  closed_ = false;
  if (!(plan_ ? runOnPlan() : runOnPoints()))
    return false;
  summarize();
  return !mesh_.empty();
}

template <typename PointNT>
bool
StructuralPoisson<PointNT>::runOnPlan()
{
  // pcl::Poisson rounds edges, where the samples are denser, unless cells are finer.
  const double edge_cells = parameters_.method == Solver::Pcl ? 0.625 : 1;
  if (plan_->rooms.empty())
    return fail("StructuralPoisson", "the floor plan has no rooms");
  if (!(plan_spacing_ > 0))
    return fail("StructuralPoisson", "the spacing of a plan's samples must be above 0 "
                                     "m, it is " +
                                         std::to_string(plan_spacing_));
  if (!checkParameters())
    return false;
  sedr::RoomPoissonParameters parameters = parameters_;
  parameters.cell_ratio = std::max(0.1, edge_cells * parameters.cell_ratio);
  std::vector<std::size_t> sizes;
  for (const sedr::PlanRoom& room : plan_->rooms)
    sizes.push_back(static_cast<std::size_t>(room.area()));
  addRooms(
      sizes,
      [this](std::size_t i) {
        const sedr::PlanRoom& room = plan_->rooms[i];
        sedr::PlanSamples samples = sedr::samplePlan(room, plan_spacing_);
        return sedr::RoomSamples{
            room.id, std::move(samples.points), std::move(samples.labels), 0,
            0,       std::move(samples.problem)};
      },
      parameters);
  return true;
}

template <typename PointNT>
bool
StructuralPoisson<PointNT>::runOnPoints()
{
  if (!input_)
    return fail("StructuralPoisson", "no input cloud is set");
  if (input_->empty())
    return fail("StructuralPoisson", "the input cloud is empty");
  if (!checkParameters())
    return false;
  if (!room_labels_.empty() && room_labels_.size() != input_->size())
    return fail("StructuralPoisson", std::to_string(room_labels_.size()) +
                                         " room labels are set for " +
                                         std::to_string(input_->size()) + " points");
  if (!initCompute())
    return fail("StructuralPoisson", "PCL refuses the input cloud and its indices");
  std::string problem = sedr::indicesProblem(*indices_, input_->size());
  if (problem.empty() && indices_->empty())
    problem =
        "no indices are selected of " + std::to_string(input_->size()) + " points";
  if (problem.empty()) {
    std::map<std::uint32_t, sedr::RoomSamples> rooms;
    gather(rooms);
    std::vector<std::size_t> sizes;
    std::vector<sedr::RoomSamples*> samples;
    for (auto& room : rooms) {
      sizes.push_back(room.second.points.size());
      samples.push_back(&room.second);
    }
    addRooms(
        sizes, [&](std::size_t i) { return std::move(*samples[i]); }, parameters_);
  }
  deinitCompute();
  return problem.empty() || fail("StructuralPoisson", problem);
}

template <typename PointNT>
void
StructuralPoisson<PointNT>::performReconstruction(PointCloud& points,
                                                  std::vector<pcl::Vertices>& polygons)
{
  sedr::MeshReconstruction<PointNT>::performReconstruction(points, polygons);
  if constexpr (pcl::traits::has_field<PointNT, pcl::fields::label>::value)
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const auto v : mesh_.triangles[t])
        points[v].label = mesh_.labels[t];
}

} // namespace pcl
