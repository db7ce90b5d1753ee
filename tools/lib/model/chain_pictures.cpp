// SPDX-License-Identifier: BSD-3-Clause
#include "chain_pictures.h"

#include <pcl/sedr_filters/impl/structure_fields.hpp>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the thinned points without reflections, the first points of the
 * chain's cloud. */
PointView
thinnedPoints(const ChainPictures::Chain& chain)
{
  const auto& cloud = *chain.getChain().cloud;
  return {cloud.empty() ? nullptr : &cloud[0].x, sizeof(pcl::PointXYZ),
          chain.getChain().scannedPoints()};
}

} // namespace

ChainPictures::ChainPictures(Chain& chain)
    : chain_(chain)
{
  chain_.getChain().on_result = [this](const std::string& stage, std::uint32_t room) {
    note(stage, room);
  };
}

ChainPictures::~ChainPictures()
{
  chain_.getChain().on_result = nullptr;
}

void
ChainPictures::note(const std::string& stage, std::uint32_t room)
{
  const StructureChain& chain = chain_.getChain();
  if (stage == "FloorProjectionRecovery")
    floors_.push_back(floorCellsOf(chain.floor_recovery));
  else if (stage == "CeilingBoundaryWallGrowing")
    walls_.push_back(roomWallsOf(chain.wall_growing, room));
  else if (stage == "StructureRefinement")
    addRefinedWalls(chain.refinement, labelsOf(*chain.refinement.getInputCloud()),
                    refined_);
  else if (stage == "VerticalHoleRepair")
    addRepairedSurfaces(chain.hole_repair, repaired_);
}

std::vector<std::string>
ChainPictures::names()
{
  return {"01_parallel_voxel_grid.png",
          "02_room_segmentation.png",
          "03_horizontal_plane_detection.png",
          "05_floor_projection_recovery.png",
          "06_ceiling_boundary_wall_growing.png",
          "07_floorplan_fitting.png",
          "08_structure_refinement.png",
          "09_vertical_hole_repair.png",
          "10_structural_poisson.png"};
}

std::vector<std::string>
ChainPictures::draw() const
{
  const StructureChain& chain = chain_.getChain();
  const PointView points(*chain.cloud);
  const std::vector<Picture> pictures{
      drawThinning(*chain_.getInputSource(), thinnedPoints(chain_),
                   chain_.getVoxelSize()),
      drawRooms(chain.getBuilding()),
      drawPlanes(chain.planes, points, chain_.getGridSize()),
      drawFloor(floors_),
      drawWalls(walls_, points),
      drawPlan(*chain.plan, chain.floorplan_fitting.getBoundaries()),
      drawRefinement(refined_, *chain.plan),
      drawRepair(repaired_, *chain.plan),
      drawMesh(chain.poisson.getMesh())};
  std::vector<std::string> files;
  for (const Picture& picture : pictures)
    files.push_back(picture.png());
  return files;
}

} // namespace pcl::sedr::tools
