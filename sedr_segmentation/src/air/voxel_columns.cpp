// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_columns.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/voxels/voxel_table.h"

#include <algorithm>
#include <map>

namespace pcl::sedr {

namespace {

constexpr std::int32_t edge = VoxelColumns::tile_edge;

std::int32_t
tileOf(std::int32_t cell)
{
  return cell >= 0 ? cell / edge : -((-cell + edge - 1) / edge);
}

std::uint32_t
withinTile(Cell cell)
{
  return static_cast<std::uint32_t>(cell.y & (edge - 1)) * edge +
         static_cast<std::uint32_t>(cell.x & (edge - 1));
}

/** @brief A point as the voxel that holds it; `is_valid` false for what has none. */
struct PlacedPoint {
  Cell cell;
  std::int32_t voxel = 0;
  bool is_valid = false;
};

PlacedPoint
placeOf(const Eigen::Vector3f& p, const CellGrid& grid, double voxel_height)
{
  const double height = p.z() / voxel_height;
  if (!(std::abs(height) < 1 << 30) || !grid.holds(p.x(), p.y()))
    return {};
  return {grid.at(p.x(), p.y()), static_cast<std::int32_t>(std::floor(height)), true};
}

/** @brief Returns how many points lie in each cube and in the 26 around it. */
std::vector<std::size_t>
pointsAround(const VoxelTable& cubes)
{
  std::vector<std::size_t> around(cubes.size(), 0);
  for (std::size_t c = 0; c < cubes.size(); ++c)
    for (int k = 0; k < 27; ++k) {
      VoxelCode code = cubes[c].code;
      code[0] += k % 3 - 1;
      code[1] += k / 3 % 3 - 1;
      code[2] += k / 9 - 1;
      const std::int64_t found = cubes.numberOf(code);
      around[c] += found < 0 ? 0 : cubes[static_cast<std::size_t>(found)].count;
    }
  return around;
}

constexpr std::size_t points_a_block = std::size_t{1} << 16;

constexpr std::size_t bytes_a_point = 128;
constexpr std::size_t bytes_of_any_scan = std::size_t{1} << 23;

} // namespace

VoxelColumns::VoxelColumns(const PointView& points,
                           const std::vector<int>& indices,
                           double cell,
                           double voxel_height,
                           unsigned threads)
    : grid_(cell)
    , voxel_height_(voxel_height)
{
  const std::size_t n = indices.empty() ? points.size() : indices.size();
  const auto pointAt = [&](std::size_t k) {
    return placeOf(points[indices.empty() ? k : static_cast<std::size_t>(indices[k])],
                   grid_, voxel_height_);
  };
  std::vector<VoxelTable> met((n + points_a_block - 1) / points_a_block);
  parallelBlocks(n, points_a_block, threads, [&](std::size_t begin, std::size_t end) {
    VoxelSum run{}; // points of the same cube, one after another
    const auto endRun = [&] {
      if (run.count > 0)
        met[begin / points_a_block].add(run);
      run.count = 0;
    };
    for (std::size_t k = begin; k < end; ++k) {
      const PlacedPoint p = pointAt(k);
      if (!p.is_valid)
        continue;
      const VoxelCode cube{tileOf(p.cell.x), tileOf(p.cell.y), tileOf(p.voxel)};
      if (!isSame(cube, run.code))
        endRun();
      run.code = cube;
      ++run.count;
    }
    endRun();
  });
  VoxelTable cubes;
  for (const VoxelTable& block : met)
    for (std::size_t c = 0; c < block.size(); ++c)
      cubes.add(block[c]);
  makeTiles(heightsOf(cubes, std::max(bytes_of_any_scan, n * bytes_a_point)));

  parallelBlocks(n, points_a_block, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const PlacedPoint p = pointAt(k);
      const std::uint32_t column = p.is_valid ? columnAt(p.cell) : none;
      if (column == none)
        continue;
      const Tile& tile = tiles_[column / tile_columns];
      const std::int32_t height = p.voxel - tile.low;
      if (height < 0 || height >= 64 * tile.words)
        continue;
      const std::size_t word =
          static_cast<std::size_t>(wordsOf(column) - bits_.data()) +
          static_cast<std::size_t>(height / 64);
      // Several threads may fill a word; in which order they do makes no difference.
      __atomic_fetch_or(&bits_[word], std::uint64_t{1} << (height % 64),
                        __ATOMIC_RELAXED);
    }
  });
}

std::int32_t
VoxelColumns::wordsBetween(const TileHeights& range)
{
  return tileOf(range.high) - tileOf(range.low) + 1;
}

std::vector<std::pair<CellKey, VoxelColumns::TileHeights>>
VoxelColumns::heightsOf(const VoxelTable& cubes, std::size_t max_bytes)
{
  const std::vector<std::size_t> around = pointsAround(cubes);
  for (std::size_t least = 1;; least *= 2) {
    std::map<CellKey, TileHeights> heights;
    for (std::size_t c = 0; c < cubes.size(); ++c)
      if (const auto& [x, y, z] = cubes[c].code; around[c] >= least)
        heights[keyOf({x, y})].add({edge * z, edge * z + edge - 1});
    std::size_t bytes = 0;
    for (const auto& entry : heights)
      bytes += tile_columns * sizeof(std::uint64_t) *
               static_cast<std::size_t>(wordsBetween(entry.second));
    if (bytes <= max_bytes)
      return {heights.begin(), heights.end()};
  }
}

void
VoxelColumns::makeTiles(const std::vector<std::pair<CellKey, TileHeights>>& heights)
{
  std::size_t words = 0;
  for (const auto& [key, range] : heights) {
    Tile tile;
    tile.corner = pcl::sedr::cellOf(key);
    tile.low = tileOf(range.low) * edge;
    tile.words = wordsBetween(range);
    tile.first = words;
    words += tile_columns * static_cast<std::size_t>(tile.words);
    tile_at_[key] = static_cast<std::uint32_t>(tiles_.size());
    tiles_.push_back(tile);
  }
  bits_.assign(words, 0);
  connectTiles();
}

VoxelColumns
VoxelColumns::halved(unsigned threads) const
{
  VoxelColumns half(CellGrid(2 * cellSize()), voxel_height_);
  std::map<CellKey, TileHeights> heights;
  for (const Tile& tile : tiles_)
    heights[keyOf({tile.corner.x >> 1, tile.corner.y >> 1})].add(
        {tile.low, tile.low + 64 * tile.words - 1});
  half.makeTiles({heights.begin(), heights.end()});
  parallelBlocks(half.tiles_.size(), 1, threads, [&](std::size_t t, std::size_t) {
    const Tile& tile = half.tiles_[t];
    for (const Cell by : {Cell{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
      const auto found =
          tile_at_.find(keyOf({2 * tile.corner.x + by.x, 2 * tile.corner.y + by.y}));
      if (found == tile_at_.end())
        continue;
      const Tile& fine = tiles_[found->second];
      const auto words = static_cast<std::size_t>(fine.words);
      const auto above = static_cast<std::size_t>((fine.low - tile.low) / 64);
      for (std::int32_t y = 0; y < edge; ++y)
        for (std::int32_t x = 0; x < edge; ++x) {
          const std::uint64_t* const from =
              bits_.data() + fine.first + withinTile({x, y}) * words;
          std::uint64_t* const into =
              half.bits_.data() + tile.first + above +
              withinTile({(edge * by.x + x) / 2, (edge * by.y + y) / 2}) *
                  static_cast<std::size_t>(tile.words);
          for (std::size_t w = 0; w < words; ++w)
            into[w] |= from[w];
        }
    }
  });
  return half;
}

void
VoxelColumns::connectTiles()
{
  for (Tile& tile : tiles_)
    for (std::size_t d = 0; d < 4; ++d) {
      const auto found = tile_at_.find(keyOf({tile.corner.x + plan_directions[d].x,
                                              tile.corner.y + plan_directions[d].y}));
      if (found != tile_at_.end())
        tile.neighbours[d] = found->second;
    }
}

std::uint32_t
VoxelColumns::columnAt(Cell cell) const
{
  const auto found = tile_at_.find(keyOf({tileOf(cell.x), tileOf(cell.y)}));
  return found == tile_at_.end()
             ? none
             : static_cast<std::uint32_t>(found->second * tile_columns) +
                   withinTile(cell);
}

std::uint32_t
VoxelColumns::neighbour(std::uint32_t column, int d) const
{
  const auto tile = static_cast<std::uint32_t>(column / tile_columns);
  const auto at = static_cast<std::int32_t>(column % tile_columns);
  const Cell step = plan_directions[static_cast<std::size_t>(d)];
  const std::int32_t x = at % edge + step.x;
  const std::int32_t y = at / edge + step.y;
  if (x >= 0 && x < edge && y >= 0 && y < edge)
    return static_cast<std::uint32_t>(tile * tile_columns) +
           static_cast<std::uint32_t>(y * edge + x);
  const std::uint32_t other = tiles_[tile].neighbours[static_cast<std::size_t>(d)];
  return other == none ? none
                       : static_cast<std::uint32_t>(other * tile_columns) +
                             withinTile({x + edge, y + edge});
}

Cell
VoxelColumns::cellOf(std::uint32_t column) const
{
  const Tile& tile = tiles_[column / tile_columns];
  const auto at = static_cast<std::int32_t>(column % tile_columns);
  return {tile.corner.x * edge + at % edge, tile.corner.y * edge + at / edge};
}

int
VoxelColumns::countBetween(std::uint32_t column,
                           std::int32_t begin,
                           std::int32_t end) const
{
  const Tile& tile = tiles_[column / tile_columns];
  const std::int32_t from = std::max(begin - tile.low, 0);
  const std::int32_t to = std::min(end - tile.low, 64 * tile.words);
  if (from >= to)
    return 0;
  const std::uint64_t* const words = wordsOf(column);
  int count = 0;
  for (std::int32_t w = from / 64; w <= (to - 1) / 64; ++w) {
    std::uint64_t word = words[w];
    if (w == from / 64)
      word &= ~std::uint64_t{0} << (from % 64);
    if (w == (to - 1) / 64)
      word &= ~std::uint64_t{0} >> (63 - (to - 1) % 64);
    count += __builtin_popcountll(word);
  }
  return count;
}

} // namespace pcl::sedr
