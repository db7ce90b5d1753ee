// SPDX-License-Identifier: BSD-3-Clause
#include "wall_body.h"

#include "../walls/wall_band.h"
#include "ifc_shapes.h"
#include "level_slab.h"

#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/plan/plan_bounds.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <iterator>
#include <limits>
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

/** @brief Removes tops on the line between their neighbours. */
std::vector<WallHeights::Top>
simplified(const std::vector<WallHeights::Top>& tops)
{
  constexpr double tolerance = 0.001;
  std::vector<WallHeights::Top> kept{tops.front()};
  for (std::size_t i = 1; i + 1 < tops.size(); ++i) {
    const WallHeights::Top& from = kept.back();
    const WallHeights::Top& to = tops[i + 1];
    const double share = (tops[i].along - from.along) / (to.along - from.along);
    if (std::abs(from.height + share * (to.height - from.height) - tops[i].height) >
        tolerance)
      kept.push_back(tops[i]);
  }
  kept.push_back(tops.back());
  return kept;
}

/** @brief Returns the band of a wall in its frame. */
PlanArea
localBandOf(const Floorplan& plan, const PlanWall& wall, const WallFrame& frame)
{
  PlanArea band = bandOf(plan, wall);
  band.boundary = inFrame(band.boundary, frame);
  for (PlanLoop& hole : band.holes)
    hole = inFrame(hole, frame);
  return band;
}

/** @brief Returns what a room takes of the plan, in a frame. */
PlanArea
areaOf(const PlanRoom& room, const WallFrame& frame)
{
  PlanArea area{inFrame(room.boundary, frame)};
  for (const PlanLoop& column : room.columns)
    area.holes.push_back(inFrame(column, frame));
  return area;
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
  double mean = 0;
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

WallHeights
heightsOf(const Floorplan& plan, const PlanWall& wall)
{
  constexpr double step = 0.02;
  constexpr double level = 0.005;
  const std::vector<Side> sides = sidesOf(plan, wall);
  const auto n =
      static_cast<std::size_t>(std::clamp(wall.stretch.length() / step, 4.0, 500.0));
  WallHeights heights;
  heights.bottom = std::numeric_limits<double>::infinity();
  double low = heights.bottom;
  bool slopes = false;
  for (std::size_t i = 0; i <= n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n);
    const double s = wall.stretch.from + share * wall.stretch.length();
    const Eigen::Vector2d on_face = faceAt(*sides[0].element, s).first;
    double top = -std::numeric_limits<double>::infinity();
    for (const Side& side : sides) {
      const double along = &side == &sides[0] ? s : side.element->project(on_face);
      const Eigen::Vector2d p = insideAt(*side.element, along);
      // The slab is looked up away from the walls at the ends of the face, too.
      const double last = std::max(side.element->length() - off, off);
      const PlanSlab& slab =
          slabAbove(side, insideAt(*side.element, std::clamp(along, off, last)));
      heights.bottom = std::min(heights.bottom, side.room->floorAt(p));
      slopes = slopes || side.slopes;
      top = std::max(top, slab.heightAt(p));
    }
    low = std::min(low, top);
    heights.tops.push_back({share, top});
  }
  const double high = heights.highest();
  if (!slopes || high - low < level)
    heights.tops = {{0, high}, {1, high}};
  else
    heights.tops = simplified(heights.tops);
  return heights;
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

WallSite::WallSite(const Floorplan& of_plan,
                   const PlanWall& of_wall,
                   const std::vector<Eigen::AlignedBox2d>& boxes)
    : plan(of_plan)
    , wall(of_wall)
    , frame(frameOf(of_plan, of_wall))
    , band(localBandOf(of_plan, of_wall, frame))
{
  const Eigen::AlignedBox2d local = boundsOf(band.boundary);
  Eigen::AlignedBox2d box;
  for (const auto corner :
       {local.BottomLeft, local.BottomRight, local.TopLeft, local.TopRight})
    box.extend(frame.toPlan(local.corner(corner)));
  for (std::size_t r = 0; r < boxes.size(); ++r)
    if (boxes[r].intersects(box))
      near.push_back(r);
}

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
    if (shareHeights(room, own) ||
        commonArea(site.band, areaOf(room, site.frame)) < half)
      continue;
    if (others.low < own_heights.low)
      heights.bottom =
          std::max(heights.bottom, ceilingInside(site.plan, site.wall, room));
    if (others.low > middle)
      for (WallHeights::Top& top : heights.tops)
        top.height = std::min(top.height, others.low);
  }
}

PlanArea
profileOf(const WallSite& site)
{
  constexpr double rounding = 1e-5; // square metres
  std::vector<PlanArea> areas;
  for (const std::size_t r : site.near) {
    const PlanRoom& room = site.plan.rooms[r];
    const PlanArea area = areaOf(room, site.frame);
    if (shareHeights(room, site.plan.rooms[site.wall.face.room]) &&
        commonArea(site.band, area) > rounding)
      areas.push_back(area);
  }
  return areas.empty() ? site.band : largestPartOutside(site.band, areas);
}

WallRuns
runsOf(const Floorplan& plan, const PlanWall& wall)
{
  const auto runOfFace = [&](const WallFace& face) {
    return face.loop > 0 ? 0 : std::tan(elementOf(plan, face).tilt);
  };
  if (elementOf(plan, wall.face).isArc())
    return {};
  const double near = runOfFace(wall.face);
  return {near, wall.other ? -runOfFace(*wall.other) : near};
}

TriangleMesh
meshOf(const Floorplan& plan,
       const PlanWall& wall,
       const WallHeights& heights,
       const WallRuns& runs,
       const PlanArea& profile)
{
  const PlanElement& element = elementOf(plan, wall.face);
  const WallFrame frame = frameOf(plan, wall);
  const double length = wall.stretch.length();
  // The top bends across the wall where it bends along it.
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> bends;
  for (std::size_t k = 1; k + 1 < heights.tops.size(); ++k) {
    constexpr double beyond = 0.01;
    const auto [place, inward] =
        faceAt(element, wall.stretch.from + heights.tops[k].along * length);
    bends.emplace_back(frame.toLocal(place + beyond * inward),
                       frame.toLocal(place - (2 * wall.thickness + beyond) * inward));
  }
  const TriangleMesh foot = triangulated(profile, bends);
  constexpr double min_height = 0.001;
  TriangleMesh mesh = prismOn(foot, allTriangles(foot), [&](const Eigen::Vector3d& p) {
    const double s =
        element.isArc() ? element.project(frame.toPlan(p.head<2>())) - wall.stretch.from
                        : p.x(); // stretches may go on beyond their element
    return std::max(heights.topAt(s / length) - heights.bottom, min_height);
  });
  for (Eigen::Vector3d& p : mesh.vertices) {
    const double across = std::clamp(-p.y() / wall.thickness, 0.0, 1.0);
    p.y() += ((1 - across) * runs.near + across * runs.far) * p.z();
  }
  return mesh;
}

} // namespace pcl::sedr::ifc
