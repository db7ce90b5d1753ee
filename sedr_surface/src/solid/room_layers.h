// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What bounds a room below and above some place in plan: indices of
 * RoomLayers::slabs, or `nothing` outside of the room. */
struct PlanRegion {
  static constexpr int nothing = -1;

  int floor = nothing;
  int ceiling = nothing;

  bool isRoom() const { return floor != nothing; }
  bool has(int slab) const { return floor == slab || ceiling == slab; }
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

/** @brief What stands on the elements of a loop. */
enum class LoopRole { Wall, ColumnFace, NicheSide, CeilingRiser, FloorRiser };

/** @brief A room's plan as a pile of loops: which lie over which, and what each means.
 * All that the solid knows of the parts of a PlanRoom stands here. */
struct RoomLayers {
  struct Slab {
    PlanSlab slab;
    std::size_t element = 0;        ///< index of its SolidElement
    const PlanLoop* loop = nullptr; ///< around all of it
    bool is_facet = false;          ///< of a ceiling that is not level
  };

  struct Loop {
    const PlanLoop* loop = nullptr;
    LoopRole role = LoopRole::Wall;
    std::size_t first_element = 0; ///< SolidElement of the loop's first element
  };

  std::vector<SolidElement> elements;
  std::vector<Slab> slabs; ///< floor, ceiling, then those of details and niches
  std::vector<Loop> loops; ///< the boundary first: later ones are fitted to earlier

  /** @param room must stay where it is */
  explicit RoomLayers(const PlanRoom& room);

  /** @brief What is at a place that the loops run around `winding` times. Columns are
   * cut out of all; of details of the ceiling, and of the floor, the last is there; of
   * niches, beside the boundary, the first. */
  PlanRegion regionOf(const std::vector<int>& winding) const;

  bool isNiche(const PlanRegion& region) const
  {
    return region.isRoom() && region.floor >= first_niche_slab_;
  }

  /** @brief What may be there instead of a region that cannot be built, the nearest to
   * it first: without its detail of the floor, of the ceiling, of both, and nothing. */
  std::vector<PlanRegion> plainRegions(const PlanRegion& region) const;

  /** @brief Of what role an element's loop is; of a slab's element Wall. */
  LoopRole roleOf(std::size_t element) const;

private:
  /** @brief A detail or niche: its region where it is all there is, `nothing` for what
   * it leaves as it was. */
  struct Part {
    PlanRegion region;
    std::size_t boundary = 0; ///< index of its loop; those of its holes follow
    std::size_t holes = 0;

    bool contains(const std::vector<int>& winding) const;
  };

  int addSlab(const PlanSlab& slab,
              const PlanLoop& loop,
              StructureLabel label,
              const std::string& name);

  void addLoop(const PlanLoop& loop, LoopRole role, const std::string& name);

  void addDetails(const std::vector<PlanDetail>& details,
                  LoopRole role,
                  const std::string& name);

  std::uint32_t room_ = 0;
  std::vector<Part>
      details_; ///< of ceiling and floor, in the order in which they count
  std::vector<Part> niches_;
  int first_niche_slab_ = 0;
};

} // namespace sedr
} // namespace pcl
