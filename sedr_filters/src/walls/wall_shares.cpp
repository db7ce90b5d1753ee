// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>

namespace pcl::sedr {

WallShares&
WallShares::operator+=(const WallShares& other)
{
  const double sum = area + other.area;
  if (!(sum > 0))
    return *this;
  for (double WallShares::*share :
       {&WallShares::measured, &WallShares::inferred, &WallShares::unseen})
    this->*share = (area * this->*share + other.area * (other.*share)) / sum;
  area = sum;
  return *this;
}

WallShares
wallShares(const Floorplan& plan, const PlanRoom& room, std::size_t element)
{
  const PlanElement& wall = room.boundary.elements[element];
  const Eigen::Vector2d middle = wall.pointAt(wall.length() / 2);
  const double whole = wall.length() * (room.ceilingAt(middle) - room.floorAt(middle));
  WallShares shares;
  if (!wall.evidence.isKnown() || !(whole > 0))
    return shares;
  double open = 0;
  for (const PlanOpening& opening : plan.openings)
    for (const OpeningWall& in : opening.walls)
      if (in.room == room.id && in.element == element)
        open += opening.width() * opening.height() / whole;
  const double unseen = std::max(wall.evidence.opening - open, 0.0);
  const double sum = wall.evidence.seen + wall.evidence.hidden + unseen;
  if (!(sum > 0)) // an opening from end to end
    return shares;
  shares.area = whole * sum;
  shares.measured = wall.evidence.seen / sum;
  shares.inferred = wall.evidence.hidden / sum;
  shares.unseen = unseen / sum;
  return shares;
}

WallShares
wallShares(const Floorplan& plan, const PlanRoom& room)
{
  WallShares all;
  for (std::size_t e = 0; e < room.boundary.elements.size(); ++e)
    all += wallShares(plan, room, e);
  return all;
}

WallShares
wallShares(const Floorplan& plan)
{
  WallShares all;
  for (const PlanRoom& room : plan.rooms)
    all += wallShares(plan, room);
  return all;
}

} // namespace pcl::sedr
