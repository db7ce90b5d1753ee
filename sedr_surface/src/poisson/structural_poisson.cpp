// SPDX-License-Identifier: BSD-3-Clause
#include "room_poisson.h"

#include "sedr_filters/src/base/parallel.h"
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/impl/structural_poisson.hpp>

#include <algorithm>
#include <functional>
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

} // namespace

std::string
problemOf(const RoomPoissonParameters& parameters)
{
  return parameters.depth >= 3 && parameters.depth <= 14
             ? ""
             : "the depth must lie from 3 to 14, it is " +
                   std::to_string(parameters.depth);
}

void
makeSurfaces(std::map<std::uint32_t, RoomSamples>& rooms,
             const RoomPoissonParameters& parameters,
             const RoomSharing& sharing,
             TriangleMesh& mesh,
             std::vector<RoomPoissonReport>& reports)
{
  std::vector<RoomSamples*> all;
  std::vector<std::size_t> mine;
  std::vector<std::size_t> sizes;
  for (auto& [number, room] : rooms) {
    if (!sharing.is_mine || sharing.is_mine(all.size())) {
      mine.push_back(all.size());
      sizes.push_back(room.points.size());
    }
    all.push_back(&room);
  }
  std::vector<RoomSurface> surfaces(all.size());
  forEachRoom(
      sizes, resolveThreads(parameters.threads), [&](std::size_t k, unsigned threads) {
        const RoomSamples room = std::move(*all[mine[k]]); // freed with the call
        surfaces[mine[k]] = surfaceOf(room, {parameters.depth, threads});
      });
  if (sharing.complete)
    sharing.complete(surfaces);
  for (RoomSurface& surface : surfaces) {
    mesh.append(surface.mesh);
    reports.push_back(std::move(surface.report));
    surface = {}; // frees it
  }
}

std::string
summaryOf(const std::vector<RoomPoissonReport>& reports)
{
  std::string sentences;
  const auto add = [&](const std::string& sentence) {
    sentences += (sentences.empty() ? "" : "; ") + sentence;
  };
  for (const RoomPoissonReport& report : reports) {
    const std::size_t all = report.points + report.skipped_points;
    if (report.skipped_points > 0)
      PCL_WARN("[pcl::StructuralPoisson] room %u: %zu of %zu points are not finite or "
               "have no normal\n",
               report.room, report.skipped_points, all);
    if (report.scaled_normals > 0)
      PCL_WARN("[pcl::StructuralPoisson] room %u: %zu of %zu normals were not of unit "
               "length\n",
               report.room, report.scaled_normals, all);
    const std::string room = "room " + std::to_string(report.room);
    if (!report.problem.empty())
      add(room +
          (report.topology.triangles > 0 ? " is not closed: " : " has no surface: ") +
          report.problem);
    if (!report.warning.empty())
      add(room + ": " + report.warning);
  }
  return sentences;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(StructuralPoisson, SEDR_POINT_TYPES)
