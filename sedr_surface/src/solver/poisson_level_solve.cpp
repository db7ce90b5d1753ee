// SPDX-License-Identifier: BSD-3-Clause
#include "poisson_level.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::sedr {
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
  const bool screened = screen_starts_[b] < screen_starts_[b + 1];
  if (screened) {
    std::fill(std::begin(extra), std::end(extra), 0.f);
    float shares[8];
    for (std::size_t i = screen_starts_[b]; i < screen_starts_[b + 1]; ++i) {
      const Screen& screen = screens_[i];
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

SolveReport
PoissonLevel::solve(const GatherHalo& gather,
                    double tolerance,
                    int max_iterations,
                    unsigned threads)
{
  constexpr std::size_t part = 32; // blocks
  SolveReport report;
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
  while (length > enough && report.iterations < max_iterations) {
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
    ++report.iterations;
  }
  report.residual = right_length > 0 ? std::sqrt(length / right_length) : 0;
  return report;
}

double
PoissonLevel::meanAtSamples(unsigned threads) const
{
  const auto sumOverScreens = [&](auto add) {
    return sumInOrder(grid_.size(), BandGrid::blocks_at_once, threads,
                      [&](std::size_t b, double& sum) {
                        float halo[BandGrid::halo_nodes];
                        if (screen_starts_[b] < screen_starts_[b + 1])
                          grid_.gatherHalo(values, b, halo);
                        for (std::size_t i = screen_starts_[b];
                             i < screen_starts_[b + 1]; ++i)
                          sum += static_cast<double>(add(screens_[i], halo));
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
