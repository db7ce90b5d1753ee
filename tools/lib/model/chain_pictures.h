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

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A PNG file to be. */
struct PictureFile {
  std::string name; ///< "05_grid_slice_detail.png"
  std::string bytes;
};

/** @brief The pictures of all stages of one run of the chain: notes during the run what
 * the stages decide plane by plane and room by room, and draws it when the run is over.
 */
class ChainPictures {
public:
  using Chain = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;

  /** @brief Listens to `chain`, which must have an input source when it runs and
   * outlive this, until the end of this. */
  explicit ChainPictures(Chain& chain);
  ~ChainPictures();
  ChainPictures(const ChainPictures&) = delete;
  ChainPictures& operator=(const ChainPictures&) = delete;

  /** @brief The names of all pictures, in the order of the stages. */
  static std::vector<std::string> names();

  /** @brief The pictures of a run that has left a mesh. */
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

} // namespace tools
} // namespace sedr
} // namespace pcl
