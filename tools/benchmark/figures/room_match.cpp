// SPDX-License-Identifier: BSD-3-Clause
#include "room_match.h"

#include <pcl/sedr_filters/plan_measures.h>
#include "largest_error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::sedr::benchmark {

namespace {

constexpr double overlap_step = 0.05;   ///< metres; cell of the grid for overlaps
constexpr double outline_chords = 0.01; ///< metres; chord tolerance of an outline's box
constexpr double min_overlap = 0.5;     ///< share of the union of two matched rooms

bool
holds(const sim::RoomTruth& room, sim::Vec2 p)
{
  return sim::contains(room.outline, p) &&
         std::none_of(
             room.columns.begin(), room.columns.end(),
             [p](const sim::Loop& column) { return sim::contains(column, p); });
}

/** @brief Returns the square metres that a found room shares with each true one. */
std::vector<double>
overlapsOf(const PlanRoom& room, const std::vector<sim::RoomTruth>& truths)
{
  std::vector<double> overlaps(truths.size(), 0.0);
  Eigen::AlignedBox2d box;
  for (const auto& corner : room.boundary.polygon(outline_chords))
    box.extend(corner);
  const double step = overlap_step;
  for (double y = box.min().y() + step / 2; y < box.max().y(); y += step)
    for (double x = box.min().x() + step / 2; x < box.max().x(); x += step) {
      if (!room.contains({x, y}))
        continue;
      for (std::size_t t = 0; t < truths.size(); ++t)
        if (holds(truths[t], {x, y}))
          overlaps[t] += step * step;
    }
  return overlaps;
}

} // namespace

std::vector<RoomPair>
matchRooms(const Floorplan& plan, const std::vector<sim::RoomTruth>& truths)
{
  std::vector<RoomPair> candidates;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    const auto overlaps = overlapsOf(plan.rooms[r], truths);
    for (std::size_t t = 0; t < truths.size(); ++t)
      if (overlaps[t] > 0)
        candidates.push_back({r, t, overlaps[t]});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.overlap > b.overlap; });
  std::vector<RoomPair> pairs;
  for (const RoomPair& candidate : candidates)
    if (std::none_of(pairs.begin(), pairs.end(), [&](const RoomPair& pair) {
          return pair.found == candidate.found || pair.truth == candidate.truth;
        }))
      pairs.push_back(candidate);
  return pairs;
}

RoomFigures
measureRooms(const Floorplan& plan,
             const std::vector<sim::RoomTruth>& truths,
             const std::map<std::uint32_t, double>& mesh_volumes)
{
  RoomFigures figures;
  figures.rooms_true = truths.size();
  figures.rooms_found = plan.rooms.size();
  for (const RoomPair& pair : matchRooms(plan, truths)) {
    const PlanRoom& room = plan.rooms[pair.found];
    const sim::RoomTruth& truth = truths[pair.truth];
    const double area = room.area();
    const double height = meanHeight(room);
    const double both = area + truth.area - pair.overlap;
    figures.rooms_matched += pair.overlap >= min_overlap * both ? 1 : 0;
    keepLargerError(figures.area_error, area, truth.area);
    keepLargerError(figures.height_error, height, truth.height);
    keepLargerError(figures.volume_error, volumeOf(room, height), truth.volume);
    const auto mesh = mesh_volumes.find(room.id);
    if (mesh != mesh_volumes.end())
      keepLargerError(figures.mesh_volume_error, mesh->second, truth.volume);
  }
  return figures;
}

} // namespace pcl::sedr::benchmark
