// SPDX-License-Identifier: BSD-3-Clause
#include "room_layers.h"

#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <optional>

namespace pcl::sedr {

namespace {

constexpr double step = 0.01;       ///< of the search for a room's boundary, metres
constexpr double most_beside = 0.4; ///< from a face of the wall to that boundary
constexpr double min_depth = 0.02;  ///< of a reveal, metres
constexpr double pane_depth = 0.05; ///< of one behind a pane that a room is drawn to
constexpr double on_slab = 0.06;    ///< distance from floor or ceiling of one on it

/** @brief An opening seen from a room: places along its wall and across it, from the
 * middle of the wall towards the room. */
class OpeningFrame {
public:
  OpeningFrame(const Floorplan& plan, const PlanOpening& opening, bool is_left)
      : from_(is_left ? opening.start : opening.end)
      , to_(is_left ? opening.end : opening.start)
  {
    for (const OpeningWall& wall : opening.walls)
      for (const PlanRoom& room : plan.rooms)
        if (room.id == wall.room && wall.element < room.boundary.elements.size() &&
            room.boundary.elements[wall.element].isArc())
          centre_ = room.boundary.elements[wall.element].centre;
  }

  Eigen::Vector2d across(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d way = (to_ - from_).normalized();
    const Eigen::Vector2d left = leftOf(way);
    if (!centre_)
      return left;
    const Eigen::Vector2d out = (p - *centre_).normalized();
    return out.dot(left) < 0 ? Eigen::Vector2d(-out) : out;
  }

  /** @param share of the width, 0 to 1 */
  Eigen::Vector2d at(double share, double off) const
  {
    Eigen::Vector2d p = from_ + share * (to_ - from_);
    if (centre_)
      p = *centre_ + (from_ - *centre_).norm() * (p - *centre_).normalized();
    return p + off * across(p);
  }

  /** @brief Returns the line along the wall at a distance from its middle. */
  PlanElement along(double off) const
  {
    PlanElement line = segment(at(0, off), at(1, off));
    if (centre_) {
      const Eigen::Vector2d a = line.start - *centre_;
      const Eigen::Vector2d b = line.end - *centre_;
      line.centre = *centre_;
      line.radius = a.norm();
      line.counter_clockwise = a.x() * b.y() > a.y() * b.x();
    }
    return line;
  }

  /** @brief Returns the loop between two distances, counter-clockwise; its first
   * element is the far end. */
  PlanLoop between(double far, double near) const
  {
    const PlanElement there = along(far);
    const PlanElement here = reversed({{along(near)}}).elements.front();
    return {
        {there, segment(there.end, here.start), here, segment(here.end, there.start)}};
  }

private:
  Eigen::Vector2d from_;
  Eigen::Vector2d to_;
  std::optional<Eigen::Vector2d> centre_; ///< of a curved wall
};

/** @brief Checks whether an opening is in another room at a distance from the middle of
 * its wall. */
bool
isInOtherRoom(const Floorplan& plan,
              const PlanRoom& own,
              const OpeningFrame& frame,
              double off)
{
  return std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& room) {
    return room.id != own.id && shareHeights(room, own) &&
           (room.contains(frame.at(0, off)) || room.contains(frame.at(0.5, off)) ||
            room.contains(frame.at(1, off)));
  });
}

/** @brief Returns the far end of an opening to the outside, before any other room. */
double
outerEnd(const Floorplan& plan,
         const PlanRoom& own,
         const OpeningFrame& frame,
         double depth)
{
  double far = -depth / 2;
  while (far < depth / 2 && isInOtherRoom(plan, own, frame, far))
    far += step;
  return far;
}

/** @brief A room beside an opening, and where it begins: distances from the middle of
 * the wall. */
struct RoomBeside {
  std::size_t room = 0;
  bool is_left = false;
  double nearest = 0;
  double farthest = 0;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
};

/** @brief Returns the bottom of an opening: the higher floor beside it if it stands on
 * that. */
PlanSlab
bottomOf(const Floorplan& plan,
         const PlanOpening& opening,
         const std::vector<RoomBeside>& beside)
{
  PlanSlab bottom = horizontalSlab(opening.bottom);
  double highest = opening.bottom - on_slab;
  for (const RoomBeside& side : beside) {
    const PlanRoom& room = plan.rooms[side.room];
    const PlanSlab& floor = room.floorSlab(room.floorDetailAt(side.place));
    const double height = floor.heightAt(side.place);
    if (height < highest || height > opening.bottom + on_slab || floor.curve)
      continue;
    highest = height;
    bottom = floor;
  }
  return bottom;
}

/** @brief Returns the top of an opening: an arch, the lower ceiling beside it if it
 * reaches that, or level. */
PlanSlab
topOf(const Floorplan& plan,
      const PlanOpening& opening,
      const OpeningFrame& frame,
      const std::vector<RoomBeside>& beside)
{
  PlanSlab top = horizontalSlab(opening.top);
  if (opening.rise > 0) {
    const double half = opening.width() / 2;
    const auto arch = std::make_shared<SlabCurve>();
    arch->centre = frame.at(0.5, 0);
    arch->axis = frame.across(arch->centre);
    arch->across = half;
    arch->up = opening.rise;
    if (opening.rise < half) // a part of a circle
      arch->across = arch->up =
          (half * half + opening.rise * opening.rise) / (2 * opening.rise);
    arch->base = opening.top - arch->up;
    top.plane[3] = -(opening.top - opening.rise / 2);
    top.curve = arch;
    return top;
  }
  double lowest = opening.top + on_slab;
  for (const RoomBeside& side : beside) {
    const PlanRoom& room = plan.rooms[side.room];
    const PlanSlab& ceiling = room.ceilingSlab(room.detailAt(side.place));
    const double height = ceiling.heightAt(side.place);
    if (height > lowest)
      continue;
    lowest = height;
    top = ceiling.curve ? horizontalSlab(height) : ceiling;
  }
  return top;
}

bool
isInTiltedWall(const PlanOpening& opening, const Floorplan& plan)
{
  return std::any_of(opening.walls.begin(), opening.walls.end(),
                     [&](const OpeningWall& wall) {
                       const PlanRoom* const room = findRoom(plan, wall.room);
                       return room && wall.element < room->boundary.elements.size() &&
                              room->boundary.elements[wall.element].tilt != 0;
                     });
}

/** @brief Returns the rooms that an opening leads to, if their boundary is near. */
std::vector<RoomBeside>
roomsBeside(const Floorplan& plan, const PlanOpening& opening)
{
  const double end = opening.depth / 2 + most_beside;
  std::vector<RoomBeside> beside;
  for (const std::size_t side : {0, 1})
    for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
      if (plan.rooms[r].id != opening.rooms[side])
        continue;
      const OpeningFrame frame(plan, opening, side == 0);
      RoomBeside found{r, side == 0, end, -end};
      for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        double off = -opening.depth / 2;
        while (off < end && !plan.rooms[r].contains(frame.at(share, off)))
          off += step;
        while (opening.leadsOutside() && off > -end &&
               plan.rooms[r].contains(frame.at(share, off - step)))
          off -= step; // the room is drawn to a pane
        if (off >= end)
          continue;
        found.nearest = std::min(found.nearest, off);
        found.farthest = std::max(found.farthest, off);
      }
      found.place = frame.at(0.5, found.farthest + step);
      if (found.nearest < end)
        beside.push_back(found);
    }
  return beside;
}

} // namespace

RevealedPlan::RevealedPlan(const Floorplan& plan)
    : rooms(plan.rooms)
    , is_open(plan.openings.size(), false)
{
  for (std::size_t k = 0; k < plan.openings.size(); ++k) {
    const PlanOpening& opening = plan.openings[k];
    if (isInTiltedWall(opening, plan) || opening.width() < min_depth ||
        opening.rise > opening.height())
      continue;
    std::vector<RoomBeside> beside = roomsBeside(plan, opening);
    // In the middle between two rooms: the plan's walls may be off the opening's line.
    const bool is_joined = beside.size() == 2;
    const double middle =
        is_joined ? (beside[0].nearest - beside[1].nearest) / 2 : 0; // to the left
    if (beside.empty())
      continue;
    const OpeningFrame first(plan, opening, beside.front().is_left);
    const PlanSlab bottom = bottomOf(plan, opening, beside);
    const PlanSlab top = topOf(plan, opening, first, beside);
    for (const RoomBeside& side : beside) {
      const PlanRoom& room = plan.rooms[side.room];
      const OpeningFrame frame(plan, opening, side.is_left);
      double far = is_joined ? (side.is_left ? middle : -middle)
                             : outerEnd(plan, room, frame, opening.depth);
      // A room that is drawn to the pane of a window ends there: the opening is cut
      // beyond it, but never into the room behind.
      const double pane = side.nearest - pane_depth;
      if (opening.leadsOutside() && side.nearest - far < min_depth &&
          side.nearest + most_beside > -opening.depth / 2 + step &&
          !isInOtherRoom(plan, room, frame, pane))
        far = pane;
      // The plan may have a niche as deep as the wall, or a room that goes on through
      // the opening.
      const bool is_through = side.nearest - far < min_depth;
      is_open[k] = is_joined
                       ? is_open[k] || (is_through && beside[0].room == beside[1].room)
                       : room.nicheAt(frame.at(0.5, far + step)) >= 0;
      if (is_open[k] || is_through)
        continue;
      reveals.push_back({k, side.room, rooms[side.room].niches.size(), is_joined});
      rooms[side.room].niches.push_back(
          {frame.between(far, side.farthest + 2 * step), bottom, top});
    }
  }
}

std::string
RevealedPlan::named(std::string text) const
{
  for (const OpeningReveal& reveal : reveals) {
    const std::string room = "room_" + std::to_string(rooms[reveal.room].id) + "_";
    const std::string niche = room + "niche_" + std::to_string(reveal.niche + 1) + "_";
    if (const std::size_t at = text.find(niche); at != std::string::npos)
      text.replace(at, niche.size(),
                   room + "opening_" + std::to_string(reveal.opening + 1) + "_");
  }
  return text;
}

} // namespace pcl::sedr
