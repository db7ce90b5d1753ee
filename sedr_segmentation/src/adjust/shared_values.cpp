// SPDX-License-Identifier: BSD-3-Clause
#include "shared_values.h"

#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Values that may be one: what is needed of them. */
struct ValueGroup {
  double mean = 0;
  double information = 0; ///< sum of the members' inverse variances
  double squares = 0;     ///< of their distances from the mean, in these
  std::size_t members = 0;
  double evidence = 0; ///< log-evidence, but for what depends on the variances of its
                       ///< members alone
};

class ValueGroups {
public:
  ValueGroups(const std::vector<MeasuredValue>& values, double interval, double period)
      : interval_(interval)
      , period_(period)
  {
    log_factorials_.push_back(0);
    for (const MeasuredValue& each : values) {
      values_.push_back({each.value, 1 / each.variance, 0, 1});
      setEvidence(values_.back());
      log_factorials_.push_back(log_factorials_.back() +
                                std::log(static_cast<double>(log_factorials_.size())));
    }
    of_.assign(values.size(), values.size());
  }

  std::vector<std::size_t> run()
  {
    bool is_moved = true; // values take turns until none gains, in a few rounds
    for (std::size_t round = 0; round < values_.size() && is_moved; ++round) {
      is_moved = false;
      for (std::size_t i = 0; i < values_.size(); ++i)
        is_moved = place(i) || is_moved;
      for (std::size_t a = 0; a < groups_.size(); ++a)
        is_moved = joinToBest(a) || is_moved;
      dropEmptyGroups();
    }
    std::vector<std::size_t> first(groups_.size(), values_.size());
    for (std::size_t i = values_.size(); i-- > 0;)
      first[of_[i]] = i;
    for (std::size_t& group : of_)
      group = first[group];
    return of_;
  }

private:
  double difference(double a, double b) const
  {
    return period_ > 0 ? std::remainder(a - b, period_) : a - b;
  }

  ValueGroup sum(const ValueGroup& a, const ValueGroup& b) const
  {
    ValueGroup both = a;
    const double off = difference(b.mean, a.mean);
    both.information += b.information;
    both.mean += off * b.information / both.information;
    both.squares +=
        b.squares + off * off * a.information * b.information / both.information;
    both.members += b.members;
    setEvidence(both);
    return both;
  }

  /** @brief Returns a group without one of its members. */
  ValueGroup rest(const ValueGroup& all, const ValueGroup& member) const
  {
    ValueGroup rest = all;
    rest.members -= 1;
    rest.information -= member.information;
    rest.mean -=
        difference(member.mean, all.mean) * member.information / rest.information;
    const double off = difference(member.mean, rest.mean);
    rest.squares -= off * off * member.information * rest.information / all.information;
    setEvidence(rest);
    return rest;
  }

  void setEvidence(ValueGroup& group) const
  {
    group.evidence = log_factorials_[group.members - 1] - group.squares / 2 -
                     std::log(interval_) + std::log(2 * M_PI / group.information) / 2;
  }

  double gain(const ValueGroup& a, const ValueGroup& b) const
  {
    return sum(a, b).evidence - a.evidence - b.evidence;
  }

  /** @brief Moves a value to the group that gains most, or to one of its own. */
  bool place(std::size_t i)
  {
    const ValueGroup& value = values_[i];
    const std::size_t old = of_[i];
    if (old < groups_.size())
      groups_[old] =
          groups_[old].members > 1 ? rest(groups_[old], value) : ValueGroup();
    std::size_t best =
        old < groups_.size() && groups_[old].members == 0 ? old : groups_.size();
    double most = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g)
      if (groups_[g].members > 0)
        if (const double gained = gain(groups_[g], value); gained > most) {
          most = gained;
          best = g;
        }
    if (best == groups_.size())
      groups_.emplace_back();
    groups_[best] = groups_[best].members > 0 ? sum(groups_[best], value) : value;
    of_[i] = best;
    return best != old;
  }

  bool joinToBest(std::size_t a)
  {
    std::size_t best = a;
    double most = 0;
    for (std::size_t b = 0; b < groups_.size() && groups_[a].members > 0; ++b)
      if (b != a && groups_[b].members > 0)
        if (const double gained = gain(groups_[a], groups_[b]); gained > most) {
          most = gained;
          best = b;
        }
    if (best == a)
      return false;
    groups_[best] = sum(groups_[best], groups_[a]);
    groups_[a] = ValueGroup();
    for (std::size_t& group : of_)
      group = group == a ? best : group;
    return true;
  }

  void dropEmptyGroups()
  {
    std::vector<std::size_t> numbers;
    std::vector<ValueGroup> groups;
    for (const ValueGroup& group : groups_) {
      numbers.push_back(groups.size());
      if (group.members > 0)
        groups.push_back(group);
    }
    for (std::size_t& group : of_)
      group = numbers[group];
    groups_ = std::move(groups);
  }

  double interval_;
  double period_;
  std::vector<double> log_factorials_;
  std::vector<ValueGroup> values_;
  std::vector<ValueGroup> groups_; ///< some without members
  std::vector<std::size_t> of_;    ///< group of each value
};

} // namespace

std::vector<std::size_t>
shareValues(const std::vector<MeasuredValue>& values, double interval, double period)
{
  return ValueGroups(values, interval, period).run();
}

} // namespace pcl::sedr
