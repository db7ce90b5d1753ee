// SPDX-License-Identifier: BSD-3-Clause
#include "height_windows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl::sedr {

namespace {

/** @brief Counts the cells of a range of candidates whose ends only increase. */
class CellsOfStretch {
public:
  CellsOfStretch(const std::vector<Candidate>& sorted, std::size_t cell_count)
      : sorted_(sorted)
      , points_in_(cell_count, 0)
  {}

  /** @brief Returns the number of cells of the candidates [first, last). */
  std::size_t count(std::size_t first, std::size_t last)
  {
    for (; first_ < std::min(first, last_); ++first_)
      occupied_ -= --points_in_[sorted_[first_].cell] == 0 ? 1 : 0;
    first_ = first;
    for (last_ = std::max(first, last_); last_ < last; ++last_)
      occupied_ += points_in_[sorted_[last_].cell]++ == 0 ? 1 : 0;
    return occupied_;
  }

private:
  const std::vector<Candidate>& sorted_;
  std::vector<std::uint32_t> points_in_; ///< of each cell
  std::size_t first_ = 0;
  std::size_t last_ = 0;
  std::size_t occupied_ = 0;
};

} // namespace

HeightWindow
densestWindow(const std::vector<Candidate>& sorted,
              double height,
              std::size_t cell_count,
              std::size_t fewer)
{
  HeightWindow best;
  best.cells = fewer;
  CellsOfStretch cells(sorted, cell_count);
  std::size_t first = 0;
  for (std::size_t last = 0; last < sorted.size(); ++last) {
    while (sorted[last].z - sorted[first].z > height)
      ++first;
    if (last + 1 - first <= best.cells) // cells cannot outnumber points
      continue;
    const std::size_t occupied = cells.count(first, last + 1);
    if (occupied > best.cells)
      best = {first, last + 1, occupied};
  }
  return best.last > 0 ? best : HeightWindow();
}

HeightHistogram
histogramOf(const std::vector<Candidate>& sorted,
            double bin_height,
            std::size_t cell_count)
{
  HeightHistogram histogram{bin_height, {}};
  std::vector<std::size_t> last_bin_of(cell_count, 0); // last bin of a cell, from 1
  for (std::size_t k = 0; k < sorted.size();) {
    const double bin = std::floor(sorted[k].z / bin_height);
    histogram.bins.push_back({bin * bin_height, 0});
    do {
      std::size_t& last = last_bin_of[sorted[k++].cell];
      histogram.bins.back().cells += last < histogram.bins.size() ? 1 : 0;
      last = histogram.bins.size();
    } while (k < sorted.size() && sorted[k].z / bin_height < bin + 1);
  }
  return histogram;
}

void
erase(std::vector<Candidate>& candidates, const std::vector<std::size_t>& positions)
{
  if (positions.empty())
    return;
  auto kept = candidates.begin() + static_cast<std::ptrdiff_t>(positions.front());
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const std::size_t next =
        k + 1 < positions.size() ? positions[k + 1] : candidates.size();
    kept = std::copy(candidates.begin() + static_cast<std::ptrdiff_t>(positions[k] + 1),
                     candidates.begin() + static_cast<std::ptrdiff_t>(next), kept);
  }
  candidates.erase(kept, candidates.end());
}

} // namespace pcl::sedr
