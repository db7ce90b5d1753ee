// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "floor_picture.h"
#include "refinement_picture.h"
#include "repair_picture.h"
#include "slice_picture.h"
#include "wall_picture.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A PNG file to be written. */
struct PictureFile {
  std::string name; ///< "05_grid_slice_detail.png"
  std::string bytes;
};

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

  /** @brief Draws the pictures of a run that made a mesh. */
  std::vector<PictureFile> draw() const;

private:
  void note(const std::string& stage, std::uint32_t room);

  Chain& chain_;
  std::vector<RoomSlices> slices_;
  std::vector<FloorCells> floors_;
  std::vector<RoomWalls> walls_;
  RefinedWalls refined_;
  RepairedSurfaces repaired_;
};

} // namespace pcl::sedr::tools
