// SPDX-License-Identifier: BSD-3-Clause
#include "column_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace pcl::sedr {

ColumnTable::ColumnTable(const CellGrid& grid,
                         const CellBox& box,
                         const PointView& points,
                         const std::vector<int>& indices)
    : frame_(box)
    , first_(frame_.values().size() + 1, 0)
{
  std::vector<std::pair<std::size_t, Entry>> all;
  for (const int i : indices) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (!std::isfinite(p.z()) || !grid.holds(p.x(), p.y()))
      continue;
    const Cell cell = grid.at(p.x(), p.y());
    if (!frame_.isInside(cell))
      continue;
    all.push_back({frame_.indexOf(cell), {p.z(), i}});
    ++first_[all.back().first + 1];
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first, a.second.z, a.second.index) <
           std::tie(b.first, b.second.z, b.second.index);
  });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  for (const auto& [cell, entry] : all)
    entries_.push_back(entry);
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
