// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"
#include "queries.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr::sim {

namespace {

/** @brief Returns the angle between two edges of the facets of a circle, radians. */
double
facetAngle(double radius)
{
  return std::sqrt(8.0 * kCurveTolerance / radius);
}

double
largestRadius(const SlabCurve& ellipsoid)
{
  return std::max({ellipsoid.along, ellipsoid.across, ellipsoid.up});
}

} // namespace

double
edgeRadius(double radius)
{
  constexpr double mean_share = 2.0 / 3.0; // mean deviation of a chord over its maximum
  return radius + mean_share * kCurveTolerance;
}

Loop
rimOf(const SlabCurve& ellipsoid, double share)
{
  const double step = facetAngle(largestRadius(ellipsoid));
  const double rays = std::ceil(2.0 * pi * std::sqrt(share) / step);
  std::vector<Vec2> rim;
  for (double ray = 0; ray < rays; ++ray) {
    const double angle = 2.0 * pi * ray / rays;
    rim.push_back(ellipsoid.centre +
                  share *
                      (ellipsoid.along * std::cos(angle) * ellipsoid.axis +
                       ellipsoid.across * std::sin(angle) * leftOf(ellipsoid.axis)));
  }
  return loopOf(rim);
}

namespace {

/** @brief Returns the creases of a vault: parallel to its axis. */
std::vector<Element>
creasesOfVault(const Loop& loop, const SlabCurve& curve)
{
  const Vec2 across = leftOf(curve.axis);
  Box2 bounds; // along and across the axis
  for (const Vec2& place : samplesAlong(loop)) {
    const Vec2 off = place - curve.centre;
    bounds.extend(Vec2(curve.axis.dot(off), across.dot(off)));
  }
  const double first = std::asin(std::max(-1.0, bounds.min().y() / curve.across));
  const double last = std::asin(std::min(1.0, bounds.max().y() / curve.across));
  const double count = std::ceil((last - first) / facetAngle(curve.across));
  std::vector<Element> creases;
  for (double k = 1; k < count; ++k) {
    const double out = curve.across * std::sin(first + (last - first) * k / count);
    const Vec2 middle = curve.centre + out * across;
    creases.push_back(segment(middle + bounds.min().x() * curve.axis,
                              middle + bounds.max().x() * curve.axis));
  }
  return creases;
}

/** @brief Returns the creases of a dome: rings, and rays to the corners of its rim. */
std::vector<Element>
creasesOfDome(const Loop& loop, const SlabCurve& curve)
{
  const auto angleOf = [&](const Vec2& off) { // from the top
    const Vec2 scaled(curve.axis.dot(off) / curve.along,
                      leftOf(curve.axis).dot(off) / curve.across);
    return std::asin(std::min(1.0, scaled.norm()));
  };
  double out = 0.0;
  for (const Element& side : loop.elements)
    out = std::max(out, angleOf(side.start - curve.centre));
  const double rings = std::ceil(out / facetAngle(largestRadius(curve)));
  const auto placeAt = [&](const Vec2& corner, double ring) {
    const Vec2 off = corner - curve.centre;
    const double angle = angleOf(off);
    return Vec2(curve.centre + std::sin(angle * ring / rings) / std::sin(angle) * off);
  };
  std::vector<Element> creases;
  for (const Element& side : loop.elements)
    for (double ring = 1; ring < rings; ++ring) {
      const Vec2 place = placeAt(side.start, ring);
      creases.push_back(segment(place, placeAt(side.end, ring)));
      creases.push_back(segment(place, placeAt(side.start, ring + 1)));
    }
  return creases;
}

} // namespace

std::vector<Element>
creasesOf(const PlanDetail& part)
{
  if (!part.slab.curve)
    return {};
  return part.slab.curve->kind == CurveKind::Cylinder
             ? creasesOfVault(part.boundary, *part.slab.curve)
             : creasesOfDome(part.boundary, *part.slab.curve);
}

std::vector<PlanDetail>
ribsOf(const Room& room, const RibFamily& family)
{
  const Vec2 along(std::cos(family.direction), std::sin(family.direction));
  const Vec2 across = leftOf(along);
  Box2 bounds; // along and across
  for (const Element& wall : room.boundary.elements)
    bounds.extend(Vec2(wall.start.dot(along), wall.start.dot(across)));
  const auto at = [&](double s, double t) { return Vec2(s * along + t * across); };
  const double start = bounds.min().x();
  const double end = bounds.max().x();
  const Slab underside = raised(room.ceiling, -family.depth);
  std::vector<PlanDetail> ribs;
  double low = bounds.min().y() + family.first.value_or(0.5 * family.spacing) -
               0.5 * family.width;
  for (; low + family.width <= bounds.max().y() + kSamePoint; low += family.spacing) {
    if (low < bounds.min().y() - kSamePoint)
      continue;
    const double high = low + family.width;
    ribs.push_back(
        {loopOf({at(start, low), at(end, low), at(end, high), at(start, high)}),
         {},
         underside});
  }
  return ribs;
}

namespace {

constexpr double kNear = 1e-3; ///< metres inside the room
constexpr double kParallel = 1e-6;

/** @brief A wall as a plane: inwards.dot(p) - run z = offset. */
struct Face {
  Element foot;         ///< at the floor
  std::size_t wall = 0; ///< of the room's outline
  double run = 0.0;     ///< tangent of the tilt
  Vec2 inwards = Vec2::Zero();
  double offset = 0.0;
  Vec2 head = Vec2::Zero(); ///< start of its upper edge, at the ceiling
};

/** @brief Tilts the walls of one room. */
class WallTilter {
public:
  explicit WallTilter(Room& room)
      : room_(room)
      , floor_(room.floor.heightAt(Vec2::Zero()))
  {}

  void run()
  {
    checkRoom();
    collectFaces();
    findHeads();
    replaceOutline();
  }

private:
  void checkRoom() const
  {
    const auto is_tilted = [this](const WallGap& gap) {
      return room_.boundary.elements[gap.wall].tilt != 0.0;
    };
    if (std::any_of(room_.openings.begin(), room_.openings.end(), is_tilted) ||
        std::any_of(room_.wall_niches.begin(), room_.wall_niches.end(), is_tilted))
      fail("a tilted wall has an opening or a niche");
    if (gradientOf(room_.floor).squaredNorm() > 0.0)
      fail("the floor is not level");
  }

  /** @brief Makes a face of every wall, and several of every tilted arc. */
  void collectFaces()
  {
    for (std::size_t wall = 0; wall < room_.boundary.elements.size(); ++wall) {
      const Element& element = room_.boundary.elements[wall];
      Face face{element, wall, std::tan(element.tilt)};
      std::vector<Vec2> corners{element.start};
      if (element.tilt != 0.0 && element.isArc()) {
        const double sweep = element.sweep();
        const auto count =
            static_cast<int>(std::ceil(std::abs(sweep) / facetAngle(element.radius)));
        const Vec2 first = (element.start - element.centre).normalized();
        for (int k = 1; k < count; ++k)
          corners.push_back(element.centre + edgeRadius(element.radius) *
                                                 rotated(first, sweep * k / count));
      }
      corners.push_back(element.end);
      for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        if (element.tilt != 0.0)
          face.foot = elementBetween(corners[i], corners[i + 1]);
        face.inwards = leftOf((corners[i + 1] - corners[i]).normalized());
        face.offset = face.inwards.dot(corners[i]) - face.run * floor_;
        faces_.push_back(face);
      }
    }
  }

  void findHeads()
  {
    const std::size_t n = faces_.size();
    for (std::size_t i = 0; i < n; ++i)
      faces_[i].head = headBetween(faces_[(i + n - 1) % n], faces_[i]);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 head = faces_[(i + 1) % n].head - faces_[i].head;
      const Vec2 foot = faces_[i].foot.end - faces_[i].foot.start;
      if (faces_[i].run != 0.0 && head.dot(foot) <= 0.0)
        fail("the head of wall ", faces_[i].wall, " has no length");
    }
  }

  /** @brief Returns where the corner between two walls meets the ceiling. */
  Vec2 headBetween(const Face& before, const Face& after) const
  {
    const Vec2& foot = after.foot.start;
    if (before.run == 0.0 && after.run == 0.0)
      return foot;
    // The corner runs along foot + way (z - floor).
    Vec2 way = before.run * before.inwards;
    const double turn = cross(before.inwards, after.inwards);
    if (std::abs(turn) > kParallel)
      way = (after.run * leftOf(before.inwards) - before.run * leftOf(after.inwards)) /
            turn;
    const Slab& top = ceilingBeside(after.run != 0.0 ? after : before, foot);
    const double climb = 1.0 - gradientOf(top).dot(way);
    return foot + (top.heightAt(foot) - floor_) / climb * way;
  }

  /** @brief Returns the ceiling inside of a tilted wall, near one end of its foot. */
  const Slab& ceilingBeside(const Face& face, const Vec2& end) const
  {
    const double s =
        (end - face.foot.start).norm() < kNear ? kNear : face.foot.length() - kNear;
    const Slab& top =
        room_.ceilingSlab(room_.detailAt(pointBeside(face.foot, s, -kNear)));
    if (top.curve)
      fail("the ceiling above a tilted wall is curved");
    return top;
  }

  /** @brief Makes the outline that of the whole area in plan; what lies between foot
   * and head of a wall becomes a part of the ceiling or, tilted out, of the floor. */
  void replaceOutline()
  {
    Loop outline;
    std::vector<std::size_t> moved(
        room_.boundary.elements.size()); // new number of each wall
    std::vector<PlanDetail> ceiling_parts;
    const auto add_corner = [&outline](const Vec2& end, const Element& shape) {
      const Vec2 start =
          outline.elements.empty() ? shape.start : outline.elements.back().end;
      if ((end - start).norm() <= 1e-9)
        return;
      outline.elements.push_back(shape);
      outline.elements.back().start = start;
      outline.elements.back().end = end;
    };
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Face& face = faces_[i];
      const Face& next = faces_[(i + 1) % faces_.size()];
      const bool tilts_out = face.run < 0.0;
      if (i == 0 || face.wall != faces_[i - 1].wall)
        moved[face.wall] = outline.elements.size();
      Element edge = face.foot;
      if (tilts_out)
        edge = elementBetween(face.head, next.head);
      const Vec2 after = next.run < 0.0 ? next.head : next.foot.start;
      add_corner(edge.end, edge);
      add_corner(after, elementBetween(edge.end, after));
      if (face.run != 0.0)
        (tilts_out ? room_.floor_details : ceiling_parts).push_back(partOf(face, next));
      room_.floor_walls += tilts_out ? 1 : 0;
    }
    room_.details.insert(room_.details.end(), ceiling_parts.begin(),
                         ceiling_parts.end());
    for (Opening& opening : room_.openings)
      opening.wall = moved[opening.wall];
    for (WallGap& niche : room_.wall_niches)
      niche.wall = moved[niche.wall];
    room_.foot = room_.boundary;
    room_.ceiling_walls = ceiling_parts.size();
    room_.boundary = outline;
  }

  PlanDetail partOf(const Face& face, const Face& next) const
  {
    const double slope = 1.0 / face.run;
    // The plane meets the floor exactly at the foot.
    return {loopOf({face.foot.start, face.foot.end, next.head, face.head}),
            {},
            planeThrough(lifted(face.foot.start, floor_), slope * face.inwards)};
  }

  Room& room_;
  const double floor_;
  std::vector<Face> faces_;
};

} // namespace

void
tiltWalls(Room& room)
{
  const auto& walls = room.boundary.elements;
  if (std::any_of(walls.begin(), walls.end(),
                  [](const Element& wall) { return wall.tilt != 0.0; }))
    WallTilter(room).run();
}

} // namespace pcl::sedr::sim
