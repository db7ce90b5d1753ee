// SPDX-License-Identifier: BSD-3-Clause
#include "ifc_bodies.h"

#include "../walls/wall_band.h"

#include "sedr_filters/src/base/quantiles.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_segmentation/src/curves/contour.h"
#include "step_file.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace pcl::sedr::ifc {
namespace {

constexpr double off = 0.02; ///< distance from a wall, which is located to millimetres

/** @brief Returns a place beside a face, inside its room. */
Eigen::Vector2d
insideAt(const PlanElement& element, double s)
{
  const auto [place, inward] = faceAt(element, std::clamp(s, 0.0, element.length()));
  return place + off * inward;
}

/** @brief The rooms on both sides of a wall, and places in them along it. */
struct Side {
  const PlanRoom* room = nullptr;
  const PlanElement* element = nullptr;
  bool slopes = false;
};

std::vector<Side>
sidesOf(const Floorplan& plan, const PlanWall& wall)
{
  std::vector<Side> sides;
  const auto add = [&](const WallFace& face) {
    const PlanRoom& room = plan.rooms[face.room];
    sides.push_back({&room, &elementOf(plan, face), hasSlopingCeiling(room)});
  };
  add(wall.face);
  if (wall.other)
    add(*wall.other);
  return sides;
}

/** @brief Returns the slab above a wall at a place, without soffits. */
const PlanSlab&
slabAbove(const Side& side, const Eigen::Vector2d& p)
{
  const PlanSlab& ceiling = side.room->ceilingSlab(side.room->detailAt(p));
  const PlanSlab& main = side.room->ceiling;
  return side.slopes || ceiling.heightAt(p) > main.heightAt(p) ? ceiling : main;
}

/** @brief Returns the heights of a wall by the rooms beside it. */
WallHeights
heightsOf(const Floorplan& plan, const PlanWall& wall)
{
  constexpr double step = 0.02;
  constexpr double level = 0.005;
  const std::vector<Side> sides = sidesOf(plan, wall);
  const auto n =
      static_cast<std::size_t>(std::clamp(wall.stretch.length() / step, 4.0, 500.0));
  WallHeights heights;
  std::vector<std::map<int, std::pair<std::size_t, double>>> floors(sides.size());
  bool slopes = false;
  for (std::size_t i = 0; i <= n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n);
    const double s = wall.stretch.from + share * wall.stretch.length();
    const Eigen::Vector2d on_face = faceAt(*sides[0].element, s).first;
    double top = -std::numeric_limits<double>::infinity();
    double floor = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const Side& side = sides[k];
      const double length = side.element->length();
      const double along =
          std::clamp(k == 0 ? s : side.element->project(on_face), 0.0, length);
      const Eigen::Vector2d p = faceAt(*side.element, along).first;
      // The slabs are looked up away from the walls at the ends of the face, too.
      const Eigen::Vector2d inside =
          insideAt(*side.element, std::clamp(along, off, std::max(length - off, off)));
      const int part = side.room->floorDetailAt(inside);
      const double ground = side.room->floorSlab(part).heightAt(p);
      auto& [places, lowest] = floors[k].try_emplace(part, 0, ground).first->second;
      ++places;
      lowest = std::min(lowest, ground);
      floor = std::min(floor, ground);
      slopes = slopes || side.slopes;
      top = std::max(top, slabAbove(side, inside).heightAt(p));
    }
    heights.tops.push_back({share, top});
    heights.surplus -=
        (top - floor) * (i == 0 || i == n ? 0.5 : 1) / static_cast<double>(n);
  }
  heights.bottom = std::numeric_limits<double>::infinity();
  for (const auto& of_side : floors)
    heights.bottom = std::min(
        heights.bottom, std::max_element(of_side.begin(), of_side.end(),
                                         [](const auto& one, const auto& other) {
                                           return one.second.first < other.second.first;
                                         })
                            ->second.second);
  const auto [low, high] = std::minmax_element(
      heights.tops.begin(), heights.tops.end(),
      [](const auto& one, const auto& other) { return one.height < other.height; });
  if (const double highest = high->height; !slopes || highest - low->height < level)
    heights.tops = {{0, highest}, {1, highest}};
  else {
    std::vector<Eigen::Vector2d> line;
    for (const WallHeights::Top& top : heights.tops)
      line.emplace_back(top.along, top.height);
    heights.tops.clear();
    for (const Eigen::Vector2d& top : simplifiedLine(line, 0.001))
      heights.tops.push_back({top.x(), top.y()});
  }
  heights.surplus += heights.mean();
  return heights;
}

/** @brief Returns the median height of a room's ceiling along the middle of a wall;
 * infinite where that is open to the ceiling of the wall's own room. */
double
ceilingInside(const Floorplan& plan, const PlanWall& wall, const PlanRoom& room)
{
  constexpr std::size_t samples = 9;
  std::vector<double> heights;
  for (std::size_t i = 0; i < samples; ++i) {
    const double along = (static_cast<double>(i) + 0.5) / samples;
    const auto [place, inward] = faceAt(
        elementOf(plan, wall.face), wall.stretch.from + wall.stretch.length() * along);
    const double height = room.ceilingAt(place - wall.thickness / 2 * inward);
    heights.push_back(height > openHeight(plan, wall.face, place)
                          ? std::numeric_limits<double>::infinity()
                          : height);
  }
  return middleValue(std::move(heights));
}

/** @brief Cuts a wall off at the ceilings of rooms below most of it and at the floors
 * of rooms above. */
void
endAtStoreys(const WallSite& site, WallHeights& heights)
{
  const PlanRoom& own = site.plan.rooms[site.wall.face.room];
  const RoomHeights own_heights = pcl::sedr::heightsOf(own);
  const double middle = (own_heights.low + own_heights.high) / 2;
  const double half = site.band.boundary.area() / 2; // else only at a corner
  for (const std::size_t r : site.near) {
    const PlanRoom& room = site.plan.rooms[r];
    const RoomHeights others = pcl::sedr::heightsOf(room);
    if (shareHeights(room, own) || commonArea(site.band, site.areaOf(room)) < half)
      continue;
    if (others.low < own_heights.low)
      heights.bottom =
          std::max(heights.bottom, ceilingInside(site.plan, site.wall, room));
    if (others.low > middle)
      for (WallHeights::Top& top : heights.tops)
        top.height = std::min(top.height, others.low);
  }
}

/** @brief Ends walls between two rooms where the wall of a room above or below one of
 * these stands in the same place, along half of them or more. */
void
endAtWallsOfOthers(std::vector<StandingWall>& walls)
{
  constexpr double near = 0.05; // metres
  for (auto& [site, heights] : walls) {
    const PlanWall& wall = site.wall;
    if (!wall.other)
      continue;
    const RoomHeights before = pcl::sedr::heightsOf(site.plan.rooms[wall.face.room]);
    const RoomHeights behind = pcl::sedr::heightsOf(site.plan.rooms[wall.other->room]);
    const double low = std::max(before.low, behind.low); // of what both rooms share
    const double high = std::min(before.high, behind.high);
    for (const auto& [other, others] : walls) {
      if (other.wall.other)
        continue;
      const PlanElement& face = elementOf(site.plan, other.wall.face);
      const Stretch& stretch = other.wall.stretch;
      Eigen::AlignedBox2d along;
      for (const double s : {stretch.from, stretch.from + stretch.length()})
        along.extend(site.frame.toLocal(faceAt(face, s).first));
      if (along.min().y() < -wall.thickness - near || along.max().y() > near ||
          std::min(along.max().x(), wall.stretch.length()) -
                  std::max(along.min().x(), 0.0) <
              wall.stretch.length() / 2)
        continue;
      if (others.bottom > high - near)
        for (WallHeights::Top& top : heights.tops)
          top.height = std::min(top.height, others.bottom);
      if (others.highest() < low + near)
        heights.bottom = std::max(heights.bottom, others.highest());
    }
  }
}

} // namespace

double
WallHeights::highest() const
{
  double height = -std::numeric_limits<double>::infinity();
  for (const Top& top : tops)
    height = std::max(height, top.height);
  return height;
}

double
WallHeights::mean() const
{
  double mean = -bottom;
  for (std::size_t k = 1; k < tops.size(); ++k)
    mean +=
        (tops[k].along - tops[k - 1].along) * (tops[k].height + tops[k - 1].height) / 2;
  return mean;
}

double
WallHeights::topAt(double along) const
{
  const auto next = std::find_if(tops.begin(), tops.end(),
                                 [&](const Top& t) { return t.along >= along; });
  if (next == tops.begin())
    return next->height;
  const Top& from = *std::prev(next);
  if (next == tops.end() || next->along <= from.along)
    return from.height;
  const double share = (along - from.along) / (next->along - from.along);
  return from.height + share * (next->height - from.height);
}

WallSite::WallSite(const Floorplan& of_plan,
                   const PlanWall& of_wall,
                   const std::vector<Eigen::AlignedBox2d>& boxes)
    : plan(of_plan)
    , wall(of_wall)
    , frame(frameOf(of_plan, of_wall))
    , band(bandOf(of_plan, of_wall))
{
  const Eigen::AlignedBox2d box = boundsOf(band.boundary);
  band.boundary = inFrame(band.boundary, frame);
  for (PlanLoop& hole : band.holes)
    hole = inFrame(hole, frame);
  for (std::size_t r = 0; r < boxes.size(); ++r)
    if (boxes[r].intersects(box))
      near.push_back(r);
}

PlanArea
WallSite::areaOf(const PlanRoom& room) const
{
  PlanArea area{inFrame(room.boundary, frame)};
  for (const PlanLoop& column : room.columns)
    area.holes.push_back(inFrame(column, frame));
  return area;
}

double
openHeight(const Floorplan& plan, const WallFace& face, const Eigen::Vector2d& p)
{
  constexpr double slab_edge = 0.25; // metres; less is no wall, but a roof's thickness
  constexpr double before = 0.01;
  const PlanElement& element = elementOf(plan, face);
  const auto [place, inward] = faceAt(element, element.project(p));
  return plan.rooms[face.room].ceilingAt(place + before * inward) - slab_edge;
}

std::vector<StandingWall>
standingWalls(const Floorplan& plan, const std::vector<PlanWall>& walls)
{
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const PlanRoom& room : plan.rooms)
    boxes.push_back(boundsOf(room.boundary));
  std::vector<StandingWall> standing;
  for (const PlanWall& wall : walls) {
    standing.push_back({WallSite(plan, wall, boxes), heightsOf(plan, wall)});
    endAtStoreys(standing.back().site, standing.back().heights);
  }
  endAtWallsOfOthers(standing);
  return standing;
}

} // namespace pcl::sedr::ifc
