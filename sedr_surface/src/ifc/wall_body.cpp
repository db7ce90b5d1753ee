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

using Lines = std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>;

/** @brief Appends a line across a wall, in its frame.
 * @param along share of its length */
void
appendAcross(const Floorplan& plan, const PlanWall& wall, double along, Lines& lines)
{
  constexpr double beyond = 0.01;
  const WallFrame frame = frameOf(plan, wall);
  const auto [place, inward] = faceAt(
      elementOf(plan, wall.face), wall.stretch.from + along * wall.stretch.length());
  lines.emplace_back(frame.toLocal(place + beyond * inward),
                     frame.toLocal(place - (2 * wall.thickness + beyond) * inward));
}

/** @brief Returns the height of a wall above its bottom at a place in its frame. */
double
heightAt(const Floorplan& plan,
         const PlanWall& wall,
         const WallHeights& heights,
         const Eigen::Vector2d& p)
{
  constexpr double min_height = 0.001;
  const PlanElement& element = elementOf(plan, wall.face);
  const double s = element.isArc() ? element.project(frameOf(plan, wall).toPlan(p)) -
                                         wall.stretch.from
                                   : p.x(); // stretches may go on beyond their element
  return std::max(heights.topAt(s / wall.stretch.length()) - heights.bottom,
                  min_height);
}

/** @brief Returns the lines in plan between which the heights of a wall and its cuts
 * are linear: where its top bends or meets those of cuts, and the outlines of cuts. */
Lines
linesOf(const Floorplan& plan,
        const PlanWall& wall,
        const WallHeights& heights,
        const std::vector<WallCut>& cuts)
{
  Lines lines;
  for (const WallHeights::Top& top : heights.tops) // level beyond the first and last
    appendAcross(plan, wall, top.along, lines);
  for (const WallCut& cut : cuts) {
    const std::vector<Eigen::Vector2d> corners =
        cut.plan.polygon(SolidParameters().chord_tolerance);
    for (std::size_t k = 0; k < corners.size(); ++k)
      lines.emplace_back(corners[k], corners[(k + 1) % corners.size()]);
    const Eigen::Vector2d middle =
        frameOf(plan, wall).toPlan(boundsOf(cut.plan).center());
    for (const PlanSlab* slab : {&cut.bottom, &cut.top})
      for (std::size_t k = 1; k < heights.tops.size(); ++k) {
        const auto& [from, low] = heights.tops[k - 1];
        const auto& [to, high] = heights.tops[k];
        const double z = slab->heightAt(middle);
        if ((z - low) * (z - high) < 0)
          appendAcross(plan, wall, from + (z - low) / (high - low) * (to - from),
                       lines);
      }
  }
  return lines;
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
  else
    heights.tops = simplified(heights.tops);
  heights.surplus += heights.mean();
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
  const TriangleMesh foot = triangulated(profile, linesOf(plan, wall, heights, {}));
  TriangleMesh mesh = prismOn(foot, allTriangles(foot), [&](const Eigen::Vector3d& p) {
    return heightAt(plan, wall, heights, p.head<2>());
  });
  for (Eigen::Vector3d& p : mesh.vertices) {
    const double across = std::clamp(-p.y() / wall.thickness, 0.0, 1.0);
    p.y() += ((1 - across) * runs.near + across * runs.far) * p.z();
  }
  return mesh;
}

double
volumeOf(const Floorplan& plan,
         const PlanWall& wall,
         const WallHeights& heights,
         const WallRuns& runs,
         const PlanArea& profile,
         const std::vector<WallCut>& cuts)
{
  const WallFrame frame = frameOf(plan, wall);
  const double taper = (runs.far - runs.near) / wall.thickness;
  const auto solidBetween = [&](double low, double high) {
    return std::max(high - low, 0.0) * (1 - taper * (low + high) / 2);
  };
  // Metres of wall above a place; a taper makes it count less further up.
  const auto solidAt = [&](const Eigen::Vector2d& p,
                           const std::vector<const WallCut*>& open) {
    std::vector<std::pair<double, double>> spans;
    for (const WallCut* cut : open)
      spans.emplace_back(cut->bottom.heightAt(frame.toPlan(p)) - heights.bottom,
                         cut->top.heightAt(frame.toPlan(p)) - heights.bottom);
    std::sort(spans.begin(), spans.end());
    const double top = heightAt(plan, wall, heights, p);
    double end = 0;
    double solid = 0;
    for (const auto& [low, high] : spans) {
      solid += solidBetween(end, std::min(low, top));
      end = std::max(end, high);
    }
    return solid + solidBetween(end, top);
  };
  const TriangleMesh foot = triangulated(profile, linesOf(plan, wall, heights, cuts));
  double volume = 0;
  for (std::size_t t = 0; t < foot.triangles.size(); ++t) {
    const Eigen::Vector3d middle =
        (foot.corner(t, 0) + foot.corner(t, 1) + foot.corner(t, 2)) / 3;
    std::vector<const WallCut*> open;
    for (const WallCut& cut : cuts)
      if (cut.plan.contains(middle.head<2>()))
        open.push_back(&cut);
    for (const int k : {0, 1, 2})
      volume += foot.scaledNormal(t).norm() / 2 *
                solidAt(foot.corner(t, k).head<2>(), open) / 3;
  }
  return volume;
}

} // namespace pcl::sedr::ifc
