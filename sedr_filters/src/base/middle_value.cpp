// SPDX-License-Identifier: BSD-3-Clause
#include "middle_value.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace pcl::sedr {

namespace {

constexpr std::size_t bins = 1024;
constexpr std::size_t fewest_for_bins = 65;

/** @brief Keeps the values in the bin of the one at `rank`, and updates the rank. */
void
keepBinOf(std::size_t& rank, std::vector<double>& values)
{
  double low = values.front();
  double high = low;
  for (const double v : values) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  const double scale = (bins - 1) / (high - low);
  if (!std::isnormal(scale))
    return;
  // Monotonic, so all values of a bin are below those of the next. The last bin is for
  // NaN, which must not index outside.
  const auto binOf = [&](double v) {
    return v <= high ? static_cast<std::size_t>((v - low) * scale) : bins;
  };
  std::array<std::uint32_t, bins + 1> count{};
  for (const double v : values)
    ++count[binOf(v)];
  std::size_t bin = 0;
  for (; rank >= count[bin]; ++bin)
    rank -= count[bin];
  values.erase(std::remove_if(values.begin(), values.end(),
                              [&](double v) { return binOf(v) != bin; }),
               values.end());
}

} // namespace

double
middleValue(std::vector<double> values)
{
  std::size_t rank = values.size() / 2; // among the remaining values
  if (values.size() >= fewest_for_bins)
    keepBinOf(rank, values);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace pcl::sedr
