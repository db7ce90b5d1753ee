// SPDX-License-Identifier: BSD-3-Clause
#include "poisson_level.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pcl::sedr {
namespace {

// Adds a sample's right-hand side to the nodes from two before its block to two behind
// it.
void
splatNormal(const BlockSample& sample, float* nodes12)
{
  float smooth[3][4];
  float slope[3][4];
  std::size_t first[3];
  for (int k = 0; k < 3; ++k) {
    const float base = std::floor(sample.place[k]);
    first[k] = static_cast<std::size_t>(base) + 1; // one node before it
    float half[5];
    for (int i = 0; i < 5; ++i)
      half[i] = quadraticSpline(base - 1.5f + static_cast<float>(i) - sample.place[k]);
    for (int i = 0; i < 4; ++i) {
      smooth[k][i] =
          quadraticSpline(base - 1 + static_cast<float>(i) - sample.place[k]);
      slope[k][i] = half[i] - half[i + 1];
    }
  }
  for (std::size_t z = 0; z < 4; ++z)
    for (std::size_t y = 0; y < 4; ++y) {
      float* row = nodes12 + ((first[2] + z) * 12 + first[1] + y) * 12 + first[0];
      const float along_x = sample.normal[0] * smooth[1][y] * smooth[2][z];
      const float across = sample.normal[1] * slope[1][y] * smooth[2][z] +
                           sample.normal[2] * smooth[1][y] * slope[2][z];
      for (std::size_t x = 0; x < 4; ++x)
        row[x] += along_x * slope[0][x] + across * smooth[0][x];
    }
}

} // namespace

PoissonLevel::PoissonLevel(const std::vector<SurfaceSample>& samples,
                           double scale,
                           float weight,
                           const std::vector<BandGrid::Key>& more,
                           unsigned threads)
    : sorted_(sortSamples(samples, scale))
{
  addBlocks(more);
  values.assign(grid_.valueCount(), 0.f);
  addScreens(weight);
  addNormals(threads);
  setDiagonal(threads);
}

void
PoissonLevel::addBlocks(const std::vector<BandGrid::Key>& more)
{
  std::vector<BandGrid::Key> keys = more;
  for (std::size_t s = 0; s < sorted_.grid.size(); ++s) {
    std::array<bool, 27> wanted{};
    for (std::size_t i = sorted_.starts[s]; i < sorted_.starts[s + 1]; ++i) {
      bool side[3][3];
      for (int k = 0; k < 3; ++k) {
        side[k][0] = sorted_.samples[i].place[k] < margin;
        side[k][1] = true;
        side[k][2] = sorted_.samples[i].place[k] > 7 - margin;
      }
      for (std::size_t n = 0; n < 27; ++n)
        if (side[0][n % 3] && side[1][n / 3 % 3] && side[2][n / 9])
          wanted[n] = true;
    }
    for (std::size_t n = 0; n < 27; ++n)
      if (wanted[n])
        keys.push_back(BandGrid::keyOf(BandGrid::around(sorted_.grid.at(s), n)));
  }
  grid_ = BandGrid(std::move(keys));
}

void
PoissonLevel::addScreens(float weight)
{
  // For each block, the samples in its cells and in those that end at its first nodes,
  // which come from the preceding blocks.
  screens_.resize(grid_.size());
  for (std::size_t s = 0; s < sorted_.grid.size(); ++s) {
    const std::size_t own = grid_.find(sorted_.grid.at(s));
    for (std::size_t i = sorted_.starts[s]; i < sorted_.starts[s + 1]; ++i) {
      const BlockSample& sample = sorted_.samples[i];
      std::int64_t cell[3];
      Screen screen;
      for (int k = 0; k < 3; ++k) {
        const float base = std::floor(sample.place[k]);
        cell[k] = static_cast<std::int64_t>(base);
        screen.share[k] = sample.place[k] - base;
      }
      screen.weight = weight * sample.area;
      for (int n = 0; n < 8; ++n) {
        const int step[3] = {n & 1, n >> 1 & 1, n >> 2};
        bool reaches = true;
        std::int64_t place[3];
        for (int k = 0; k < 3; ++k) {
          reaches = reaches && (step[k] == 0 || cell[k] == 7);
          place[k] = step[k] ? -1 : cell[k];
        }
        if (!reaches)
          continue;
        const std::size_t b = grid_.neighbour(own, step[0], step[1], step[2]);
        screen.corner = static_cast<std::uint32_t>(
            BandGrid::haloIndex(place[0], place[1], place[2]));
        screen.area = n == 0 ? sample.area : 0;
        if (b < grid_.size())
          screens_[b].push_back(screen);
      }
    }
  }
}

void
PoissonLevel::addNormals(unsigned threads)
{
  right_.assign(grid_.valueCount(), 0.f);
  // Blocks two apart never share a node: eight sets run in sequence, the blocks of each
  // in parallel.
  std::vector<std::size_t> sets[8];
  for (std::size_t s = 0; s < sorted_.grid.size(); ++s) {
    const BandGrid::Block block = sorted_.grid.at(s);
    sets[(block[0] & 1) + 2 * (block[1] & 1) + 4 * (block[2] & 1)].push_back(s);
  }
  for (const auto& set : sets)
    parallelFor(set.size(), BandGrid::blocks_at_once, threads, [&](std::size_t i) {
      const std::size_t s = set[i];
      const std::size_t own = grid_.find(sorted_.grid.at(s));
      float nodes12[12 * 12 * 12] = {};
      for (std::size_t p = sorted_.starts[s]; p < sorted_.starts[s + 1]; ++p)
        splatNormal(sorted_.samples[p], nodes12);
      const float* value = nodes12;
      for (int z = -2; z < 10; ++z)
        for (int y = -2; y < 10; ++y)
          for (int x = -2; x < 10; ++x, ++value)
            if (*value != 0 && grid_.blockAt(own, x, y, z) < grid_.size())
              right_[grid_.valueAt(own, x, y, z)] += *value;
    });
}

void
PoissonLevel::setDiagonal(unsigned threads)
{
  diagonal_.assign(grid_.valueCount(), 1.f);
  parallelFor(grid_.size(), BandGrid::blocks_at_once, threads, [&](std::size_t b) {
    float sums[BandGrid::halo_nodes];
    float shares[8];
    std::fill(std::begin(sums), std::end(sums), 6.f);
    for (const Screen& screen : screens_[b]) {
      cornerShares(screen.share, shares);
      for (std::size_t c = 0; c < 8; ++c)
        sums[screen.corner + corners[c]] += screen.weight * shares[c] * shares[c];
    }
    BandGrid::copyInner(sums, &diagonal_[b * BandGrid::nodes]);
  });
}

namespace {

// Calls add(i, sum) for [0, n), and adds up the sums of parts that do not depend on the
// number of threads, in their order.
template <typename Add>
double
sumInOrder(std::size_t n, std::size_t part, unsigned threads, Add add)
{
  std::vector<double> sums((n + part - 1) / part, 0.);
  parallelFor(n, part, threads, [&](std::size_t i) { add(i, sums[i / part]); });
  return std::accumulate(sums.begin(), sums.end(), 0.);
}

} // namespace

void
PoissonLevel::apply(const float* halo, std::size_t b, float* result) const
{
  float extra[BandGrid::halo_nodes];
  const bool screened = !screens_[b].empty();
  if (screened) {
    std::fill(std::begin(extra), std::end(extra), 0.f);
    float shares[8];
    for (const Screen& screen : screens_[b]) {
      const float value = screen.valueIn(halo) * screen.weight;
      cornerShares(screen.share, shares);
      for (std::size_t c = 0; c < 8; ++c)
        extra[screen.corner + corners[c]] += value * shares[c];
    }
  }
  for (int z = 0; z < 8; ++z)
    for (int y = 0; y < 8; ++y) {
      const std::size_t first = BandGrid::haloIndex(0, y, z);
      const float* h = halo + first;
      for (int x = 0; x < 8; ++x)
        result[x] = 6 * h[x] - h[x - 1] - h[x + 1] - h[x - 10] - h[x + 10] -
                    h[x - 100] - h[x + 100];
      if (screened)
        for (int x = 0; x < 8; ++x)
          result[x] += extra[first + static_cast<std::size_t>(x)];
      result += 8;
    }
}

double
PoissonLevel::applyAll(const std::vector<float>& x,
                       std::vector<float>& result,
                       unsigned threads) const
{
  return sumInOrder(grid_.size(), BandGrid::blocks_at_once, threads,
                    [&](std::size_t b, double& sum) {
                      float halo[BandGrid::halo_nodes];
                      grid_.gatherHalo(x, b, halo);
                      float* own = &result[b * BandGrid::nodes];
                      apply(halo, b, own);
                      float product = 0;
                      for (std::size_t i = 0; i < BandGrid::nodes; ++i)
                        product += own[i] * x[b * BandGrid::nodes + i];
                      sum += static_cast<double>(product);
                    });
}

void
PoissonLevel::solve(const GatherHalo& gather, unsigned threads)
{
  constexpr double tolerance = 1e-2;
  constexpr int max_iterations = 200;
  constexpr std::size_t part = 32; // blocks
  const std::size_t blocks = grid_.size();
  const std::size_t n = blocks * BandGrid::nodes;
  std::vector<float> residual(grid_.valueCount(), 0.f);
  std::vector<float> step(grid_.valueCount(), 0.f);
  std::vector<float> applied(n);
  // The residual, with the given values around the blocks.
  double length = sumInOrder(
      blocks, BandGrid::blocks_at_once, threads, [&](std::size_t b, double& sum) {
        float halo[BandGrid::halo_nodes];
        gather(b, halo);
        apply(halo, b, &applied[b * BandGrid::nodes]);
        for (std::size_t i = b * BandGrid::nodes; i < (b + 1) * BandGrid::nodes; ++i) {
          residual[i] = right_[i] - applied[i];
          step[i] = residual[i] / diagonal_[i];
          sum += static_cast<double>(residual[i] * step[i]);
        }
      });
  const double right_length =
      sumInOrder(n, part * BandGrid::nodes, threads, [&](std::size_t i, double& sum) {
        sum += static_cast<double>(right_[i] * right_[i] / diagonal_[i]);
      });
  const double enough = tolerance * tolerance * right_length;
  for (int k = 0; k < max_iterations && length > enough; ++k) {
    const double curvature = applyAll(step, applied, threads);
    if (!(curvature > 0))
      break;
    const auto along = static_cast<float>(length / curvature);
    const double next =
        sumInOrder(blocks, part, threads, [&](std::size_t b, double& sum) {
          float block_sum = 0;
          for (std::size_t i = b * BandGrid::nodes; i < (b + 1) * BandGrid::nodes;
               ++i) {
            values[i] += along * step[i];
            residual[i] -= along * applied[i];
            block_sum += residual[i] * residual[i] / diagonal_[i];
          }
          sum += static_cast<double>(block_sum);
        });
    const auto back = static_cast<float>(next / length);
    parallelFor(n, part * BandGrid::nodes, threads, [&](std::size_t i) {
      step[i] = residual[i] / diagonal_[i] + back * step[i];
    });
    length = next;
  }
}

double
PoissonLevel::meanAtSamples(unsigned threads) const
{
  const auto sumOverScreens = [&](auto add) {
    return sumInOrder(grid_.size(), BandGrid::blocks_at_once, threads,
                      [&](std::size_t b, double& sum) {
                        float halo[BandGrid::halo_nodes];
                        if (!screens_[b].empty())
                          grid_.gatherHalo(values, b, halo);
                        for (const Screen& screen : screens_[b])
                          sum += static_cast<double>(add(screen, halo));
                      });
  };
  const double area =
      sumOverScreens([](const Screen& screen, const float*) { return screen.area; });
  const double sum = sumOverScreens([](const Screen& screen, const float* halo) {
    return screen.area * screen.valueIn(halo);
  });
  return area > 0 ? sum / area : 0;
}

} // namespace pcl::sedr
