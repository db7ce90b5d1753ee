// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A face of a room's solid: its floor, a wall, the underside of a detail. */
struct SolidElement {
  std::uint32_t room = 0; ///< PlanRoom::id
  StructureLabel label = StructureLabel::Other;
  /** @brief Where it stands in the plan, counted from 1: room_1_floor, room_1_wall_3,
   * room_1_column_2_face_1, room_1_detail_1, room_1_detail_1_edge_4. */
  std::string name;
};

/** @brief What bounds a room below and above some place in plan: indices of
 * RoomLayers::slabs, or `nothing` outside of the room. */
struct PlanRegion {
  static constexpr int nothing = -1;

  int floor = nothing;
  int ceiling = nothing;

  bool isRoom() const { return floor != nothing; }
  bool operator==(const PlanRegion& o) const
  {
    return floor == o.floor && ceiling == o.ceiling;
  }
  bool operator!=(const PlanRegion& o) const { return !(*this == o); }
  bool operator<(const PlanRegion& o) const
  {
    return floor != o.floor ? floor < o.floor : ceiling < o.ceiling;
  }
};

/** @brief A room's plan as a pile of loops: which lie over which, and what each means.
 * All that the solid knows of the parts of a PlanRoom stands here. */
struct RoomLayers {
  struct Slab {
    PlanSlab slab;
    std::size_t element = 0; ///< index of its SolidElement
  };

  struct Loop {
    const PlanLoop* loop = nullptr;
    StructureLabel label = StructureLabel::Other; ///< of the faces that stand on it
    std::size_t first_element = 0; ///< SolidElement of the loop's first element
  };

  /** @brief A detail of the ceiling. */
  struct Detail {
    int slab = 0;
    std::size_t boundary = 0; ///< index of its loop; those of its holes follow
    std::size_t holes = 0;
  };

  std::vector<SolidElement> elements;
  std::vector<Slab> slabs; ///< floor, ceiling, then an underside a detail
  std::vector<Loop> loops; ///< the boundary, then columns, then details
  std::vector<Detail> details;

  /** @param room must stay where it is */
  explicit RoomLayers(const PlanRoom& room);

  /** @brief What is at a place that the loops run around `winding` times: columns are
   * cut out of what is inside the boundary, and of details the last is there. */
  PlanRegion regionOf(const std::vector<int>& winding) const;

  /** @brief The region without its detail: below the main ceiling. */
  PlanRegion withoutDetail(PlanRegion region) const;

private:
  void addSlab(const PlanRoom& room,
               const PlanSlab& slab,
               StructureLabel label,
               const std::string& name);

  void addLoop(const PlanRoom& room,
               const PlanLoop& loop,
               StructureLabel label,
               const std::string& name);
};

} // namespace sedr
} // namespace pcl
