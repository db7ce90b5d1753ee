// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/structure_chain.h>

#include "sedr_filters/src/base/labels.h"
#include "sedr_segmentation/src/plan/room_gaps.h"

#include <numeric>
#include <vector>

namespace pcl::sedr {

/** @brief Returns 0, 1, ..., n - 1. */
inline pcl::IndicesPtr
allIndices(std::size_t n)
{
  pcl::IndicesPtr indices(new pcl::Indices(n));
  std::iota(indices->begin(), indices->end(), 0);
  return indices;
}

/** @brief Returns what was seen and the plan does not explain, in connected places of
 * 0.25 m2 and more.
 *
 * Floors and ceilings: columns of air that end more than 10 cm off the model, and off
 * its noise; one warning a room for each if they make up 2 % of it, or as much as
 * furniture covers; and floor that was not seen if furniture cannot hide it. What may
 * be furniture by its size, see isAsFurniture(), does not count. Places within two
 * cells of a wall or column do not count, nor do those with points on the model, nor
 * those outside of the plan, which coverageOf() tells of.
 *
 * Walls and sides of columns: places with nothing on them and something seen behind,
 * not before, which is in no other room, and ceilings that go on behind, if they make
 * up 1 % of all surfaces of the room; and what lies 5 to 15 cm before them, if it makes
 * up 2 %. Openings and their reveals do not count. Things that reach up to the ceiling,
 * as walls do, and are none: one warning a room.
 *
 * O(points + columns of the building).
 * @param points thinned
 * @param building its rooms have the ids of those of the plan */
std::vector<PlanWarning> unexplainedSurfaces(const PointView& points,
                                             const Building& building,
                                             const Floorplan& plan,
                                             const Priors& priors = {});

/** @brief A run of a StructureChain: what the stages leave each other beside the
 * results that the chain keeps. */
class ChainRun {
public:
  using Cloud = StructureChain::Cloud;
  using StructureCloud = StructureChain::StructureCloud;

  explicit ChainRun(StructureChain& chain)
      : chain_(chain)
      , sight_(chain.mirrored.lines)
  {}

  /** @brief Checks the scan and finds the frame to work in.
   * @param own of the building; else that of the scan, made level */
  bool findFrame(const ScanPositions& positions, bool own);

  /** @brief Moves the cloud, the raw points of the fit and the rays to that frame. */
  void moveToBuilding();

  /** @brief Runs all stages but the mesh, in that frame; turns their results back. */
  bool findStructure();

  /** @brief Makes the mesh of the structure that an earlier run has found. */
  bool makeMesh();

  bool fail(const std::string& reason);

  /** @brief Fails because of the scan, not of a stage. */
  bool refuse(const std::string& reason)
  {
    chain_.failed_stage = "input";
    return fail(reason);
  }

private:
  /** @brief Runs one stage and stores its report. */
  bool runStage(const std::string& name,
                std::size_t points_in,
                bool (ChainRun::*step)(StageReport&));

  /** @brief Adds a warning that a stage failed for one room; the others continue. */
  void warn(std::uint32_t room, const std::string& reason);

  void warn(PlanWarning warning) { chain_.warnings.push_back(std::move(warning)); }

  void warnOfLostPoints();
  void warnOfInput();

  /** @brief Checks which direction is up, and finds how a tilted scan is levelled. */
  bool checkUp(const ScanPositions& positions);

  /** @brief Turns the results back to the level frame. */
  void moveBack();

  bool partRooms(StageReport& report);
  bool findPlanes(StageReport& report);

  /** @brief Labels the floor of a room; the rest of what is below its ceiling are its
   * hidden cells.
   * @return number of points */
  std::size_t labelFloor(std::size_t room);

  bool growWalls(StageReport& report);

  /** @brief Returns the points that a room owns but those well below its ceiling,
   * seen or hidden: none of them is of a wall. */
  pcl::IndicesPtr nearRim(std::size_t room) const;

  /** @brief Returns those of the points near the rim of a room that are beside hidden
   * cells of its ceiling, from which no wall grows: what is there is wall. */
  pcl::Indices besideHidden(std::size_t room, const pcl::Indices& near_rim) const;

  bool fitPlan(StageReport& report);
  bool findOpenings(StageReport& report);
  bool refine(StageReport& report);
  bool repair(StageReport& report);

  /** @brief Returns the labelled points of a room, the input of refinement. */
  StructureCloud::Ptr labelledCloud(std::uint32_t room) const;

  /** @brief Removes the labels of every room that has no plan. */
  void giveUpRoomsWithoutPlan();

  void warnOfGuesses();
  void compareVolumes();
  bool extrude(StageReport& report);
  bool mesh(StageReport& report);

  /** @brief Gives a point a label and a room. */
  void give(int point, StructureLabel label, std::size_t room)
  {
    chain_.labels[static_cast<std::size_t>(point)] = valueOf(label);
    chain_.rooms[static_cast<std::size_t>(point)] = static_cast<std::uint32_t>(room);
  }

  /** @brief Returns the points with a label. */
  pcl::IndicesPtr labelled(StructureLabel label) const;

  /** @brief Returns the points of one room with a label. Requires shareOut() after the
   * last change of any other room's points. */
  pcl::IndicesPtr labelled(StructureLabel label, std::uint32_t room) const;

  /** @brief Updates the list of points of every room. */
  void shareOut();

  /** @brief Returns the gaps of a room, from its ceiling, seen or hidden, down to its
   * floor. */
  std::vector<RoomGap> gapsOf(std::size_t room) const;

  /** @brief Finds the owner of each point. */
  void findOwners();

  /** @brief Labels what no stage did on the risers of a room's ceiling and floor, and
   * on its walls if they tilt: walls grow from the ceiling straight down. */
  void labelRisers(const PlanRoom& room);

  /** @brief Labels the points in niches, which no earlier stage considers. */
  void labelNiches();

  /** @brief Data of a room before its plan is fitted. */
  struct ChainRoom {
    pcl::Indices ceiling;  ///< ceiling points, whatever its shape
    pcl::Indices floor;    ///< points of its floor and platforms
    PlanSlab ceiling_slab; ///< largest slab of its ceiling
    PlanSlab floor_slab;   ///< largest slab of its floor
    CellSet scope;         ///< cells of its ceiling, seen or hidden
    HiddenCells hidden;
  };

  StructureChain& chain_;
  std::shared_ptr<const SightLines> sight_; ///< rays, in the frame of the cloud
  std::vector<ChainRoom> regions_;
  std::vector<PointOwner> owners_;     ///< of each thinned point
  std::vector<pcl::IndicesPtr> owned_; ///< points of each room, without those beyond
  std::vector<pcl::Indices> shares_;   ///< points of each room, starting with room 0
  std::vector<StructureCloud::Ptr>
      refined_; ///< of each room of the plan, until repaired
};

} // namespace pcl::sedr
