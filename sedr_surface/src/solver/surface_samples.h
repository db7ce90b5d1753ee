// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/impl/room_samples.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A sparse regular grid along a surface: blocks of 8 x 8 x 8 nodes, of which
 * only the listed ones exist. Node values are in one array, 512 per block with x
 * fastest. After the last block come 512 zeros that represent all missing blocks.
 *
 * Coordinates of nodes and blocks are signed integers; a block holds the nodes from 8
 * times its coordinates on. */
class BandGrid {
public:
  using Block = std::array<std::int64_t, 3>;
  using Key = std::uint64_t;

  static constexpr std::int64_t edge = 8;
  static constexpr std::size_t nodes = 512;
  /// Blocks per work item of a thread; sums are formed in their order.
  static constexpr std::size_t blocks_at_once = 32;
  static constexpr std::size_t halo_nodes = 1000; ///< block with one layer around it
  static constexpr std::int64_t reach = 1 << 20;  ///< limit of block coordinates

  BandGrid() = default;

  /** @brief Makes the blocks of the keys, in any order; duplicates are allowed. */
  explicit BandGrid(std::vector<Key> keys);

  static Key keyOf(const Block& block);

  static Block blockOf(Key key);

  /** @brief Returns the n-th of the 27 blocks around a block, x fastest; 13: itself. */
  static Block around(const Block& block, std::size_t n);

  /** @brief Returns the place of a node within its block. */
  static std::size_t nodeIndex(std::int64_t x, std::int64_t y, std::int64_t z)
  {
    return static_cast<std::size_t>((z * edge + y) * edge + x);
  }

  static std::size_t haloIndex(std::int64_t x, std::int64_t y, std::int64_t z)
  {
    return static_cast<std::size_t>(((z + 1) * 10 + y + 1) * 10 + x + 1);
  }

  std::size_t size() const { return keys_.size(); }

  /** @brief Returns the size of an array of values, including the zeros. */
  std::size_t valueCount() const { return (size() + 1) * nodes; }

  Block at(std::size_t b) const { return blockOf(keys_[b]); }

  const std::vector<Key>& keys() const { return keys_; }

  /** @brief Returns the index of a block, size() if it does not exist. O(log n). */
  std::size_t find(const Block& block) const;

  /** @brief Returns the indices of the blocks around(), size() if they do not exist. */
  const std::array<std::uint32_t, 27>& neighbours(std::size_t b) const
  {
    return neighbours_[b];
  }

  /** @brief Returns the index of a neighbour of block `b`, each step -1, 0 or 1. */
  std::size_t neighbour(std::size_t b, int dx, int dy, int dz) const
  {
    return neighbours_[b]
                      [static_cast<std::size_t>((dz + 1) * 9 + (dy + 1) * 3 + dx + 1)];
  }

  /** @brief Returns the block of a node relative to the first one of block `b`, each
   * coordinate -8 to 15. */
  std::size_t blockAt(std::size_t b, int x, int y, int z) const
  {
    return neighbour(b, x >> 3, y >> 3, z >> 3);
  }

  /** @brief Returns the place of such a node in an array of values; one of the zeros if
   * its block does not exist. */
  std::size_t valueAt(std::size_t b, int x, int y, int z) const
  {
    return blockAt(b, x, y, z) * nodes + nodeIndex(x & 7, y & 7, z & 7);
  }

  /** @brief Returns true if all eight corners exist of the cell above node (x, y, z) of
   * block `b`, each 0 to 7. */
  bool holdsCell(std::size_t b, int x, int y, int z) const;

  /** @brief Returns true if one of the 26 neighbours of block `b` does not exist. */
  bool atRim(std::size_t b) const { return at_rim_[b]; }

  /** @brief Copies the nodes of the block within a halo. */
  static void copyInner(const float* halo, float* values)
  {
    for (int z = 0; z < 8; ++z)
      for (int y = 0; y < 8; ++y)
        values = std::copy_n(halo + haloIndex(0, y, z), edge, values);
  }

  /** @brief Copies a block and the layer of nodes around it. */
  void gatherHalo(const std::vector<float>& values, std::size_t b, float* halo) const;

private:
  std::vector<Key> keys_;
  std::vector<std::array<std::uint32_t, 27>> neighbours_;
  std::vector<bool> at_rim_;
};

/** @brief Offsets in a halo from a cell's lowest corner to all eight. */
constexpr std::array<std::uint32_t, 8> corners = {0, 1, 10, 11, 100, 101, 110, 111};

/** @brief Computes the trilinear weights of the corners for a point within the cell.
 * @param share position along each axis, 0 to 1 */
inline void
cornerShares(const float* share, float* shares)
{
  for (std::size_t c = 0; c < 8; ++c)
    shares[c] = (c & 1 ? share[0] : 1 - share[0]) * (c & 2 ? share[1] : 1 - share[1]) *
                (c & 4 ? share[2] : 1 - share[2]);
}

/** @brief Returns whether a surface passes through a cell.
 * @param lowest the cell's lowest corner in a halo */
inline bool
isCrossed(const float* lowest, float iso)
{
  int above = 0;
  for (const auto c : corners)
    above += lowest[c] > iso;
  return above > 0 && above < 8;
}

/** @brief Returns whether a surface passes through any cell of a halo. */
inline bool
isHaloCrossed(const float* halo, float iso)
{
  const auto range = std::minmax_element(halo, halo + BandGrid::halo_nodes);
  return *range.first <= iso && *range.second > iso;
}

/** @brief A surface sample with the area that it represents; lengths in cells of some
 * grid. */
struct SurfaceSample {
  Eigen::Vector3d position;
  Eigen::Vector3f normal; ///< its length is the area
  float area;
};

/** @brief A sample within its block. */
struct BlockSample {
  float place[3]; ///< from the block's first node, 0 to 8
  float normal[3];
  float area;
};

/** @brief Samples sorted by block. */
struct SortedSamples {
  BandGrid grid; ///< blocks with samples
  std::vector<BlockSample> samples;
  std::vector<std::size_t> starts; ///< first sample of each block, and the end

  /** @brief Appends the samples within `reach` cells of a block, at most 8, with places
   * relative to it and unit normals. */
  void gather(const BandGrid::Block& block,
              float reach,
              std::vector<BlockSample>& around) const;
};

/** @brief Estimates the distance between neighbouring points of a surface, metres: the
 * side of the square per point, median by area, from at most 4000 points. Zero for
 * fewer than 10 points. O(n log n). */
double measureSpacing(const std::vector<OrientedPoint>& points);

/** @brief Sorts samples into the blocks of a grid with cells `scale` times as large.
 * O(n log n). */
SortedSamples sortSamples(const std::vector<SurfaceSample>& samples, double scale);

/** @brief Merges samples in the same cube of `size` cells: mean weighted by area, sum
 * of areas. O(n log n). */
std::vector<SurfaceSample> mergeSamples(const std::vector<SurfaceSample>& samples,
                                        double size);

/** @brief Sets each sample's area from the local density of samples.
 * @param spacing typical distance of neighbours, cells */
void setAreas(std::vector<SurfaceSample>& samples, double spacing);

/** @brief Returns the quadratic B-spline at `t`: 0.75 at 0, zero from 1.5 on. */
float quadraticSpline(float t);

} // namespace pcl::sedr
