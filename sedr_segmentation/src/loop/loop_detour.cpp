// SPDX-License-Identifier: BSD-3-Clause
#include "../links/loop_window.h"
#include "detour_lines.h"

#include "sedr_filters/src/base/exactness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace pcl::sedr {

namespace {

/** @brief Searches the cheapest way from the link before a window to the link after
 * it. Curve 0 is the link before, the last one the link after, and between them are
 * lines that may be followed on the way. */
class DetourSearch {
public:
  DetourSearch(const LoopChain& chain,
               const Window& window,
               const PathCost& cost,
               const PathCost::Zone& zone,
               const std::vector<LoopLink>& lines,
               const LoopParameters& parameters)
      : window_(window)
      , cost_(cost)
      , zone_(zone)
      , shortest_(parameters.priors.min_wall)
      , element_cost_(parameters.priors.element_cost)
  {
    curves_.push_back(chain.links[window.before]);
    curves_.insert(curves_.end(), lines.begin(), lines.end());
    curves_.push_back(chain.links[window.after]);
    findCorners(parameters);
    for (const auto& c : curves_) {
      zones_.push_back(cost.zoneOn(c.curve, zone));
      costs_on_.push_back(cost.pointCostsOn(c.curve, zone));
    }
    std::vector<double> least = cost.pointCosts({}, zone);
    for (const std::size_t i : {std::size_t{0}, curves_.size() - 1})
      takeLess(costs_on_[i], least);
    min_.assign(max_lines + 2, least);
    for (const auto& costs : costs_on_)
      takeLess(costs, least);
    floor_ = sumOf(least);
  }

  /** @brief Finds the cheapest way that costs less than `limit`. Not among points all
   * over the place, which are no walls.
   * @return whether there is one */
  bool run(double limit)
  {
    if (floor_ > 2 * (window_.radius + 1))
      return false;
    best_ = limit;
    trial_ = {0};
    best_trial_.clear();
    extend(0);
    return !best_trial_.empty();
  }

  /** @brief The lines of the way found. */
  std::vector<LoopLink> links() const
  {
    std::vector<LoopLink> result;
    for (std::size_t k = 1; k + 1 < best_trial_.size(); ++k) {
      LoopLink link = curves_[best_trial_[k]];
      if (link.curve.direction.dot(cornerAfter(k) - cornerAfter(k - 1)) < 0)
        link.curve.direction = -link.curve.direction;
      result.push_back(link);
    }
    return result;
  }

  /** @brief Where these lines and the link after them start. */
  std::vector<Eigen::Vector2d> corners() const
  {
    std::vector<Eigen::Vector2d> result;
    for (std::size_t k = 0; k + 1 < best_trial_.size(); ++k)
      result.push_back(cornerAfter(k));
    return result;
  }

private:
  static constexpr std::size_t max_lines = 3;

  /** @brief Lowers each cost to another where that is less. */
  static void takeLess(const std::vector<double>& other, std::vector<double>& costs)
  {
    for (std::size_t k = 0; k < costs.size(); ++k)
      costs[k] = std::min(costs[k], other[k]);
  }

  double sumOf(const std::vector<double>& costs) const
  {
    return std::accumulate(costs.begin(), costs.end(), 0.0) / zone_.density;
  }

  /** @brief What the points cost at least on the curves of the trial and one more. */
  double minWith(std::size_t more) const
  {
    const std::vector<double>& least = min_[trial_.size() - 1];
    const std::vector<double>& costs = costs_on_[more];
    double sum = 0;
    for (std::size_t k = 0; k < least.size(); ++k)
      sum += std::min(least[k], costs[k]);
    return sum / zone_.density;
  }

  struct Corner {
    bool exists = false;
    Eigen::Vector2d place;
  };

  void findCorners(LoopParameters parameters)
  {
    // findCorner() looks four times as far.
    parameters.corner_reach = window_.radius / 4;
    const std::size_t n = curves_.size();
    corners_.resize(n * n);
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (std::size_t j = 1; j < n; ++j) {
        Corner& c = corners_[i * n + j];
        const PlanCurve& a = curves_[i].curve;
        const PlanCurve& b = curves_[j].curve;
        const bool is_new = i > 0 || j + 1 < n;
        c.exists =
            i != j && findCorner(a, b, window_.middle, parameters, c.place) &&
            (!is_new ||
             std::abs(leftOf(a.tangentAt(c.place)).dot(b.tangentAt(c.place))) > 0.3);
      }
  }

  const Corner& corner(std::size_t i, std::size_t j) const
  {
    return corners_[i * curves_.size() + j];
  }

  Eigen::Vector2d cornerAfter(std::size_t k) const
  {
    return corner(best_trial_[k], best_trial_[k + 1]).place;
  }

  /** @brief The part of curve `i` between curves `h` and `j`. */
  PlanElement piece(std::size_t h, std::size_t i, std::size_t j) const
  {
    const std::size_t last = curves_.size() - 1;
    const Eigen::Vector2d start = i == 0 ? window_.lead_in.start : corner(h, i).place;
    const Eigen::Vector2d end = i == last ? window_.lead_out.end : corner(i, j).place;
    return LoopChain::elementBetween(curves_[i], start, end);
  }

  /** @brief Cost of that part; infinite where it would run backwards. */
  double pieceCost(std::size_t h, std::size_t i, std::size_t j)
  {
    const auto [it, is_new] = piece_costs_.try_emplace({h, i, j}, 0);
    if (!is_new)
      return it->second;
    const PlanElement e = piece(h, i, j);
    const bool is_line = i > 0 && i + 1 < curves_.size();
    const bool is_forward =
        is_line ? e.length() >= shortest_ : runsForward(curves_[i], e, same_corner);
    // A way with a piece that costs more than is left will not become the best.
    it->second = is_forward ? cost_.ofElement(e, zones_[i], best_ - floor_)
                            : std::numeric_limits<double>::infinity();
    return it->second;
  }

  /** @brief Goes on from the end of the trial in all ways; `spent`: what its elements
   * cost but for the last. */
  void extend(double spent)
  {
    const std::size_t last = curves_.size() - 1;
    const std::size_t i = trial_.back();
    const std::size_t h = trial_.size() > 1 ? trial_[trial_.size() - 2] : 0;
    for (std::size_t j = trial_.size() <= max_lines ? 1 : last; j <= last; ++j) {
      if (!corner(i, j).exists ||
          std::find(trial_.begin(), trial_.end(), j) != trial_.end())
        continue;
      // What this piece and those after it cost at least, and the points, where all
      // curves of the way are known.
      const double pieces = (j == last ? 2 : 3) * element_cost_;
      const bool is_known = j == last || trial_.size() == max_lines;
      if (floor_ + spent + pieces >= best_ ||
          (is_known && minWith(j) + spent + pieces >= best_))
        continue;
      const double so_far = spent + pieceCost(h, i, j);
      if (floor_ + so_far + pieces - element_cost_ >= best_)
        continue;
      trial_.push_back(j);
      if (j == last)
        finish(so_far + pieceCost(i, j, j));
      else {
        min_[trial_.size() - 1] = min_[trial_.size() - 2];
        takeLess(costs_on_[j], min_[trial_.size() - 1]);
        extend(so_far);
      }
      trial_.pop_back();
    }
  }

  void finish(double cost)
  {
    if (floor_ + cost >= best_)
      return;
    std::vector<PlanElement> path;
    for (std::size_t k = 0; k < trial_.size(); ++k)
      path.push_back(piece(k > 0 ? trial_[k - 1] : 0, trial_[k],
                           k + 1 < trial_.size() ? trial_[k + 1] : 0));
    cost += cost_.ofPoints(path, zone_, best_ - cost);
    if (cost >= best_)
      return;
    best_ = cost;
    best_trial_ = trial_;
  }

  const Window& window_;
  const PathCost& cost_;
  const PathCost::Zone& zone_;
  double shortest_;                   ///< element of a way, metres
  double element_cost_;               ///< least cost of one
  std::vector<PathCost::Zone> zones_; ///< of each curve, the points on it
  std::vector<LoopLink> curves_;
  std::vector<Corner> corners_; ///< of curves i and j at i * n + j
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, double> piece_costs_;
  std::vector<std::vector<double>> costs_on_; ///< of the points, on each curve
  std::vector<std::vector<double>> min_; ///< of the points, on the first of a trial
  double floor_ = 0;                     ///< what the points cost whatever the way
  double best_ = 0;
  std::vector<std::size_t> trial_;
  std::vector<std::size_t> best_trial_;
};

} // namespace

bool
tryDetour(LoopChain& chain,
          const Window& window,
          const PathCost& cost,
          const PathCost::Zone& zone,
          const Guides& guides,
          const LoopParameters& parameters)
{
  DetourSearch search(chain, window, cost, zone,
                      detourLines(chain, window, cost, zone, guides, parameters.priors),
                      parameters);
  return search.run(cost.of(window.path, zone) - minGain(parameters.priors)) &&
         replaceLinks(chain, window, search.links(), search.corners(), cost,
                      parameters.priors);
}

} // namespace pcl::sedr
