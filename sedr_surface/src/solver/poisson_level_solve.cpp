// SPDX-License-Identifier: BSD-3-Clause
#include "poisson_level.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::sedr {
namespace {

// Sums body(begin, end) in order over parts of [0, n) that do not depend on the number
// of threads.
template <typename Body>
double
sumInOrder(std::size_t n, std::size_t part, unsigned threads, Body body)
{
  std::vector<double> sums((n + part - 1) / part, 0.);
  parallelBlocks(n, part, threads, [&](std::size_t begin, std::size_t end) {
    sums[begin / part] = body(begin, end);
  });
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
      cornerShares(screen.share, shares);
      float value = 0;
      for (std::size_t c = 0; c < 8; ++c)
        value += shares[c] * halo[screen.corner + corners[c]];
      value *= screen.weight;
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

void
PoissonLevel::applyAll(const std::vector<float>& x,
                       std::vector<float>& result,
                       double& product,
                       unsigned threads) const
{
  product = sumInOrder(grid_.size(), BandGrid::blocks_at_once, threads,
                       [&](std::size_t begin, std::size_t end) {
                         float halo[BandGrid::halo_nodes];
                         double sum = 0;
                         for (std::size_t b = begin; b < end; ++b) {
                           grid_.gatherHalo(x, b, halo);
                           float* own = &result[b * BandGrid::nodes];
                           apply(halo, b, own);
                           float block_sum = 0;
                           for (std::size_t i = 0; i < BandGrid::nodes; ++i)
                             block_sum += own[i] * x[b * BandGrid::nodes + i];
                           sum += static_cast<double>(block_sum);
                         }
                         return sum;
                       });
}

SolveReport
PoissonLevel::solve(const GatherHalo& gather,
                    double tolerance,
                    int max_iterations,
                    unsigned threads)
{
  SolveReport report;
  const std::size_t n = grid_.size() * BandGrid::nodes;
  std::vector<float> residual(grid_.valueCount(), 0.f);
  std::vector<float> step(grid_.valueCount(), 0.f);
  std::vector<float> applied(n);
  double right_length = 0;
  // The residual, with the given values around the blocks.
  double length = sumInOrder(grid_.size(), BandGrid::blocks_at_once, threads,
                             [&](std::size_t begin, std::size_t end) {
                               float halo[BandGrid::halo_nodes];
                               double sum = 0;
                               for (std::size_t b = begin; b < end; ++b) {
                                 gather(b, halo);
                                 apply(halo, b, &applied[b * BandGrid::nodes]);
                                 for (std::size_t i = b * BandGrid::nodes;
                                      i < (b + 1) * BandGrid::nodes; ++i) {
                                   residual[i] = right_[i] - applied[i];
                                   step[i] = residual[i] / diagonal_[i];
                                   sum += static_cast<double>(residual[i] * step[i]);
                                 }
                               }
                               return sum;
                             });
  constexpr std::size_t part = 32 * BandGrid::nodes;
  right_length = sumInOrder(n, part, threads, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i)
      sum += static_cast<double>(right_[i] * right_[i] / diagonal_[i]);
    return sum;
  });
  const double enough = tolerance * tolerance * right_length;
  while (length > enough && report.iterations < max_iterations) {
    double curvature = 0;
    applyAll(step, applied, curvature, threads);
    if (!(curvature > 0))
      break;
    const auto along = static_cast<float>(length / curvature);
    const double next =
        sumInOrder(n, part, threads, [&](std::size_t begin, std::size_t end) {
          double sum = 0;
          for (std::size_t row = begin; row < end; row += BandGrid::nodes) {
            float row_sum = 0;
            for (std::size_t i = row; i < row + BandGrid::nodes; ++i) {
              values[i] += along * step[i];
              residual[i] -= along * applied[i];
              row_sum += residual[i] * residual[i] / diagonal_[i];
            }
            sum += static_cast<double>(row_sum);
          }
          return sum;
        });
    const auto back = static_cast<float>(next / length);
    parallelFor(n, part, threads, [&](std::size_t i) {
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
  std::vector<double> areas(
      (grid_.size() + BandGrid::blocks_at_once - 1) / BandGrid::blocks_at_once, 0.);
  const double sum = sumInOrder(
      grid_.size(), BandGrid::blocks_at_once, threads,
      [&](std::size_t begin, std::size_t end) {
        float halo[BandGrid::halo_nodes];
        float shares[8];
        double part = 0;
        for (std::size_t b = begin; b < end; ++b) {
          if (screen_starts_[b] == screen_starts_[b + 1])
            continue;
          grid_.gatherHalo(values, b, halo);
          for (std::size_t i = screen_starts_[b]; i < screen_starts_[b + 1]; ++i) {
            const Screen& screen = screens_[i];
            cornerShares(screen.share, shares);
            float value = 0;
            for (std::size_t c = 0; c < 8; ++c)
              value += shares[c] * halo[screen.corner + corners[c]];
            part += static_cast<double>(screen.area * value);
            areas[begin / BandGrid::blocks_at_once] += static_cast<double>(screen.area);
          }
        }
        return part;
      });
  const double area = std::accumulate(areas.begin(), areas.end(), 0.);
  return area > 0 ? sum / area : 0;
}

} // namespace pcl::sedr
