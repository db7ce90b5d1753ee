// SPDX-License-Identifier: BSD-3-Clause
#include "ifc_parts.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl::sedr::ifc {
namespace {

/** @brief Returns by how much one turns on a flight, radians. */
double
turnOf(const PlanFlight& flight)
{
  double turn = 0;
  for (std::size_t k = 1; k + 1 < flight.steps(); ++k) {
    const Eigen::Vector2d a = flight.middle(k) - flight.middle(k - 1);
    const Eigen::Vector2d b = flight.middle(k + 1) - flight.middle(k);
    turn += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(turn);
}

/** @brief Returns the treads of a flight, each as thick as two steps are high.
 * @param ground height of the storey, metres */
StepRef
treadsOf(IfcDocument& document, const PlanFlight& flight, double ground)
{
  std::vector<StepRef> treads;
  for (std::size_t k = 0; k + 1 < flight.steps(); ++k) {
    const auto& front = flight.risers[k];
    const auto& back = flight.risers[k + 1];
    const double top = flight.bottom + flight.rise * static_cast<double>(k + 1);
    const double bottom = std::max(flight.bottom, top - 2 * flight.rise);
    treads.push_back(document.shapes
                         .extrusion(loopOf({front[1], back[1], back[0], front[0]}), {},
                                    bottom - ground, top - bottom)
                         .item);
    document.shapes.colour(treads.back(), "detail");
  }
  return document.shapes.product(
      {document.shapes.body(document.body_context, "SweptSolid", treads)});
}

} // namespace

void
writeStairs(IfcDocument& document)
{
  constexpr double straight = M_PI / 9;
  std::size_t number = 0;
  for (const PlanStair& stair : document.plan.stairs) {
    const auto room = std::find_if(
        document.rooms.begin(), document.rooms.end(), [&](const IfcRoom& r) {
          return r.room.id == stair.rooms[stair.rooms[0] == 0 ? 1 : 0];
        });
    if (stair.flights.empty() || room == document.rooms.end())
      continue;
    const std::string name = "stair_" + std::to_string(++number);
    const bool is_straight =
        stair.flights.size() == 1 && turnOf(stair.flights[0]) < straight;
    const StepRef whole = document.addElement(
        "IFCSTAIR", name, room->storey, document.placeIn(room->storey), {},
        {symbol(is_straight ? "STRAIGHT_RUN_STAIR" : "NOTDEFINED")});
    std::vector<StepRef> flights;
    for (const PlanFlight& flight : stair.flights) {
      const std::string part = name + "_flight_" + std::to_string(flights.size() + 1);
      const StepRef place = document.placeIn(room->storey);
      const double turn = turnOf(flight);
      flights.push_back(document.step.add(
          "IFCSTAIRFLIGHT",
          {document.guid(part), none, part, none, none, place,
           treadsOf(document, flight, document.groundOf(room->storey)), none,
           integer(flight.steps()), integer(flight.steps() - 1), flight.rise,
           flight.going(),
           symbol(turn < straight           ? "STRAIGHT"
                  : turn < 2 * M_PI * 3 / 4 ? "WINDER"
                                            : "SPIRAL")}));
    }
    document.relate("IFCRELAGGREGATES", "flights of " + name, whole, flights);
    ++document.model.stairs;
  }
}

} // namespace pcl::sedr::ifc
