// SPDX-License-Identifier: BSD-3-Clause
// What a scan shows in dots becomes surfaces, and what floats in the air goes.
#include "voxel_columns.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <utility>

namespace pcl::sedr {

template <typename Visitor>
void
VoxelColumns::forEachCompany(std::size_t t, Visitor visit) const
{
  const Tile& tile = tiles_[t];
  for (std::uint32_t at = 0; at < tile_columns; ++at) {
    const auto column = static_cast<std::uint32_t>(t * tile_columns) + at;
    std::array<std::uint32_t, 9> around{};
    std::size_t n = 0;
    for (std::int32_t w = 0; w < tile.words; ++w) {
      const std::int32_t begin = tile.low + 64 * w;
      const std::uint64_t own = wordFrom(column, begin);
      if (own == 0)
        continue;
      if (n == 0)
        n = columnsAround(column, around);
      std::array<std::uint64_t, 4> digits{};
      const auto count = [&](std::uint64_t word) {
        word &= ~(digits[0] & digits[1] & digits[2] & digits[3]);
        for (std::uint64_t& digit : digits) {
          const std::uint64_t carry = digit & word;
          digit ^= word;
          word = carry;
        }
      };
      for (std::size_t k = 0; k < n; ++k) {
        const std::uint64_t middle = wordFrom(around[k], begin);
        count(middle << 1 | wordFrom(around[k], begin - 64) >> 63);
        count(middle >> 1 | wordFrom(around[k], begin + 64) << 63);
        if (k > 0)
          count(middle);
      }
      visit(tile.first + at * static_cast<std::size_t>(tile.words) +
                static_cast<std::size_t>(w),
            own, digits);
    }
  }
}

std::size_t
VoxelColumns::columnsAround(std::uint32_t column,
                            std::array<std::uint32_t, 9>& around) const
{
  std::size_t n = 0;
  around[n++] = column;
  for (int d = 0; d < 4; ++d) {
    const std::uint32_t side = neighbour(column, d);
    const std::uint32_t corner = side == none ? none : neighbour(side, (d + 1) % 4);
    for (const std::uint32_t other : {side, corner})
      if (other != none)
        around[n++] = other;
  }
  return n;
}

namespace {

/** @brief The voxels whose number, as four words of binary digits, is at least n. */
std::uint64_t
atLeast(const std::array<std::uint64_t, 4>& digits, unsigned n)
{
  std::uint64_t more = 0;
  std::uint64_t equal = ~std::uint64_t{0};
  for (unsigned k = 4; k-- > 0;)
    if ((n >> k & 1) != 0)
      equal &= digits[k];
    else {
      more |= equal & digits[k];
      equal &= ~digits[k];
    }
  return more | equal;
}

/** @brief The company that two thirds of those counted have. */
int
usualOf(const std::array<std::size_t, 16>& counts)
{
  std::size_t usual = 0;
  while (usual < 15 && 3 * counts[usual + 1] >= 2 * counts[0] && counts[0] > 0)
    ++usual;
  return static_cast<int>(usual);
}

} // namespace

std::vector<VoxelColumns::CompanyCounts>
VoxelColumns::companyIn(std::size_t t) const
{
  const Tile& tile = tiles_[t];
  std::vector<CompanyCounts> counts(static_cast<std::size_t>(tile.words));
  forEachCompany(t, [&](std::size_t at, std::uint64_t own, const auto& digits) {
    CompanyCounts& of_word = counts[(at - tile.first) % counts.size()];
    for (unsigned n = 0; n < of_word.size(); ++n)
      of_word[n] +=
          static_cast<std::size_t>(__builtin_popcountll(own & atLeast(digits, n)));
  });
  return counts;
}

int
VoxelColumns::usualCompany(unsigned threads) const
{
  std::vector<std::vector<CompanyCounts>> of_tile(tiles_.size());
  parallelBlocks(tiles_.size(), 1, threads,
                 [&](std::size_t t, std::size_t) { of_tile[t] = companyIn(t); });
  CompanyCounts all{};
  for (const auto& words : of_tile)
    for (const CompanyCounts& counts : words)
      for (std::size_t n = 0; n < all.size(); ++n)
        all[n] += counts[n];
  return usualOf(all);
}

void
VoxelColumns::keepSurfaces(unsigned threads)
{
  constexpr int most = 4; // neighbours: a surface's edge has five
  std::vector<std::vector<unsigned>> least(tiles_.size()); // by words, as below
  parallelBlocks(tiles_.size(), 1, threads, [&](std::size_t t, std::size_t) {
    for (const CompanyCounts& counts : companyIn(t))
      least[t].push_back(
          static_cast<unsigned>(std::clamp((usualOf(counts) + 1) / 2, 1, most)));
  });
  const auto keepWithCompany = [&](unsigned more) {
    std::vector<std::uint64_t> kept(bits_.size(), 0);
    parallelBlocks(tiles_.size(), 1, threads, [&](std::size_t t, std::size_t) {
      forEachCompany(t, [&](std::size_t at, std::uint64_t own, const auto& digits) {
        kept[at] =
            own &
            atLeast(digits, more + least[t][(at - tiles_[t].first) % least[t].size()]);
      });
    });
    bits_ = std::move(kept);
  };
  keepWithCompany(0);
  const std::vector<std::uint64_t> all = bits_;
  keepWithCompany(1);
  for (const int axis : {0, 1})
    bits_ = spreadAlong(axis, 1, true, threads);
  for (std::size_t k = 0; k < bits_.size(); ++k)
    bits_[k] &= all[k];
}

std::uint32_t
VoxelColumns::stepAlong(std::uint32_t column, int line, bool is_back) const
{
  static constexpr std::array<std::array<int, 2>, 4> steps{
      {{0, -1}, {1, -1}, {0, 1}, {0, 3}}}; // x, y, both diagonals: plan_directions
  for (const int d : steps[static_cast<std::size_t>(line)])
    if (d >= 0 && column != none)
      column = neighbour(column, is_back ? (d + 2) % 4 : d);
  return column;
}

std::vector<std::uint64_t>
VoxelColumns::spreadAlong(int line, int reach, bool widens, unsigned threads) const
{
  std::vector<std::uint64_t> spread(bits_.size(), 0);
  parallelBlocks(tiles_.size(), 1, threads, [&](std::size_t t, std::size_t) {
    const Tile& tile = tiles_[t];
    const auto words = static_cast<std::size_t>(tile.words);
    for (std::uint32_t at = 0; at < tile_columns; ++at) {
      const auto own = static_cast<std::uint32_t>(t * tile_columns) + at;
      std::uint64_t* const result = spread.data() + tile.first + at * words;
      std::copy_n(wordsOf(own), words, result);
      for (const bool is_back : {false, true}) {
        std::uint32_t column = own;
        for (int step = 0; step < reach && column != none; ++step) {
          column = stepAlong(column, line, is_back);
          for (std::size_t w = 0; w < words; ++w) {
            const std::uint64_t other =
                column == none
                    ? 0
                    : wordFrom(column, tile.low + 64 * static_cast<std::int32_t>(w));
            result[w] = widens ? result[w] | other : result[w] & other;
          }
        }
      }
    }
  });
  return spread;
}

void
VoxelColumns::closeDots(int reach, unsigned threads)
{
  const int each_way = reach / 2;
  if (each_way == 0)
    return;
  const std::vector<std::uint64_t> seen = bits_;
  for (const bool widens : {true, false})
    for (const int axis : {0, 1})
      bits_ = spreadAlong(axis, each_way, widens, threads);
  for (std::size_t k = 0; k < bits_.size(); ++k)
    bits_[k] |= seen[k]; // at the rim of the tiles
}

void
VoxelColumns::closeHoles(int reach, unsigned threads)
{
  const std::vector<std::uint64_t> seen = bits_;
  std::vector<std::uint64_t> closed(bits_.size(), ~std::uint64_t{0});
  for (int line = 0; line < 4; ++line) {
    for (const bool widens : {true, false})
      bits_ = spreadAlong(line, reach / 2, widens, threads);
    for (std::size_t k = 0; k < bits_.size(); ++k)
      closed[k] &= bits_[k];
    bits_ = seen;
  }
  for (std::size_t k = 0; k < bits_.size(); ++k)
    bits_[k] |= closed[k];
}

} // namespace pcl::sedr
