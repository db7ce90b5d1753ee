// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/hanging_furniture.h>

#include <pcl/sedr_filters/cell_table.h>
#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_segmentation/box_clusters.h>
#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

/** @brief The floor that is below most of some cells; null where there is none. */
const Level*
floorBelow(const CellMask& cells,
           const CellGrid& grid,
           const Level& ceiling,
           const std::vector<Level>& levels,
           double least_height)
{
  const Level* best = nullptr;
  std::size_t most = 0;
  for (const Level& level : levels) {
    if (level.kind != LevelKind::Floor)
      continue;
    std::size_t covered = 0;
    for (std::size_t i = 0; i < cells.values().size(); ++i) {
      const Cell cell = cells.cellAt(i);
      const Eigen::Vector2d place = grid.centre(cell);
      covered += cells.values()[i] && level.cells.contains(cell) &&
                         level.slab.heightAt(place) <
                             ceiling.slab.heightAt(place) - least_height
                     ? 1
                     : 0;
    }
    if (covered > most) {
      most = covered;
      best = &level;
    }
  }
  return best;
}

/** @brief The points in or near each of some boxes of cells; those of large boxes far
 * apart all. O(points). */
std::vector<std::vector<int>>
sharesOf(const std::vector<CellBox>& boxes,
         const CellGrid& grid,
         const PointView& points,
         unsigned threads)
{
  constexpr std::size_t points_a_block = 65536;
  constexpr double table_cell = 1; // metres
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(grid.size());
  CellTable near(table_cell);
  std::vector<CellTable::Entry> entries;
  for (std::size_t c = 0; c < boxes.size(); ++c)
    entries.push_back({near.boxAround(grid.centre(boxes[c].low) - margin,
                                      grid.centre(boxes[c].high) + margin),
                       static_cast<std::uint32_t>(c)});
  const bool has_table = near.fill(entries).empty();
  using Shares = std::vector<std::vector<int>>;
  std::vector<Shares> parts(points.size() / points_a_block + 1, Shares(boxes.size()));
  const auto look = [&](std::size_t begin, std::size_t end) {
    Shares& shares = parts[begin / points_a_block];
    for (std::size_t i = begin; i < end; ++i) {
      if (!points.isFinite(i))
        continue;
      const Eigen::Vector2d place = points[i].head<2>().cast<double>();
      if (has_table)
        for (const std::uint32_t c : near.at(place))
          shares[c].push_back(static_cast<int>(i));
      else
        for (auto& share : shares)
          share.push_back(static_cast<int>(i));
    }
  };
  parallelBlocks(points.size(), points_a_block, threads, look);
  Shares shares(boxes.size());
  for (const Shares& part : parts)
    for (std::size_t c = 0; c < boxes.size(); ++c)
      shares[c].insert(shares[c].end(), part[c].begin(), part[c].end());
  return shares;
}

/** @brief A region of a ceiling, and a box with room for what hangs around it. */
struct CeilingRegion {
  const Level* level;
  CellSet cells;
  CellBox box;
};

} // namespace

HangingFurniture
hangingFurnitureBelow(const std::vector<Level>& levels,
                      const PointView& points,
                      double cell_size,
                      double least_height,
                      unsigned threads)
{
  constexpr double margin = 0.8;
  constexpr double least_area = 1; // square metres
  const CellGrid grid(cell_size);
  const int reach = cellsFor(margin, cell_size);
  std::vector<CeilingRegion> ceilings;
  std::vector<CellBox> boxes;
  for (const Level& level : levels) {
    if (level.kind != LevelKind::Ceiling)
      continue;
    for (CellSet& cells : connectedRegions(level.cells)) {
      if (static_cast<double>(cells.size()) * cell_size * cell_size < least_area)
        continue;
      boxes.push_back(boxOf(cells));
      ceilings.push_back({&level, std::move(cells), grown(boxes.back(), reach)});
    }
  }
  const std::vector<CellBox> clusters = clusterBoxes(boxes, reach);
  const std::vector<std::vector<int>> shares =
      sharesOf(clusters, grid, points, threads);
  HangingFurniture found;
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const CellBox& box = clusters[c];
    if (!maskProblem(box).empty())
      continue;
    const ColumnTable columns(grid, box, points, shares[c], threads);
    std::vector<HangingFurniture> parts(ceilings.size());
    parallelBlocks(ceilings.size(), 1, threads, [&](std::size_t k, std::size_t) {
      const auto& [level, cells, around] = ceilings[k];
      if (overlapOf(box, around).count() != around.count())
        return;
      const CellMask seen(cells, around);
      const Level* floor = floorBelow(seen, grid, *level, levels, least_height);
      if (floor)
        parts[k] = hangingFurniture(seen, grid, points, columns, level->slab,
                                    floor->slab, threads);
    });
    for (const HangingFurniture& part : parts) {
      found.points.insert(found.points.end(), part.points.begin(), part.points.end());
      found.behind.insert(found.behind.end(), part.behind.begin(), part.behind.end());
    }
  }
  std::sort(found.points.begin(), found.points.end());
  found.points.erase(std::unique(found.points.begin(), found.points.end()),
                     found.points.end());
  // A ceiling and the soffit beside it may both continue a wall.
  std::sort(found.behind.begin(), found.behind.end(), [](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  found.behind.erase(std::unique(found.behind.begin(), found.behind.end()),
                     found.behind.end());
  return found;
}

} // namespace sedr
} // namespace pcl
