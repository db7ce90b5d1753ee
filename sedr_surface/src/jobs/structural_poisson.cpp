// SPDX-License-Identifier: BSD-3-Clause
#include "../poisson/plan_samples.h"
#include "../poisson/room_poisson.h"
#include "room_threads.h"

#include "sedr_filters/src/base/parallel.h"
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/impl/structural_poisson.hpp>

#include <algorithm>
#include <functional>
#include <optional>

namespace pcl::sedr {

namespace {

/** @brief Makes the surfaces of rooms. `samples(i)` is called once for each, `sizes`
 * give the work of each. */
void
addRooms(const std::vector<std::size_t>& sizes,
         const std::function<RoomSamples(std::size_t)>& samples,
         const RoomPoissonParameters& parameters,
         std::shared_ptr<RoomWorkers> workers,
         RoomMeshes meshes)
{
  const auto add = [&](const RoomSurface& surface) {
    meshes.mesh.append(surface.mesh);
    meshes.reports.push_back(surface.report);
  };
  const bool go_side_by_side =
      sizes.size() > 1 && resolveThreads(parameters.threads) > 1;
  if (!workers && go_side_by_side)
    workers = std::make_shared<RoomThreads>(parameters.threads);
  if (!workers) {
    for (std::size_t i = 0; i < sizes.size(); ++i)
      add(surfaceOf(samples(i), parameters));
    return;
  }
  std::vector<std::optional<RoomSurface>> surfaces(sizes.size());
  std::vector<std::uint32_t> rooms(sizes.size());
  std::size_t next = 0;
  workers->work(
      sizes,
      [&](std::size_t i) {
        SurfaceJob job{samples(i), parameters};
        rooms[i] = job.samples.room;
        return job;
      },
      [&](std::size_t i, RoomResult result) {
        surfaces[i].emplace();
        if (auto* surface = std::get_if<RoomSurface>(&result))
          *surfaces[i] = std::move(*surface);
        else {
          surfaces[i]->report.room = rooms[i];
          surfaces[i]->report.problem = std::get<LostRoom>(result).reason;
        }
        for (; next < surfaces.size() && surfaces[next]; ++next) {
          add(*surfaces[next]);
          *surfaces[next] = {};
        }
      });
}

} // namespace

std::string
problemOf(const RoomPoissonParameters& parameters)
{
  std::string problem;
  const auto check = [&](bool right, const char* rule, double value) {
    if (right || !problem.empty())
      return;
    std::string number = std::to_string(value);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.')
      number.pop_back();
    problem = std::string(rule) + ", it is " + number;
  };
  check(parameters.depth >= 3 && parameters.depth <= 14,
        "the depth must lie from 3 to 14", parameters.depth);
  check(parameters.point_weight >= 0 && std::isfinite(parameters.point_weight),
        "the point weight must be 0 or more", parameters.point_weight);
  check(parameters.cell_ratio >= 0.1 && parameters.cell_ratio <= 10,
        "the cell ratio must lie from 0.1 to 10", parameters.cell_ratio);
  check(parameters.support_distance > 0, "the support distance must be above 0 m",
        parameters.support_distance);
  check(parameters.min_points >= 10, "the least number of points must be 10 or more",
        static_cast<double>(parameters.min_points));
  return problem;
}

void
makeSurfaces(std::map<std::uint32_t, RoomSamples>& rooms,
             const RoomPoissonParameters& parameters,
             const std::shared_ptr<RoomWorkers>& workers,
             RoomMeshes meshes)
{
  std::vector<std::size_t> sizes;
  std::vector<RoomSamples*> samples;
  for (auto& [number, room] : rooms) {
    sizes.push_back(room.points.size());
    samples.push_back(&room);
  }
  addRooms(
      sizes, [&](std::size_t i) { return std::move(*samples[i]); }, parameters, workers,
      meshes);
}

std::string
makeSurfaces(const Floorplan& plan,
             double spacing,
             const RoomPoissonParameters& parameters,
             const std::shared_ptr<RoomWorkers>& workers,
             RoomMeshes meshes)
{
  if (plan.rooms.empty())
    return "the floor plan has no rooms";
  if (!(spacing > 0))
    return "the spacing of a plan's samples must be above 0 m, it is " +
           std::to_string(spacing);
  std::vector<std::size_t> sizes;
  for (const PlanRoom& room : plan.rooms)
    sizes.push_back(static_cast<std::size_t>(room.area()));
  addRooms(
      sizes,
      [&](std::size_t i) {
        PlanSamples samples = samplePlan(plan.rooms[i], spacing);
        return RoomSamples{plan.rooms[i].id,
                           std::move(samples.points),
                           std::move(samples.labels),
                           0,
                           0,
                           std::move(samples.problem)};
      },
      parameters, workers, meshes);
  return {};
}

std::string
summaryOf(const std::vector<RoomPoissonReport>& reports)
{
  std::vector<std::string> sentences;
  for (const RoomPoissonReport& report : reports) {
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
  return all;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(StructuralPoisson, SEDR_POINT_TYPES)
