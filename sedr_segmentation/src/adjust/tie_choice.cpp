// SPDX-License-Identifier: BSD-3-Clause
#include "plan_ties.h"
#include "shared_values.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::sedr {

namespace {

class TieChoice {
public:
  TieChoice(const PlanUnknowns& plan, const AdjustmentParameters& parameters)
      : plan_(plan)
      , parameters_(parameters)
  {}

  std::vector<PlanTie> run()
  {
    shareDirections();
    putOnLines();
    findTangents();
    levelSlabs();
    return ties_;
  }

private:
  /** @brief Adds a tie if the cost of its free values exceeds its contradiction.
   * @param interval logarithm of the interval of the free values */
  bool accept(const PlanTie& tie, double interval)
  {
    const TieOdds odds = oddsOf(tie, plan_.all);
    if (plan_.all[tie.a].is_kept || plan_.all[tie.b].is_kept ||
        !(odds.contradiction < interval + odds.sharpness))
      return false;
    ties_.push_back(tie);
    return true;
  }

  /** @brief Returns the unknowns of a kind, those with the most accurate parameter
   * first. */
  std::vector<std::size_t> ordered(UnknownKind kind, Eigen::Index parameter) const
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t u = 0; u < plan_.all.size(); ++u)
      if (plan_.all[u].kind == kind && !plan_.all[u].is_kept)
        order.emplace_back(plan_.all[u].information.inverse()(parameter, parameter), u);
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> numbers;
    for (const auto& entry : order)
      numbers.push_back(entry.second);
    return numbers;
  }

  /** @brief Ties unknowns whose values of a parameter are one to the first of them. */
  template <typename Value>
  void tieValues(const std::vector<std::size_t>& numbers,
                 Eigen::Index parameter,
                 double interval,
                 double period,
                 PlanTieKind kind,
                 const Value& value)
  {
    std::vector<MeasuredValue> values;
    for (const std::size_t u : numbers)
      values.push_back({value(plan_.all[u]),
                        plan_.all[u].information.inverse()(parameter, parameter)});
    const std::vector<std::size_t> first = shareValues(values, interval, period);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (first[i] != i)
        ties_.push_back({kind, numbers[first[i]], numbers[i]});
  }

  void shareDirections()
  {
    tieValues(ordered(UnknownKind::Line, 1), 1, parameters_.free_direction, M_PI / 2,
              PlanTieKind::Direction, [](const Unknown& u) {
                return std::atan2(u.direction.y(), u.direction.x());
              });
    direction_.resize(plan_.all.size());
    for (std::size_t u = 0; u < plan_.all.size(); ++u)
      direction_[u] = u;
    for (const PlanTie& tie : ties_)
      direction_[tie.b] = tie.a;
  }

  /** @brief Puts walls that face the same way, and lines within a room, on the line of
   * a near one. */
  void putOnLines()
  {
    using Place = std::pair<double, std::size_t>; // offset from the origin, and unknown
    std::map<std::pair<std::size_t, bool>, std::vector<Place>> parallels;
    for (const std::size_t u : ordered(UnknownKind::Line, 0)) {
      const Unknown& line = plan_.all[u];
      const Eigen::Vector2d way = plan_.all[direction_[u]].direction;
      const bool is_across = std::abs(way.dot(line.direction)) < M_SQRT1_2;
      const Eigen::Vector2d left = is_across ? way : leftOf(way);
      std::vector<Place>& others = parallels[{direction_[u], is_across}];
      const Place place{left.dot(line.point), u};
      const auto from = std::lower_bound(others.begin(), others.end(),
                                         Place{place.first - parameters_.reach, 0});
      std::size_t best = u;
      double most = 0;
      for (auto it = from;
           it != others.end() && it->first <= place.first + parameters_.reach; ++it) {
        if (!mayBeOneLine(it->second, u))
          continue;
        const TieOdds odds = oddsOf({PlanTieKind::OnLine, it->second, u}, plan_.all);
        const double gain =
            std::log(parameters_.free_offset) + odds.sharpness - odds.contradiction;
        if (gain <= most)
          continue;
        most = gain;
        best = it->second;
      }
      if (best != u)
        accept({PlanTieKind::OnLine, best, u}, std::log(parameters_.free_offset));
      others.insert(std::lower_bound(others.begin(), others.end(), place), place);
    }
  }

  bool mayBeOneLine(std::size_t number, std::size_t other) const
  {
    constexpr double max_interruption = 3; // of one wall, such as a passage, metres
    const Unknown& a = plan_.all[number];
    const Unknown& b = plan_.all[other];
    const bool face_alike = a.direction.dot(b.direction) > 0;
    if (!a.isSeen() || !b.isSeen() || (a.room != b.room && !(a.is_wall && b.is_wall)) ||
        (a.is_wall && b.is_wall && !face_alike))
      return false;
    return std::abs(a.direction.dot(b.point - a.point)) - a.half - b.half <=
           max_interruption;
  }

  void findTangents()
  {
    for (const UnknownLoop& loop : plan_.loops) {
      const auto& elements = loop.loop->elements;
      for (std::size_t i = 0; i < elements.size() && elements.size() > 1; ++i) {
        const std::size_t j = (i + 1) % elements.size();
        PlanTie tie{PlanTieKind::Tangent, loop.of_element[i], loop.of_element[j]};
        if (plan_.all[tie.b].kind == UnknownKind::Line)
          std::swap(tie.a, tie.b);
        const Unknown& a = plan_.all[tie.a];
        const Unknown& b = plan_.all[tie.b];
        const Eigen::Vector2d before = elements[i].normalAt(elements[i].length());
        const Eigen::Vector2d after = elements[j].normalAt(0);
        if (tie.a == tie.b || b.kind == UnknownKind::Line || a.is_kept || b.is_kept ||
            !(before.dot(after) > std::cos(parameters_.smooth_joint)))
          continue;
        tie.side = tangentSide(a, b);
        const double radius =
            a.kind == UnknownKind::Circle ? std::min(a.radius, b.radius) : b.radius;
        const double interval = radius * (1 - std::cos(parameters_.smooth_joint));
        if (!accept(tie, std::log(interval)) &&
            intersections(a.curve(), b.curve()).empty())
          ties_.push_back(tie); // else they would not meet
      }
    }
  }

  static int tangentSide(const Unknown& a, const Unknown& b)
  {
    if (a.kind == UnknownKind::Line)
      return leftOf(a.direction).dot(b.point - a.point) < 0 ? -1 : 1;
    return (a.point - b.point).norm() < std::max(a.radius, b.radius) ? 1 : -1;
  }

  /** @brief Levels slabs, makes details parallel to the main slab, and ties the heights
   * of level floors and those of level ceilings. */
  void levelSlabs()
  {
    std::vector<std::vector<std::size_t>> level(2); // ceilings, floors
    for (const UnknownSlab& s : plan_.slabs) {
      const Unknown& u = plan_.all[s.unknown];
      const double square = 2 * std::log(parameters_.free_slope);
      if (s.slab->curve)
        continue;
      if (accept({PlanTieKind::Level, s.unknown, s.unknown}, square)) {
        if (u.isSeen())
          level[s.is_floor ? 1 : 0].push_back(s.unknown);
      }
      else if (s.parent != s.unknown)
        accept({PlanTieKind::EqualSlope, s.parent, s.unknown}, square);
    }
    for (std::vector<std::size_t>& slabs : level) {
      std::stable_sort(slabs.begin(), slabs.end(), [&](std::size_t a, std::size_t b) {
        return plan_.all[a].information(0, 0) > plan_.all[b].information(0, 0);
      });
      tieValues(slabs, 0, parameters_.free_height, 0, PlanTieKind::EqualHeight,
                [](const Unknown& u) { return u.height; });
    }
  }

  const PlanUnknowns& plan_;
  const AdjustmentParameters& parameters_;
  std::vector<PlanTie> ties_;
  std::vector<std::size_t> direction_; ///< line that sets each line's direction
};

} // namespace

std::vector<PlanTie>
chooseTies(const PlanUnknowns& plan, const AdjustmentParameters& parameters)
{
  return TieChoice(plan, parameters).run();
}

} // namespace pcl::sedr
