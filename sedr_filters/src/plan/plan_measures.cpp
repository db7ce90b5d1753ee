// SPDX-License-Identifier: BSD-3-Clause
#include "../base/quantiles.h"
#include "../walls/plan_walls.h"
#include "plan_geometry.h"
#include "room_lookup.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::sedr {
namespace {

/** @brief Returns the volume of a room with tilted walls, by a million samples: columns
 * of air between floor and ceiling, cut by the sections of the walls at 100 heights. */
double
volumeBetweenTiltedWalls(const PlanRoom& room)
{
  constexpr std::size_t sections = 100;
  constexpr double max_columns = 1e4;
  const RoomLookup lookup(room);
  const Eigen::AlignedBox2d box = boundsOf(outermostBoundary(room));
  const double step = std::sqrt(box.volume() / max_columns);
  struct Column {
    Eigen::Vector2d at;
    double floor;
    double ceiling;
  };
  std::vector<Column> columns;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (double y = box.min().y() + step / 2; y < box.max().y(); y += step)
    for (double x = box.min().x() + step / 2; x < box.max().x(); x += step) {
      const Eigen::Vector2d p(x, y);
      if (std::any_of(room.columns.begin(), room.columns.end(),
                      [&](const PlanLoop& c) { return c.contains(p); }))
        continue;
      columns.push_back({p, lookup.floorAt(p), lookup.ceilingAt(p)});
      low = std::min(low, columns.back().floor);
      high = std::max(high, columns.back().ceiling);
    }
  const double height = (high - low) / sections;
  std::size_t count = 0;
  for (std::size_t k = 0; k < sections; ++k) {
    const double z = low + (static_cast<double>(k) + 0.5) * height;
    const PlanLoop section = boundaryAt(room, z);
    const LoopLookup walls(section);
    for (const Column& column : columns)
      count += z > column.floor && z < column.ceiling && walls.contains(column.at);
  }
  return static_cast<double>(count) * step * step * height;
}

} // namespace

ClearHeight
clearHeight(const PlanRoom& room)
{
  constexpr double usual_step = 0.05;
  constexpr double max_samples = 1e6;
  constexpr double rounding = 1e-6; // metres
  const Eigen::AlignedBox2d box = boundsOf(room.boundary);
  ClearHeight found;
  if (box.isEmpty())
    return found;
  const double step = std::max(usual_step, std::sqrt(box.volume() / max_samples));
  const RoomLookup lookup(room);
  std::vector<double> heights;
  for (double y = box.min().y() + step / 2; y < box.max().y(); y += step)
    for (double x = box.min().x() + step / 2; x < box.max().x(); x += step) {
      const Eigen::Vector2d p(x, y);
      if (!lookup.contains(p))
        continue;
      const double height = lookup.ceilingAt(p) - lookup.floorAt(p);
      if (heights.empty() || height < found.least) {
        found.least = height;
        found.lowest = p;
      }
      found.greatest = std::max(found.greatest, height);
      found.share_2_0 += height >= 2.0 - rounding ? 1 : 0;
      found.share_1_5 += height >= 1.5 - rounding ? 1 : 0;
      found.mean += height;
      heights.push_back(height);
    }
  if (heights.empty())
    return found;
  for (double* sum : {&found.mean, &found.share_2_0, &found.share_1_5})
    *sum /= static_cast<double>(heights.size());
  found.usual = middleValue(std::move(heights));
  return found;
}

double
volumeOf(const PlanRoom& room, double mean_height)
{
  double volume =
      isTilted(room) ? volumeBetweenTiltedWalls(room) : mean_height * room.area();
  for (const PlanNiche& niche : room.niches) {
    const Eigen::Vector2d somewhere = niche.boundary.elements.front().pointAt(0);
    volume += niche.boundary.area() *
              (niche.top.heightAt(somewhere) - niche.bottom.heightAt(somewhere));
  }
  return volume;
}

double
sillOf(const Floorplan& plan, const PlanOpening& opening)
{
  constexpr double inside = 0.05; // metres
  const Eigen::Vector2d way = (opening.end - opening.start).normalized();
  const Eigen::Vector2d left(-way.y(), way.x());
  for (const std::size_t side : {0U, 1U})
    if (const PlanRoom* const room = findRoom(plan, opening.rooms[side]))
      return opening.bottom -
             room->floorAt((opening.start + opening.end) / 2 +
                           (side == 0 ? 1 : -1) * (opening.depth / 2 + inside) * left);
  return 0;
}

std::vector<OpeningLeaf>
leavesOf(const PlanOpening& opening)
{
  std::vector<OpeningLeaf> leaves;
  const Eigen::Vector2d way = opening.end - opening.start;
  const double side = opening.swing == opening.rooms[0] ? 1 : -1;
  const Eigen::Vector2d into = side * Eigen::Vector2d(-way.y(), way.x());
  const Eigen::Vector2d face = opening.depth / 2 * into.normalized();
  const double share = opening.hinge == OpeningHinge::Both ? 0.5 : 1;
  if (opening.hinge == OpeningHinge::Start || opening.hinge == OpeningHinge::Both)
    leaves.push_back({opening.start + face, opening.start + face + share * way,
                      opening.start + face + share * into});
  if (opening.hinge == OpeningHinge::End || opening.hinge == OpeningHinge::Both)
    leaves.push_back({opening.end + face, opening.end + face - share * way,
                      opening.end + face + share * into});
  return leaves;
}

std::string
leafOf(const PlanOpening& opening)
{
  const std::vector<OpeningLeaf> leaves = leavesOf(opening);
  if (leaves.size() != 1)
    return leaves.empty() ? "" : "double";
  const Eigen::Vector2d way = leaves[0].open - leaves[0].hinge;
  const Eigen::Vector2d shut = leaves[0].shut - leaves[0].hinge;
  return way.x() * shut.y() < way.y() * shut.x() ? "left" : "right";
}

bool
isAt(const PlanOpening& opening,
     const Eigen::Vector2d& place,
     double bottom,
     double top)
{
  constexpr double beside = 0.5; // metres
  const Eigen::Vector2d way = (opening.end - opening.start).normalized();
  const Eigen::Vector2d off = place - opening.start;
  const double along = way.dot(off);
  return along > 0 && along < opening.width() &&
         std::abs(way.x() * off.y() - way.y() * off.x()) < beside &&
         bottom < opening.top && top > opening.bottom;
}

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
