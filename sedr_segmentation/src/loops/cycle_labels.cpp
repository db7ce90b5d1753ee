// SPDX-License-Identifier: BSD-3-Clause
#include "cycle_labels.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief The cheapest way around a cycle from one place back to it. */
class CycleWalk {
public:
  CycleWalk(const CycleCosts& costs, std::size_t start)
      : costs_(costs)
      , start_(start)
      , from_(costs.own.size())
      , sum_(costs.labels)
      , next_(costs.labels)
  {}

  /** @brief Walks from one candidate of the place, or from any.
   * @param[out] labels of the walk
   * @return its cost; the place itself counts once
   * @param[out] is_closed whether it ends with the candidate it began with */
  double
  walk(std::size_t first, bool any, std::vector<std::size_t>& labels, bool& is_closed)
  {
    const std::size_t n = costs_.places();
    const std::size_t k = costs_.labels;
    const double* const start_own = costs_.own.data() + start_ * k;
    for (std::size_t a = 0; a < k; ++a)
      sum_[a] = any || a == first ? start_own[a] : never;
    for (std::size_t q = 1; q <= n; ++q) {
      const std::size_t i = (start_ + q - 1) % n;
      const std::size_t j = (i + 1) % n;
      const double* const change = costs_.change.data() + i * k * k;
      const double* const own = costs_.own.data() + j * k;
      const double* const entry = costs_.entry.data() + j * k;
      std::fill(next_.begin(), next_.end(), never);
      for (std::size_t a = 0; a < k; ++a) {
        if (sum_[a] == never)
          continue;
        for (std::size_t b = 0; b < k; ++b) {
          const double step = change[a * k + b];
          const double cost = sum_[a] + step + (step > 0 ? entry[b] : 0);
          if (cost < next_[b]) {
            next_[b] = cost;
            from_[(q - 1) * k + b] = static_cast<std::uint8_t>(a);
          }
        }
      }
      for (std::size_t b = 0; q < n && b < k; ++b)
        next_[b] += own[b];
      sum_.swap(next_);
    }
    const std::size_t last =
        any ? static_cast<std::size_t>(std::min_element(sum_.begin(), sum_.end()) -
                                       sum_.begin())
            : first;
    std::size_t b = last;
    for (std::size_t q = n; q > 0; --q) {
      b = from_[(q - 1) * k + b];
      labels[(start_ + q - 1) % n] = b;
    }
    is_closed = b == last;
    return sum_[last];
  }

private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  const CycleCosts& costs_;
  std::size_t start_;
  std::vector<std::uint8_t> from_;
  std::vector<double> sum_;
  std::vector<double> next_;
};

} // namespace

std::vector<std::size_t>
cheapestCycle(const CycleCosts& costs)
{
  const std::size_t n = costs.places();
  std::vector<std::size_t> labels(n, 0);
  if (n == 0)
    return labels;
  bool is_closed = false;
  CycleWalk(costs, 0).walk(0, true, labels, is_closed);
  if (is_closed)
    return labels;
  const std::size_t middle = n / 2;
  const std::size_t first = labels[middle];
  CycleWalk(costs, middle).walk(first, false, labels, is_closed);
  return labels;
}

} // namespace pcl::sedr
