// SPDX-License-Identifier: BSD-3-Clause
#include "plan_figures.h"

#include "largest_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr::benchmark {

namespace {

constexpr double same_place = 1e-6;   ///< metres; tolerance of equal curves in a scene
constexpr double sharp_corner = 0.17; ///< sine of the turning angle, about 10 degrees
constexpr double arc_reach = 0.1;     ///< metres from an arc to the plan's element

/** @brief A true line or arc: one or more consecutive elements of a loop on one curve.
 */
using Curve = std::vector<sim::Element>;

Eigen::Vector2d
eigen(const sim::Vec2& p)
{
  return {p.x, p.y};
}

/** @brief Returns the sine of the turning angle from one element to the next. */
double
turnBetween(const sim::Element& a, const sim::Element& b)
{
  return sim::cross(sim::rightNormalAt(a, sim::lengthOf(a)), sim::rightNormalAt(b, 0));
}

bool
continues(const sim::Element& a, const sim::Element& b)
{
  if ((a.bulge == 0) != (b.bulge == 0) || (a.bulge > 0) != (b.bulge > 0) ||
      std::abs(turnBetween(a, b)) > same_place)
    return false;
  return a.bulge == 0 ||
         std::abs(sim::arcOf(a).radius - sim::arcOf(b).radius) < same_place;
}

std::vector<Curve>
curvesOf(const sim::Loop& loop)
{
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const sim::Element element = sim::elementOf(loop, i);
    if (!curves.empty() && continues(curves.back().back(), element))
      curves.back().push_back(element);
    else
      curves.push_back({element});
  }
  if (curves.size() > 1 && continues(curves.back().back(), curves.front().front())) {
    curves.back().insert(curves.back().end(), curves.front().begin(),
                         curves.front().end());
    curves.erase(curves.begin());
  }
  return curves;
}

/** @brief Returns the number of corners; a loop of one curve is a circle. */
std::size_t
cornersAmong(std::size_t curves)
{
  return curves == 1 ? 0 : curves;
}

std::vector<const PlanElement*>
elementsOf(const PlanRoom& room)
{
  std::vector<const PlanElement*> elements;
  for (const PlanElement& e : room.boundary.elements)
    elements.push_back(&e);
  for (const PlanLoop& column : room.columns)
    for (const PlanElement& e : column.elements)
      elements.push_back(&e);
  return elements;
}

/** @brief Returns the relative error of an arc's radius; 1 if the plan has no arc. */
double
radiusErrorOf(const sim::Element& arc, const std::vector<const PlanElement*>& elements)
{
  const Eigen::Vector2d middle = eigen(sim::pointAt(arc, sim::lengthOf(arc) / 2));
  const double radius = sim::arcOf(arc).radius;
  double error = 1;
  for (const PlanElement* e : elements)
    if (e->isArc() && e->distance(middle) < arc_reach)
      error = std::min(error, std::abs(e->radius - radius) / radius);
  return error;
}

double
distanceOf(const Eigen::Vector2d& corner,
           const std::vector<const PlanElement*>& elements)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const PlanElement* e : elements)
    nearest = std::min(nearest, (e->start - corner).norm());
  return nearest;
}

/** @brief Sums over the loops of one pair of rooms. */
class PairFigures {
public:
  PairFigures(const PlanRoom& room, const sim::RoomTruth& truth, PlanFigures& figures)
      : elements_(elementsOf(room))
      , figures_(figures)
  {
    addTruth(truth.outline);
    for (const sim::Loop& column : truth.columns)
      addTruth(column);
    found_ = cornersAmong(room.boundary.elements.size());
    for (const PlanLoop& column : room.columns)
      found_ += cornersAmong(column.elements.size());
    note();
    keepLarger(figures.perimeter_error,
               std::abs(room.perimeter() - truth.perimeter) / truth.perimeter);
  }

private:
  void addTruth(const sim::Loop& loop)
  {
    const auto curves = curvesOf(loop);
    true_ += cornersAmong(curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const sim::Element& first = curves[i].front();
      const sim::Element& last = curves[(i + curves.size() - 1) % curves.size()].back();
      if (std::abs(turnBetween(last, first)) > sharp_corner)
        keepLarger(figures_.corner_distance_max,
                   distanceOf(eigen(first.start), elements_));
      if (first.bulge == 0)
        continue;
      ++arcs_true_;
      keepLarger(figures_.radius_error, radiusErrorOf(first, elements_));
    }
  }

  void note()
  {
    const auto add = [](std::optional<std::size_t>& sum, std::size_t n) {
      sum = sum.value_or(0) + n;
    };
    add(figures_.corners_true, true_);
    add(figures_.corners_found, found_);
    add(figures_.rooms_with_other_corners, true_ == found_ ? 0 : 1);
    add(figures_.arcs_true, arcs_true_);
    add(figures_.arcs_found, static_cast<std::size_t>(std::count_if(
                                 elements_.begin(), elements_.end(),
                                 [](const PlanElement* e) { return e->isArc(); })));
  }

  std::vector<const PlanElement*> elements_;
  PlanFigures& figures_;
  std::size_t true_ = 0;
  std::size_t found_ = 0;
  std::size_t arcs_true_ = 0;
};

} // namespace

PlanFigures
measurePlan(const Floorplan& plan, const std::vector<sim::RoomTruth>& truths)
{
  PlanFigures figures;
  for (const RoomPair& pair : matchRooms(plan, truths))
    PairFigures(plan.rooms[pair.found], truths[pair.truth], figures);
  return figures;
}

} // namespace pcl::sedr::benchmark
