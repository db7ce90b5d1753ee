// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/slice_detail.h>

#include <pcl/sedr_filters/plane_fit.h>
#include <pcl/sedr_segmentation/column_table.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace pcl {
namespace sedr {

namespace {

/** @brief A gap of more than this parts the runs of a column, metres: thrice the voxel size. */
constexpr double run_gap = 0.15;

/** @brief One room on the grid. */
struct Scene {
  const PointView& points;
  const SliceParameters& parameters;
  const PlanSlab& slab;
  double floor_height;
  CellGrid grid;
  CellMask ceiling;
  ColumnTable columns;

  double
  ceilingAt(Cell cell) const
  {
    return slab.heightAt(grid.centre(cell));
  }

  /** @brief Height of the slice at `fraction` of the room's height below the ceiling. */
  double
  sliceAt(Cell cell, double fraction) const
  {
    const double top = ceilingAt(cell);
    return top - fraction * (top - floor_height);
  }
};

/** @brief Cells with points in the slice. */
CellMask
sliceMask(const Scene& scene, double fraction)
{
  CellMask slice(scene.ceiling.box());
  const double half = scene.parameters.slice_thickness / 2;
  for (std::size_t i = 0; i < slice.values().size(); ++i) {
    const Cell cell = slice.cellAt(i);
    const double z = scene.sliceAt(cell, fraction);
    slice.values()[i] = scene.columns.hasWithin(cell, z - half, z + half) ? 1 : 0;
  }
  return slice;
}

/** @brief Keeps the regions of at least the minimum size in which most cells pass `test`. */
template <typename Test>
CellMask
keepRegions(const CellMask& mask, std::size_t minimum_cells, double minimum_share, Test test)
{
  const MaskRegions regions = labelRegions(mask, true);
  std::vector<std::size_t> passed(regions.sizes.size(), 0);
  for (std::size_t i = 0; i < mask.values().size(); ++i)
    if (regions.label[i] >= 0 && test(mask.cellAt(i)))
      ++passed[static_cast<std::size_t>(regions.label[i])];
  CellMask kept(mask.box());
  for (std::size_t i = 0; i < mask.values().size(); ++i) {
    if (regions.label[i] < 0)
      continue;
    const auto r = static_cast<std::size_t>(regions.label[i]);
    kept.values()[i] = regions.sizes[r] >= minimum_cells &&
                               static_cast<double>(passed[r]) >=
                                   minimum_share * static_cast<double>(regions.sizes[r])
                           ? 1
                           : 0;
  }
  return kept;
}

/** @brief Length and width of a straight strip of cells, metres, from its spread: that of a uniform
 * strip of length l has the variance l^2 / 12. */
Eigen::Vector2d
extentOf(const CellMask& strip, const CellGrid& grid)
{
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  double count = 0;
  for (std::size_t i = 0; i < strip.values().size(); ++i) {
    if (!strip.values()[i])
      continue;
    const Eigen::Vector2d p = grid.centre(strip.cellAt(i));
    count += 1;
    const Eigen::Vector2d d = p - mean;
    mean += d / count;
    scatter += d * (p - mean).transpose();
  }
  if (count == 0)
    return {0, 0};
  const Eigen::Matrix2d even = (scatter + scatter.transpose()) / 2 / count;
  const Eigen::Vector2d spread =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(even).eigenvalues();
  return {std::sqrt(12 * std::max(0.0, spread[1])), std::sqrt(12 * std::max(0.0, spread[0]))};
}

/** @brief Whether a region is the head of a door or a window rather than a soffit: it meets the
 * ceiling along one short straight line, whose wall goes on to both sides, or along a line below
 * which the wall of a sill stands. */
bool
isNiche(const Scene& scene, const CellMask& region)
{
  const CellMask front = intersect(dilated(region, 3), scene.ceiling);
  const Eigen::Vector2d extent = extentOf(front, scene.grid);
  if (extent[0] < scene.parameters.widest_niche && extent[1] < 5 * scene.parameters.cell_size)
    return true;
  const CellMask edge = intersect(region, dilated(front, 3));
  std::size_t walls = 0;
  for (std::size_t i = 0; i < edge.values().size(); ++i)
    if (edge.values()[i] && scene.columns.share(edge.cellAt(i),
                                                scene.floor_height + 0.15,
                                                scene.floor_height + 0.65,
                                                5,
                                                0) >= 0.6)
      ++walls;
  // The edge is up to three cells wide, and the sill's wall in one of them.
  return 4 * walls >= edge.count();
}

/** @brief The zero-valued regions that a slice and the ceiling enclose and the ceiling alone does
 * not, where something is seen between the two heights. */
CellMask
enclosedBySlices(const Scene& scene,
                 std::initializer_list<double> fractions,
                 double lowest_fraction)
{
  CellMask united = scene.ceiling;
  for (const double fraction : fractions)
    // One cell more on each side closes the pinholes of a sparse wall.
    united = unite(united, dilated(sliceMask(scene, fraction), 1));
  const CellMask found =
      subtract(enclosedCells(united), enclosedCells(scene.ceiling));
  const CellMask seen =
      keepRegions(found, scene.parameters.minimum_cells, 0.5, [&](Cell cell) {
        return scene.columns.hasWithin(cell,
                                       scene.sliceAt(cell, lowest_fraction),
                                       scene.ceilingAt(cell) + scene.parameters.tolerance);
      });
  const MaskRegions regions = labelRegions(seen, true);
  CellMask kept(seen.box());
  for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
    const CellMask region = regionMask(seen, regions, static_cast<std::int32_t>(r));
    if (!isNiche(scene, region))
      kept = unite(kept, region);
  }
  return kept;
}

/** @brief The first trial whose slices enclose a detail. */
CellMask
runTrials(const Scene& scene, SliceDetails& details)
{
  CellMask found(scene.ceiling.box());
  double fraction = 0;
  for (int trial = 1; trial <= std::min(3, scene.parameters.trials); ++trial) {
    fraction = trial == 1 ? 1.0 / 4 : trial == 2 ? 1.0 / 2 : 3.0 / 8;
    found = trial == 3 ? enclosedBySlices(scene, {1.0 / 8, 3.0 / 8}, fraction)
                       : enclosedBySlices(scene, {fraction}, fraction);
    if (found.count() == 0)
      continue;
    details.trial = trial;
    break;
  }
  return found;
}

/** @brief The uppermost run of a column if it starts above half the room's height and is not the
 * ceiling: an underside, or a riser between two heights. */
bool
hasOwnTop(const Scene& scene, Cell cell, ColumnRun& top)
{
  if (scene.ceiling.at(cell))
    return false;
  const std::vector<ColumnRun> runs = scene.columns.runs(cell, run_gap);
  if (runs.empty())
    return false;
  top = runs.back();
  return top.low > scene.sliceAt(cell, 0.5);
}

/** @brief Cells with an underside (a short run) and, where they join those, with a riser. Strips of
 * undersides narrower than three cells are left out: the wall above a window or a door ends in such
 * a strip. */
CellMask
undersideCells(const Scene& scene)
{
  CellMask undersides(scene.ceiling.box());
  CellMask risers(scene.ceiling.box());
  ColumnRun top;
  for (std::size_t i = 0; i < undersides.values().size(); ++i) {
    if (!hasOwnTop(scene, undersides.cellAt(i), top))
      continue;
    const bool is_short = top.high - top.low < 2 * scene.parameters.tolerance;
    (is_short ? undersides : risers).values()[i] = 1;
  }
  undersides = intersect(undersides, dilated(eroded(undersides, 1), 2));
  return unite(undersides, intersect(risers, dilated(undersides, 2)));
}

/** @brief Whether the rim of an island is closed up to the ceiling: then it is built, not hung. */
bool
hasRisers(const Scene& scene, const CellMask& island)
{
  const CellMask rim = subtract(island, eroded(island, 1));
  std::size_t closed = 0;
  for (std::size_t i = 0; i < rim.values().size(); ++i) {
    if (!rim.values()[i])
      continue;
    const Cell cell = rim.cellAt(i);
    const double top = scene.ceilingAt(cell);
    const std::vector<ColumnRun> runs = scene.columns.runs(cell, run_gap);
    const double end = runs.empty() ? top : runs.back().high > top + 0.02 ? runs.back().high
                                                                          : runs.back().low;
    const double low = std::min(top, end) + 0.02;
    const double high = std::max(top, end) - 0.02;
    if (high - low < 0.05 || scene.columns.share(cell, low, high, 2, 1) >= 1)
      ++closed;
  }
  return 2 * closed >= rim.count();
}

/** @brief Whether a region is a part of the room: the floor goes on below a quarter of it or more.
 * Below the head of a window there is a sill, below that of a door hardly anything. */
bool
hasFloorBelow(const Scene& scene, const CellMask& region)
{
  std::size_t above_floor = 0;
  for (std::size_t i = 0; i < region.values().size(); ++i)
    if (region.values()[i] && scene.columns.hasWithin(region.cellAt(i),
                                                      scene.floor_height - 0.1,
                                                      scene.floor_height + 0.1))
      ++above_floor;
  return 4 * above_floor >= region.count();
}

/** @brief Cells with an underside of their own that join the ceiling's cells. Those that the ceiling
 * encloses all around are islands: small or unattached ones are lamps, not structure. */
CellMask
cellsWithUndersides(const Scene& scene)
{
  const SliceParameters& p = scene.parameters;
  const CellMask found = undersideCells(scene);
  const CellMask near_ceiling = dilated(scene.ceiling, 2);
  const CellMask enclosed = enclosedCells(scene.ceiling);
  const MaskRegions regions = labelRegions(found, true);
  CellMask kept(found.box());
  for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
    if (regions.sizes[r] < p.minimum_cells)
      continue;
    const CellMask region = regionMask(found, regions, static_cast<std::int32_t>(r));
    if (intersect(region, near_ceiling).count() == 0)
      continue;
    const bool is_island = intersect(region, enclosed).count() == region.count();
    const double area = static_cast<double>(regions.sizes[r]) * p.cell_size * p.cell_size;
    if (is_island ? area >= p.minimum_island_area && hasRisers(scene, region)
                  : hasFloorBelow(scene, region) && !isNiche(scene, region))
      kept = unite(kept, region);
  }
  return kept;
}

/** @brief The points of the details: of each column the uppermost run, if it starts above half the
 * room's height; walls, which come up from below, are left out. */
void
collectPoints(const Scene& scene, const CellMask& found, SliceDetails& details)
{
  const MaskRegions regions = labelRegions(found, true);
  std::vector<std::size_t> order(regions.sizes.size());
  for (std::size_t r = 0; r < order.size(); ++r)
    order[r] = r;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return regions.sizes[a] > regions.sizes[b];
  });
  std::vector<std::size_t> rank(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    rank[order[k]] = k;
    details.sizes.push_back(regions.sizes[order[k]]);
  }

  std::vector<std::pair<int, std::size_t>> found_points;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < found.values().size(); ++i) {
    if (!found.values()[i])
      continue;
    const Cell cell = found.cellAt(i);
    const std::size_t region = rank[static_cast<std::size_t>(regions.label[i])];
    ColumnRun top;
    if (!hasOwnTop(scene, cell, top))
      continue;
    for (auto* e = scene.columns.begin(cell); e != scene.columns.end(cell); ++e)
      if (e->z >= top.low)
        found_points.emplace_back(e->index, region);
    lowest = std::min<double>(lowest, top.low);
  }
  std::sort(found_points.begin(), found_points.end());
  for (const auto& [index, region] : found_points) {
    details.indices.push_back(index);
    details.region.push_back(region);
  }
  details.cells = found.toSet();
  if (std::isfinite(lowest))
    details.slice_height = lowest - scene.parameters.cell_size;
}

} // namespace

SliceDetails
findSliceDetails(const PointView& points,
                 const std::vector<int>& indices,
                 const std::vector<int>& ceiling,
                 const PlanSlab& slab,
                 double floor_height,
                 const SliceParameters& parameters,
                 std::string& problem)
{
  SliceDetails details;
  const CellGrid grid(parameters.cell_size);
  const CellSet ceiling_cells(grid, points, ceiling);
  const CellSet all_cells(grid, points, indices);
  const CellBox box = grown(boxOf(unite(ceiling_cells, all_cells)), 3);
  problem = maskProblem(box);
  if (!problem.empty())
    return details;
  const Scene scene{points,
                    parameters,
                    slab,
                    floor_height,
                    grid,
                    CellMask(ceiling_cells, box),
                    ColumnTable(grid, box, points, indices)};
  const CellMask enclosed = runTrials(scene, details);
  collectPoints(scene, unite(enclosed, cellsWithUndersides(scene)), details);
  return details;
}

} // namespace sedr
} // namespace pcl
