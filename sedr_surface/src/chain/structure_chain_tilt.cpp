// SPDX-License-Identifier: BSD-3-Clause

#include "chain_run.h"

#include "../mesh/mesh_repair.h"
#include "sedr_filters/src/rays/sight_lines.h"
#include "sedr_segmentation/src/adjust/plan_adjustment.h"
#include "sedr_segmentation/src/plan/room_ceilings.h"
#include "sedr_segmentation/src/scan/scan_tilt.h"
#include "sedr_segmentation/src/scan/tilted_faces.h"
#include "sedr_segmentation/src/scan/wall_tilt_fit.h"

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
ChainRun::straightenScan()
{
  tilted_faces_ =
      tiltedFaces(PointView(*chain_.cloud), *allIndices(chain_.cloud->size()),
                  chain_.room_segmentation.getNumberOfThreads());
  chain_.straightening = Straightening(tilted_faces_);
  if (chain_.straightening.isIdentity())
    return;
  for (auto& p : *chain_.cloud)
    p.getVector3fMap() =
        chain_.straightening.straighten(p.getVector3fMap().cast<double>())
            .cast<float>();
  chain_.floorplan_fitting.moveRawPoints(
      [&](const Eigen::Vector3d& p) { return chain_.straightening.straighten(p); });
  sight_ = nullptr; // rays are not straight there
}

void
ChainRun::tiltPlan()
{
  chain_.straight_plan_ = chain_.plan;
  if (chain_.straightening.isIdentity())
    return;
  const pcl::IndicesConstPtr indices = chain_.floorplan_fitting.getRawIndices();
  const PointView raw = chain_.floorplan_fitting.getRawPoints();
  const PointView points = raw.size() > 0 ? raw : PointView(*chain_.cloud);
  std::vector<Eigen::Vector3f> scanned;
  for (std::size_t i = 0; i < points.size(); ++i)
    scanned.push_back(
        chain_.straightening.back(points[i].cast<double>()).cast<float>());
  const PointView as_scanned(scanned.data(), sizeof(Eigen::Vector3f), scanned.size());
  const pcl::Indices used = indices && raw.size() > 0 ? *indices : pcl::Indices();
  tiltWalls(chain_.straightening, tilted_faces_, *chain_.plan);
  AdjustmentParameters adjustment;
  adjustment.threads = chain_.room_segmentation.getNumberOfThreads();
  adjustPlan(*chain_.plan, as_scanned, used, adjustment);
  chain_.straight_plan_ = std::make_shared<Floorplan>(straightened(*chain_.plan));
  fitCeilingsAsScanned(as_scanned, used);
  const Straightening fitted(tiltedFaces(*chain_.plan));
  for (auto& p : *chain_.cloud) {
    const Eigen::Vector3d scanned =
        chain_.straightening.back(p.getVector3fMap().cast<double>());
    p.getVector3fMap() = fitted.straighten(scanned).cast<float>();
  }
  chain_.straightening = fitted;
  for (const PlanRoom& room : chain_.plan->rooms)
    for (std::size_t e = 0; e < room.boundary.elements.size(); ++e)
      if (const double tilt = room.boundary.elements[e].tilt; tilt != 0)
        warn({WarningKind::Tilted, {tilt * 180 / M_PI}, room.id, e + 1});
}

void
ChainRun::fitCeilingsAsScanned(const PointView& scanned, const pcl::Indices& indices)
{
  std::vector<RoomSheet> sheets;
  for (const PlanRoom& room : chain_.plan->rooms)
    if (isTilted(room))
      sheets.push_back({room.id, {}, {}});
  if (sheets.empty())
    return;
  const pcl::IndicesConstPtr ceilings = sheetPoints();
  for (const int i : *ceilings)
    for (RoomSheet& sheet : sheets)
      if (sheet.room == chain_.rooms[static_cast<std::size_t>(i)])
        sheet.points.push_back(
            chain_.straightening.back((*chain_.cloud)[static_cast<std::size_t>(i)]
                                          .getVector3fMap()
                                          .cast<double>()));
  giveCeilings(std::move(sheets), scanned, indices,
               chain_.room_segmentation.getNumberOfThreads(), *chain_.plan);
}

void
ChainRun::tiltStructure()
{
  chain_.straight_structure_ = chain_.structure;
  if (chain_.straightening.isIdentity())
    return;
  chain_.structure.reset(new StructureCloud(*chain_.straight_structure_));
  for (auto& p : *chain_.structure) {
    const Eigen::Vector3d at = p.getVector3fMap().cast<double>();
    const Eigen::Vector3d normal = p.getNormalVector3fMap().cast<double>();
    p.getVector3fMap() = chain_.straightening.back(at).cast<float>();
    p.getNormalVector3fMap() =
        chain_.straightening.normalBack(at, normal).cast<float>();
  }
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
  TriangleMesh mesh = poisson.getMesh();
  if (!straightening.isIdentity()) // the walls get their tilts back
    for (Eigen::Vector3d& v : mesh.vertices)
      v = straightening.back(v);
  mesh = inScanFrame(std::move(mesh));
  if (isMeshMoved())
    partEqualPositions(mesh); // as floats, two rotated positions may coincide
  return mesh;
}

} // namespace pcl::sedr
