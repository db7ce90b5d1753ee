// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../grids/place_table.h"
#include "room_lookup.h"
#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The stretch of heights that an upright surface covers at one place, metres.
 */
struct UprightSpan {
  double low = 0;
  double high = 0;        ///< not above low where there is no surface
  bool faces_left = true; ///< whether the room is on the left of the element's way
};

/** @brief A wall, the face of a column, the riser of a detail or a side of a niche: an
 * element of a room's plan, upright from one height to another. */
struct UprightSurface {
  const PlanRoom* room = nullptr;
  const PlanElement* element = nullptr;
  UprightKind kind = UprightKind::Wall;
  StructureLabel label = StructureLabel::Wall; ///< Wall, Column or Detail
  int part = -1; ///< of a riser or a niche: index in the room's list
  std::shared_ptr<const RoomLookup> lookup; ///< what is where in the room

  /** @brief What the surface covers at distance `s` along the element. */
  UprightSpan spanAt(double s) const;

  /** @brief Unit normal into the room at distance `s`. */
  Eigen::Vector3d normalAt(double s) const;
};

/** @brief The upright surfaces of a room: walls, then columns, risers of ceiling and
 * floor, and niches. They point into `room`, which must stay where it is. */
std::vector<UprightSurface> uprightSurfaces(const PlanRoom& room);

/** @brief The point at a place in plan of whatever floor is below, or of whatever
 * ceiling or detail is above the place; whether the place is in the room is not asked.
 * Parts at a height of their own are labelled Detail. */
SurfacePoint
slabPointAt(const RoomLookup& room, const Eigen::Vector2d& place, bool is_floor);

/** @brief The point at a place in plan of a niche's bottom or top. */
SurfacePoint nichePointAt(const PlanRoom& room,
                          const PlanNiche& niche,
                          const Eigen::Vector2d& place,
                          bool is_bottom);

/** @brief The point of the room's structure that a scanned point with a label stands
 * for (paper, section 2.4): ceiling and floor points move to the plane, wall and column
 * points to their line or circle in x and y while z stays, detail points to the
 * underside, the riser or the niche, whichever is nearest.
 * @return false where that would be farther than `farthest` metres, or beside the room:
 * then the point is not of this structure */
bool snapToRoom(const PlanRoom& room,
                const std::vector<UprightSurface>& uprights,
                const Eigen::Vector3d& position,
                StructureLabel label,
                double farthest,
                SurfacePoint& snapped);

/** @brief The structure of a room made ready for snapToRoom() of many points: each
 * looks at the surfaces near it only. */
class RoomSurfaces {
public:
  /** @param room must stay as and where it is
   * @param farthest that a point may be from its surface, metres */
  RoomSurfaces(const PlanRoom& room, double farthest);

  /** @brief As snapToRoom(). */
  bool snap(const Eigen::Vector3d& position,
            StructureLabel label,
            SurfacePoint& snapped) const;

private:
  RoomLookup lookup_;
  std::vector<UprightSurface> uprights_;
  double farthest_;
  PlaceTable near_; ///< the surfaces within reach
};

} // namespace sedr
} // namespace pcl
