// SPDX-License-Identifier: BSD-3-Clause
#include "column_order.h"

#include "column_table.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace pcl::sedr {

ColumnTable::ColumnTable(const CellGrid& grid,
                         const CellBox& box,
                         const PointView& points,
                         const std::vector<int>& indices,
                         unsigned threads)
    : frame_(box)
{
  const auto columnOf = [&](Cell cell) {
    return frame_.isInside(cell) ? static_cast<std::uint32_t>(frame_.indexOf(cell))
                                 : no_column;
  };
  const ColumnOrder order(grid, points, indices, frame_.values().size(), columnOf,
                          threads);
  first_ = order.first();
  entries_ = order.sorted<Entry>(
      [&](std::size_t k, std::uint32_t) {
        return Entry{points[static_cast<std::size_t>(indices[k])].z(), indices[k]};
      },
      [](const Entry& a, const Entry& b) {
        return a.z != b.z ? a.z < b.z : a.index < b.index;
      });
}

bool
ColumnTable::hasWithin(Cell cell, double low, double high) const
{
  const Entry* const last = end(cell);
  const Entry* const it = std::lower_bound(
      begin(cell), last, low, [](const Entry& e, double z) { return e.z < z; });
  return it != last && it->z <= high;
}

namespace {

/** @brief A height bin of a profile, from the end of the bin below. */
struct Part {
  double end;
  bool is_occupied;
};

} // namespace

double
ColumnTable::share(Cell cell, double low, double high, int bins, int radius) const
{
  if (high <= low || bins <= 0)
    return 0;
  const auto parts = static_cast<std::size_t>(bins);
  constexpr std::size_t usual = 32;
  std::array<Part, usual> few;
  std::vector<Part> many;
  if (parts > usual)
    many.resize(parts);
  Part* const part = parts > usual ? many.data() : few.data();
  for (std::size_t b = 0; b < parts; ++b)
    part[b] = {low + (high - low) * static_cast<double>(b + 1) / bins, false};
  std::size_t empty = parts;
  const auto look = [&](Cell at) {
    const Entry* const last = end(at);
    const Entry* it = std::lower_bound(
        begin(at), last, low, [](const Entry& e, double z) { return e.z < z; });
    for (std::size_t b = 0; b < parts && it != last; ++b) {
      if (it->z <= part[b].end && !part[b].is_occupied) {
        part[b].is_occupied = true;
        --empty;
      }
      while (it != last && it->z < part[b].end)
        ++it;
    }
  };
  for (int dy = -radius; dy <= radius && empty > 0; ++dy)
    for (int dx = -radius; dx <= radius && empty > 0; ++dx)
      look({cell.x + dx, cell.y + dy});
  return static_cast<double>(parts - empty) / bins;
}

ColumnTable
ColumnTable::without(const CellMask& cells) const
{
  ColumnTable rest(box());
  rest.first_.reserve(first_.size());
  rest.first_.push_back(0);
  rest.entries_.reserve(entries_.size());
  for (std::size_t c = 0; c + 1 < first_.size(); ++c) {
    if (!cells.at(frame_.cellAt(c)))
      rest.entries_.insert(rest.entries_.end(), entries_.data() + first_[c],
                           entries_.data() + first_[c + 1]);
    rest.first_.push_back(rest.entries_.size());
  }
  return rest;
}

std::vector<int>
ColumnTable::indicesIn(const CellMask& cells) const
{
  std::vector<int> indices;
  for (std::size_t i = 0; i < cells.values().size(); ++i)
    if (cells.values()[i]) {
      const Cell cell = cells.cellAt(i);
      for (const Entry* e = begin(cell); e != end(cell); ++e)
        indices.push_back(e->index);
    }
  std::sort(indices.begin(), indices.end());
  return indices;
}

std::vector<ColumnRun>
ColumnTable::runs(Cell cell, double gap) const
{
  std::vector<ColumnRun> result;
  for (const Entry* e = begin(cell); e != end(cell); ++e) {
    if (result.empty() || e->z - result.back().high > gap)
      result.push_back({e->z, e->z});
    result.back().high = e->z;
  }
  return result;
}

} // namespace pcl::sedr
