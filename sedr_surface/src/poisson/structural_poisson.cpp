// SPDX-License-Identifier: BSD-3-Clause
#include "plan_samples.h"
#include "room_poisson.h"

#include "sedr_filters/src/base/parallel.h"
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/impl/structural_poisson.hpp>

#include <algorithm>
#include <functional>
#include <mutex>
#include <numeric>

namespace pcl::sedr {

namespace {

/** @brief Calls `work(i, threads)` for each room. Threads that share one room wait for
 * each other at every step, so every thread has a room of its own; only rooms that
 * exceed one thread's share of the work come first, on all threads. */
void
forEachRoom(const std::vector<std::size_t>& sizes,
            unsigned threads,
            const std::function<void(std::size_t, unsigned)>& work)
{
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::size_t left = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  std::size_t next = 0;
  for (; next < order.size() && sizes[order[next]] * threads > left; ++next) {
    work(order[next], threads);
    left -= sizes[order[next]];
  }
  parallelBlocks(order.size() - next, 1, threads,
                 [&](std::size_t k, std::size_t) { work(order[next + k], 1); });
}

/** @brief Makes the surfaces of rooms. `samples(i)` is called at most once for each,
 * one at a time; `sizes` give the work of each. */
void
addRooms(const std::vector<std::size_t>& sizes,
         const std::function<RoomSamples(std::size_t)>& samples,
         const RoomPoissonParameters& parameters,
         const RoomSharing& sharing,
         RoomMeshes meshes)
{
  std::vector<std::size_t> mine;
  std::vector<std::size_t> sizes_of_mine;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (!sharing.is_mine || sharing.is_mine(i)) {
      mine.push_back(i);
      sizes_of_mine.push_back(sizes[i]);
    }
  std::vector<RoomSurface> surfaces(sizes.size());
  std::vector<char> is_made(sizes.size(), 0);
  std::size_t next = 0;
  const auto addUpTo = [&](std::size_t end) { // frees each
    for (; next < end && is_made[next] != 0; ++next) {
      meshes.mesh.append(surfaces[next].mesh);
      meshes.reports.push_back(surfaces[next].report);
      surfaces[next] = {};
    }
  };
  std::mutex one_at_a_time;
  forEachRoom(sizes_of_mine, resolveThreads(parameters.threads),
              [&](std::size_t k, unsigned threads) {
                RoomPoissonParameters own = parameters;
                own.threads = threads;
                std::unique_lock<std::mutex> lock(one_at_a_time);
                const RoomSamples room = samples(mine[k]);
                lock.unlock();
                RoomSurface surface = surfaceOf(room, own);
                lock.lock();
                surfaces[mine[k]] = std::move(surface);
                is_made[mine[k]] = 1;
                if (!sharing.complete)
                  addUpTo(sizes.size());
              });
  if (!sharing.complete)
    return;
  sharing.complete(surfaces);
  is_made.assign(sizes.size(), 1);
  addUpTo(sizes.size());
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
             const RoomSharing& sharing,
             RoomMeshes meshes)
{
  std::vector<std::size_t> sizes;
  std::vector<RoomSamples*> samples;
  for (auto& [number, room] : rooms) {
    sizes.push_back(room.points.size());
    samples.push_back(&room);
  }
  addRooms(
      sizes, [&](std::size_t i) { return std::move(*samples[i]); }, parameters, sharing,
      meshes);
}

std::string
makeSurfaces(const Floorplan& plan,
             double spacing,
             const RoomPoissonParameters& parameters,
             const RoomSharing& sharing,
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
      parameters, sharing, meshes);
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
