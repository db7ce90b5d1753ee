// SPDX-License-Identifier: BSD-3-Clause
#include "shared_values.h"

#include "sedr_filters/src/grids/disjoint_sets.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Values that are one. */
struct ValueGroup {
  double mean = 0;
  double information = 0; ///< sum of the inverse variances
  double squares = 0;     ///< of the distances from the mean, in these
  std::size_t members = 1;
  std::size_t any = 0; ///< one of them
};

class ValueGroups {
public:
  ValueGroups(std::size_t values, double interval, double period)
      : interval_(interval)
      , period_(period)
      , log_factorials_(values + 1, 0)
      , sets_(values)
  {
    for (std::size_t k = 1; k <= values; ++k)
      log_factorials_[k] = log_factorials_[k - 1] + std::log(static_cast<double>(k));
  }

  void add(const ValueGroup& value)
  {
    if (!joinToBest(value, groups_.size()))
      groups_.push_back(value);
  }

  /** @brief Joins groups until none gains by it. */
  void join()
  {
    for (std::size_t a = 0; a < groups_.size();)
      if (joinToBest(groups_[a], a)) {
        groups_.erase(groups_.begin() + static_cast<std::ptrdiff_t>(a));
        a = 0;
      }
      else
        ++a;
  }

  std::size_t firstOf(std::size_t value) { return sets_.find(value); }

private:
  ValueGroup sum(const ValueGroup& a, const ValueGroup& b) const
  {
    const double off =
        period_ > 0 ? std::remainder(b.mean - a.mean, period_) : b.mean - a.mean;
    ValueGroup both = a;
    both.information += b.information;
    both.mean += off * b.information / both.information;
    both.squares +=
        b.squares + off * off * a.information * b.information / both.information;
    both.members += b.members;
    return both;
  }

  /** @brief Returns the log-evidence of a group, but for what depends on the variances
   * of its members alone. */
  double evidence(const ValueGroup& group) const
  {
    return log_factorials_[group.members - 1] - group.squares / 2 -
           std::log(interval_) + std::log(2 * M_PI / group.information) / 2;
  }

  /** @brief Joins a group to the one that gains most by it, not to itself.
   * @return false if none does */
  bool joinToBest(const ValueGroup& group, std::size_t own)
  {
    const double alone = evidence(group);
    std::size_t best = own;
    double most = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const double gain =
          g == own ? 0
                   : evidence(sum(groups_[g], group)) - evidence(groups_[g]) - alone;
      if (gain > most) {
        most = gain;
        best = g;
      }
    }
    if (best == own)
      return false;
    sets_.join(groups_[best].any, group.any);
    groups_[best] = sum(groups_[best], group);
    return true;
  }

  double interval_;
  double period_;
  std::vector<double> log_factorials_;
  std::vector<ValueGroup> groups_;
  DisjointSets<std::size_t> sets_; ///< of the values
};

} // namespace

std::vector<std::size_t>
shareValues(const std::vector<MeasuredValue>& values, double interval, double period)
{
  ValueGroups groups(values.size(), interval, period);
  for (std::size_t i = 0; i < values.size(); ++i)
    groups.add({values[i].value, 1 / values[i].variance, 0, 1, i});
  groups.join();
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < values.size(); ++i)
    first.push_back(groups.firstOf(i));
  return first;
}

} // namespace pcl::sedr
