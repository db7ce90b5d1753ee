// SPDX-License-Identifier: BSD-3-Clause
#include "weighted_values.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace sedr {

Interval
shortestHalf(std::vector<Weighted> values)
{
  std::sort(values.begin(), values.end());
  double all = 0;
  for (const auto& v : values)
    all += v.weight;
  Interval best;
  bool is_found = false;
  double sum = 0;
  for (std::size_t first = 0, last = 0; last < values.size(); ++last) {
    sum += values[last].weight;
    while (sum - values[first].weight >= all / 2)
      sum -= values[first++].weight;
    const double width = values[last].value - values[first].value;
    if (sum < all / 2 || (is_found && width >= best.width))
      continue;
    best = {(values[last].value + values[first].value) / 2, width};
    is_found = true;
  }
  return best;
}

double
quantileOf(std::vector<Weighted> values, double share)
{
  std::sort(values.begin(), values.end());
  double all = 0;
  for (const auto& v : values)
    all += v.weight;
  double sum = 0;
  for (const auto& v : values) {
    sum += v.weight;
    if (sum >= share * all)
      return v.value;
  }
  return 0;
}

double
medianOf(std::vector<Weighted> values)
{
  return quantileOf(std::move(values), 0.5);
}

} // namespace sedr
} // namespace pcl
