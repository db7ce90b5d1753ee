// SPDX-License-Identifier: BSD-3-Clause
#include "air_gaps.h"

#include "air_labelling.h"
#include "hidden_air.h"
#include "veils.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Which gaps are air. Those with headroom are. Lower ones are the air above a
 * table, below a sloping roof or a beam, or the void within a slab: one labelling, see
 * AirLabelling, tells which go on from tall air below the same ceiling. The void within
 * a slab meets that of a room only where the ceiling was not seen.
 * @return 1 for each gap that is air, else 0. O(gaps) and a minimum cut. */
std::vector<std::uint8_t>
airOf(const AirGaps& gaps)
{
  const std::int32_t step = gaps.voxels(gaps.parameters().same_ceiling);
  std::vector<std::uint8_t> is_air(gaps.size(), 1);
  std::vector<std::size_t> place(gaps.size(), 0); // of a low gap
  std::vector<std::uint32_t> low;
  for (std::uint32_t g = 0; g < gaps.size(); ++g)
    if (!gaps.isTall(gaps[g])) {
      place[g] = low.size();
      low.push_back(g);
      is_air[g] = 0;
    }
  AirLabelling labelling(low.size(), gaps);
  for (const std::uint32_t g : low)
    for (int d = 0; d < 4; ++d) {
      const std::uint32_t o = gaps.link(g, d);
      if (o == AirGaps::none || std::abs(gaps[o].high - gaps[g].high) > step)
        labelling.addEnd(place[g]);
      else if (is_air[o] != 0)
        labelling.addKnown(place[g]);
      else
        labelling.addOther(place[g], place[o]);
    }
  const std::vector<std::uint8_t> is_added = labelling.solve();
  for (std::size_t k = 0; k < low.size(); ++k)
    is_air[low[k]] = is_added[k];
  return is_air;
}

constexpr std::size_t gaps_a_block = 16384;

/** @brief Voxels that two gaps have in common. */
std::int32_t
overlapOf(const AirGap& a, const AirGap& b)
{
  return std::min(a.high, b.high) - std::max(a.low, b.low);
}

} // namespace

AirGaps::AirGaps(const VoxelColumns& columns,
                 const VoxelColumns& seen,
                 const AirParameters& parameters,
                 const VoxelColumns* fine)
    : columns_(columns)
    , parameters_(parameters)
{
  findGaps();
  if (fine != nullptr)
    setGaps(withoutVeils(*this, *fine));
  followCeilings(seen);
  closeSlabs();
  std::vector<AirGap> all = hiddenAirOf(*this);
  all.insert(all.begin(), gaps_.begin(), gaps_.end());
  setGaps(std::move(all));
  linkGaps();
  gaps_ = withBothFaces(*this);
  linkGaps();
  keepAir();
}

void
AirGaps::findGaps()
{
  const std::size_t tiles = columns_.tiles();
  std::vector<std::vector<AirGap>> found(tiles);
  const int thinnest = voxels(parameters_.thinnest);
  parallelBlocks(tiles, 1, parameters_.threads, [&](std::size_t t, std::size_t) {
    const auto begin = static_cast<std::uint32_t>(t * VoxelColumns::tile_columns);
    for (std::uint32_t c = begin; c < begin + VoxelColumns::tile_columns; ++c) {
      bool has_floor = false;
      std::int32_t low = 0;
      columns_.forEachRun(c, [&](std::int32_t from, std::int32_t to) {
        if (has_floor && from - low >= thinnest)
          found[t].push_back({c, low, from, true, true});
        has_floor = true;
        low = to;
      });
    }
  });
  std::vector<AirGap> gaps;
  for (auto& of_tile : found)
    gaps.insert(gaps.end(), of_tile.begin(), of_tile.end());
  setGaps(std::move(gaps));
}

/** @brief Raises the gaps that end below a closed hole to the ceiling that was seen
 * above it, where that goes on from a gap beside. */
void
AirGaps::followCeilings(const VoxelColumns& seen)
{
  const int step = voxels(parameters_.same_ceiling);
  std::vector<std::int32_t> ceiling; // of each gap, the first seen voxel above
  std::vector<std::uint32_t> front;  // gaps that end at it
  for (std::uint32_t g = 0; g < gaps_.size(); ++g) {
    std::int32_t at = gaps_[g].high;
    const std::uint32_t column = gaps_[g].column;
    while (columns_.isOccupied(column, at) && !seen.isOccupied(column, at))
      ++at;
    ceiling.push_back(at);
    if (at == gaps_[g].high)
      front.push_back(g);
  }
  for (std::size_t k = 0; k < front.size(); ++k) {
    const AirGap from = gaps_[front[k]];
    for (int d = 0; d < 4; ++d) {
      const std::uint32_t column = columns_.neighbour(from.column, d);
      if (column == VoxelColumns::none)
        continue;
      for (std::uint32_t g = first_[column]; g < first_[column + 1]; ++g)
        if (gaps_[g].high < ceiling[g] && columns_.isOccupied(column, ceiling[g]) &&
            overlapOf(gaps_[g], from) > 0 && std::abs(ceiling[g] - from.high) <= step) {
          gaps_[g].high = ceiling[g];
          front.push_back(g);
        }
    }
  }
}

void
AirGaps::closeSlabs()
{
  for (std::size_t before = 0; before < gaps_.size();) { // once for each storey
    before = gaps_.size();
    setGaps(withHolesClosed(*this));
  }
}

void
AirGaps::setGaps(std::vector<AirGap> gaps)
{
  gaps_ = std::move(gaps);
  const auto isBefore = [](const AirGap& a, const AirGap& b) {
    return std::pair(a.column, a.low) < std::pair(b.column, b.low);
  };
  if (!std::is_sorted(gaps_.begin(), gaps_.end(), isBefore))
    std::stable_sort(gaps_.begin(), gaps_.end(), isBefore);
  first_.assign(columns_.size() + 1, 0);
  for (const AirGap& gap : gaps_)
    ++first_[gap.column + 1];
  for (std::size_t c = 1; c < first_.size(); ++c)
    first_[c] += first_[c - 1];
}

std::uint32_t
AirGaps::goingOnFrom(const AirGap& gap, std::uint32_t column) const
{
  if (column == VoxelColumns::none)
    return none;
  const int same = voxels(parameters_.same_surface);
  const int tall = voxels(parameters_.headroom);
  std::uint32_t best = none;
  std::pair<bool, std::int32_t> most(false, 0);
  for (std::uint32_t g = first_[column]; g < first_[column + 1]; ++g) {
    const std::int32_t common = overlapOf(gaps_[g], gap);
    const std::int32_t lower =
        std::min(gaps_[g].high - gaps_[g].low, gap.high - gap.low);
    const bool is_same_floor =
        common >= tall && std::abs(gaps_[g].low - gap.low) <= same;
    const std::pair here(is_same_floor, common);
    if (common > 0 && 2 * common >= lower && here > most) {
      most = here;
      best = g;
    }
  }
  return best;
}

double
AirGaps::occupiedShare(std::uint32_t column, std::int32_t low, std::int32_t high) const
{
  const std::int32_t step = std::max(1, voxels(columns_.cellSize() / 2));
  int occupied = 0;
  int steps = 0;
  for (std::int32_t at = low; at < high; at += step, ++steps)
    occupied +=
        columns_.countBetween(column, at, std::min(at + step, high)) > 0 ? 1 : 0;
  return steps == 0 ? 0 : static_cast<double>(occupied) / steps;
}

void
AirGaps::linkGaps()
{
  links_.assign(gaps_.size(), {none, none, none, none});
  const auto forAll = [&](const auto& visit) {
    parallelBlocks(gaps_.size(), gaps_a_block, parameters_.threads,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t g = begin; g < end; ++g)
                       visit(g);
                   });
  };
  forAll([&](std::size_t g) {
    for (int d = 0; d < 4; ++d)
      links_[g][static_cast<std::size_t>(d)] =
          goingOnFrom(gaps_[g], columns_.neighbour(gaps_[g].column, d));
  });
  const std::vector<Links> wanted = links_;
  forAll([&](std::size_t g) {
    for (std::size_t d = 0; d < 4; ++d)
      if (wanted[g][d] != none && wanted[wanted[g][d]][(d + 2) % 4] != g)
        links_[g][d] = none;
  });
}

bool
AirGaps::isDrop(std::size_t g, int d) const
{
  const std::uint32_t o = link(g, d);
  return o != none && isTall(gaps_[g]) && isTall(gaps_[o]) &&
         std::abs(gaps_[g].low - gaps_[o].low) > voxels(parameters_.highest_step);
}

std::uint32_t
AirGaps::climb(std::size_t g, int d) const
{
  const AirGap& gap = gaps_[g];
  if (link(g, d) != none || !isTall(gap))
    return none;
  const std::uint32_t next = goingOnFrom(gap, columns_.neighbour(gap.column, d));
  const std::uint32_t above = next == none ? none : link(next, (d + 2) % 4);
  return above == none || above < g ? none : next;
}

std::uint32_t
AirGaps::diagonal(std::size_t g, int d) const
{
  const int e = (d + 1) % 4;
  const std::uint32_t a = next(g, d);
  const std::uint32_t b = next(g, e);
  if (a == none || b == none)
    return none;
  const std::uint32_t corner = next(a, e);
  return corner == next(b, d) ? corner : none;
}

void
AirGaps::keepAir()
{
  const std::vector<std::uint8_t> is_air = airOf(*this);
  std::vector<AirGap> kept;
  for (std::size_t g = 0; g < gaps_.size(); ++g)
    if (is_air[g])
      kept.push_back(gaps_[g]);
  void_area_ = static_cast<double>(gaps_.size() - kept.size()) * columns_.cellSize() *
               columns_.cellSize();
  setGaps(std::move(kept));
  linkGaps();
}

} // namespace pcl::sedr
