// SPDX-License-Identifier: BSD-3-Clause
#include "weighted_values.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl::sedr {

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

/** @brief Uses quickselect on the weights. O(n). */
double
quantileOf(std::vector<Weighted> values, double share)
{
  const auto weigh = [](auto from, auto to) {
    return std::accumulate(
        from, to, 0.0, [](double sum, const Weighted& v) { return sum + v.weight; });
  };
  double wanted = share * weigh(values.begin(), values.end());
  auto from = values.begin();
  auto to = values.end();
  while (to - from > 1) {
    const auto middle = from + (to - from) / 2;
    std::nth_element(from, middle, to);
    const double below = weigh(from, middle);
    if (below >= wanted) {
      to = middle;
    }
    else {
      from = middle;
      wanted -= below;
    }
  }
  return from == to ? 0 : from->value;
}

double
medianOf(std::vector<Weighted> values)
{
  return quantileOf(std::move(values), 0.5);
}

} // namespace pcl::sedr
