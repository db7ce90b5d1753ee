// SPDX-License-Identifier: BSD-3-Clause
#include "poisson_level.h"

#include "sedr_filters/src/base/parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl::sedr {
namespace {

constexpr float outside = -0.5f;
constexpr float weight = 10; // of samples against smoothness: alpha of equation 4
constexpr std::size_t min_for_threads = 8000; // samples

// Nodes of the coarser grid that surround a halo, starting one node before the block.
constexpr std::size_t patch_edge = 6;

// Refines `patch_edge` values two cells apart to ten values one cell apart, starting
// between the first two.
void
refineRow(const float* coarse, std::size_t stride, float* fine, std::size_t fine_stride)
{
  for (std::size_t i = 0; i < 10; ++i) {
    const float* at = coarse + (i + 1) / 2 * stride;
    fine[i * fine_stride] =
        i % 2 == 1 ? *at
                   : 0.5f * (coarse[i / 2 * stride] + coarse[(i / 2 + 1) * stride]);
  }
}

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

/** @brief The grids, the finest first. */
class PoissonHierarchy {
public:
  PoissonHierarchy(std::size_t max_blocks, unsigned threads)
      : max_blocks_(max_blocks)
      , threads_(threads)
  {}

  PoissonSolution solve(const std::vector<SurfaceSample>& samples)
  {
    constexpr double coarsest_cells = 20; // across all samples
    double extent = 0;
    for (const SurfaceSample& sample : samples)
      extent = std::max(
          extent, (sample.position - samples.front().position).cwiseAbs().maxCoeff());
    std::vector<std::vector<SurfaceSample>> merged(1, samples);
    for (double cells = 2 * extent; cells > coarsest_cells; cells /= 2)
      merged.push_back(
          mergeSamples(merged.back(), std::ldexp(1., static_cast<int>(merged.size()))));
    levels_.resize(merged.size());
    for (std::size_t level = levels_.size(); level-- > 0 && problem_.empty();)
      solveLevel(
          level, merged[level],
          level + 1 == levels_.size()
              ? blocksOfBox(merged[level], std::ldexp(1., static_cast<int>(level)))
              : blocksAtSurface(level + 1));
    return {std::move(levels_.front()), mean_, problem_};
  }

private:
  float valueAt(std::size_t level, std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    if (level == levels_.size())
      return outside;
    const BandGrid& grid = levels_[level].grid();
    const std::size_t b = grid.find({x >> 3, y >> 3, z >> 3});
    if (b < grid.size())
      return levels_[level]
          .values[b * BandGrid::nodes + BandGrid::nodeIndex(x & 7, y & 7, z & 7)];
    const std::int64_t lo[3] = {x >> 1, y >> 1, z >> 1};
    const std::int64_t hi[3] = {lo[0] + (x & 1), lo[1] + (y & 1), lo[2] + (z & 1)};
    float sum = 0;
    for (int c = 0; c < 8; ++c)
      sum += valueAt(level + 1, c & 1 ? hi[0] : lo[0], c & 2 ? hi[1] : lo[1],
                     c & 4 ? hi[2] : lo[2]);
    return sum / 8;
  }

  void interpolate(std::size_t level, const BandGrid::Block& block, float* halo) const
  {
    if (level + 1 == levels_.size()) {
      std::fill(halo, halo + BandGrid::halo_nodes, outside);
      return;
    }
    const PoissonLevel& coarser = levels_[level + 1];
    const BandGrid& grid = coarser.grid();
    // The block is an eighth of a coarser one, in which the patch has its place.
    const BandGrid::Block whole = {block[0] >> 1, block[1] >> 1, block[2] >> 1};
    const std::size_t own = grid.find(whole);
    int first[3];
    for (std::size_t k = 0; k < 3; ++k)
      first[k] = static_cast<int>(block[k] & 1) * 4 - 1;
    float patch[patch_edge * patch_edge * patch_edge];
    float* value = patch;
    for (int z = first[2]; z < first[2] + 6; ++z)
      for (int y = first[1]; y < first[1] + 6; ++y)
        for (int x = first[0]; x < first[0] + 6; ++x)
          *value++ = own < grid.size() && grid.blockAt(own, x, y, z) < grid.size()
                         ? coarser.values[grid.valueAt(own, x, y, z)]
                         : valueAt(level + 1, 8 * whole[0] + x, 8 * whole[1] + y,
                                   8 * whole[2] + z);
    float along_x[6 * 6 * 10];
    float along_y[6 * 10 * 10];
    for (std::size_t row = 0; row < 36; ++row)
      refineRow(patch + row * 6, 1, along_x + row * 10, 1);
    for (std::size_t z = 0; z < 6; ++z)
      for (std::size_t x = 0; x < 10; ++x)
        refineRow(along_x + z * 60 + x, 10, along_y + z * 100 + x, 10);
    for (std::size_t yx = 0; yx < 100; ++yx)
      refineRow(along_y + yx, 100, halo + yx, 100);
  }

  void gather(std::size_t level, std::size_t b, float* halo) const
  {
    const BandGrid& grid = levels_[level].grid();
    if (!grid.atRim(b)) {
      grid.gatherHalo(levels_[level].values, b, halo);
      return;
    }
    float inside[BandGrid::halo_nodes];
    grid.gatherHalo(levels_[level].values, b, inside);
    interpolate(level, grid.at(b), halo);
    std::size_t i = 0;
    for (int z = -1; z <= 8; ++z)
      for (int y = -1; y <= 8; ++y)
        for (int x = -1; x <= 8; ++x, ++i)
          if (grid.blockAt(b, x, y, z) < grid.size())
            halo[i] = inside[i];
  }

  void solveLevel(std::size_t level,
                  const std::vector<SurfaceSample>& samples,
                  std::vector<BandGrid::Key> more)
  {
    constexpr int max_rounds = 40;
    const double scale = std::ldexp(1., static_cast<int>(level));
    const bool coarsest = level + 1 == levels_.size();
    // Small grids are faster with one thread.
    const unsigned threads = samples.size() < min_for_threads ? 1 : threads_;
    PoissonLevel before;
    int widened = -1;
    do {
      levels_[level] = PoissonLevel(samples, scale, weight, more, threads);
      start(level, before, threads);
      levels_[level].solve(
          [this, level](std::size_t b, float* halo) { gather(level, b, halo); },
          threads);
      mean_ = levels_[level].meanAtSamples(threads);
      ++widened;
      if (coarsest)
        return;
      const auto missing =
          blocksMissing(level, level == 0 ? static_cast<float>(mean_) : 0.f);
      if (missing.empty())
        return;
      more.insert(more.end(), missing.begin(), missing.end());
      before = std::move(levels_[level]);
    } while (widened < max_rounds && before.grid().size() + more.size() <= max_blocks_);
    problem_ = "the surface runs out of the " + std::to_string(before.grid().size()) +
               " blocks of cells: the points enclose nothing";
    levels_[level] = std::move(before);
  }

  void start(std::size_t level, const PoissonLevel& before, unsigned threads)
  {
    PoissonLevel& current = levels_[level];
    const BandGrid& grid = current.grid();
    parallelFor(grid.size(), BandGrid::blocks_at_once, threads, [&](std::size_t b) {
      float* values = &current.values[b * BandGrid::nodes];
      const std::size_t old = before.grid().find(grid.at(b));
      if (old < before.grid().size()) {
        std::copy_n(&before.values[old * BandGrid::nodes], BandGrid::nodes, values);
        return;
      }
      float halo[BandGrid::halo_nodes];
      interpolate(level, grid.at(b), halo);
      BandGrid::copyInner(halo, values);
    });
  }

  std::vector<BandGrid::Key> blocksOfBox(const std::vector<SurfaceSample>& samples,
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

  std::vector<BandGrid::Key> blocksAtSurface(std::size_t level) const
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

  std::vector<BandGrid::Key> blocksMissing(std::size_t level, float iso) const
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

  std::size_t max_blocks_;
  unsigned threads_;
  std::vector<PoissonLevel> levels_;
  double mean_ = 0;
  std::string problem_;
};

} // namespace

PoissonSolution
solvePoisson(const std::vector<SurfaceSample>& samples,
             std::size_t max_blocks,
             unsigned threads)
{
  return PoissonHierarchy(max_blocks, threads).solve(samples);
}

} // namespace pcl::sedr
