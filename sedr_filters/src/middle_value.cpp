// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/middle_value.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl {
namespace sedr {

double
middleValue(std::vector<double> values)
{
  constexpr std::size_t bins = 1024;
  std::size_t rank = values.size() / 2; // among the values that are left
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double low = *least;
  const double scale = (bins - 1) / (*greatest - low);
  if (values.size() > 4 * bins && std::isnormal(scale)) {
    // Rises with the value, so that all values of a bin are below those of the next.
    const auto binOf = [&](double v) {
      return static_cast<std::size_t>((v - low) * scale);
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
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace sedr
} // namespace pcl
