// SPDX-License-Identifier: BSD-3-Clause
#include "detail_extension.h"

#include <pcl/sedr_segmentation/detail_fit.h>

#include <pcl/sedr_filters/plane_fit.h>
#include <pcl/sedr_segmentation/cell_count.h>
#include <pcl/sedr_segmentation/column_table.h>
#include <pcl/sedr_segmentation/horizontal_levels.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace sedr {

namespace {

/** @brief The height of every cell of a room: 0 the main slab, k the k-th detail, -1
 * none. */
struct HeightMap {
  CellMask room;
  std::vector<std::int32_t> label;
  std::vector<std::int32_t> seen; ///< the labels of what was seen, -1 where filled
  PlanSlab main;
  std::vector<PlanSlab> details; ///< of labels 1, 2, ...

  const PlanSlab& slabOf(std::int32_t of) const
  {
    return of == 0 ? main : details[static_cast<std::size_t>(of - 1)];
  }
};

/** @brief The levels among the detail points. */
std::vector<Level>
detailLevels(const PointView& points,
             const SlabEvidence& evidence,
             const RoomFitParameters& parameters)
{
  LevelParameters p;
  p.tolerance = parameters.slab_tolerance;
  p.cell_size = parameters.cell_size;
  p.minimum_area = parameters.minimum_detail_area;
  p.seed = parameters.loop.seed;
  return findLevels(points, evidence.details, p);
}

/** @brief A step of less than this between two heights is unevenness, metres. */
constexpr double least_step = 0.06;

/** @brief Smallest part of a floor at a height of its own, square metres. */
constexpr double least_floor_area = 1.0;

/** @brief Mean height of a slab over the main one, above the cells of a mask. */
double
heightOverMain(const PlanSlab& main,
               const PlanSlab& slab,
               const CellMask& cells,
               const CellGrid& grid)
{
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells.values().size(); ++i) {
    if (!cells.values()[i])
      continue;
    const Eigen::Vector2d p = grid.centre(cells.cellAt(i));
    sum += slab.heightAt(p) - main.heightAt(p);
    ++count;
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

/** @brief The plane of the detail over some cells: parallel to the main slab, unless it
 * is wide enough for its points to say clearly otherwise. */
PlanSlab
detailSlab(const PointView& points,
           const SlabEvidence& evidence,
           const PlanSlab& main,
           const Level& level,
           const CellMask& cells,
           const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  std::vector<int> own;
  for (const int i : evidence.details) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (cells.at(grid.at(p.x(), p.y())) &&
        std::abs(distanceAbove(level.slab, p)) <= parameters.slab_tolerance)
      own.push_back(i);
  }
  const PlanSlab leaning =
      fitSlabRobustly(points, own, level.slab, parameters.slab_tolerance);
  const PlanSlab parallel =
      fitParallel(points, own, main, level.slab, parameters.slab_tolerance);
  constexpr double least_width = 1.0;
  const bool is_wide =
      eroded(cells, cellsFor(least_width / 2, grid.size())).count() > 0;
  const bool is_clear =
      leaning.residual < 0.7 * parallel.residual && leaning.inliers >= parallel.inliers;
  return is_wide && is_clear ? leaning : parallel;
}

/** @brief Labels the cells of the main slab and of each connected detail. */
HeightMap
seenHeights(const PointView& points,
            const SlabEvidence& evidence,
            const PlanSlab& main_slab,
            const CellMask& room,
            const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  // Furniture leaves small and thin pieces at the heights of a floor.
  const double least_area =
      evidence.is_floor ? least_floor_area : parameters.minimum_detail_area;
  const double opening = evidence.is_floor ? 2 : 1;
  const auto least = static_cast<std::size_t>(least_area / (grid.size() * grid.size()));
  HeightMap map{room,
                std::vector<std::int32_t>(room.values().size(), -1),
                {},
                main_slab,
                {}};
  const CellMask main =
      intersect(CellMask(CellSet(grid, points, evidence.main), room.box()), room);
  for (std::size_t i = 0; i < map.label.size(); ++i)
    if (main.values()[i])
      map.label[i] = 0;
  for (const Level& level : detailLevels(points, evidence, parameters)) {
    CellMask cells = intersect(CellMask(level.cells, room.box()), room);
    if (std::abs(heightOverMain(main_slab, level.slab, cells, grid)) < least_step)
      continue;
    cells = subtract(eroded(dilated(cells, 2), 2), main);
    cells = intersect(cells, dilated(eroded(cells, opening), opening + 1));
    const MaskRegions regions = labelRegions(cells, true);
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      if (regions.sizes[r] < least)
        continue;
      map.details.push_back(detailSlab(
          points, evidence, main_slab, level,
          regionMask(cells, regions, static_cast<std::int32_t>(r)), parameters));
      for (std::size_t i = 0; i < map.label.size(); ++i)
        if (regions.label[i] == static_cast<std::int32_t>(r) && map.label[i] < 0)
          map.label[i] = static_cast<std::int32_t>(map.details.size());
    }
  }
  map.seen = map.label;
  return map;
}

/** @brief Gives every other cell of the room the label that is nearest by steps. */
void
fillHeights(HeightMap& map)
{
  growLabels(map.room, std::numeric_limits<int>::max(), map.label);
}

/** @brief Adds what of a loop others may follow. */
void
appendElements(const PlanLoop& loop, std::vector<PlanElement>& elements)
{
  constexpr double shortest = 0.1;
  for (const auto& e : loop.elements)
    if (e.length() > shortest)
      elements.push_back(e);
}

/** @brief Points along a loop, a centimetre apart: edges of details beside a wall lie
 * on it. */
void
appendPoints(const PlanLoop& loop, std::vector<Eigen::Vector2d>& points)
{
  for (const auto& e : loop.elements)
    for (double s = 0.005; s < e.length(); s += 0.01)
      points.push_back(e.pointAt(s));
}

/** @brief Lowest and highest slab within two cells of a cell; false where there is one
 * only. */
bool
stepBeside(const HeightMap& map,
           const CellGrid& grid,
           Cell cell,
           double& low,
           double& high)
{
  low = std::numeric_limits<double>::infinity();
  high = -low;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      const Cell near{cell.x + dx, cell.y + dy};
      const std::int32_t label =
          map.room.at(near) ? map.label[map.room.indexOf(near)] : -1;
      if (label < 0)
        continue;
      const double height = map.slabOf(label).heightAt(grid.centre(cell));
      low = std::min(low, height);
      high = std::max(high, height);
    }
  return high - low >= least_step;
}

/** @brief Whether what shows at a point goes on beyond the riser between two heights: a
 * shelf that stands before it, or hangs from it. */
bool
goesOn(const ColumnTable& columns,
       Cell cell,
       double z,
       double low,
       double high,
       bool is_floor)
{
  constexpr double gap = 0.12;
  constexpr double beyond = 0.15;
  const std::vector<ColumnRun> runs = columns.runs(cell, gap);
  return std::any_of(runs.begin(), runs.end(), [&](const ColumnRun& run) {
    return run.low <= z && z <= run.high &&
           (is_floor ? run.high > high + beyond : run.low < low - beyond);
  });
}

/** @brief Whether a point is at the height of any slab, such as the tread of a step
 * between floor and platform. */
bool
isOnSlab(const HeightMap& map, const Eigen::Vector3f& p, double margin)
{
  return std::abs(distanceAbove(map.main, p)) <= margin ||
         std::any_of(map.details.begin(), map.details.end(), [&](const PlanSlab& slab) {
           return std::abs(distanceAbove(slab, p)) <= margin;
         });
}

/** @brief Points in plan that show edges of details: those between two heights beside
 * each other. */
std::vector<Eigen::Vector2d>
riserPoints(const PointView& points,
            const SlabEvidence& evidence,
            const HeightMap& map,
            const ColumnTable& columns,
            const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  std::vector<Eigen::Vector2d> risers;
  for (const int i : evidence.around) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    const Cell cell = grid.at(p.x(), p.y());
    double low = 0;
    double high = 0;
    if (!map.room.isInside(cell) || !stepBeside(map, grid, cell, low, high))
      continue;
    const double margin = std::min(parameters.slab_tolerance, (high - low) / 4);
    if (p.z() > low + margin && p.z() < high - margin && !isOnSlab(map, p, margin) &&
        !goesOn(columns, cell, p.z(), low, high, evidence.is_floor))
      risers.push_back(p.head<2>().cast<double>());
  }
  return risers;
}

/** @brief Whether something closes the step along most of the edge between a detail and
 * what is beside it. A shelf below a soffit has no riser: it is furniture. */
bool
hasRisers(const HeightMap& map,
          const ColumnTable& columns,
          const CellGrid& grid,
          std::int32_t label)
{
  std::size_t edges = 0;
  std::size_t closed = 0;
  for (std::size_t i = 0; i < map.label.size(); ++i) {
    if (map.label[i] != label)
      continue;
    const Cell cell = map.room.cellAt(i);
    for (const Cell d : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
      const Cell to{cell.x + d.x, cell.y + d.y};
      const std::int32_t other =
          map.room.at(to) ? map.label[map.room.indexOf(to)] : std::int32_t{-1};
      if (other < 0 || other == label)
        continue;
      const Eigen::Vector2d p = grid.centre(cell);
      const double a = map.slabOf(label).heightAt(p);
      const double b = map.slabOf(other).heightAt(p);
      ++edges;
      const double low = std::min(a, b) + 0.02;
      const double high = std::max(a, b) - 0.02;
      // Bins that hold a voxel each, at most four.
      const int bins = std::min(4, cellsFor(high - low, 1.2 * grid.size()));
      if (high - low < 0.06 || columns.share(cell, low, high, bins, 2) >= 0.5)
        ++closed;
    }
  }
  return 2 * closed >= edges;
}

/** @brief Gives the parts of a floor that platforms and walls enclose, but no riser
 * does, to the platforms: where one is hidden, the recovered floor lies below it. */
void
fillHiddenParts(HeightMap& map, const ColumnTable& columns, const CellGrid& grid)
{
  CellMask rest = map.room;
  for (std::size_t i = 0; i < map.label.size(); ++i)
    if (map.label[i] > 0)
      rest.values()[i] = 0;
  const MaskRegions parts = labelRegions(rest, false);
  const auto largest =
      std::max_element(parts.sizes.begin(), parts.sizes.end()) - parts.sizes.begin();
  map.details.push_back(map.main);
  const auto tried = static_cast<std::int32_t>(map.details.size());
  const auto relabel = [&](std::int32_t part, std::int32_t label) {
    for (std::size_t i = 0; i < map.label.size(); ++i)
      if (parts.label[i] == part)
        map.label[i] = label;
  };
  for (std::size_t r = 0; r < parts.sizes.size(); ++r) {
    const auto part = static_cast<std::int32_t>(r);
    if (part == largest)
      continue;
    relabel(part, tried);
    relabel(part, hasRisers(map, columns, grid, tried) ? 0 : -1);
  }
  map.details.pop_back();
  fillHeights(map);
}

/** @brief Takes out the details without risers, one by one, and gives their cells to
 * what is beside them. */
void
dropUnsupported(HeightMap& map, const ColumnTable& columns, const CellGrid& grid)
{
  for (std::size_t k = map.details.size(); k >= 1; --k) {
    const auto label = static_cast<std::int32_t>(k);
    if (hasRisers(map, columns, grid, label))
      continue;
    for (auto& l : map.label)
      l = l == label ? -1 : l;
    fillHeights(map);
  }
}

/** @brief The cells of a detail, less those unseen that are within larger ones: behind
 * what hides an edge, it goes on straight. */
CellMask
cellsOf(const HeightMap& map,
        std::int32_t label,
        const std::vector<PlanDetail>& larger,
        const CellGrid& grid)
{
  CellMask cells(map.room.box());
  for (std::size_t i = 0; i < map.label.size(); ++i) {
    const auto encloses = [&](const PlanDetail& d) {
      return d.boundary.contains(grid.centre(cells.cellAt(i)));
    };
    if (map.label[i] == label &&
        (map.seen[i] == label || std::none_of(larger.begin(), larger.end(), encloses)))
      cells.values()[i] = 1;
  }
  return cells;
}

/** @brief The labels of the details, the widest first. */
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

/** @brief Lets beams go on over what was not seen of them; joined pieces share their
 * label. */
void
extendBeams(HeightMap& map, const CellGrid& grid)
{
  extendDetails(map.room, map.details, grid, map.label);
  for (std::size_t i = 0; i < map.seen.size(); ++i)
    if (map.seen[i] > 0)
      map.seen[i] = map.label[i];
}

/** @brief The cells of a room and what its boundary holds besides, strips narrower than
 * three cells left out: a beam may hide the corner between it and the wall. */
CellMask
withHiddenCorners(const CellMask& cells, const PlanLoop& boundary, const CellGrid& grid)
{
  CellMask beyond(cells.box());
  for (std::size_t i = 0; i < cells.values().size(); ++i)
    beyond.values()[i] =
        !cells.values()[i] && boundary.contains(grid.centre(cells.cellAt(i))) ? 1 : 0;
  return unite(cells, dilated(eroded(beyond, 1), 1));
}

PlanDetail
fitDetail(const HeightMap& map,
          const CellMask& cells,
          bool is_floor,
          std::int32_t label,
          const PlanPoints& risers,
          const std::vector<PlanElement>& others,
          const RoomFitParameters& parameters)
{
  PlanDetail detail;
  detail.slab = map.slabOf(label);
  // The cells of a riser belong to the lower of its two ceilings, the higher of its
  // floors.
  const bool is_low =
      heightOverMain(map.main, detail.slab, cells, CellGrid(parameters.cell_size)) < 0;
  LoopParameters loop = parameters.loop;
  loop.expected_offset = (is_low != is_floor ? 0.5 : -0.5) * parameters.cell_size;
  loop.reach = 2 * parameters.cell_size;
  loop.evidence_span =
      2 * parameters.cell_size; // a riser has few points above each other
  loop.corner_reach = 3 * parameters.cell_size;
  const std::vector<Contour> contours = traceContours(cells, parameters.cell_size);
  const auto largest = std::max_element(
      contours.begin(), contours.end(),
      [](const Contour& a, const Contour& b) { return signedArea(a) < signedArea(b); });
  if (largest == contours.end() || !(signedArea(*largest) > 0))
    return detail;
  detail.boundary = fitLoop(*largest, risers, others, loop);
  for (const auto& contour : contours)
    if (signedArea(contour) < -parameters.minimum_detail_area)
      detail.holes.push_back(fitLoop(contour, risers, others, loop));
  return detail;
}

} // namespace

std::vector<PlanDetail>
fitDetails(const PointView& points,
           const SlabEvidence& evidence,
           const PlanRoom& room,
           const CellMask& cells,
           const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  HeightMap map =
      seenHeights(points, evidence, evidence.is_floor ? room.floor : room.ceiling,
                  withHiddenCorners(cells, room.boundary, grid), parameters);
  if (!evidence.is_floor)
    extendBeams(map, grid);
  fillHeights(map);
  const ColumnTable columns(grid, cells.box(), points, evidence.around);
  if (evidence.is_floor)
    fillHiddenParts(map, columns, grid);
  dropUnsupported(map, columns, grid);
  std::vector<Eigen::Vector2d> edges =
      riserPoints(points, evidence, map, columns, parameters);
  appendPoints(room.boundary, edges);
  const PlanPoints risers(std::move(edges), 0.1);
  std::vector<PlanElement> others;
  appendElements(room.boundary, others);
  for (const auto& column : room.columns)
    appendElements(column, others);

  std::vector<PlanDetail> details;
  for (const std::int32_t label : widestFirst(map)) {
    PlanDetail detail = fitDetail(map, cellsOf(map, label, details, grid),
                                  evidence.is_floor, label, risers, others, parameters);
    if (detail.boundary.elements.empty())
      continue;
    appendElements(detail.boundary, others);
    details.push_back(std::move(detail));
  }
  std::stable_sort(details.begin(), details.end(), [](const auto& a, const auto& b) {
    return a.boundary.area() > b.boundary.area();
  });
  return details;
}

} // namespace sedr
} // namespace pcl
