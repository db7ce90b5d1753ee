// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../grids/place_table.h"
#include "room_lookup.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/impl/refinement.h>

#include <memory>
#include <vector>

namespace pcl::sedr {

/** @brief The kind of a vertical surface of a room. */
enum class VerticalKind {
  Wall,           ///< from the floor to the ceiling, or to a niche
  WallAboveNiche, ///< from the top of a niche to the ceiling
  ColumnFace,
  CeilingRiser, ///< between two heights of the ceiling
  FloorRiser,   ///< between two heights of the floor
  NicheSide     ///< a side or the back of a niche
};

/** @brief The range of heights of a vertical surface at one place, metres. */
struct VerticalSpan {
  double low = 0;
  double high = 0;        ///< not above `low` where there is no surface
  bool faces_left = true; ///< whether the room is to the left of the element
};

/** @brief A vertical surface: an element of a room's plan between two heights. It is a
 * wall, which may be tilted, a column face, a riser of a detail or a niche side. */
struct VerticalSurface {
  const PlanRoom* room = nullptr;
  const PlanElement* element = nullptr;
  VerticalKind kind = VerticalKind::Wall;
  StructureLabel label = StructureLabel::Wall; ///< Wall, Column or Detail
  int part = -1; ///< of a riser or niche: index in the room's list
  std::shared_ptr<const RoomLookup> lookup; ///< queries on the room

  /** @brief Returns the heights of the surface at distance `s` along the element. */
  VerticalSpan spanAt(double s) const;

  /** @brief Returns the unit normal into the room at distance `s`. */
  Eigen::Vector3d normalAt(double s) const;

  /** @brief Returns the point at height `z` above distance `s`; of a wall whose length
   * differs at that height, above the same share of it. */
  Eigen::Vector3d pointAt(double s, double z) const;

  /** @brief Returns the distance along the element of the point at height p.z() that is
   * nearest to `p`. */
  double project(const Eigen::Vector3d& p) const;

private:
  /** @brief Returns whether it has another place in plan at another height. */
  bool moves() const { return label == StructureLabel::Wall && lookup->isTilted(); }

  /** @brief Returns the wall at a height. */
  PlanElement at(double z) const;
};

/** @brief Returns the vertical surfaces of a room: walls, then columns, risers of
 * ceiling and floor, and niche sides. They point into `room`, which must not move. */
std::vector<VerticalSurface> verticalSurfaces(const PlanRoom& room);

/** @brief Returns the point of the floor, or of the ceiling, at a place in plan,
 * details included. Does not check that the place is in the room. Parts at their own
 * height are labelled Detail. */
SurfacePoint
slabPointAt(const RoomLookup& room, const Eigen::Vector2d& place, bool is_floor);

/** @brief Returns the point of a niche's bottom or top at a place in plan. */
SurfacePoint nichePointAt(const PlanRoom& room,
                          const PlanNiche& niche,
                          const Eigen::Vector2d& place,
                          bool is_bottom);

/** @brief The structure of a room, onto which many points are projected: a query only
 * looks at nearby surfaces. */
class RoomSurfaces {
public:
  /** @param room must not move or change while this object exists
   * @param farthest maximum distance of a point from its surface, metres */
  RoomSurfaces(const PlanRoom& room, double farthest);

  /** @brief Projects a labelled point onto the structure (paper, section 2.4). Ceiling
   * and floor points move to the plane. Wall and column points move to their line or
   * circle in x and y and keep z. Detail points move to the nearest underside, riser or
   * niche.
   * @return false if the point would move farther than allowed or lies outside the
   * room: it is not part of this structure */
  bool snap(const Eigen::Vector3d& position,
            StructureLabel label,
            SurfacePoint& snapped) const;

private:
  RoomLookup lookup_;
  std::vector<VerticalSurface> verticals_;
  double farthest_;
  PlaceTable near_; ///< surfaces within reach of a place
};

} // namespace pcl::sedr
