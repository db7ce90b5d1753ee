// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_segmentation/src/rooms/room_planes.h"

#include <pcl/sedr_segmentation/floorplan_fitting.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Data of a room before its plan is fitted. */
struct ChainRoom {
  pcl::Indices ceiling;  ///< ceiling points, whatever its shape
  pcl::Indices floor;    ///< points of its floor and platforms
  PlanSlab ceiling_slab; ///< largest slab of its ceiling
  PlanSlab floor_slab;   ///< largest slab of its floor
  CellSet scope;         ///< cells of its ceiling, seen or hidden
  HiddenCells hidden;
  pcl::Indices owned; ///< points that bound its air, without those beyond its walls
};

/** @brief A thinned scan whose rooms were found; room r + 1 is the r-th. */
struct ScannedBuilding {
  PointView points;
  const Building& building;
  CellGrid grid; ///< of the stages
  Priors priors;
  RoomPlaneParameters planes;
};

/** @brief Returns the rooms of a building with the points of ceilings and floors, and
 * those that they own. */
std::vector<ChainRoom> roomsOf(const Building& building);

/** @brief Finds the main planes of the rooms, and the cells of their ceilings. */
void findCeilings(const ScannedBuilding& scan, std::vector<ChainRoom>& rooms);

/** @brief Restricts the floors to what is no furniture; the rest of what is below the
 * ceiling of a room are its hidden cells. */
void findFloors(const ScannedBuilding& scan, std::vector<ChainRoom>& rooms);

/** @brief Labels the points of ceilings and floors. */
void labelSlabs(const std::vector<ChainRoom>& rooms,
                const CellGrid& grid,
                StructureModel& model);

/** @brief Lets the walls of the rooms grow from their ceilings and labels them. Where a
 * ceiling is hidden, from which no wall grows, what is beside it is wall.
 * @return why no point was found, a sentence, or empty */
std::string growWalls(const std::vector<ChainRoom>& rooms,
                      const CellGrid& grid,
                      pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>& growing,
                      StructureModel& model);

/** @brief Labels by the fitted plan what no stage did: points on the risers of ceilings
 * and floors, on walls that tilt (they grow from the ceiling straight down). Rooms
 * without a plan lose their labels.
 * @param reach farthest that a point is from its surface, metres */
void
labelByPlan(const std::vector<ChainRoom>& rooms, double reach, StructureModel& model);

/** @brief Labels the points in niches, also those beyond the walls. */
void
labelNiches(const std::vector<PointOwner>& owners, double reach, StructureModel& model);

/** @brief Returns the points with a label. */
pcl::IndicesPtr labelled(const StructureModel& model, StructureLabel label);

/** @brief Returns the points of each room, starting with those of none. */
std::vector<pcl::Indices> pointsByRoom(const StructureModel& model, std::size_t rooms);

/** @brief Gives a point a label and a room. */
inline void
assign(StructureModel& model, int point, StructureLabel label, std::size_t room)
{
  model.labels[static_cast<std::size_t>(point)] = static_cast<std::uint32_t>(label);
  model.rooms[static_cast<std::size_t>(point)] = static_cast<std::uint32_t>(room);
}

/** @brief Moves a cloud to another frame. */
void moveCloud(const BuildingFrame& frame, StructureModel::Cloud& cloud);

/** @brief Turns results in the frame of the building back to the level frame. */
void moveBack(StructureModel& model);

/** @brief Warns of what was left out of the scan before the stages ran.
 * @param raw the points from which it was thinned; may be empty */
void warnOfInput(const PointView& raw, StructureModel& model);

/** @brief Warns of rooms and walls of which little was measured. */
void warnOfGuesses(StructureModel& model);

/** @brief Warns of rooms whose mesh has another volume than their solid. */
void warnOfVolumes(const std::vector<RoomSolidReport>& solids,
                   const std::vector<RoomPoissonReport>& meshes,
                   StructureModel& model);

/** @brief Sets the cells of all stages, metres. */
void setCells(ChainStages& stages, double size);

/** @brief Sets the cells of the stages that analyse the scan, and moves what wall
 * growing allows by the difference; repaired points keep their density. */
void enlargeCells(ChainStages& stages, double size);

/** @brief A run of the stages, and what they leave each other. Each stage returns why
 * it failed, a sentence, or an empty text. */
struct ChainRun {
  ChainStages& stages;
  StructureModel& model;
  double plane_tolerance = 0.07; ///< metres
  bool may_be_in_feet = false;   ///< the scan
  std::vector<ChainRoom> rooms{};
  std::vector<StructureModel::StructureCloud::Ptr>
      refined{}; ///< until repaired, by room

  std::string partRooms(StageReport& report);

  /** @brief Finds planes, cells and floors of the rooms. The cells are enlarged
   * if the scan is sparse. */
  std::string findPlanes(StageReport& report);
  std::string findWalls(StageReport& report);
  std::string fitPlan(StageReport& report);
  std::string findOpenings(StageReport& report);

  /** @brief Moves the labelled points of each room of the plan onto it. */
  std::string refine(StageReport& report);

  /** @brief Fills the holes of the refined points. */
  std::string repair(StageReport& report);
  std::string extrude(StageReport& report);
  std::string makeMesh(StageReport& report);
};

} // namespace pcl::sedr
