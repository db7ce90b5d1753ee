// SPDX-License-Identifier: BSD-3-Clause
#include "detail_outline.h"

#include "../curves/contour.h"
#include "../curves/plan_segment.h"
#include "../loops/loop_assembly.h"
#include "sedr_filters/src/base/exactness.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

std::vector<Eigen::Vector2d>
placesOf(const LoopContour& contour)
{
  std::vector<Eigen::Vector2d> places;
  for (const LoopSample& sample : contour.samples)
    places.push_back(sample.place);
  return places;
}

/** @brief Returns the contour of the largest region, and those of holes of a minimum
 * area. */
std::vector<LoopContour>
largestContours(const CellMask& cells, const CellGrid& grid, double min_hole)
{
  std::vector<LoopContour> contours;
  for (LoopContour& contour : contoursOf(cells, grid, 0))
    if (contour.is_hole ? signedArea(placesOf(contour)) < -min_hole : contours.empty())
      contours.push_back(std::move(contour));
  return contours;
}

/** @brief Returns the curves of the elements that contours may follow, each once. */
std::vector<SeededCurve>
curvesBeside(const std::vector<PlanElement>& elements,
             const std::vector<LoopContour>& contours,
             double reach)
{
  std::vector<SeededCurve> curves;
  for (const PlanElement& e : elements) {
    SeededCurve path;
    double least = reach;
    for (const LoopContour& contour : contours)
      for (const LoopSample& sample : contour.samples)
        if (const double d = e.distance(sample.place); d < least) {
          least = d;
          path.seed = sample.place;
        }
    path.curve = carrierOf(e);
    const auto isSame = [&](const SeededCurve& other) {
      return other.curve.isCircle() == e.isArc() &&
             other.curve.distance(e.start) < same_line &&
             other.curve.distance(e.pointAt(e.length() / 2)) < same_line &&
             other.curve.distance(e.end) < same_line;
    };
    if (least < reach && std::none_of(curves.begin(), curves.end(), isSame))
      curves.push_back(path);
  }
  return curves;
}

/** @brief Returns a contour with straight sides, its steps evened out. */
PlanLoop
polygonOf(const LoopContour& contour, double tolerance)
{
  PlanLoop loop;
  const std::vector<Eigen::Vector2d> corners = simplified(placesOf(contour), tolerance);
  for (std::size_t i = 0; i < corners.size(); ++i)
    loop.elements.push_back(segment(corners[i], corners[(i + 1) % corners.size()]));
  return loop;
}

} // namespace

DetailOutline
outlineOf(const CellMask& cells,
          const CellMask& seen,
          const PlanPoints& edges,
          const std::vector<PlanElement>& known,
          const RoomFitParameters& parameters)
{
  constexpr double reach = 6; // cells: farther elements are none of its edges
  const CellGrid grid(parameters.cell_size);
  const LoopEnergy energy;
  std::vector<LoopContour> contours =
      largestContours(cells, grid, parameters.minimum_detail_area);
  for (LoopContour& contour : contours)
    gatherBeside(edges, {&cells, &seen, nullptr}, grid, energy, contour);
  findSurfaces(contours, energy, grid.size());
  const std::vector<WallLine> no_lines;
  LoopSolver solver(contours, no_lines, energy, grid.size(),
                    wallNoise(contours, energy, grid.size()), 1);
  solver.setKnown(curvesBeside(known, contours, reach * grid.size()));
  solver.solve();
  DetailOutline outline;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    PlanLoop loop = assembleLoop(solver, c);
    if (loop.elements.empty())
      loop = polygonOf(contours[c], grid.size());
    if (contours[c].is_hole)
      outline.holes.push_back(std::move(loop));
    else
      outline.boundary = std::move(loop);
  }
  return outline;
}

} // namespace pcl::sedr
