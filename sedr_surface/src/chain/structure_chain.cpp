// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"

#include "../mesh/mesh_repair.h"
#include "sedr_filters/src/rays/mirrored_points.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr {

StructureChain::StructureChain()
{
  reset(Cloud::ConstPtr(new Cloud));
  // In a round room, facets of 0.5 mm would dominate the distance from solid to truth.
  extrusion.setChordTolerance(0.00025);
}

StructureChain::~StructureChain() = default;

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
  plane_detection.setPriors(priors);
  floorplan_fitting.setPriors(priors);
  opening_detection.setPriors(priors);
}

void
StructureChain::setCells(double size)
{
  plane_detection.setGridSize(size);
  room_segmentation.setGridSize(size);
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
  setCloud(thinned);
  plan = std::make_shared<Floorplan>();
  structure.reset(new StructureCloud);
  levelling.reset();
  frame = {};
  coverage = {};
  is_in_frame_ = seems_in_feet_ = false;
  up_doubt_.clear();
  reports.clear();
  warnings.clear();
  unit_doubt.clear();
  failed_stage.clear();
  problem.clear();
}

void
StructureChain::setCloud(const Cloud::ConstPtr& thinned)
{
  cloud.reset(new Cloud(*thinned));
  labels.assign(cloud->size(), 0);
  rooms.assign(cloud->size(), 0);
}

bool
StructureChain::findFrame(const Cloud::ConstPtr& thinned,
                          const ScanPositions& positions)
{
  reset(thinned);
  is_in_frame_ = ChainRun(*this).findFrame(positions, true);
  return is_in_frame_;
}

bool
StructureChain::findStructure(const Cloud::ConstPtr& thinned)
{
  if (!thinned) {
    problem = "no cloud was given";
    return false;
  }
  if (is_in_frame_) {
    is_in_frame_ = false; // of the next cloud
    setCloud(thinned);
    return ChainRun(*this).findStructure();
  }
  reset(thinned);
  ChainRun run(*this);
  if (!run.findFrame({}, false))
    return false;
  run.moveToBuilding();
  return run.findStructure();
}

bool
StructureChain::makeMesh()
{
  return ChainRun(*this).makeMesh();
}

void
StructureChain::leaveOutMirrored(const ScanPositions& positions,
                                 std::size_t step,
                                 Cloud& thinned,
                                 std::vector<Eigen::Vector3f>& rows)
{
  const MirroredPoints found = findMirroredPoints(
      PointView(thinned), PointView(rows.data(), sizeof(Eigen::Vector3f), rows.size()),
      step, positions, room_segmentation.getNumberOfThreads());
  mirrored.positions = static_cast<std::size_t>(
      std::count_if(positions.begin(), positions.end(),
                    [](const ScanPosition& position) { return position.isKnown(); }));
  mirrored.untrue = static_cast<std::size_t>(std::count_if(
      positions.begin(), positions.end(), [&](const ScanPosition& position) {
        return std::find(found.untrue.begin(), found.untrue.end(), position.place) !=
               found.untrue.end();
      }));
  mirrored.rays = found.rays;
  mirrored.mirrors = found.mirrors;
  mirrored.lines =
      found.lines.empty() ? nullptr : std::make_shared<SightLines>(found.lines);
  mirrored.behind.clear();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < thinned.size(); ++i)
    if (found.of_thinned[i] == 0) {
      thinned[kept++] = thinned[i];
      mirrored.behind.push_back(found.behind[i]);
    }
  mirrored.points = thinned.size() - kept;
  thinned.resize(kept);
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (found.of_rows[k] != 0)
      rows[k].setConstant(std::numeric_limits<float>::quiet_NaN());
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
