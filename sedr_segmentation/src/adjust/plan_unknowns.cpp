// SPDX-License-Identifier: BSD-3-Clause
#include "plan_unknowns.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

bool
isOn(const PlanElement& e, const Unknown& u)
{
  if (e.isArc())
    return u.kind == UnknownKind::Circle && (e.centre - u.point).norm() < same_place &&
           std::abs(e.radius - u.radius) < same_place;
  const PlanCurve line = u.curve();
  return u.kind == UnknownKind::Line && line.distance(e.start) < same_place &&
         line.distance(e.end) < same_place;
}

/** @brief Extends the part of a line in use by an element. */
void
extend(const PlanElement& e, Unknown& line)
{
  double low = -line.half;
  double high = line.half;
  for (const Eigen::Vector2d& p : {e.start, e.end}) {
    low = std::min(low, (p - line.point).dot(line.direction));
    high = std::max(high, (p - line.point).dot(line.direction));
  }
  line.point += (low + high) / 2 * line.direction;
  line.half = (high - low) / 2;
}

} // namespace

void
Unknown::move(const Eigen::Vector3d& step)
{
  if (kind == UnknownKind::Circle) {
    point += step.head<2>();
    radius += step[2];
  }
  else if (kind == UnknownKind::Plane) {
    height += step[0];
    slope += step.tail<2>();
  }
  else {
    const Eigen::Vector2d left = leftOf(direction);
    point += step[0] * left;
    direction = std::cos(step[1]) * direction + std::sin(step[1]) * left;
    run += step[2];
  }
}

void
Unknown::describeAt(double z)
{
  point += run * (z - height) * leftOf(direction);
  Eigen::Matrix3d before = Eigen::Matrix3d::Identity(); // steps there from steps here
  before(0, 2) = height - z;
  information = before.transpose() * information * before;
  height = z;
}

SurfaceAccuracy
Unknown::accuracyAt(const Eigen::Vector2d& place) const
{
  const Eigen::Vector3d by = row({place.x(), place.y(), height});
  return {std::sqrt(by.dot(covariance * by)), deviation};
}

PlanCurve
Unknown::curve() const
{
  PlanCurve curve;
  curve.point = point;
  curve.direction = direction;
  curve.radius = kind == UnknownKind::Circle ? radius : 0;
  return curve;
}

PlanUnknowns::PlanUnknowns(Floorplan& plan, const AdjustmentParameters& p)
    : parameters_(p)
{
  for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    addRoom(plan.rooms[r], r);
  describeBelowCeilings();
  for (Unknown& u : all)
    u.information = prior(u);
}

void
PlanUnknowns::addRoom(PlanRoom& room, std::size_t index)
{
  const std::size_t first = all.size();
  addLoop(room.boundary, index, first, true);
  loops.back().walls_of = &room;
  for (PlanLoop& column : room.columns)
    addLoop(column, index, first, true);
  for (auto* const details : {&room.details, &room.floor_details})
    for (PlanDetail& detail : *details) {
      addLoop(detail.boundary, index, first, false);
      for (PlanLoop& hole : detail.holes)
        addLoop(hole, index, first, false);
    }
  for (PlanNiche& niche : room.niches)
    addLoop(niche.boundary, index, first, false);

  const std::size_t ceiling = all.size();
  addSlab(room.ceiling, room.boundary, index, ceiling, false);
  for (PlanDetail& detail : room.details)
    addSlab(detail.slab, detail.boundary, index, ceiling, false);
  const std::size_t floor = all.size();
  addSlab(room.floor, room.boundary, index, floor, true);
  for (PlanDetail& detail : room.floor_details)
    addSlab(detail.slab, detail.boundary, index, floor, true);
  for (PlanNiche& niche : room.niches) {
    addSlab(niche.bottom, niche.boundary, index, floor, true);
    addSlab(niche.top, niche.boundary, index, ceiling, false);
  }
}

void
PlanUnknowns::addLoop(PlanLoop& loop, std::size_t room, std::size_t first, bool is_wall)
{
  UnknownLoop added;
  added.loop = &loop;
  added.room = room;
  for (const PlanElement& e : loop.elements) {
    added.of_element.push_back(unknownOf(e, first));
    Unknown& u = all[added.of_element.back()];
    u.is_wall = u.is_wall || is_wall;
    u.room = room;
  }
  loops.push_back(std::move(added));
}

std::size_t
PlanUnknowns::unknownOf(const PlanElement& e, std::size_t first)
{
  for (std::size_t k = first; k < all.size(); ++k)
    if (isOn(e, all[k])) {
      if (e.isArc())
        all[k].half = std::max(all[k].half, e.length() / 2);
      else
        extend(e, all[k]);
      return k;
    }
  Unknown u;
  u.kind = e.isArc() ? UnknownKind::Circle : UnknownKind::Line;
  u.point = e.isArc() ? e.centre : Eigen::Vector2d((e.start + e.end) / 2);
  u.radius = e.radius;
  u.half = e.length() / 2;
  if (!e.isArc() && u.half > 0)
    u.direction = (e.end - e.start).normalized();
  all.push_back(u);
  return all.size() - 1;
}

void
PlanUnknowns::addSlab(PlanSlab& slab,
                      const PlanLoop& loop,
                      std::size_t room,
                      std::size_t parent,
                      bool is_floor)
{
  Unknown u;
  u.kind = UnknownKind::Plane;
  u.room = room;
  const Eigen::AlignedBox2d box = boundsOf(loop);
  u.point = box.center();
  u.half = loop.length() > 0 ? std::abs(loop.area()) / loop.length() : 0;
  PlanSlab plane = slab;
  plane.curve = nullptr;
  u.height = plane.heightAt(u.point);
  u.slope = -slab.plane.head<2>() / slab.plane[2];
  slabs.push_back({&slab, all.size(), parent, is_floor});
  all.push_back(u);
}

/** @brief Describes straight walls where the plan was made: below the ceiling, whether
 * they tilt or not. */
void
PlanUnknowns::describeBelowCeilings()
{
  constexpr double below_ceiling = 0.25; // middle of the band that shows walls, metres
  for (const UnknownLoop& loop : loops)
    for (std::size_t i = 0; i < loop.of_element.size() && loop.walls_of; ++i) {
      Unknown& u = all[loop.of_element[i]];
      if (u.kind != UnknownKind::Line)
        continue;
      const double tilt = loop.loop->elements[i].tilt;
      u.may_tilt = true;
      u.is_tilted = u.is_tilted || tilt != 0;
      u.run = tilt != 0 ? std::tan(tilt) : u.run;
    }
  for (const UnknownLoop& loop : loops)
    for (const std::size_t k : loop.of_element)
      if (Unknown& u = all[k]; loop.walls_of && u.may_tilt) {
        u.height = u.foot = loop.walls_of->floor.heightAt(u.point);
        const Eigen::Vector2d inside = u.point + 0.01 * leftOf(u.direction);
        u.describeAt(
            std::max(u.foot, loop.walls_of->ceilingAt(inside) - below_ceiling));
      }
}

void
PlanUnknowns::standOnFeet()
{
  for (const UnknownLoop& loop : loops) {
    std::vector<bool> is_moved(loop.of_element.size(), false);
    for (std::size_t i = 0; i < is_moved.size() && loop.walls_of; ++i) {
      PlanElement& wall = loop.loop->elements[i];
      const Unknown& u = all[loop.of_element[i]];
      if (wall.tilt == 0 || u.is_tilted)
        continue;
      for (Eigen::Vector2d* const end : {&wall.start, &wall.end})
        *end = u.curve().project(*end);
      wall.tilt = 0;
      is_moved[i] = true;
    }
    rejoin(*loop.loop, is_moved);
  }
  for (Unknown& u : all)
    if (u.may_tilt)
      u.describeAt(u.foot);
}

Eigen::Matrix3d
PlanUnknowns::prior(const Unknown& u) const
{
  constexpr double fixed = 1e6; // standard deviations to a metre or radian
  const double place = 1 / parameters_.coarse;
  const double turn = std::max(0.05, u.half) / parameters_.coarse;
  Eigen::Vector3d sigmas(place, turn, u.is_tilted ? 1 / parameters_.free_tilt : fixed);
  if (u.kind == UnknownKind::Circle)
    sigmas.setConstant(place);
  else if (u.kind == UnknownKind::Plane)
    sigmas[2] = turn;
  return sigmas.cwiseAbs2().asDiagonal();
}

void
PlanUnknowns::write() const
{
  for (const UnknownSlab& s : slabs) {
    const Unknown& u = all[s.unknown];
    if (s.slab->curve)
      continue;
    Eigen::Vector3d normal(-u.slope.x(), -u.slope.y(), 1);
    normal.normalize();
    s.slab->plane << normal,
        -normal.dot(Eigen::Vector3d(u.point.x(), u.point.y(), u.height));
    if (!u.isSeen())
      continue;
    s.slab->inliers = static_cast<std::size_t>(u.count);
    s.slab->residual = u.noise;
    s.slab->accuracy = u.accuracyAt(u.point);
  }
  for (const UnknownLoop& loop : loops)
    for (std::size_t i = 0; i < loop.of_element.size(); ++i) {
      const Unknown& u = all[loop.of_element[i]];
      if (loop.walls_of && u.kind == UnknownKind::Line)
        loop.loop->elements[i].tilt = u.is_tilted ? std::atan(u.run) : 0;
      if (!u.isSeen())
        continue;
      PlanElement& e = loop.loop->elements[i];
      e.inliers = static_cast<std::size_t>(u.count);
      e.residual = u.noise;
      e.accuracy = u.accuracyAt(e.pointAt(e.length() / 2));
    }
}

} // namespace pcl::sedr
