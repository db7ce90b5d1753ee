// SPDX-License-Identifier: BSD-3-Clause

#include "../base/parallel_for.h"
#include "surface_cells.h"

#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::sedr {

namespace {

/** @brief Converts a strip of a room; its first cell is output point `first`. */
RepairedStrip
repairedStrip(const SurfaceCells::Strip& strip, std::uint32_t room, std::size_t first)
{
  RepairedStrip result{room,
                       strip.surface.kind,
                       strip.surface.label,
                       *strip.surface.element,
                       {}};
  for (std::size_t c = 0; c < strip.spans.size(); ++c)
    result.columns.push_back({strip.spans[c].low, strip.spans[c].high,
                              first + strip.first[c],
                              strip.first[c + 1] - strip.first[c]});
  return result;
}

} // namespace

Refinement
refineToPlan(const PointView& points,
             const std::vector<int>& indices,
             const std::vector<std::uint32_t>& labels,
             const std::vector<std::uint32_t>& rooms,
             const Floorplan& plan,
             double farthest,
             unsigned threads)
{
  std::map<std::uint32_t, RoomSurfaces> surfaces;
  for (const auto& room : plan.rooms)
    surfaces.try_emplace(room.id, room, farthest);

  std::vector<SurfacePoint> snapped(indices.size());
  std::vector<std::uint8_t> is_structure(indices.size(), 0);
  parallelFor(indices.size(), 4096, threads, [&](std::size_t k) {
    const auto i = static_cast<std::size_t>(indices[k]);
    const auto room = surfaces.find(rooms[i]);
    if (room == surfaces.end() || !points.isFinite(i))
      return;
    is_structure[k] =
        room->second.snap(points[i].cast<double>(),
                          static_cast<StructureLabel>(labels[i]), snapped[k])
            ? 1
            : 0;
  });

  Refinement result;
  for (std::size_t k = 0; k < indices.size(); ++k)
    if (is_structure[k]) {
      result.sources.push_back(indices[k]);
      result.points.push_back(snapped[k]);
    }
  return result;
}

bool
isInOpening(const Floorplan& plan, const Eigen::Vector3d& place)
{
  constexpr double beside = 0.1; // the bulge of a curved wall, metres
  return std::any_of(
      plan.openings.begin(), plan.openings.end(), [&](const PlanOpening& o) {
        const double half = o.width() / 2;
        const Eigen::Vector2d way = (o.end - o.start) / (2 * half);
        const Eigen::Vector2d off = place.head<2>() - (o.start + o.end) / 2;
        const double along = off.dot(way) / half; // -1 to 1
        if (!(std::abs(along) < 1) || place.z() <= o.bottom ||
            std::abs(way.x() * off.y() - way.y() * off.x()) > o.depth / 2 + beside)
          return false;
        return place.z() < o.top - o.rise * (1 - std::sqrt(1 - along * along));
      });
}

std::vector<RepairedPoint>
repairHoles(const std::vector<SurfacePoint>& refined,
            const Floorplan& plan,
            double cell_size,
            std::vector<RepairedStrip>* strips)
{
  std::map<std::uint32_t, std::vector<std::size_t>> points_of;
  for (std::size_t i = 0; i < refined.size(); ++i)
    points_of[refined[i].room].push_back(i);
  std::vector<RepairedPoint> repaired;
  for (const auto& room : plan.rooms) {
    SurfaceCells cells(room, cell_size);
    for (const std::size_t i : points_of[room.id])
      cells.occupy(refined[i], i);
    if (strips)
      for (const auto& strip : cells.strips())
        strips->push_back(repairedStrip(strip, room.id, repaired.size()));
    repaired.reserve(repaired.size() + cells.cells().size());
    for (const auto& cell : cells.cells()) {
      if (cell.is_occupied)
        repaired.push_back({refined[cell.source], static_cast<int>(cell.source)});
      else
        repaired.push_back({cell.centre, -1});
    }
  }
  return repaired;
}

} // namespace pcl::sedr
