// SPDX-License-Identifier: BSD-3-Clause

#include "chain_run.h"

#include "../mesh/mesh_repair.h"
#include "sedr_filters/src/rays/sight_lines.h"
#include "sedr_segmentation/src/scan/scan_tilt.h"
#include <pcl/sedr_segmentation/tilted_faces.h>

#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns the centre of the bounding box of the finite points. */
Eigen::Vector3d
middleOf(const StructureChain::Cloud& cloud)
{
  Eigen::AlignedBox3d box;
  for (const auto& p : cloud)
    if (p.getVector3fMap().allFinite())
      box.extend(p.getVector3fMap().cast<double>().eval());
  return box.isEmpty() ? Eigen::Vector3d::Zero().eval() : box.center();
}

} // namespace

void
ChainRun::levelScan()
{
  if (chain_.trust_up)
    return;
  const ScanTilt tilt =
      tiltOf(PointView(*chain_.cloud), *allIndices(chain_.cloud->size()),
             chain_.room_segmentation.getNumberOfThreads(), chain_.priors_);
  if (!(tilt.angle > 0))
    return;
  chain_.levelling = Levelling::of(tilt.up, middleOf(*chain_.cloud));
  for (auto& p : *chain_.cloud)
    p.getVector3fMap() =
        chain_.levelling->level(p.getVector3fMap().cast<double>()).cast<float>();
  chain_.floorplan_fitting.moveRawPoints(
      [&](const Eigen::Vector3d& p) { return chain_.levelling->level(p); });
  if (sight_)
    sight_ = std::make_shared<SightLines>(sight_->levelled(*chain_.levelling));
  warn(warningOf(WarningKind::Levelled,
                 chain_.keep_levelled ? "points, mesh and solid stay level"
                                      : "points, mesh and solid are turned back",
                 {chain_.levelling->angle() * 180 / M_PI,
                  chain_.levelling->direction() * 180 / M_PI}));
}

void
ChainRun::makeWallsVertical()
{
  faces_ = tiltedFaces(PointView(*chain_.cloud), *allIndices(chain_.cloud->size()),
                       chain_.room_segmentation.getNumberOfThreads());
  if (faces_.empty())
    return;
  scanned_.reset(new Cloud(*chain_.cloud));
  for (auto& p : *chain_.cloud)
    p.getVector3fMap() =
        withVerticalWalls(faces_, p.getVector3fMap().cast<double>()).cast<float>();
}

TriangleMesh
StructureChain::inScanFrame(TriangleMesh mesh) const
{
  if (!levelling || keep_levelled)
    return mesh;
  for (Eigen::Vector3d& v : mesh.vertices)
    v = levelling->back(v);
  return mesh;
}

StructureChain::StructureCloud::Ptr
StructureChain::structureInScanFrame() const
{
  if (!levelling || keep_levelled)
    return structure;
  const StructureCloud::Ptr turned(new StructureCloud(*structure));
  const Eigen::Matrix3d back = levelling->rotation.transpose();
  for (auto& p : *turned) {
    p.getVector3fMap() =
        levelling->back(p.getVector3fMap().cast<double>()).cast<float>();
    p.getNormalVector3fMap() =
        (back * p.getNormalVector3fMap().cast<double>()).cast<float>();
  }
  return turned;
}

TriangleMesh
StructureChain::meshInScanFrame() const
{
  TriangleMesh mesh = inScanFrame(poisson.getMesh());
  if (isMeshMoved())
    partEqualPositions(mesh); // as floats, two rotated positions may coincide
  return mesh;
}

} // namespace pcl::sedr
