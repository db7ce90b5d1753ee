// SPDX-License-Identifier: BSD-3-Clause
#include "facet_borders.h"

#include "../curves/loop_difference.h"
#include "../curves/plan_curve.h"
#include "../sheets/sheet_fit.h"
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

/** @brief Share of a piece's cells in the room of which nothing was seen. */
double
shareInferred(const FacetSheet& sheet, const CellCracks& cracks, std::size_t piece)
{
  std::size_t inside = 0;
  std::size_t seen = 0;
  for (std::size_t cell = 0; cell < cracks.piece.size(); ++cell) {
    if (cracks.piece[cell] != static_cast<std::int32_t>(piece) ||
        !sheet.is_inside[cell])
      continue;
    ++inside;
    seen += sheet.is_seen[cell];
  }
  return inside == 0 ? 0 : 1 - static_cast<double>(seen) / static_cast<double>(inside);
}

double
areaInside(const FacetSheet& sheet, const CellCracks& cracks, std::size_t piece)
{
  std::size_t inside = 0;
  for (std::size_t cell = 0; cell < cracks.piece.size(); ++cell)
    inside +=
        cracks.piece[cell] == static_cast<std::int32_t>(piece) && sheet.is_inside[cell]
            ? 1
            : 0;
  return static_cast<double>(inside) * sheet.grid.size * sheet.grid.size;
}

} // namespace

std::vector<double>
wallDirections(const PlanLoop& boundary)
{
  constexpr double same = 0.035; // radians
  constexpr std::size_t most = 4;
  std::vector<std::pair<double, double>> weights; // direction, length
  for (const PlanElement& element : boundary.elements) {
    if (element.isArc())
      continue;
    const Eigen::Vector2d way = element.end - element.start;
    double direction = std::atan2(way.y(), way.x());
    direction -= M_PI / 2 * std::floor(direction / (M_PI / 2));
    const auto known =
        std::find_if(weights.begin(), weights.end(), [&](const auto& other) {
          const double off = std::abs(other.first - direction);
          return std::min(off, M_PI / 2 - off) < same;
        });
    if (known != weights.end())
      known->second += way.norm();
    else
      weights.emplace_back(direction, way.norm());
  }
  std::stable_sort(weights.begin(), weights.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<double> directions;
  for (const auto& [direction, length] : weights)
    if (directions.size() < most) {
      directions.push_back(direction);
      directions.push_back(direction + M_PI / 2);
    }
  return directions;
}

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
  std::vector<std::pair<double, std::size_t>> pieces; // by area
  for (std::size_t piece = 0; piece < cracks.first_cell.size(); ++piece) {
    const double area = areaInside(sheet, cracks, piece);
    if (area > 0)
      pieces.emplace_back(-area, piece);
  }
  std::sort(pieces.begin(), pieces.end());
  std::vector<PlanDetail>& details = is_floor ? room.floor_details : room.details;
  details.clear();
  const bool slopes = hasSlope(sheet);
  for (const auto& [negative, piece] : pieces) {
    PlanDetail facet;
    const std::size_t cell = cracks.first_cell[piece];
    facet.slab = sheet.facets[static_cast<std::size_t>(sheet.label[cell])];
    facet.slab.inferred = shareInferred(sheet, cracks, piece);
    if (piece == pieces.front().second)
      (is_floor ? room.floor : room.ceiling) = facet.slab;
    if (sheet.label[cell] ==
        sheet.label[cracks.first_cell[pieces.front().second]]) // the main one, or beyond
      continue;                                                // what parts it
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
