// SPDX-License-Identifier: BSD-3-Clause
#include "loop_unseen.h"

#include "sedr_filters/src/base/exactness.h"

#include "../curves/main_directions.h"
#include "../links/link_fit.h"
#include "../links/link_replacement.h"
#include "../links/link_views.h"
#include "../links/loop_window.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

std::vector<Eigen::Vector2d>
directionsSeen(const LoopChain& chain,
               const std::vector<double>& shares,
               const Priors& priors)
{
  std::vector<DirectedLine> lines;
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (shares[i] >= priors.share_few && !chain.links[i].curve.isCircle())
      lines.push_back({chain.element(i).length(), chain.links[i].curve.direction});
  return mainDirections(std::move(lines), priors);
}

/** @brief Turns a line to the nearest of some directions; false where none is near. */
bool
turnTo(const std::vector<Eigen::Vector2d>& directions,
       double other_direction,
       PlanCurve& line)
{
  double nearest = other_direction;
  Eigen::Vector2d best = line.direction;
  for (const auto& d : directions) {
    const double turn =
        std::asin(std::min(1.0, std::abs(leftOf(d).dot(line.direction))));
    if (turn >= nearest)
      continue;
    nearest = turn;
    best = d.dot(line.direction) < 0 ? Eigen::Vector2d(-d) : d;
  }
  const bool is_found = nearest < other_direction;
  line.direction = best;
  return is_found;
}

/** @brief Those of some directions that a straight link beside another one has, or that
 * are square to it. */
std::vector<Eigen::Vector2d>
directionsBeside(const LoopChain& chain,
                 std::size_t i,
                 const std::vector<Eigen::Vector2d>& directions,
                 const Priors& priors)
{
  const double same = priors.same_direction;
  std::vector<Eigen::Vector2d> beside;
  for (const std::size_t k : {chain.before(i), chain.after(i)})
    for (const auto& d : directions)
      if (const PlanCurve& line = chain.links[k].curve;
          !line.isCircle() && std::min(std::abs(d.dot(line.direction)),
                                       std::abs(leftOf(d).dot(line.direction))) < same)
        beside.push_back(d);
  return beside;
}

/** @brief Shifts a line to where the contour beside an element reaches farthest
 * outwards, but for a few samples. */
void
shiftOutwards(const PlanElement& e,
              const std::vector<ContourSample>& samples,
              const LoopParameters& parameters,
              PlanCurve& line)
{
  const Priors& priors = parameters.priors;
  constexpr double few = 0.03;
  constexpr double min_cosine = 0.9;
  std::vector<double> outwards;
  const Eigen::Vector2d way = (e.end - e.start).normalized();
  for (const auto& s : samples) {
    const double along = (s.place - e.start).dot(way);
    if (along > 0 && along < e.length() && e.distance(s.place) < priors.max_wall &&
        s.tangent.dot(way) > min_cosine)
      outwards.push_back(leftOf(line.direction).dot(line.point - s.place));
  }
  if (outwards.empty())
    return;
  std::sort(outwards.begin(), outwards.end());
  const auto at =
      static_cast<std::size_t>((1 - few) * static_cast<double>(outwards.size() - 1));
  // Cells at a wall that is seen are its own; where it is not, they reach beyond it.
  line.point -= (outwards[at] + parameters.expected_offset) * leftOf(line.direction);
}

/** @brief The straight way between the corners of a link. */
LoopLink
chordOf(const LoopChain& chain, std::size_t i)
{
  LoopLink chord;
  chord.curve = lineThrough(chain.corners[i], chain.corners[chain.after(i)]);
  return chord;
}

/** @brief Puts a line in the place of a link and of a shorter one beside it that runs
 * alike, so that the line does not meet it, and is hardly seen.
 * @return the position of that one, which is left out; the number of links where there
 * is none */
std::size_t
putLineOverBoth(std::size_t i,
                const PlanCurve& line,
                const std::vector<double>& shares,
                const LoopParameters& parameters,
                LoopChain& chain)
{
  const double hardly = parameters.priors.share_half;
  const double alike = parameters.priors.other_direction;
  const double longest = chain.element(i).length() / 2;
  for (const std::size_t k : {chain.after(i), chain.before(i)}) {
    const PlanElement beside = chain.element(k);
    if (chain.size() < 5 || shares[k] >= hardly || beside.length() > longest ||
        sineBetween(line, chain.links[k].curve, beside.start) > alike)
      continue;
    const std::size_t between = k == chain.after(i) ? k : i; // the corner of both
    LoopChain joined = chain;
    joined.links.erase(joined.links.begin() + static_cast<std::ptrdiff_t>(k));
    joined.corners.erase(joined.corners.begin() + static_cast<std::ptrdiff_t>(between));
    if (k == chain.before(i) && i == 0) { // the link now starts where the last one did
      std::rotate(joined.corners.begin(), joined.corners.end() - 1,
                  joined.corners.end());
    }
    if (!putLine(k < i ? i - 1 : i, line, parameters, joined))
      continue;
    chain = std::move(joined);
    return k;
  }
  return chain.size();
}

/** @brief Root mean square distance of points from a curve. */
double
residualOf(const PlanCurve& curve, const std::vector<WeightedPoint>& points)
{
  double sum = 0;
  for (const WeightedPoint& p : points)
    sum += std::pow(curve.distance(p.position), 2);
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/** @brief Arcs of which less than half was seen become straight, where a line agrees as
 * well with that: they were bent by the edge of the ceiling. */
void
straightenArcs(const PlanPoints& evidence,
               const LoopParameters& parameters,
               LoopChain& chain)
{
  const Priors& priors = parameters.priors;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const LoopLink& link = chain.links[i];
    if (!link.curve.isCircle() || link.is_known ||
        !isSeenInPart(chain, i, evidence, parameters))
      continue;
    const std::vector<WeightedPoint> points =
        pointsAlong(chain, i, evidence, parameters);
    if (static_cast<double>(points.size()) < priors.min_points)
      continue;
    PlanCurve line = fitLine(points);
    const PlanElement e = chain.element(i);
    if (line.direction.dot(e.end - e.start) < 0)
      line.direction = -line.direction;
    if (residualOf(line, points) <=
        priors.clearly * residualOf(link.curve, points) + 2 * priors.unevenness)
      putLine(i, line, parameters, chain);
  }
}

/** @brief Leaves out the links beside one that are shorter than `min_length` and as
 * little seen: they lead to where the view ended.
 * @param[in,out] i the position of the link */
void
dropShortBeside(std::size_t& i,
                double min_length,
                const LoopParameters& parameters,
                std::vector<double>& shares,
                LoopChain& chain)
{
  for (const bool is_before : {true, false}) {
    const std::size_t k = is_before ? chain.before(i) : chain.after(i);
    if (chain.element(k).length() >= min_length ||
        shares[k] >= parameters.priors.share_few ||
        !dropLink(k, min_length, parameters, chain))
      continue;
    shares.erase(shares.begin() + static_cast<std::ptrdiff_t>(k));
    i -= k < i ? 1 : 0;
  }
}

/** @brief Mends an unseen link that runs along no wall, as the end of what can be seen
 * of a ceiling does: links beside it that are about square to each other meet; those
 * that run alike are joined by a line square to them.
 * @return whether it was left out */
bool
straightenOblique(std::size_t i,
                  const std::vector<ContourSample>& samples,
                  const LoopParameters& parameters,
                  LoopChain& chain)
{
  const Priors& priors = parameters.priors;
  const PlanElement e = chain.element(i);
  const Eigen::Vector2d middle = (e.start + e.end) / 2;
  const PlanCurve& before = chain.links[chain.before(i)].curve;
  const double sine = sineBetween(before, chain.links[chain.after(i)].curve, middle);
  if (sine >= 0.7) // square rather than alike
    return dropLink(i, priors.max_corner_depth, parameters, chain);
  if (sine > priors.other_direction)
    return false;
  PlanCurve line;
  line.direction = leftOf(before.tangentAt(middle));
  if (line.direction.dot(e.end - e.start) < 0)
    line.direction = -line.direction;
  line.point = middle;
  shiftOutwards(e, samples, parameters, line);
  putLine(i, line, parameters, chain);
  return false;
}

} // namespace

void
squareUnseenLinks(LoopChain& chain,
                  const std::vector<ContourSample>& samples,
                  const PlanPoints& evidence,
                  const LoopParameters& parameters)
{
  const Priors& priors = parameters.priors;
  const double min_length = 2 * priors.evidence_cell; // less is between what was seen
  if (chain.size() < 3)
    return;
  straightenArcs(evidence, parameters, chain);
  std::vector<double> shares = sharesSeen(chain, evidence, parameters);
  const std::vector<Eigen::Vector2d> directions = directionsSeen(chain, shares, priors);
  for (std::size_t i = 0; i < chain.size();) {
    const PlanElement e = chain.element(i);
    const bool is_unseen = shares[i] < priors.share_unseen;
    // The open leaf of a door, a curtain; the lintel of a window goes all along.
    const bool is_oblique = !is_unseen && shares[i] < priors.share_few &&
                            !chain.links[i].curve.isCircle() &&
                            isSeenInPart(chain, i, evidence, parameters);
    if (e.length() >= min_length && (is_unseen || is_oblique)) {
      if (chain.links[i].curve.isCircle())
        chain.links[i] = chordOf(chain, i);
      PlanCurve line = chain.links[i].curve;
      line.point = line.project((e.start + e.end) / 2);
      if (!turnTo(directionsBeside(chain, i, directions, priors),
                  priors.other_direction, line) &&
          !turnTo(directions, priors.other_direction, line)) {
        dropShortBeside(i, min_length, parameters, shares, chain);
        if (straightenOblique(i, samples, parameters, chain)) {
          shares.erase(shares.begin() + static_cast<std::ptrdiff_t>(i));
          continue;
        }
      }
      else if (is_unseen) {
        shiftOutwards(e, samples, parameters, line);
        if (!putLine(i, line, parameters, chain)) {
          const std::size_t count = chain.size();
          const std::size_t gone = putLineOverBoth(i, line, shares, parameters, chain);
          if (gone < count)
            shares.erase(shares.begin() + static_cast<std::ptrdiff_t>(gone));
          i -= gone < i ? 1 : 0;
        }
      }
    }
    ++i;
  }
}

} // namespace pcl::sedr
