// SPDX-License-Identifier: BSD-3-Clause
#include "wall_body.h"

#include "level_slab.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

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

/** @brief The ceiling above a wall: places along it, and the slabs there. */
struct SlabsAbove {
  struct Place {
    Eigen::Vector2d at;
    double height = 0;
  };

  std::vector<Place> places;
  std::vector<const PlanSlab*> slabs;
};

double
planeHeight(const Eigen::Vector4d& plane, const Eigen::Vector2d& p)
{
  return -(plane.head<2>().dot(p) + plane[3]) / plane[2];
}

/** @brief Returns the planes above a wall if its top is on the lowest of them
 * everywhere. */
std::vector<Eigen::Vector4d>
roofOf(const SlabsAbove& above)
{
  constexpr double tolerance = 0.005;
  std::vector<Eigen::Vector4d> planes;
  for (const PlanSlab* slab : above.slabs) {
    if (slab->curve)
      return {};
    const bool is_known =
        std::any_of(planes.begin(), planes.end(), [&](const Eigen::Vector4d& plane) {
          return plane.head<3>().dot(slab->plane.head<3>()) > 0.99999 &&
                 std::abs(planeHeight(plane, above.places.front().at) -
                          slab->heightAt(above.places.front().at)) < tolerance;
        });
    if (!is_known)
      planes.push_back(slab->plane);
  }
  constexpr double level = 1 - 1e-6; // cosine of 0.1 degrees
  if (planes.size() == 1 && planes[0][2] > level)
    return {};
  for (const SlabsAbove::Place& place : above.places) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector4d& plane : planes)
      lowest = std::min(lowest, planeHeight(plane, place.at));
    if (std::abs(lowest - place.height) > tolerance)
      return {};
  }
  return planes;
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
  SlabsAbove above;
  for (std::size_t i = 0; i <= n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n);
    const double s = wall.stretch.from + share * wall.stretch.length();
    const Eigen::Vector2d on_face = faceAt(*sides[0].element, s).first;
    double top = -std::numeric_limits<double>::infinity();
    SlabsAbove::Place place;
    const PlanSlab* highest = nullptr;
    for (const Side& side : sides) {
      const double along = &side == &sides[0] ? s : side.element->project(on_face);
      const Eigen::Vector2d p = insideAt(*side.element, along);
      // The slab is looked up away from the walls at the ends of the face, too.
      const double last = std::max(side.element->length() - off, off);
      const PlanSlab& slab =
          slabAbove(side, insideAt(*side.element, std::clamp(along, off, last)));
      heights.bottom = std::min(heights.bottom, side.room->floorAt(p));
      slopes = slopes || side.slopes;
      if (slab.heightAt(p) <= top)
        continue;
      top = slab.heightAt(p);
      place = {p, top};
      highest = &slab;
    }
    low = std::min(low, top);
    heights.tops.push_back({share, top});
    above.places.push_back(place);
    if (above.slabs.empty() || above.slabs.back() != highest)
      above.slabs.push_back(highest);
  }
  const double high = heights.highest();
  if (slopes)
    heights.roof = roofOf(above);
  if (!slopes || high - low < level)
    heights.tops = {{0, high}, {1, high}};
  else
    heights.tops = simplified(heights.tops);
  return heights;
}

double
heightAbove(const PlanArea& profile,
            const WallFrame& frame,
            const WallHeights& heights,
            double run)
{
  constexpr double above = 0.1;
  const Eigen::Vector2d shift(0, run * (heights.highest() - heights.bottom));
  double highest = heights.highest();
  for (const Eigen::Vector2d& corner : profile.boundary.polygon(0.01)) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector4d& plane : heights.roof)
      lowest =
          std::min(lowest, std::max(planeHeight(plane, frame.toPlan(corner)),
                                    planeHeight(plane, frame.toPlan(corner + shift))));
    highest = std::max(highest, lowest);
  }
  return highest + above;
}

} // namespace pcl::sedr::ifc
