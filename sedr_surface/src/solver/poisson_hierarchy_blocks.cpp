// SPDX-License-Identifier: BSD-3-Clause
#include "poisson_hierarchy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::sedr {
namespace {

// Calls visit(x, y, z) for cells that the surface crosses, by their lowest nodes from
// `first` to 7.
template <typename Visit>
void
forCrossedCells(const float* halo, float iso, int first, Visit visit)
{
  if (!isHaloCrossed(halo, iso))
    return;
  for (int z = first; z < 8; ++z)
    for (int y = first; y < 8; ++y)
      for (int x = first; x < 8; ++x)
        if (isCrossed(halo + BandGrid::haloIndex(x, y, z), iso))
          visit(x, y, z);
}

void
makeUnique(std::vector<BandGrid::Key>& keys)
{
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

} // namespace

std::vector<BandGrid::Key>
PoissonHierarchy::blocksOfBox(const std::vector<SurfaceSample>& samples,
                              double scale) const
{
  constexpr double pad = 5; // cells within which the function settles
  Eigen::AlignedBox3d box;
  for (const SurfaceSample& sample : samples)
    box.extend(sample.position);
  BandGrid::Block first;
  BandGrid::Block last;
  for (int k = 0; k < 3; ++k) {
    first[static_cast<std::size_t>(k)] =
        static_cast<std::int64_t>(std::floor((box.min()[k] / scale - pad) / 8));
    last[static_cast<std::size_t>(k)] =
        static_cast<std::int64_t>(std::floor((box.max()[k] / scale + pad) / 8));
  }
  std::vector<BandGrid::Key> keys;
  for (std::int64_t z = first[2]; z <= last[2]; ++z)
    for (std::int64_t y = first[1]; y <= last[1]; ++y)
      for (std::int64_t x = first[0]; x <= last[0]; ++x)
        keys.push_back(BandGrid::keyOf({x, y, z}));
  return keys;
}

std::vector<BandGrid::Key>
PoissonHierarchy::blocksAtSurface(std::size_t level) const
{
  const BandGrid& grid = levels_[level].grid();
  std::vector<BandGrid::Key> keys;
  float halo[BandGrid::halo_nodes];
  for (std::size_t b = 0; b < grid.size(); ++b) {
    const BandGrid::Block block = grid.at(b);
    std::array<bool, 64> wanted{};
    gather(level, b, halo);
    forCrossedCells(halo, 0, 0, [&](int x, int y, int z) {
      // The finer cells of this one and two more on each side, in blocks -1 to 2 of
      // those within this one.
      const int cell[3] = {x, y, z};
      int lo[3];
      int hi[3];
      for (int k = 0; k < 3; ++k) {
        lo[k] = (2 * cell[k] - 2 + 8) / 8;
        hi[k] = (2 * cell[k] + 3 + 8) / 8;
      }
      for (int k = lo[2]; k <= hi[2]; ++k)
        for (int j = lo[1]; j <= hi[1]; ++j)
          for (int i = lo[0]; i <= hi[0]; ++i)
            wanted[static_cast<std::size_t>((k * 4 + j) * 4 + i)] = true;
    });
    for (std::int64_t i = 0; i < 64; ++i)
      if (wanted[static_cast<std::size_t>(i)])
        keys.push_back(
            BandGrid::keyOf({2 * block[0] + i % 4 - 1, 2 * block[1] + i / 4 % 4 - 1,
                             2 * block[2] + i / 16 - 1}));
  }
  makeUnique(keys);
  return keys;
}

std::vector<BandGrid::Key>
PoissonHierarchy::blocksMissing(std::size_t level, float iso) const
{
  const BandGrid& grid = levels_[level].grid();
  std::vector<BandGrid::Key> keys;
  float halo[BandGrid::halo_nodes];
  for (std::size_t b = 0; b < grid.size(); ++b) {
    if (!grid.atRim(b))
      continue;
    const BandGrid::Block block = grid.at(b);
    gather(level, b, halo);
    forCrossedCells(halo, iso, -1, [&](int x, int y, int z) {
      for (int c = 0; c < 8; ++c) {
        const int n[3] = {x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)};
        if (grid.blockAt(b, n[0], n[1], n[2]) == grid.size())
          keys.push_back(
              BandGrid::keyOf({block[0] + (n[0] >> 3), block[1] + (n[1] >> 3),
                               block[2] + (n[2] >> 3)}));
      }
    });
  }
  makeUnique(keys);
  return keys;
}

} // namespace pcl::sedr
