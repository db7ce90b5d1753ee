// SPDX-License-Identifier: BSD-3-Clause
#include "cycle_labels.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pcl::sedr {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr auto any = std::numeric_limits<std::size_t>::max();

/** @brief The cheapest way along a cycle from one place to another. */
class CycleWalk {
public:
  CycleWalk(const CycleCosts& costs, std::size_t start, std::size_t steps)
      : costs_(costs)
      , start_(start)
      , steps_(steps)
      , from_(1, 0)
  {
    for (std::size_t q = 1; q <= steps; ++q)
      from_.push_back(from_.back() + costs.candidates(placeAt(q)));
    back_.resize(from_.back());
  }

  /** @brief Walks from a candidate of the first place to one of the last, or from and
   * to any. What the last place itself costs is left out.
   * @param[out] labels of the places from the first on, before the last
   * @return the candidate of the last place */
  std::size_t
  walk(std::size_t first, std::size_t last, std::vector<std::size_t>& labels)
  {
    const std::size_t k = costs_.candidates(start_);
    std::vector<double> sum(k, never);
    for (std::size_t a = 0; a < k; ++a)
      if (first == any || a == first)
        sum[a] = costs_.own[costs_.first[start_] + a];
    std::vector<double> next;
    for (std::size_t q = 1; q <= steps_; ++q) {
      step(q, sum, next);
      sum.swap(next);
    }
    if (last == any)
      last = static_cast<std::size_t>(std::min_element(sum.begin(), sum.end()) -
                                      sum.begin());
    std::size_t b = last;
    for (std::size_t q = steps_; q > 0; --q) {
      b = back_[from_[q - 1] + b];
      labels[placeAt(q - 1)] = b;
    }
    return last;
  }

private:
  std::size_t placeAt(std::size_t q) const { return (start_ + q) % costs_.places(); }

  /** @brief Makes the q-th step. */
  void step(std::size_t q, const std::vector<double>& sum, std::vector<double>& next)
  {
    const std::size_t i = placeAt(q - 1);
    const std::size_t j = placeAt(q);
    const std::size_t k = costs_.candidates(j);
    const float* const change = costs_.change.data() + costs_.pairs[i];
    const double* const entry = costs_.entry.data() + costs_.first[j];
    std::uint8_t* const back = back_.data() + from_[q - 1];
    next.assign(k, never);
    for (std::size_t a = 0; a < sum.size(); ++a) {
      if (sum[a] == never)
        continue;
      for (std::size_t b = 0; b < k; ++b) {
        const double change_cost = static_cast<double>(change[a * k + b]);
        const double cost = sum[a] + change_cost + (change_cost > 0 ? entry[b] : 0);
        if (cost < next[b]) {
          next[b] = cost;
          back[b] = static_cast<std::uint8_t>(a);
        }
      }
    }
    for (std::size_t b = 0; q < steps_ && b < k; ++b)
      next[b] += costs_.own[costs_.first[j] + b];
  }

  const CycleCosts& costs_;
  std::size_t start_;
  std::size_t steps_;
  std::vector<std::size_t> from_; ///< first of each step in `back_`
  std::vector<std::uint8_t> back_;
};

} // namespace

std::vector<std::size_t>
cheapestCycle(const CycleCosts& costs)
{
  const std::size_t n = costs.places();
  std::vector<std::size_t> labels(n, 0);
  if (n == 0)
    return labels;
  if (CycleWalk(costs, 0, n).walk(any, any, labels) == labels[0])
    return labels;
  const std::size_t middle = n / 2;
  const std::size_t label = labels[middle];
  CycleWalk(costs, middle, n).walk(label, label, labels);
  return labels;
}

void
cheapestWay(const CycleCosts& costs,
            std::size_t from,
            std::size_t steps,
            std::vector<std::size_t>& labels)
{
  const std::size_t to = (from + steps) % costs.places();
  CycleWalk(costs, from, steps).walk(labels[from], labels[to], labels);
}

} // namespace pcl::sedr
