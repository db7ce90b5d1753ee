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
  return keepRegions(found, scene.parameters.minimum_cells, 0.5, [&](Cell cell) {
    return scene.columns.hasWithin(cell,
                                   scene.sliceAt(cell, lowest_fraction),
                                   scene.ceilingAt(cell) + scene.parameters.tolerance);
  });
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

/** @brief The tops of the columns that are not ceiling: undersides (short runs) in regions of one
 * height, and risers (long runs). */
struct Tops {
  CellMask undersides;
  CellMask risers;
  std::vector<float> height; ///< lower end of the uppermost run of each cell
};

/** @brief Strips of undersides narrower than three cells are left out: the wall above a window or a
 * door ends in such a strip. */
Tops
findTops(const Scene& scene)
{
  Tops tops{CellMask(scene.ceiling.box()), CellMask(scene.ceiling.box()), {}};
  tops.height.assign(tops.undersides.values().size(), 0.f);
  ColumnRun top;
  for (std::size_t i = 0; i < tops.height.size(); ++i) {
    if (!hasOwnTop(scene, tops.undersides.cellAt(i), top))
      continue;
    const bool is_short = top.high - top.low < 2 * scene.parameters.tolerance;
    (is_short ? tops.undersides : tops.risers).values()[i] = 1;
    tops.height[i] = top.low;
  }
  tops.undersides = intersect(tops.undersides, dilated(eroded(tops.undersides, 1), 2));
  return tops;
}

/** @brief Regions of undersides in which neighbours differ by less than the tolerance in height. */
std::vector<CellMask>
regionsOfOneHeight(const Scene& scene, const Tops& tops)
{
  const CellMask& mask = tops.undersides;
  std::vector<CellMask> regions;
  std::vector<std::uint8_t> is_seen(mask.values().size(), 0);
  for (std::size_t start = 0; start < is_seen.size(); ++start) {
    if (!mask.values()[start] || is_seen[start])
      continue;
    std::vector<std::size_t> members{start};
    is_seen[start] = 1;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Cell cell = mask.cellAt(members[k]);
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell to{cell.x + dx, cell.y + dy};
          if (!mask.at(to) || is_seen[mask.indexOf(to)] ||
              std::abs(tops.height[mask.indexOf(to)] - tops.height[members[k]]) >
                  scene.parameters.tolerance)
            continue;
          is_seen[mask.indexOf(to)] = 1;
          members.push_back(mask.indexOf(to));
        }
    }
    if (members.size() < scene.parameters.minimum_cells)
      continue;
    regions.emplace_back(mask.box());
    for (const std::size_t i : members)
      regions.back().values()[i] = 1;
  }
  return regions;
}

/** @brief Whether the floor goes on below a quarter of a region or more. Below the head of a window
 * there is a sill. */
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

/** @brief A strip of cells along a line. */
struct Strip {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
  double length = 0; ///< metres
  double width = 0;
};

/** @brief The straight strip that cells spread along: one of length l has the variance l^2 / 12. */
Strip
stripOf(const CellMask& cells, const CellGrid& grid)
{
  Strip strip;
  std::vector<Eigen::Vector2d> places;
  for (std::size_t i = 0; i < cells.values().size(); ++i)
    if (cells.values()[i]) {
      places.push_back(grid.centre(cells.cellAt(i)));
      strip.middle += places.back();
    }
  if (places.empty())
    return strip;
  const auto count = static_cast<double>(places.size());
  strip.middle /= count;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const auto& p : places)
    scatter += (p - strip.middle) * (p - strip.middle).transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter);
  strip.direction = solver.eigenvectors().col(1);
  strip.length = std::sqrt(12 * std::max(0.0, solver.eigenvalues()[1]));
  strip.width = std::sqrt(12 * std::max(0.0, solver.eigenvalues()[0]));
  return strip;
}

/** @brief Whether a wall stands on the strip's line beyond one of its ends. */
bool
goesOnAsWall(const Scene& scene, const Strip& strip, double top)
{
  for (const double side : {-1.0, 1.0}) {
    int walls = 0;
    for (const double beyond : {0.15, 0.2, 0.25, 0.3}) {
      const Eigen::Vector2d p =
          strip.middle + side * (strip.length / 2 + beyond) * strip.direction;
      const Cell cell = scene.grid.at(p.x(), p.y());
      walls += scene.columns.share(cell, scene.floor_height + 0.2, top - 0.1, 8, 2) >= 0.6 ? 1 : 0;
    }
    if (walls >= 3)
      return true;
  }
  return false;
}

/** @brief Whether a region is the head of a door or a window rather than a soffit: shallow, it meets
 * the rest of the ceiling along one straight line, on which the wall goes on beside it; or that
 * line is as short as a door is wide. */
bool
isNiche(const Scene& scene, const Tops& tops, const CellMask& region)
{
  constexpr double deepest = 0.55;
  const double cell = scene.parameters.cell_size;
  const CellMask others = subtract(unite(scene.ceiling, tops.undersides), dilated(region, 1.5));
  const CellMask front = intersect(dilated(region, 4), others);
  const Strip strip = stripOf(front, scene.grid);
  if (strip.length == 0)
    return true;
  if (strip.width > 6 * cell)
    return false;
  const double depth = static_cast<double>(region.count()) * cell * cell / strip.length;
  double top = 0;
  for (std::size_t i = 0; i < region.values().size(); ++i)
    if (region.values()[i])
      top += tops.height[i] / static_cast<double>(region.count());
  return strip.length < scene.parameters.widest_niche ||
         (depth < deepest && goesOnAsWall(scene, strip, top));
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

/** @brief Whether a region of one height is a part of the ceiling. What the ceiling encloses all
 * around is an island: small or unattached ones are lamps. */
bool
isDetail(const Scene& scene, const Tops& tops, const CellMask& enclosed, const CellMask& region)
{
  const SliceParameters& p = scene.parameters;
  if (intersect(region, enclosed).count() == region.count()) {
    const double area = static_cast<double>(region.count()) * p.cell_size * p.cell_size;
    return area >= p.minimum_island_area && hasRisers(scene, region);
  }
  return hasFloorBelow(scene, region) && !isNiche(scene, tops, region);
}

/** @brief The regions of `cells` that come within two cells of `ceiling`, or of one that does. */
CellMask
joinedWith(const CellMask& ceiling, const CellMask& cells)
{
  const CellMask both = unite(ceiling, cells);
  const CellMask bridged = eroded(dilated(both, 2), 1);
  const MaskRegions regions = labelRegions(bridged, true);
  std::vector<std::uint8_t> has_ceiling(regions.sizes.size(), 0);
  for (std::size_t i = 0; i < ceiling.values().size(); ++i)
    if (ceiling.values()[i] && regions.label[i] >= 0)
      has_ceiling[static_cast<std::size_t>(regions.label[i])] = 1;
  CellMask joined(cells.box());
  for (std::size_t i = 0; i < joined.values().size(); ++i)
    joined.values()[i] = cells.values()[i] && regions.label[i] >= 0 &&
                                 has_ceiling[static_cast<std::size_t>(regions.label[i])]
                             ? 1
                             : 0;
  return joined;
}

/** @brief The risers that join a kept underside: they do not reach below it and the ceiling, as the
 * wall above a window under a soffit does. */
CellMask
risersBeside(const Scene& scene, const Tops& tops, const CellMask& kept)
{
  const CellMask near = intersect(tops.risers, dilated(kept, 2));
  CellMask risers(near.box());
  for (std::size_t i = 0; i < near.values().size(); ++i) {
    if (!near.values()[i])
      continue;
    const Cell cell = near.cellAt(i);
    double lowest = std::numeric_limits<double>::infinity();
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const Cell to{cell.x + dx, cell.y + dy};
        if (kept.at(to) && tops.undersides.at(to))
          lowest = std::min<double>(lowest, tops.height[kept.indexOf(to)]);
        if (scene.ceiling.at(to))
          lowest = std::min(lowest, scene.ceilingAt(to));
      }
    risers.values()[i] = tops.height[i] >= lowest - scene.parameters.tolerance ? 1 : 0;
  }
  return risers;
}

/** @brief `seeds` and what can be reached from them through `domain`. */
CellMask
grownInto(const CellMask& seeds, const CellMask& domain)
{
  std::vector<std::int32_t> label(seeds.values().size(), -1);
  for (std::size_t i = 0; i < label.size(); ++i)
    label[i] = seeds.values()[i] ? 0 : -1;
  growLabels(domain, std::numeric_limits<int>::max(), label);
  CellMask grown_mask(seeds.box());
  for (std::size_t i = 0; i < label.size(); ++i)
    grown_mask.values()[i] = label[i] == 0 ? 1 : 0;
  return grown_mask;
}

/** @brief The cells of all details: regions of one height that join the ceiling, directly or through
 * each other, their risers, and what else the slices enclosed with them. */
CellMask
detailCells(const Scene& scene, const CellMask& enclosed_by_slices)
{
  const Tops tops = findTops(scene);
  const CellMask enclosed = enclosedCells(scene.ceiling);
  CellMask kept(scene.ceiling.box());
  CellMask refused(scene.ceiling.box());
  for (const CellMask& region : regionsOfOneHeight(scene, tops)) {
    CellMask& side = isDetail(scene, tops, enclosed, region) ? kept : refused;
    side = unite(side, region);
  }
  kept = joinedWith(scene.ceiling, kept);
  const CellMask risers = risersBeside(scene, tops, kept);
  kept = unite(kept, risers);
  // What was not seen of a detail, the slices' outline encloses with it; walls and heads of windows
  // bound it.
  const CellMask bounds = unite(refused, subtract(tops.risers, risers));
  const MaskRegions outlined = labelRegions(enclosed_by_slices, true);
  for (std::size_t r = 0; r < outlined.sizes.size(); ++r) {
    const CellMask region = regionMask(enclosed_by_slices, outlined, static_cast<std::int32_t>(r));
    if (2 * intersect(region, kept).count() >= region.count())
      kept = grownInto(kept, subtract(region, bounds));
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
  collectPoints(scene, detailCells(scene, runTrials(scene, details)), details);
  return details;
}

} // namespace sedr
} // namespace pcl
