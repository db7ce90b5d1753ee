// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "chain_rooms.h"

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Sets the cells of all stages, metres. */
void setCells(ChainStages& stages, double size);

/** @brief Sets the cells of the stages that analyse the scan, and moves what wall
 * growing allows by the difference; repaired points keep their density. */
void enlargeCells(ChainStages& stages, double size);

/** @brief What the stages of a run leave each other. */
struct ChainRun {
  ChainStages& stages;
  StructureModel& model;
  bool may_be_in_feet = false; ///< the scan
  std::vector<ChainRoom> rooms{};
  std::vector<PointOwner> owners{}; ///< of the points
  std::vector<StructureModel::StructureCloud::Ptr>
      refined{}; ///< until repaired, by room
};

// Each stage returns why it failed, a sentence, or an empty text.
std::string partRooms(ChainRun& run, StageReport& report);

/** @brief Finds planes, cells, floors and owners of the rooms. The cells are enlarged
 * if the scan is sparse. */
std::string findPlanes(ChainRun& run, StageReport& report);
std::string findWalls(ChainRun& run, StageReport& report);
std::string fitPlan(ChainRun& run, StageReport& report);
std::string findOpenings(ChainRun& run, StageReport& report);

/** @brief Moves the labelled points of each room of the plan onto it. */
std::string refine(ChainRun& run, StageReport& report);

/** @brief Fills the holes of the refined points. */
std::string repair(ChainRun& run, StageReport& report);
std::string extrude(ChainRun& run, StageReport& report);
std::string makeMesh(ChainRun& run, StageReport& report);

} // namespace pcl::sedr
