// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Floor and ceiling of a room at a place in plan: indices of RoomLayers::slabs,
 * or `nothing` outside the room. */
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

/** @brief The vertical surface above the elements of a loop. */
enum class LoopRole { Wall, ColumnFace, NicheSide, CeilingRiser, FloorRiser };

/** @brief A room's plan as an ordered list of loops with their meanings. The solid's
 * only source on the parts of a PlanRoom. */
struct RoomLayers {
  struct Slab {
    PlanSlab slab;
    std::size_t element = 0;        ///< index of its SolidElement
    const PlanLoop* loop = nullptr; ///< around all parts of the slab
    bool is_facet = false;          ///< of a ceiling that is not level
  };

  struct Loop {
    const PlanLoop* loop = nullptr;
    LoopRole role = LoopRole::Wall;
    std::size_t first_element = 0; ///< SolidElement of the loop's first element
  };

  std::vector<SolidElement> elements;
  std::vector<Slab> slabs; ///< floor, ceiling, then details and niches
  std::vector<Loop> loops; ///< boundary first; later ones are fitted to earlier

  /** @param room must outlive this object */
  explicit RoomLayers(const PlanRoom& room);

  /** @brief Returns the region at a place, given the winding number of each loop.
   * Columns are cut out of the room. Of overlapping details of the ceiling, or of the
   * floor, the last counts; of niches, outside the room, the first. */
  PlanRegion regionOf(const std::vector<int>& winding) const;

  bool isNiche(const PlanRegion& region) const
  {
    return region.isRoom() && region.floor >= first_niche_slab_;
  }

  /** @brief Returns replacements for a region that cannot be built, the most similar
   * first: without its floor detail, its ceiling detail, both, and nothing. */
  std::vector<PlanRegion> plainRegions(const PlanRegion& region) const;

  /** @brief Returns the role of an element's loop; Wall for a slab's element. */
  LoopRole roleOf(std::size_t element) const { return roles_[element]; }

  /** @brief Returns what an element belongs to: "a part of its ceiling". */
  std::string wordsOf(std::size_t element) const { return words_[element]; }

private:
  /** @brief A detail or niche. Its region has `nothing` for what it does not change. */
  struct Part {
    PlanRegion region;
    std::size_t boundary = 0; ///< index of its loop, followed by those of its holes
    std::size_t holes = 0;

    bool contains(const std::vector<int>& winding) const;
  };

  void addElement(StructureLabel label,
                  LoopRole role,
                  const char* words,
                  const std::string& name);

  int addSlab(const PlanSlab& slab,
              const PlanLoop& loop,
              StructureLabel label,
              const char* words,
              const std::string& name);

  void addLoop(const PlanLoop& loop, LoopRole role, const std::string& name);

  void addDetails(const std::vector<PlanDetail>& details,
                  LoopRole role,
                  const std::string& name);

  std::uint32_t room_ = 0;
  std::vector<LoopRole> roles_;    ///< of elements
  std::vector<const char*> words_; ///< of elements
  std::vector<Part> details_;      ///< of ceiling and floor, by increasing precedence
  std::vector<Part> niches_;
  int first_niche_slab_ = 0;
};

/** @brief Returns a room with vertical walls, each at its position at headOf() the
 * room. Its details move with them. */
PlanRoom verticalAtHead(const PlanRoom& room);

/** @brief Tilts walls of a solid that was built with vertical ones. Every vertex moves
 * to the intersection of its surfaces (walls, ceilings, floors, risers) by Newton's
 * method. Floors and ceilings that would fold are triangulated again. The adjacency of
 * surfaces does not change.
 * @param layers of verticalAtHead()
 * @param room with tilted walls
 * @param[in,out] solid with indices into layers.elements
 * @return an empty string, or what cannot be built, as the end of a sentence */
std::string
tiltSolid(const RoomLayers& layers, const PlanRoom& room, TriangleMesh& solid);

/** @brief The part of an opening's reveals that belongs to the solid of a room: one of
 * its niches. */
struct OpeningReveal {
  std::size_t opening = 0; ///< index of Floorplan::openings
  std::size_t room = 0;    ///< index of Floorplan::rooms
  std::size_t niche = 0;   ///< index of PlanRoom::niches
  bool is_joined = false;  ///< it ends in the middle of the wall, where another begins
};

/** @brief The rooms of a plan with a niche for each opening beside them, after their
 * own. An opening between two rooms is a niche of either, and both end at the same face
 * in the middle of the wall. Others end at the outer face. */
struct RevealedPlan {
  std::vector<PlanRoom> rooms;
  std::vector<OpeningReveal> reveals; ///< by opening
  std::vector<bool> is_open; ///< openings that the room or a niche of the plan takes up

  /** @brief Openings in tilted walls, and those beside which no wall of their rooms is,
   * stay closed. */
  explicit RevealedPlan(const Floorplan& plan);

  /** @brief Returns a text with the names of the niches of openings replaced:
   * room_1_niche_2_side_1 becomes room_1_opening_5_side_1. */
  std::string named(std::string text) const;
};

} // namespace pcl::sedr
