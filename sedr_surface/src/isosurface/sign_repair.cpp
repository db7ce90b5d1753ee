// SPDX-License-Identifier: BSD-3-Clause
#include "sign_repair.h"
#include "../solver/cell_corners.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::sedr {
namespace {

constexpr int gentle_rounds = 8;

using Corners = std::array<int, 4>;

// The faces of a cell through its lowest node, as rings of corners.
constexpr std::array<Corners, 3> faces = {{{0, 1, 3, 2}, {0, 2, 6, 4}, {0, 1, 5, 4}}};

// Returns the corner of a cell whose sign must change, or -1, given the eight values.
int
findFlip(const float* value, bool gentle)
{
  const auto above = [value](int c) { return value[c] > 0; };
  const auto preferred = [&](int c, int best) {
    if (!gentle && !above(c))
      return best;
    return best < 0 || std::abs(value[c]) < std::abs(value[best]) ? c : best;
  };
  for (const Corners& face : faces)
    if (above(face[0]) == above(face[2]) && above(face[1]) == above(face[3]) &&
        above(face[0]) != above(face[1])) {
      int best = -1;
      for (const int c : face)
        best = preferred(c, best);
      return best;
    }
  int count = 0;
  for (int c = 0; c < 8; ++c)
    count += above(c);
  for (int c = 0; c < 4; ++c)
    if (above(c) == above(7 - c) &&
        ((above(c) && count == 2) || (!above(c) && count == 6))) {
      if (gentle)
        return preferred(7 - c, c);
      int best = -1;
      for (int i = 0; i < 8; ++i)
        best = preferred(i, best);
      return best;
    }
  return -1;
}

// Returns the index in the values of the node whose sign must change in a cell of block
// `b`, or one past the end.
std::size_t
findFlipOfCell(const BandGrid& grid,
               std::size_t b,
               const float* halo,
               const std::array<int, 3>& cell,
               bool gentle)
{
  const std::size_t none = grid.valueCount();
  const float* lowest = halo + BandGrid::haloIndex(cell[0], cell[1], cell[2]);
  float value[8];
  int above = 0;
  for (std::size_t c = 0; c < 8; ++c) {
    value[c] = lowest[corners[c]];
    above += value[c] > 0;
  }
  if (above < 2 || above > 6)
    return none;
  const int flip = findFlip(value, gentle);
  if (flip < 0)
    return none;
  std::size_t place = none;
  for (int c = 0; c < 8; ++c) {
    const int n[3] = {cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2)};
    const std::size_t block = grid.neighbour(b, n[0] >> 3, n[1] >> 3, n[2] >> 3);
    if (block == grid.size())
      return none; // no cell of the band, as a node is missing
    if (c == flip)
      place =
          block * BandGrid::nodes + BandGrid::nodeIndex(n[0] & 7, n[1] & 7, n[2] & 7);
  }
  return place;
}

} // namespace

std::size_t
makeWellComposed(const BandGrid& grid, std::vector<float>& values, unsigned threads)
{
  std::size_t changed = 0;
  std::vector<std::size_t> suspects(grid.size());
  for (std::size_t b = 0; b < suspects.size(); ++b)
    suspects[b] = b;
  for (int round = 0; !suspects.empty(); ++round) {
    const bool gentle = round < gentle_rounds;
    constexpr std::size_t part = 64;
    std::vector<std::vector<std::size_t>> flips((suspects.size() + part - 1) / part);
    parallelBlocks(
        suspects.size(), part, threads, [&](std::size_t begin, std::size_t end) {
          float halo[BandGrid::halo_nodes];
          for (std::size_t s = begin; s < end; ++s) {
            const std::size_t b = suspects[s];
            grid.gatherHalo(values, b, halo);
            const auto range = std::minmax_element(halo, halo + BandGrid::halo_nodes);
            if (*range.first > 0 || *range.second <= 0)
              continue;
            for (int i = 0; i < static_cast<int>(BandGrid::nodes); ++i) {
              const std::array<int, 3> cell = {i & 7, i >> 3 & 7, i >> 6};
              const std::size_t place = findFlipOfCell(grid, b, halo, cell, gentle);
              if (place < values.size())
                flips[begin / part].push_back(place);
            }
          }
        });
    std::vector<std::size_t> all;
    for (const auto& list : flips)
      all.insert(all.end(), list.begin(), list.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    suspects.clear();
    for (const std::size_t place : all) {
      // Near zero, so that it may easily change again.
      values[place] = values[place] > 0 ? -1e-4f : 1e-4f;
      for (std::size_t i = 0; i < 27; ++i) {
        const int n = static_cast<int>(i);
        const std::size_t b = grid.neighbour(place / BandGrid::nodes, n % 3 - 1,
                                             n / 3 % 3 - 1, n / 9 - 1);
        if (b < grid.size())
          suspects.push_back(b);
      }
    }
    std::sort(suspects.begin(), suspects.end());
    suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
    changed += all.size();
  }
  return changed;
}

} // namespace pcl::sedr
