// SPDX-License-Identifier: BSD-3-Clause
#include "detail_extension.h"
#include "detail_outline.h"
#include "detail_risers.h"
#include "height_map.h"

#include "../profiles/cell_count.h"
#include "detail_fit.h"
#include "sedr_filters/src/plan/room_lookup.h"

#include <algorithm>

namespace pcl::sedr {

namespace {

/** @brief Appends the elements that other loops may reuse: those over `shortest`. */
void
appendElements(const PlanLoop& loop,
               double shortest,
               std::vector<PlanElement>& elements)
{
  for (const auto& e : loop.elements)
    if (e.length() > shortest)
      elements.push_back(e);
}

/** @brief Appends points along a loop, 1 cm apart, as edges of details at a wall
 * coincide with it. */
void
appendPoints(const PlanLoop& loop, std::vector<Eigen::Vector2d>& points)
{
  for (const auto& e : loop.elements)
    for (double s = 0.005; s < e.length(); s += 0.01)
      points.push_back(e.pointAt(s));
}

/** @brief Returns the cells of a detail without unseen cells inside larger details, as
 * their edges continue straight where hidden. */
CellMask
seenCellsOf(const HeightMap& map,
            std::int32_t label,
            const CellBox& box,
            const std::vector<const PlanDetail*>& larger,
            const CellGrid& grid)
{
  CellMask cells = cellsOf(map, label, box);
  for (std::size_t i = 0; i < cells.values().size(); ++i) {
    const Cell cell = cells.cellAt(i);
    const auto encloses = [&](const PlanDetail* d) {
      return d->boundary.contains(grid.centre(cell));
    };
    if (cells.values()[i] && map.seen[map.room.indexOf(cell)] != label &&
        std::any_of(larger.begin(), larger.end(), encloses))
      cells.values()[i] = 0;
  }
  return cells;
}

/** @brief Returns the labels of the details, the one with the most cells first. */
std::vector<std::int32_t>
widestFirst(const HeightMap& map)
{
  std::vector<std::size_t> sizes(map.details.size() + 1, 0);
  for (const std::int32_t l : map.label)
    if (l > 0)
      ++sizes[static_cast<std::size_t>(l)];
  std::vector<std::int32_t> labels;
  for (std::size_t k = 1; k < sizes.size(); ++k)
    labels.push_back(static_cast<std::int32_t>(k));
  std::stable_sort(labels.begin(), labels.end(), [&](std::int32_t a, std::int32_t b) {
    return sizes[static_cast<std::size_t>(a)] > sizes[static_cast<std::size_t>(b)];
  });
  return labels;
}

/** @brief Extends beams over their hidden parts; merged parts get one label. */
void
extendBeams(HeightMap& map, const CellGrid& grid)
{
  extendDetails(map.room, map.details, grid, map.label, map.priors);
  for (std::size_t i = 0; i < map.seen.size(); ++i)
    if (map.seen[i] > 0)
      map.seen[i] = map.label[i];
}

/** @brief Returns the cells inside a room's boundary: those of the room, and others in
 * strips at least three cells wide, as a beam may hide the corner at a wall. */
CellMask
withinBoundary(const CellMask& cells, const PlanLoop& boundary, const CellGrid& grid)
{
  CellMask held(cells.box());
  const LoopLookup lookup(boundary);
  for (std::size_t i = 0; i < held.values().size(); ++i)
    held.values()[i] = lookup.contains(grid.centre(cells.cellAt(i))) ? 1 : 0;
  const CellMask hidden = subtract(held, cells);
  return unite(intersect(cells, held), dilated(eroded(hidden, 1), 1));
}

/** @brief Returns the points at the rim of a detail, so that denser points of others do
 * not attract it. At a ceiling, no furniture hides the rim. */
std::vector<Eigen::Vector2d>
atRim(const PlanPoints& points,
      const CellMask& cells,
      const CellGrid& grid,
      const Priors& priors)
{
  const auto reach = static_cast<int>(priors.riser_cells) + 1;
  if (cells.count() == 0)
    return {};
  const CellMask near = cropped(cells, grown(boxOf(cells.toSet()), reach + 1));
  const CellMask rim = subtract(dilated(near, reach), eroded(near, reach));
  std::vector<Eigen::Vector2d> own;
  points.forEachIn({grid.centre(rim.box().low), grid.centre(rim.box().high)},
                   [&](const Eigen::Vector2d& p) {
                     if (rim.at(grid.at(p.x(), p.y())))
                       own.push_back(p);
                   });
  return own;
}

} // namespace

std::vector<PlanDetail>
fitDetails(const PointView& points,
           const SlabEvidence& evidence,
           const PlanRoom& room,
           const CellMask& cells,
           const ColumnTable& columns,
           const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  const Priors& priors = parameters.priors;
  HeightMap map = seenHeights(points, evidence,
                              withinBoundary(cells, room.boundary, grid), parameters);
  if (map.details.empty())
    return {};
  if (!evidence.is_floor) {
    extendBeams(map, grid);
    giveShadowsToHigher(map, grid);
  }
  fillHeights(map);
  if (evidence.is_floor)
    fillHiddenParts(map, columns, grid);
  dropUnsupported(map, columns, grid, evidence.is_floor);
  std::vector<Eigen::Vector2d> edges =
      riserPoints(points, evidence, map, columns, parameters);
  appendPoints(room.boundary, edges);
  const double point_cell = priors.evidence_cell;
  std::vector<PlanElement> others;
  appendElements(room.boundary, point_cell, others);
  for (const auto& column : room.columns)
    appendElements(column, point_cell, others);

  const PlanPoints of_all(edges, point_cell);
  const std::vector<CellBox> boxes = boxesOf(map);
  const std::vector<std::int32_t> order = widestFirst(map);
  const auto boxOfRank = [&](std::size_t k) -> const CellBox& {
    return boxes[static_cast<std::size_t>(order[k])];
  };
  std::vector<PlanDetail> fitted(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) { // after the larger ones near it
    const CellBox reach = grown(boxOfRank(k), cellsFor(priors.max_wall, grid.size()));
    std::vector<const PlanDetail*> near;
    std::vector<PlanElement> known = others;
    for (std::size_t l = 0; l < k; ++l) {
      if (overlapOf(reach, boxOfRank(l)).count() == 0)
        continue;
      near.push_back(&fitted[l]);
      appendElements(fitted[l].boundary, point_cell, known);
    }
    const CellMask own = seenCellsOf(map, order[k], boxOfRank(k), near, grid);
    CellMask seen = own;
    for (std::size_t i = 0; i < seen.values().size(); ++i)
      if (map.seen[map.room.indexOf(seen.cellAt(i))] != order[k])
        seen.values()[i] = 0;
    DetailOutline outline = outlineOf(
        own, seen,
        evidence.is_floor ? of_all
                          : PlanPoints(atRim(of_all, own, grid, priors), point_cell),
        known, parameters);
    fitted[k].slab = map.slabOf(order[k]);
    fitted[k].boundary = std::move(outline.boundary);
    fitted[k].holes = std::move(outline.holes);
  }
  std::vector<PlanDetail> details;
  for (PlanDetail& detail : fitted)
    if (!detail.boundary.elements.empty())
      details.push_back(std::move(detail));
  std::stable_sort(details.begin(), details.end(), [](const auto& a, const auto& b) {
    return a.boundary.area() > b.boundary.area();
  });
  return details;
}

} // namespace pcl::sedr
