// SPDX-License-Identifier: BSD-3-Clause
#include "dual_surface.h"

#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl::sedr {
namespace {

constexpr int gentle_rounds = 8;

// Returns the corners that are connected along edges of a cell with the lowest one of
// `set`, a bit for each corner.
unsigned
connectedPart(unsigned set)
{
  unsigned part = set & (~set + 1);
  for (int step = 0; step < 8; ++step)
    part |= set & ((part & 0x55) << 1 | (part & 0xaa) >> 1 | (part & 0x33) << 2 |
                   (part & 0xcc) >> 2 | (part & 0x0f) << 4 | (part & 0xf0) >> 4);
  return part;
}

// Returns for each set of corners above zero whether a cell is well composed: both its
// corners above zero and the others are connected.
std::array<bool, 256>
wellComposedSets()
{
  std::array<bool, 256> is_good{};
  for (unsigned above = 0; above < 256; ++above)
    is_good[above] =
        connectedPart(above) == above && connectedPart(255 - above) == 255 - above;
  return is_good;
}

// Returns the corner of a cell whose sign must change, or -1: the one with the value
// nearest to zero, if possible of those that make the cell well composed.
int
findFlip(const float* lowest, bool gentle)
{
  static const std::array<bool, 256> is_good = wellComposedSets();
  unsigned above = 0;
  for (unsigned c = 0; c < 8; ++c)
    above |= lowest[corners[c]] > 0 ? 1u << c : 0u;
  if (is_good[above])
    return -1;
  int best = -1;
  std::pair<bool, float> least;
  for (unsigned c = 0; c < 8; ++c) {
    const std::pair<bool, float> cost(!is_good[above ^ 1u << c],
                                      std::abs(lowest[corners[c]]));
    if ((gentle || (above >> c & 1u) != 0) && (best < 0 || cost < least)) {
      best = static_cast<int>(c);
      least = cost;
    }
  }
  return best;
}

// Appends the places of the values of a block's cells whose sign must change.
void
findFlips(const BandGrid& grid,
          const std::vector<float>& values,
          std::size_t b,
          bool gentle,
          std::vector<std::size_t>& flips)
{
  float halo[BandGrid::halo_nodes];
  grid.gatherHalo(values, b, halo);
  if (!isHaloCrossed(halo, 0))
    return;
  for (int i = 0; i < static_cast<int>(BandGrid::nodes); ++i) {
    const int x = i & 7;
    const int y = i >> 3 & 7;
    const int z = i >> 6;
    const int flip = findFlip(halo + BandGrid::haloIndex(x, y, z), gentle);
    if (flip >= 0 && grid.holdsCell(b, x, y, z))
      flips.push_back(
          grid.valueAt(b, x + (flip & 1), y + (flip >> 1 & 1), z + (flip >> 2)));
  }
}

} // namespace

void
makeWellComposed(const BandGrid& grid, std::vector<float>& values, unsigned threads)
{
  constexpr std::size_t part = 64;
  std::vector<bool> is_suspect(grid.size(), true);
  for (int round = 0;; ++round) {
    std::vector<std::vector<std::size_t>> flips((grid.size() + part - 1) / part);
    parallelFor(grid.size(), part, threads, [&](std::size_t b) {
      if (is_suspect[b])
        findFlips(grid, values, b, round < gentle_rounds, flips[b / part]);
    });
    std::vector<std::size_t> all;
    for (const auto& list : flips)
      all.insert(all.end(), list.begin(), list.end());
    if (all.empty())
      return;
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    is_suspect.assign(grid.size(), false);
    for (const std::size_t place : all) {
      // Near zero, so that it may easily change again.
      values[place] = values[place] > 0 ? -1e-4f : 1e-4f;
      for (const std::size_t b : grid.neighbours(place / BandGrid::nodes))
        if (b < grid.size())
          is_suspect[b] = true;
    }
  }
}

} // namespace pcl::sedr
