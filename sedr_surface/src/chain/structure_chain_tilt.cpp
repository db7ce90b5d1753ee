// SPDX-License-Identifier: BSD-3-Clause
#include "all_indices.h"

#include <pcl/sedr_surface/structure_chain.h>

#include "sedr_segmentation/src/scan/scan_tilt.h"
#include <pcl/sedr_surface/mesh_repair.h>

#include <cmath>
#include <cstdio>

namespace pcl {
namespace sedr {

namespace {

/** @brief The middle of the box of the finite points. */
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
StructureChain::levelScan()
{
  if (trust_up)
    return;
  const ScanTilt tilt = tiltOf(PointView(*cloud), *allIndices(cloud->size()),
                               room_segmentation.getNumberOfThreads());
  if (!(tilt.angle > 0))
    return;
  levelling = Levelling::of(tilt.up, middleOf(*cloud));
  for (auto& p : *cloud)
    p.getVector3fMap() =
        levelling->level(p.getVector3fMap().cast<double>()).cast<float>();
  floorplan_fitting.levelRawPoints(*levelling);
  char text[300];
  std::snprintf(
      text, sizeof text,
      "the scan is tilted by %.2f degrees, its up towards %.0f degrees from x: it was "
      "made level for the fit; %s, and the plan is of the level frame",
      levelling->angle() * 180 / M_PI, levelling->direction() * 180 / M_PI,
      keep_levelled ? "points, mesh and solid stay level"
                    : "points, mesh and solid are turned back");
  warnings.push_back(text);
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
  if (levelling && !keep_levelled)
    partEqualPositions(mesh); // a float may hold two turned places alike
  return mesh;
}

} // namespace sedr
} // namespace pcl
