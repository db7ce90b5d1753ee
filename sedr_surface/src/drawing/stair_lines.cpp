// SPDX-License-Identifier: BSD-3-Clause
#include "plan_lines.h"

#include "sedr_filters/src/plan/plan_segment.h"

#define BOOST_ALLOW_DEPRECATED_HEADERS // Boost.Geometry includes one
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pcl::sedr {
namespace {

constexpr double dot = 0.04; ///< radius of the mark at a foot, metres

/** @brief A flight as a plan shows it, which looks down from where it cuts. */
struct ShownFlight {
  const PlanFlight* flight = nullptr;
  std::uint32_t room = 0;
  std::size_t below = 0; ///< number of its risers below the cut

  bool isCut() const { return below < flight->steps(); }

  /** @brief Returns the outline of its treads up to the middle of the one that is cut.
   */
  PlanLoop outline() const
  {
    PlanFlight part = *flight;
    part.risers.resize(isCut() ? below + 1 : below);
    if (isCut())
      for (std::size_t side = 0; side < 2; ++side)
        part.risers[below][side] =
            (part.risers[below - 1][side] + part.risers[below][side]) / 2;
    return loopOf(part.outline());
  }

  /** @brief Returns its treads from one on, and the line on which one walks, from a dot
   * at its foot to an arrow. It ends in two break lines where the plan cuts it. */
  std::vector<PlanElement> linesFrom(std::size_t first) const
  {
    const auto& risers = flight->risers;
    const std::size_t last = below - 1;
    std::vector<PlanElement> found;
    const auto add = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
      found.push_back(segment(from, to));
    };
    for (std::size_t k = first; k <= last; ++k)
      add(risers[k][0], risers[k][1]);
    for (std::size_t k = first; k < last; ++k) {
      add(risers[k][0], risers[k + 1][0]);
      add(risers[k][1], risers[k + 1][1]);
      add(flight->middle(k), flight->middle(k + 1));
    }
    if (first == 0) {
      add(flight->middle(0) + Eigen::Vector2d(dot, 0),
          flight->middle(0) + Eigen::Vector2d(dot, 0));
      found.back().centre = flight->middle(0);
      found.back().radius = dot;
    }
    if (last > first)
      for (const PlanElement& side :
           arrowHead(flight->middle(last - 1), flight->middle(last)))
        found.push_back(side);
    if (!isCut())
      return found;
    const auto along = [&](std::size_t side, double up) -> Eigen::Vector2d {
      return risers[last][side] + up * (risers[last + 1][side] - risers[last][side]);
    };
    for (const double up : {0.15, 0.4})
      add(along(0, up), along(1, up + 0.45));
    add(risers[last][0], along(0, 0.4));
    add(risers[last][1], along(1, 0.85));
    return found;
  }
};

} // namespace

std::array<PlanElement, 2>
arrowHead(const Eigen::Vector2d& from, const Eigen::Vector2d& tip)
{
  constexpr double length = 0.15; // metres
  const Eigen::Vector2d way = length * (tip - from).normalized();
  const Eigen::Vector2d left(-way.y() / 2, way.x() / 2);
  return {segment(tip - way + left, tip), segment(tip, tip - way - left)};
}

PlanLoop
stairwellOf(const PlanStair& stair)
{
  namespace geometry = boost::geometry;
  using Corner = geometry::model::d2::point_xy<double>;
  geometry::model::multi_point<Corner> ends;
  for (const PlanFlight& flight : stair.flights)
    for (const PlanFlight::Riser& riser : flight.risers)
      for (const Eigen::Vector2d& end : riser)
        ends.emplace_back(end.x(), end.y());
  geometry::model::polygon<Corner, false, false> hull;
  geometry::convex_hull(ends, hull);
  std::vector<Eigen::Vector2d> corners;
  for (const Corner& corner : hull.outer())
    corners.emplace_back(corner.x(), corner.y());
  return loopOf(corners);
}

void
addStairs(const Floorplan& plan, std::vector<PlanLine>& lines)
{
  constexpr double cut = 1.2;     // metres above its floor
  constexpr double beside = 0.03; // lines as near to a flight are part of it, metres
  std::vector<ShownFlight> shown;
  for (const PlanStair& stair : plan.stairs) {
    const bool is_up = findRoom(plan, stair.rooms[0]) != nullptr;
    if (!is_up && !findRoom(plan, stair.rooms[1]))
      continue;
    for (const PlanFlight& flight : stair.flights) {
      std::size_t below = 0;
      while (below < flight.steps() &&
             (!is_up || flight.bottom + flight.rise * static_cast<double>(below) <
                            stair.bottom + cut))
        ++below;
      if (below > 0 && flight.steps() > 1)
        shown.push_back({&flight, stair.rooms[is_up ? 0 : 1], below});
    }
  }
  std::stable_sort(shown.begin(), shown.end(),
                   [](const ShownFlight& a, const ShownFlight& b) {
                     return a.flight->bottom > b.flight->bottom;
                   });
  std::vector<PlanLoop> above;
  for (const ShownFlight& flight : shown) {
    const auto isSeen = [&](const Eigen::Vector2d& p) {
      return std::none_of(above.begin(), above.end(), [&](const PlanLoop& other) {
        return other.contains(p) || other.distance(p) < beside;
      });
    };
    std::size_t first = 0; // after the last tread that is hidden
    for (std::size_t k = 0; k + 1 < flight.below; ++k)
      if (!isSeen((flight.flight->middle(k) + flight.flight->middle(k + 1)) / 2))
        first = k + 1;
    for (const PlanElement& line : first + 1 < flight.below
                                       ? flight.linesFrom(first)
                                       : std::vector<PlanElement>())
      for (const PlanElement& part :
           partsWhere(line, [&](double s) { return isSeen(line.pointAt(s)); }))
        if (part.length() > beside)
          lines.push_back({part, PlanLayer::Stair, flight.room});
    above.push_back(flight.outline());
  }
}

} // namespace pcl::sedr
