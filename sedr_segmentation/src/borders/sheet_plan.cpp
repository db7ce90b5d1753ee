// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_plan.h"

#include "facet_borders.h"

#include "../curves/loop_difference.h"
#include "../curves/plan_curve.h"
#include "sedr_filters/src/base/exactness.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief A closed line of places as a loop of segments. */
PlanLoop
loopThrough(const std::vector<Eigen::Vector2d>& corners)
{
  PlanLoop loop;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    PlanElement element;
    element.start = corners[k];
    element.end = corners[(k + 1) % corners.size()];
    if ((element.end - element.start).norm() > 1e-9)
      loop.elements.push_back(element);
  }
  return loop;
}

/** @brief The loops around a piece: the outer one counter-clockwise, others clockwise.
 */
std::vector<PlanLoop>
loopsOf(const CellCracks& cracks,
        std::size_t piece,
        const std::vector<std::vector<Eigen::Vector2d>>& borders)
{
  std::vector<PlanLoop> loops;
  for (const std::vector<ChainUse>& uses : cracks.loops[piece]) {
    std::vector<Eigen::Vector2d> corners;
    for (const ChainUse& use : uses) {
      std::vector<Eigen::Vector2d> line = borders[use.chain];
      if (!use.forward)
        std::reverse(line.begin(), line.end());
      corners.insert(corners.end(), line.begin(), line.end() - 1);
    }
    loops.push_back(loopThrough(corners));
  }
  return loops;
}

/** @brief Returns the parts of a counter-clockwise loop inside a boundary, without
 * slivers; the loop itself if both coincide up to rounding. */
std::vector<PlanLoop>
within(const PlanLoop& loop, const PlanLoop& boundary)
{
  std::vector<PlanLoop> inside = intersection(loop, boundary);
  double missing = loop.area();
  for (const PlanLoop& part : inside)
    missing -= part.area();
  for (const PlanLoop& part : difference(loop, boundary))
    missing -= part.area();
  if (std::abs(missing) > same_place) // square metres
    return {loop};
  constexpr double sliver = 0.005; // metres
  inside.erase(std::remove_if(inside.begin(), inside.end(),
                              [](const PlanLoop& part) {
                                return 2 * part.area() <= sliver * part.length();
                              }),
               inside.end());
  return inside;
}

/** @brief How many cells of each piece are in the room, and how many were seen. */
std::vector<std::pair<std::size_t, std::size_t>>
cellsInside(const FacetSheet& sheet, const CellCracks& cracks)
{
  std::vector<std::pair<std::size_t, std::size_t>> cells(cracks.first_cell.size());
  for (std::size_t cell = 0; cell < cracks.piece.size(); ++cell)
    if (sheet.is_inside[cell]) {
      auto& [inside, seen] = cells[static_cast<std::size_t>(cracks.piece[cell])];
      ++inside;
      seen += sheet.is_seen[cell];
    }
  return cells;
}

} // namespace

void
giveCeiling(const FacetSheet& sheet,
            const std::vector<Eigen::Vector3d>& points,
            const std::vector<Eigen::Vector3d>& risers,
            PlanRoom& room,
            bool is_floor)
{
  const CellCracks cracks = cracksOf(sheet.grid, sheet.label);
  const auto borders =
      bordersOf(sheet, cracks, points, risers, wallDirections(room.boundary));
  const auto cells = cellsInside(sheet, cracks);
  std::vector<std::size_t> pieces;
  for (std::size_t piece = 0; piece < cells.size(); ++piece)
    if (cells[piece].first > 0)
      pieces.push_back(piece);
  std::stable_sort(pieces.begin(), pieces.end(), [&](std::size_t a, std::size_t b) {
    return cells[a].first > cells[b].first;
  });
  std::vector<PlanDetail>& details = is_floor ? room.floor_details : room.details;
  details.clear();
  const bool slopes = hasSlope(sheet);
  for (const std::size_t piece : pieces) {
    PlanDetail facet;
    const std::size_t cell = cracks.first_cell[piece];
    facet.slab = sheet.facets[static_cast<std::size_t>(sheet.label[cell])];
    facet.slab.inferred = 1 - static_cast<double>(cells[piece].second) /
                                  static_cast<double>(cells[piece].first);
    if (piece == pieces.front())
      (is_floor ? room.floor : room.ceiling) = facet.slab;
    if (sheet.label[cell] ==
        sheet.label[cracks.first_cell[pieces.front()]]) // the main one, or beyond
      continue;                                         // what parts it
    facet.is_facet = slopes && !is_floor;
    std::vector<PlanLoop> outer;
    std::vector<PlanLoop> holes;
    for (const PlanLoop& loop : loopsOf(cracks, piece, borders))
      if (loop.area() > 0)
        outer = within(loop, room.boundary);
      else if (loop.area() < 0)
        holes.push_back(reversed(loop));
    for (PlanLoop& part : outer) {
      facet.holes.clear();
      for (const PlanLoop& hole : holes)
        for (const PlanLoop& of_hole : within(hole, part))
          facet.holes.push_back(reversed(of_hole));
      facet.boundary = std::move(part);
      if (facet.boundary.elements.size() > 1)
        details.push_back(facet);
    }
  }
}

} // namespace pcl::sedr
