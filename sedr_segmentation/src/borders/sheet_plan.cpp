// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_plan.h"

#include "../curves/contour.h"
#include "../curves/loop_difference.h"
#include "../curves/plan_curve.h"
#include "../sheets/shape_proposals.h"
#include "../surface/cell_points.h"
#include "border_steps.h"
#include "cell_cracks.h"

#include "sedr_filters/src/base/exactness.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Checks whether a cell is at a wall, whose points are no riser's. */
bool
isAtWall(const FacetSheet& sheet, std::size_t cell)
{
  bool is_inside = true;
  return !sheet.grid.forAllWithin(cell, RiserBins::to_wall, [&](std::size_t near) {
    is_inside = is_inside && sheet.is_inside[near] != 0;
  }) || !is_inside;
}

/** @brief The lowest and the highest of the facets near a cell, above its middle. */
std::pair<double, double>
heightsAbout(const FacetSheet& sheet, std::size_t cell)
{
  std::int32_t last = FacetSheet::none;
  std::pair<double, double> heights(std::numeric_limits<double>::infinity(),
                                    -std::numeric_limits<double>::infinity());
  sheet.grid.forAllWithin(
      cell, static_cast<int>(2 * SheetCracks::reach), [&](std::size_t near) {
        if (sheet.label[near] == last)
          return;
        last = sheet.label[near];
        const double height = sheet.facets[static_cast<std::size_t>(last)].heightAt(
            sheet.grid.centre(cell));
        heights = {std::min(heights.first, height), std::max(heights.second, height)};
      });
  return heights;
}

} // namespace

std::vector<Eigen::Vector3d>
pointsOfRisers(const FacetSheet& sheet,
               const PointView& scan,
               const std::vector<int>& indices)
{
  const double margin = facet_band * sheet.noise;
  std::vector<std::pair<double, double>> heights(sheet.grid.count());
  for (std::size_t cell = 0; cell < heights.size(); ++cell) {
    heights[cell] = heightsAbout(sheet, cell);
    auto& [low, high] = heights[cell];
    if (!(high - low > margin))
      high = low - margin; // no step
    else if (isAtWall(sheet, cell))
      high = low + margin; // only where the lower facet ends
  }
  std::vector<Eigen::Vector3d> points;
  forAllOver(sheet.grid, scan, indices,
             [&](std::size_t cell, const Eigen::Vector3d& p) {
               const auto& [low, high] = heights[cell];
               if (p.z() > low - margin && p.z() < high)
                 points.push_back(p);
             });
  return points;
}

namespace {

using Place = Eigen::Vector2d;

/** @brief Where the borders of three pieces or more come together. */
using BorderJunctions = std::map<CrackVertex, Eigen::Vector2d>;

using Ends = std::vector<const BorderPart*>;

/** @brief Where parts cross that come together near a place, of all crossings the
 * nearest; where none do, on the first part there is. */
Place
meetingOf(const Ends& parts, const Place& near, double farthest)
{
  std::optional<Place> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto place = crossing(*parts[i], *parts[j], near, farthest);
      if (!place || (*place - near).norm() >= nearest)
        continue;
      nearest = (*place - near).norm();
      best = place;
    }
  if (best)
    return *best;
  for (const BorderPart* part : parts)
    if (const auto place = part->project(near, farthest))
      return *place;
  return near;
}

/** @brief The junctions in the room: where the parts that end at a vertex cross.
 * @param parts of each chain */
BorderJunctions
junctionsOf(const SheetCracks& cracks,
            const std::vector<std::vector<BorderPart>>& parts)
{
  std::map<CrackVertex, Ends> ends;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    const auto& vertices = cracks.cracks.chains[c].vertices;
    if (parts[c].empty() || vertices.front() == vertices.back())
      continue;
    if (cracks.isInside(vertices.front()))
      ends[vertices.front()].push_back(&parts[c].front());
    if (cracks.isInside(vertices.back()))
      ends[vertices.back()].push_back(&parts[c].back());
  }
  BorderJunctions junctions;
  for (const auto& [vertex, ending] : ends)
    junctions[vertex] =
        meetingOf(ending, cracks.placeOf(vertex), 2 * cracks.reachAt(vertex));
  return junctions;
}

/** @brief Where one part of a chain goes over into the next. */
Place
jointOf(const BorderPart& before, const BorderPart& after, const SheetCracks& cracks)
{
  return meetingOf({&after, &before},
                   (before.samples.back() + after.samples.front()) / 2,
                   2 * SheetCracks::reach * cracks.cellSize());
}

/** @brief Puts the parts of each chain together to one line. */
class BorderLines {
public:
  BorderLines(const SheetCracks& cracks,
              const std::vector<std::vector<BorderPart>>& parts)
      : cracks_(cracks)
      , parts_(parts)
      , junctions_(junctionsOf(cracks, parts))
  {}

  std::vector<Place> lineOf(std::size_t c) const
  {
    const auto& vertices = cracks_.cracks.chains[c].vertices;
    const std::vector<BorderPart>& parts = parts_[c];
    if (parts.empty())
      return rawLine(vertices);
    std::vector<Place> line;
    const bool is_closed = vertices.front() == vertices.back();
    if (!is_closed)
      line = endOf(vertices.front(), parts.front(), parts.front().samples.front());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (k > 0)
        line.push_back(jointOf(parts[k - 1], parts[k], cracks_));
      else if (is_closed)
        line.push_back(jointOf(parts.back(), parts.front(), cracks_));
      if (parts[k].meets())
        addSamples(parts[k], line);
    }
    if (is_closed)
      line.push_back(line.front());
    else {
      const auto end =
          endOf(vertices.back(), parts.back(), parts.back().samples.back());
      line.insert(line.end(), end.rbegin(), end.rend());
    }
    return simplifiedLine(line, border_tolerance);
  }

private:
  std::vector<Place> rawLine(const std::vector<CrackVertex>& vertices) const
  {
    std::vector<Place> line;
    for (const CrackVertex& v : vertices)
      line.push_back(cracks_.placeOf(v));
    return simplifiedLine(line, border_tolerance);
  }

  /** @brief The places from the end of a chain to where its last part begins: its
   * junction, or what leads there from beside the room.
   * @param sample of the part that is nearest to the end */
  std::vector<Place>
  endOf(const CrackVertex& vertex, const BorderPart& part, const Place& sample) const
  {
    const auto junction = junctions_.find(vertex);
    if (junction != junctions_.end())
      return {junction->second};
    const Place outside = cracks_.placeOf(vertex);
    return {outside, beyond(part, sample, outside)};
  }

  /** @brief A place on the line of a part, a little farther out than its sample. */
  Place beyond(const BorderPart& part, const Place& sample, const Place& outside) const
  {
    const double step = 2.2 * cracks_.cellSize();
    const Place on_line = part.project(sample, step).value_or(sample);
    const Place normal = part.sideOf(on_line).second;
    Place way(-normal.y(), normal.x());
    if (way.dot(outside - on_line) < 0)
      way = -way;
    const Place out = on_line + step * way;
    return part.project(out, step).value_or(out);
  }

  /** @brief Adds the samples of a part that do not lie beside its ends. */
  void addSamples(const BorderPart& part, std::vector<Place>& line) const
  {
    const double margin = 2 * cracks_.cellSize();
    const Place& first = part.samples.front();
    const Place& last = part.samples.back();
    const bool is_round = (first - last).norm() < margin && part.samples.size() > 8;
    for (const Place& sample : part.samples)
      if (is_round ||
          ((sample - first).norm() > margin && (sample - last).norm() > margin))
        line.push_back(sample);
  }

  const SheetCracks& cracks_;
  const std::vector<std::vector<BorderPart>>& parts_; ///< of each chain
  const BorderJunctions junctions_;
};

/** @brief The lines between the pieces of a sheet in plan, one of each chain of
 * `cracks`, from its first vertex to its last: where two facets meet, the line above
 * which both have one height; elsewhere straight steps where their riser
 * is, or between the points of both, along the walls' directions where they are nearly
 * so.
 * @param points of the ceiling
 * @param risers points between its heights, see pointsOfRisers()
 * @param directions of the walls, radians */
std::vector<std::vector<Eigen::Vector2d>>
bordersOf(const FacetSheet& sheet,
          const CellCracks& cracks,
          const std::vector<Eigen::Vector3d>& points,
          const std::vector<Eigen::Vector3d>& risers,
          const std::vector<double>& directions)
{
  const SheetCracks pieces{sheet, cracks};
  const CellPoints cells(sheet.grid, sheet.is_inside, points);
  const CellPoints vertical(sheet.grid, sheet.is_inside, risers);
  const BorderSteps steps(pieces, cells, vertical, directions);
  std::vector<std::vector<BorderPart>> parts;
  for (const CrackChain& chain : cracks.chains)
    parts.push_back(partsOf(chain, pieces, steps));
  const BorderLines lines(pieces, parts);
  std::vector<std::vector<Eigen::Vector2d>> borders;
  for (std::size_t c = 0; c < cracks.chains.size(); ++c)
    borders.push_back(lines.lineOf(c));
  return borders;
}

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
