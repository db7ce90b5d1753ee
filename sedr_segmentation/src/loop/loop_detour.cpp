// SPDX-License-Identifier: BSD-3-Clause
#include "../links/loop_window.h"

#include "sedr_filters/src/base/exactness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace pcl {
namespace sedr {

namespace {

/** @brief A point of a zone as seen across lines of a direction. */
struct CrossPoint {
  double offset; ///< to the left of the origin
  double cost;   ///< on the path as it is

  bool operator<(const CrossPoint& other) const { return offset < other.offset; }
};

/** @brief A line that may be followed, and what it might save. */
struct Proposal {
  LoopLink link;
  double unexplained; ///< cost of the points on it as it is
};

/** @brief The densest lines of a direction through the points, where the path as it is
 * leaves some of them unexplained. `points` are used up. */
void
appendLines(const Eigen::Vector2d& direction,
            std::vector<CrossPoint>& points,
            double tolerance,
            double density,
            const Priors& priors,
            std::vector<Proposal>& lines)
{
  const double min_length = priors.element_cost; // a shorter one cannot pay
  const double min_unexplained = minGain(priors);
  constexpr std::size_t max_lines = 5;
  const double width = tolerance / 2;
  std::sort(points.begin(), points.end());
  for (std::size_t k = 0; k < max_lines && !points.empty(); ++k) {
    auto best_first = points.begin();
    auto best_last = points.begin();
    for (auto first = points.begin(), last = first; last != points.end(); ++last) {
      while (last->offset - first->offset > width)
        ++first;
      if (last - first > best_last - best_first) {
        best_first = first;
        best_last = last;
      }
    }
    double sum = 0;
    double cost = 0;
    for (auto it = best_first; it <= best_last; ++it) {
      sum += it->offset;
      cost += it->cost;
    }
    const auto count = static_cast<double>(best_last - best_first + 1);
    if (count < min_length * density)
      return;
    const double offset = sum / count;
    if (cost >= min_unexplained * density) {
      LoopLink link;
      link.curve.direction = direction;
      link.curve.point = offset * leftOf(direction);
      link.keeps_direction = true;
      lines.push_back({link, cost});
    }
    // What is beside the line is its noise.
    points.erase(std::lower_bound(points.begin(), points.end(),
                                  CrossPoint{offset - tolerance, 0}),
                 std::upper_bound(points.begin(), points.end(),
                                  CrossPoint{offset + tolerance, 0}));
  }
}

/** @brief Adds a link turned about its middle into the nearest of the directions. */
void
appendAligned(const LoopLink& link,
              const PlanElement& e,
              const std::vector<Eigen::Vector2d>& directions,
              std::vector<LoopLink>& lines)
{
  constexpr double largest_turn = 0.6; // sine
  double least = largest_turn;
  LoopLink aligned = link;
  for (const auto& d : directions) {
    const double turn = std::abs(leftOf(d).dot(link.curve.direction));
    if (turn >= least)
      continue;
    least = turn;
    aligned.curve.direction = d;
  }
  aligned.curve.point = (e.start + e.end) / 2;
  aligned.keeps_direction = true;
  aligned.is_bridge = false;
  if (least > 0.001 && least < largest_turn)
    lines.push_back(aligned);
}

/** @brief Whether a known curve is that of a link of the window. */
bool
isFollowed(const PlanCurve& curve, const LoopChain& chain, const Window& window)
{
  const auto is = [&](std::size_t i) {
    return chain.links[i].is_known && chain.links[i].curve.point == curve.point;
  };
  return is(window.before) || is(window.after) ||
         std::any_of(window.inner.begin(), window.inner.end(), is);
}

/** @brief Lines that a way through a window may follow: along its points in the given
 * directions, and the lines it follows already. */
std::vector<LoopLink>
linesOf(const LoopChain& chain,
        const Window& window,
        const PathCost& cost,
        const PathCost::Zone& zone,
        const Guides& guides,
        const Priors& priors)
{
  constexpr std::size_t max_lines = 10;
  std::vector<Proposal> proposals;
  const std::vector<double> costs = cost.pointCosts(window.path, zone);
  for (const auto& direction : guides.directions) {
    std::vector<CrossPoint> points;
    for (std::size_t i = 0; i < zone.points.size(); ++i)
      points.push_back({zone.points[i].dot(leftOf(direction)), costs[i]});
    appendLines(direction, points, cost.tolerance(), zone.density, priors, proposals);
  }
  std::stable_sort(proposals.begin(), proposals.end(),
                   [](const Proposal& a, const Proposal& b) {
                     return a.unexplained > b.unexplained;
                   });
  std::vector<LoopLink> lines;
  for (std::size_t i = 0; i < std::min(max_lines, proposals.size()); ++i)
    lines.push_back(proposals[i].link);
  for (std::size_t k = 0; k < window.inner.size(); ++k) {
    const LoopLink& link = chain.links[window.inner[k]];
    if (link.curve.isCircle())
      continue;
    lines.push_back(link);
    if (!link.is_known)
      appendAligned(link, window.path[k + 1], guides.directions, lines);
  }
  for (const auto& curve : guides.known)
    if (!curve.isCircle() && curve.distance(window.middle) < window.radius &&
        !isFollowed(curve, chain, window)) {
      LoopLink link;
      link.curve = curve;
      link.is_known = true;
      lines.push_back(link);
    }
  return lines;
}

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
                      linesOf(chain, window, cost, zone, guides, parameters.priors),
                      parameters);
  return search.run(cost.of(window.path, zone) - minGain(parameters.priors)) &&
         replaceLinks(chain, window, search.links(), search.corners(), cost,
                      parameters.priors);
}

} // namespace sedr
} // namespace pcl
