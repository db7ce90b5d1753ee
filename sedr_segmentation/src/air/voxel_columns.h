// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pcl::sedr {

class VoxelTable;

/** @brief The four neighbours of a plan cell: +x, +y, -x, -y. That of direction d seen
 * from the other side is (d + 2) % 4. */
constexpr std::array<Cell, 4> plan_directions{Cell{1, 0}, Cell{0, 1}, Cell{-1, 0},
                                              Cell{0, -1}};

/** @brief A scan as voxels: for every column of the plan the set of its occupied
 * voxels, a bit each.
 *
 * Columns lie in tiles of 64 by 64, which exist only where points are; a tile's columns
 * have bits for its own heights. Memory: 8 bytes a column of an occupied tile for every
 * 64 voxels of its height. Columns are numbered tile by tile, row by row in a tile. */
class VoxelColumns {
public:
  static constexpr std::int32_t tile_edge = 64;
  static constexpr std::size_t tile_columns = std::size_t{64} * 64;
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  /** @brief Fills the voxels that hold at least one finite point of `points[indices]`.
   * Cubes of 64 x 64 x 64 voxels with the fewest points in and around them are left out
   * where all columns would take more than 128 bytes a point (and 8 MB): points seen
   * through windows, and strays. O(n).
   * @param cell edge of a column, metres
   * @param voxel_height metres
   * @param indices empty: all points
   * @param threads 0: as many as there are processors; the result is the same */
  VoxelColumns(const PointView& points,
               const std::vector<int>& indices,
               double cell,
               double voxel_height,
               unsigned threads);

  /** @brief The same with columns of two by two of these: a voxel is occupied where
   * one of its four is. O(columns). */
  VoxelColumns halved(unsigned threads) const;

  const CellGrid& grid() const { return grid_; }
  double cellSize() const { return grid_.size(); }
  double voxelHeight() const { return voxel_height_; }

  /** @brief Number of columns of all tiles. */
  std::size_t size() const { return tiles_.size() * tile_columns; }

  std::size_t tiles() const { return tiles_.size(); }

  /** @brief Number of the column of a cell, `none` where there is no tile. */
  std::uint32_t columnAt(Cell cell) const;

  /** @brief The neighbour of a column in plan_directions[d], or `none`. */
  std::uint32_t neighbour(std::uint32_t column, int d) const;

  Cell cellOf(std::uint32_t column) const;

  /** @brief The voxel of a height: voxel k reaches from k to k + 1 voxel heights. */
  std::int32_t voxelAt(double z) const
  {
    return static_cast<std::int32_t>(std::floor(z / voxel_height_));
  }

  /** @brief Lower end of a voxel, metres. */
  double heightOf(std::int32_t voxel) const { return voxel * voxel_height_; }

  bool isOccupied(std::uint32_t column, std::int32_t voxel) const
  {
    return countBetween(column, voxel, voxel + 1) > 0;
  }

  /** @brief Number of occupied voxels of a column from `begin` to before `end`. */
  int countBetween(std::uint32_t column, std::int32_t begin, std::int32_t end) const;

  /** @brief Calls `visit(begin, end)` for each run of occupied voxels, lowest first. */
  template <typename Visitor>
  void forEachRun(std::uint32_t column, Visitor visit) const
  {
    const Tile& tile = tiles_[column / tile_columns];
    const std::uint64_t* const words = wordsOf(column);
    std::int32_t begin = 0;
    bool is_in_run = false;
    for (std::int32_t w = 0; w < tile.words; ++w) {
      std::uint64_t word = words[w];
      if (word == 0 && !is_in_run)
        continue;
      for (std::int32_t k = 0; k < 64; ++k, word >>= 1)
        if (((word & 1) != 0) != is_in_run) {
          const std::int32_t at = tile.low + 64 * w + k;
          if (is_in_run)
            visit(begin, at);
          begin = at;
          is_in_run = !is_in_run;
        }
    }
    if (is_in_run)
      visit(begin, tile.low + 64 * tile.words);
  }

  /** @brief How many of the 26 voxels around an occupied one are so, at most 15, in two
   * thirds of all places: 8 and more where the scan is dense for this cell. A few dense
   * surfaces do not make a sparse scan dense. O(columns). */
  int usualCompany(unsigned threads) const;

  /** @brief Empties the voxels that are of no surface: points in mid-air. Those stay
   * that have half of the company usual in 64 layers of their tile, and of what is left
   * more, or beside them in their layer one that has: edges of surfaces, and sparsely
   * seen walls beside a dense hall, stay. O(columns). */
  void keepSurfaces(unsigned threads);

  /** @brief Closes what is narrower than `reach` columns along x or y: a morphological
   * closing of every layer of voxels by a square, so that what a sparse scan shows in
   * dots is a surface. O(columns). */
  void closeDots(int reach, unsigned threads);

  /** @brief Closes holes in surfaces that are narrower than `reach` columns in all
   * directions: what closings of every layer along x, y and both diagonals have in
   * common. A strip between two surfaces, behind a duct, stays open along itself.
   * O(columns). */
  void closeHoles(int reach, unsigned threads);

private:
  VoxelColumns(const CellGrid& grid, double voxel_height)
      : grid_(grid)
      , voxel_height_(voxel_height)
  {}

  /** @brief The lowest and the highest voxel of a tile. */
  struct TileHeights {
    std::int32_t low = std::numeric_limits<std::int32_t>::max();
    std::int32_t high = std::numeric_limits<std::int32_t>::min();

    void add(const TileHeights& other)
    {
      low = std::min(low, other.low);
      high = std::max(high, other.high);
    }
  };

  struct Tile {
    Cell corner;            ///< lowest cell over 64
    std::int32_t low = 0;   ///< voxel of the first bit, a multiple of 64
    std::int32_t words = 0; ///< of each column
    std::size_t first = 0;  ///< word of its first column
    std::array<std::uint32_t, 4> neighbours{none, none, none, none};
  };

  const std::uint64_t* wordsOf(std::uint32_t column) const
  {
    const Tile& tile = tiles_[column / tile_columns];
    return bits_.data() + tile.first +
           (column % tile_columns) * static_cast<std::size_t>(tile.words);
  }

  /** @brief 64 voxels of a column from `begin`, a multiple of 64. */
  std::uint64_t wordFrom(std::uint32_t column, std::int32_t begin) const
  {
    const Tile& tile = tiles_[column / tile_columns];
    const std::int32_t w = (begin - tile.low) / 64;
    return begin < tile.low || w >= tile.words ? 0 : wordsOf(column)[w];
  }

  /** @brief The next column along x (line 0), y (1) or a diagonal (2, 3), or `none`. */
  std::uint32_t stepAlong(std::uint32_t column, int line, bool is_back) const;

  /** @brief Each voxel with those of its layer up to `reach` columns away along a line
   * of the plan, see stepAlong(): occupied where one of them is (`widens`), or all. */
  std::vector<std::uint64_t>
  spreadAlong(int line, int reach, bool widens, unsigned threads) const;

  /** @brief Words of a column of a tile. */
  static std::int32_t wordsBetween(const TileHeights& range);

  /** @brief Returns the heights of the tiles that take at most `max_bytes`: of all
   * cubes with as many points in and around them as it takes. */
  static std::vector<std::pair<CellKey, TileHeights>> heightsOf(const VoxelTable& cubes,
                                                                std::size_t max_bytes);

  /** @brief Makes the tiles of some heights, which are sorted by their keys. */
  void makeTiles(const std::vector<std::pair<CellKey, TileHeights>>& heights);
  void connectTiles();

  /** @brief A column and those of the eight around it that there are.
   * @return how many */
  std::size_t columnsAround(std::uint32_t column,
                            std::array<std::uint32_t, 9>& around) const;

  /** @brief Calls `visit(word, occupied, company)` for each word of a tile that is not
   * empty: where it lies in `bits_`, what is in it, and the number of neighbours of
   * each of its voxels, up to 15, as four words of binary digits. */
  template <typename Visitor>
  void forEachCompany(std::size_t tile, Visitor visit) const;

  /** @brief How many voxels have at least 0, 1, ... 15 neighbours. */
  using CompanyCounts = std::array<std::size_t, 16>;

  /** @brief The same of each word of a tile's columns. */
  std::vector<CompanyCounts> companyIn(std::size_t tile) const;

  CellGrid grid_;
  double voxel_height_;
  std::vector<Tile> tiles_; ///< row by row
  std::unordered_map<CellKey, std::uint32_t> tile_at_;
  std::vector<std::uint64_t> bits_;
};

} // namespace pcl::sedr
