// SPDX-License-Identifier: BSD-3-Clause
#include "../curves/plan_segment.h"

#include "../links/link_fit.h"
#include "../links/loop_chain.h"
#include "../links/loop_path_cost.h"
#include "../links/loop_runs.h"
#include "../links/loop_tangents.h"
#include "loop_revision.h"
#include "loop_unseen.h"
#include "sedr_filters/src/base/exactness.h"

#include "loop_fit.h"
#include "loop_lobes.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief The way a run's samples lead along its curve. */
LoopLink
linkOf(const Run& run, const std::vector<ContourSample>& samples)
{
  LoopLink link;
  link.curve = run.curve;
  link.is_known = run.is_known;
  double turn = 0;
  for (std::size_t k = 0; k < run.count; ++k) {
    const ContourSample& s = samples[(run.first + k) % samples.size()];
    turn += run.curve.isCircle() ? leftOf(s.position - run.curve.point).dot(s.tangent)
                                 : run.curve.direction.dot(s.tangent);
  }
  if (run.curve.isCircle())
    link.counter_clockwise = turn > 0;
  else if (turn < 0)
    link.curve.direction = -link.curve.direction;
  return link;
}

/** @brief Joins the runs to a closed chain. */
LoopChain
join(const std::vector<Run>& runs,
     const std::vector<ContourSample>& samples,
     const LoopParameters& parameters)
{
  std::vector<LoopLink> links;
  std::vector<Eigen::Vector2d> places;
  for (const Run& run : runs) {
    links.push_back(linkOf(run, samples));
    const std::size_t last = (run.first + samples.size() - 1) % samples.size();
    places.emplace_back((samples[last].position + samples[run.first].position) / 2);
  }
  if (runs.size() == 1)
    places[0] = samples[runs[0].first].position;
  return joinLinks(links, places, parameters);
}

/** @brief Whether no arc runs the wrong way round: nearly a whole turn to an end just
 * behind its start. */
bool
runsForward(const PlanLoop& loop)
{
  return std::none_of(loop.elements.begin(), loop.elements.end(),
                      [](const PlanElement& e) {
                        return e.isArc() && std::abs(e.sweep()) > 1.95 * M_PI &&
                               (e.start - e.end).norm() > 1e-9;
                      });
}

/** @brief Whether the loop is a sound outline of the contour: it does not cross itself,
 * and its area is that of the contour but for a rim. */
bool
isSound(const PlanLoop& loop, const Contour& contour, const LoopParameters& parameters)
{
  if (loop.elements.empty() || !runsForward(loop))
    return false;
  const std::vector<Eigen::Vector2d> polygon = loop.polygon(chord);
  if (polygon.size() < 3 || crossesItself(polygon))
    return false;
  const double area = signedArea(contour);
  const double rim = parameters.corner_reach * loop.length() + 0.01;
  return std::abs(loop.area() - area) < std::min(rim, 0.5 * std::abs(area) + 0.01) &&
         (loop.area() > 0) == (area > 0);
}

/** @brief The contour itself, its staircase evened out. */
PlanLoop
polygonLoop(const std::vector<ContourSample>& samples, double tolerance)
{
  std::vector<Eigen::Vector2d> places;
  for (const auto& s : samples)
    places.push_back(s.position);
  PlanLoop loop;
  const std::vector<Eigen::Vector2d> corners = simplified(places, tolerance);
  for (std::size_t i = 0; i < corners.size(); ++i)
    loop.elements.push_back(segment(corners[i], corners[(i + 1) % corners.size()]));
  return loop;
}

/** @brief The elements that an outline along some samples can follow, or that can
 * explain points beside it. */
std::vector<PlanElement>
elementsBeside(const std::vector<PlanElement>& elements,
               const std::vector<ContourSample>& samples,
               const LoopParameters& parameters)
{
  const double reach = corner_reaches * parameters.corner_reach;
  Eigen::AlignedBox2d box;
  for (const auto& s : samples)
    box.extend(s.place);
  std::vector<PlanElement> beside;
  for (const auto& e : elements)
    if (boxAround(e).exteriorDistance(box) <= reach &&
        std::any_of(samples.begin(), samples.end(), [&](const ContourSample& s) {
          return e.distance(s.place) <= reach;
        }))
      beside.push_back(e);
  return beside;
}

/** @brief The curves of some elements, each once. */
std::vector<PlanCurve>
curvesOf(const std::vector<PlanElement>& elements)
{
  std::vector<PlanCurve> curves;
  for (const auto& e : elements) {
    const auto runsAlong = [&](const PlanCurve& curve) {
      return curve.isCircle() == e.isArc() && curve.distance(e.start) < same_place &&
             curve.distance(e.pointAt(e.length() / 2)) < same_place &&
             curve.distance(e.end) < same_place;
    };
    if (std::any_of(curves.begin(), curves.end(), runsAlong))
      continue;
    curves.push_back(carrierOf(e));
  }
  return curves;
}

/** @brief A chain without the arcs that run nearly around their circle: the ends of a
 * short one have come out in the wrong order. */
LoopChain
withoutTurnedArcs(const LoopChain& chain, const LoopParameters& parameters)
{
  std::vector<LoopLink> links;
  std::vector<Eigen::Vector2d> places;
  bool was_turned = false;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const PlanElement e = chain.element(i);
    const bool is_turned = e.isArc() && std::abs(e.sweep()) > 1.5 * M_PI;
    if (!is_turned) {
      links.push_back(chain.links[i]);
      places.push_back(
          was_turned ? Eigen::Vector2d((chain.corners[chain.before(i)] + e.start) / 2)
                     : e.start);
    }
    was_turned = is_turned;
  }
  if (was_turned && !places.empty())
    places.front() = (chain.corners.back() + places.front()) / 2;
  return links.size() < 3 ? chain : joinLinks(links, places, parameters);
}

/** @brief Fits the links to the evidence and improves them by it, in turn. */
void
revise(LoopChain& chain,
       const std::vector<ContourSample>& samples,
       const PlanPoints& evidence,
       const std::vector<PlanElement>& others,
       const std::vector<PlanCurve>& known,
       bool is_of_room,
       const LoopParameters& parameters)
{
  if (chain.size() < 3)
    return;
  refitLinks(chain, evidence, parameters);
  const Guides guides{
      mainDirections(linesOf(chain, known, parameters.priors), parameters.priors),
      known};
  const PathCost cost(samples, evidence, guides.directions, others, noiseOf(chain),
                      parameters);
  reviseChain(chain, cost, evidence, guides, parameters);
  for (int round = 0; round < 2; ++round) {
    refitLinks(chain, evidence, parameters);
    alignShortLinks(chain, parameters.priors);
  }
  refitLinks(chain, evidence, parameters);
  if (is_of_room && chain.loop().area() > 0)
    squareUnseenLinks(chain, samples, evidence, parameters);
}

} // namespace

PlanLoop
fitLoop(const Contour& contour,
        const PlanPoints& evidence,
        const std::vector<PlanElement>& known,
        const LoopParameters& parameters,
        std::vector<ContourSample>* places)
{
  if (contour.size() < 4)
    return {};
  const std::vector<ContourSample> samples =
      sampleContour(contour, evidence, parameters);
  if (places)
    *places = samples;
  const std::vector<PlanElement> beside = elementsBeside(known, samples, parameters);
  const std::vector<PlanCurve> curves = curvesOf(beside);
  const std::vector<Run> runs = findRuns(samples, evidence, curves, parameters);
  if (!runs.empty()) {
    const LoopChain found = join(runs, samples, parameters);
    LoopChain revised = found;
    revise(revised, samples, evidence, beside, curves, known.empty(), parameters);
    for (LoopChain chain : {revised, withoutTurnedArcs(revised, parameters), found,
                            withoutTurnedArcs(found, parameters)}) {
      closeTangents(chain, parameters);
      PlanLoop loop = chain.loop();
      dropPoints(loop);
      cutLobes(loop, parameters.priors);
      if (isSound(loop, contour, parameters))
        return loop;
    }
  }
  for (const double tolerance : {parameters.tolerance, 0.0}) {
    const PlanLoop loop = polygonLoop(samples, tolerance);
    if (isSound(loop, contour, parameters))
      return loop;
  }
  PlanLoop staircase;
  const std::vector<Eigen::Vector2d> corners = simplified(contour, 1e-9);
  for (std::size_t i = 0; i < corners.size(); ++i)
    staircase.elements.push_back(
        segment(corners[i], corners[(i + 1) % corners.size()]));
  return staircase;
}

} // namespace pcl::sedr
