// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stage_pictures.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Pictures of all stages of a run of the chain. Records the decisions of stages
 * per plane and room during the run; draws them afterwards. */
class ChainPictures {
public:
  using Chain = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;

  /** @brief Observes `chain` during this object's lifetime. The chain must have an
   * input source when it runs, and outlive this object. */
  explicit ChainPictures(Chain& chain);
  ~ChainPictures();
  ChainPictures(const ChainPictures&) = delete;
  ChainPictures& operator=(const ChainPictures&) = delete;

  /** @brief Returns the names of all pictures, in the order of the stages. */
  static std::vector<std::string> names();

  /** @brief Returns the pictures of a run that made a mesh, as PNG, by names(). */
  std::vector<std::string> draw() const;

private:
  void note(const std::string& stage, std::uint32_t room);

  Chain& chain_;
  std::vector<FloorCells> floors_;
  std::vector<RoomWalls> walls_;
  RefinedWalls refined_;
  RepairedSurfaces repaired_;
};

} // namespace pcl::sedr::tools
