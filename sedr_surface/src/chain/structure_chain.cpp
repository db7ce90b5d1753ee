// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"

namespace pcl::sedr {

StructureChain::StructureChain()
{
  reset(Cloud::ConstPtr(new Cloud));
  // In a round room, facets of 0.5 mm would dominate the distance from solid to truth.
  extrusion.setChordTolerance(0.00025);
}

void
StructureChain::setGridSize(double size)
{
  restoreCells();
  setCells(size);
}

void
StructureChain::setPriors(const Priors& priors)
{
  priors_ = priors;
  room_segmentation.setHeadroom(priors.min_headroom);
  room_segmentation.setWidestDoor(priors.max_door_width);
  plane_detection.setPriors(priors);
  slice_detail.setPriors(priors);
  floorplan_fitting.setPriors(priors);
}

void
StructureChain::setCells(double size)
{
  plane_detection.setGridSize(size);
  room_segmentation.setGridSize(size);
  slice_detail.setGridSize(size);
  floor_recovery.setGridSize(size);
  floorplan_fitting.setGridSize(size);
  hole_repair.setGridSize(size);
}

/** @brief Enlarges the cells of the stages that analyse the scan; repaired points keep
 * their density. */
void
StructureChain::enlargeCells(double size)
{
  const double least = plane_detection.getGridSize();
  const double repaired = hole_repair.getGridSize();
  setCells(size);
  hole_repair.setGridSize(repaired);
  wall_growing.setDistanceThreshold(wall_growing.getDistanceThreshold() +
                                    2 * (size - least));
  enlarged_from_ = least;
}

void
StructureChain::restoreCells()
{
  if (enlarged_from_ > 0)
    enlargeCells(enlarged_from_); // back to smaller cells
  enlarged_from_ = 0;
}

void
StructureChain::reset(const Cloud::ConstPtr& thinned)
{
  restoreCells();
  // Points are added where a ceiling is hidden: usually at most a thirtieth.
  cloud.reset(new Cloud);
  cloud->reserve(thinned->size() + thinned->size() / 30);
  *cloud = *thinned;
  scanned_points_ = cloud->size();
  labels.clear();
  rooms.clear();
  for (auto* const values : {&labels, &rooms}) {
    values->reserve(cloud->points.capacity());
    values->resize(cloud->size(), 0);
  }
  planes.clear();
  plan = std::make_shared<Floorplan>();
  structure.reset(new StructureCloud);
  levelling.reset();
  straightening = Straightening();
  tilts.clear();
  straight_plan_ = plan;
  straight_structure_ = structure;
  repaired_shares_.clear();
  unseen_.clear();
  reports.clear();
  warnings.clear();
  unit_doubt.clear();
  failed_stage.clear();
  problem.clear();
}

bool
StructureChain::findStructure(const Cloud::ConstPtr& thinned)
{
  if (!thinned) {
    problem = "no cloud was given";
    return false;
  }
  reset(thinned);
  return ChainRun(*this).findStructure();
}

bool
StructureChain::makeMesh()
{
  return ChainRun(*this).makeMesh();
}

} // namespace pcl::sedr
