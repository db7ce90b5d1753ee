// SPDX-License-Identifier: BSD-3-Clause
// All stages on the scan of one room, chained by hand.
#include <pcl/io/pcd_io.h>
#include <pcl/sedr_filters/floor_projection_recovery.h>
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/grid_region_outlier_removal.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/structure_refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>
#include <pcl/sedr_segmentation/grid_slice_detail.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>
#include <pcl/sedr_segmentation/opening_detection.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/structural_poisson.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using StructureCloud = pcl::PointCloud<pcl::PointStructure>; // normal, label, room
using pcl::sedr::StructureLabel;

namespace {

/** @brief What the stages find, as indices into one cloud. */
struct Parts {
  Cloud::Ptr cloud;
  pcl::IndicesPtr ceiling{new pcl::Indices};
  pcl::IndicesPtr floor{new pcl::Indices};
  pcl::IndicesPtr details{new pcl::Indices};
  pcl::IndicesPtr walls{new pcl::Indices};
  double slice_height = 0; ///< metres, NaN without details
};

const char*
nameOf(pcl::sedr::LevelKind kind)
{
  switch (kind) {
  case pcl::sedr::LevelKind::Ceiling:
    return "ceiling";
  case pcl::sedr::LevelKind::Floor:
    return "floor";
  default:
    return "other";
  }
}

/** @brief Every stage keeps the sentence that says why it failed. */
[[noreturn]] void
giveUp(const pcl::sedr::StageError& stage)
{
  throw std::runtime_error(stage.getErrorMessage());
}

// [thin]
Cloud::Ptr
thin(const Cloud::ConstPtr& scan)
{
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(scan);
  grid.setLeafSize(0.05f, 0.05f, 0.05f);
  Cloud::Ptr thinned(new Cloud);
  grid.filter(*thinned);
  if (thinned->empty())
    giveUp(grid);
  std::cout << "thinned: " << thinned->size() << " points\n";
  return thinned;
}
// [thin]

// [planes]
/** @brief The largest ceiling and the largest floor. */
void
findPlanes(Parts& parts)
{
  pcl::HorizontalPlaneDetection<pcl::PointXYZ> detection;
  detection.setInputCloud(parts.cloud);
  std::vector<pcl::HorizontalPlane> planes;
  if (!detection.segment(planes))
    giveUp(detection);
  for (const auto& plane : planes) {
    std::cout << "plane: " << nameOf(plane.kind) << " at " << plane.height << " m, "
              << plane.area << " m2\n";
    if (plane.kind == pcl::sedr::LevelKind::Other)
      continue;
    auto& level =
        plane.kind == pcl::sedr::LevelKind::Ceiling ? *parts.ceiling : *parts.floor;
    if (plane.inliers.indices.size() > level.size())
      level = plane.inliers.indices;
  }
}
// [planes]

// [outliers]
/** @brief Leaves of the ceiling the largest region: the room. */
void
removeOutliers(Parts& parts)
{
  pcl::GridRegionOutlierRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(parts.cloud);
  removal.setIndices(parts.ceiling);
  pcl::Indices kept;
  removal.filter(kept);
  if (kept.empty())
    giveUp(removal);
  parts.ceiling->clear();
  for (const auto i : kept)
    if (removal.getRegionLabels()[static_cast<std::size_t>(i)] == 1)
      parts.ceiling->push_back(i);
  std::cout << "ceiling: " << parts.ceiling->size() << " points of the largest of "
            << removal.getRegionSizes().size() << " regions\n";
}
// [outliers]

// [details]
void
findDetails(Parts& parts)
{
  pcl::GridSliceDetail<pcl::PointXYZ> slices;
  slices.setInputCloud(parts.cloud);
  slices.setCeilingIndices(parts.ceiling);
  slices.setFloorIndices(parts.floor);
  pcl::PointIndices found;
  if (!slices.segment(found))
    giveUp(slices);
  *parts.details = found.indices;
  parts.slice_height = slices.getSliceHeight();
  std::cout << "details: " << found.indices.size() << " points in "
            << slices.getRegionSizes().size() << " regions\n";
}
// [details]

// [floor]
/** @brief The floor below ceiling and details; what furniture hid is appended to the
 * cloud. */
void
recoverFloor(Parts& parts)
{
  pcl::FloorProjectionRecovery<pcl::PointXYZ> recovery;
  recovery.setInputCloud(parts.cloud);
  recovery.setIndices(parts.floor);
  recovery.setCeilingIndices(parts.ceiling);
  recovery.setDetailIndices(parts.details);
  Cloud floor;
  recovery.filter(floor);
  if (floor.empty())
    giveUp(recovery);

  const std::size_t seen = floor.size() - recovery.getNumberOfProjected();
  parts.floor->assign(recovery.getProjectedIndices().begin(),
                      recovery.getProjectedIndices().begin() +
                          static_cast<std::ptrdiff_t>(seen));
  for (std::size_t i = seen; i < floor.size(); ++i) {
    parts.floor->push_back(static_cast<pcl::index_t>(parts.cloud->size()));
    parts.cloud->push_back(floor[i]);
  }
  std::cout << "floor: " << seen << " points seen, " << recovery.getNumberOfProjected()
            << " projected\n";
}
// [floor]

// [walls]
void
growWalls(Parts& parts)
{
  pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ> growing;
  growing.setInputCloud(parts.cloud);
  growing.setCeilingIndices(parts.ceiling);
  growing.setFloorIndices(parts.floor);
  growing.setDetailIndices(parts.details);
  growing.setSliceHeight(parts.slice_height);
  pcl::PointIndices walls_and_details;
  if (!growing.segment(walls_and_details))
    giveUp(growing);
  *parts.walls = growing.getWallIndices();
  std::cout << "walls: " << parts.walls->size() << " points\n";
}
// [walls]

// [plan]
std::shared_ptr<const pcl::sedr::Floorplan>
fitPlan(const Parts& parts, const Cloud::ConstPtr& scan)
{
  pcl::FloorplanFitting<pcl::PointXYZ> fitting;
  fitting.setInputCloud(parts.cloud);
  fitting.setCeilingIndices(parts.ceiling);
  fitting.setFloorIndices(parts.floor);
  fitting.setDetailIndices(parts.details);
  fitting.setWallIndices(parts.walls);
  fitting.setRawCloud(scan); // more exact than voxels
  const auto plan = std::make_shared<pcl::sedr::Floorplan>();
  if (!fitting.segment(*plan))
    giveUp(fitting);
  pcl::OpeningDetection<pcl::PointXYZ> openings;
  openings.setInputCloud(scan);
  if (!openings.segment(*plan))
    giveUp(openings);
  for (const auto& room : plan->rooms)
    std::cout << "plan: room " << room.id << " has " << room.area() << " m2, "
              << room.boundary.elements.size() << " walls, " << room.columns.size()
              << " columns, " << room.details.size() << " details, "
              << room.niches.size() << " niches, " << plan->openings.size()
              << " openings\n";
  return plan;
}
// [plan]

// [label]
/** @brief One cloud for the rest of the way: what a point is, and in which room. */
StructureCloud::Ptr
labelled(const Parts& parts)
{
  StructureCloud::Ptr structure(new StructureCloud);
  const auto add = [&](const pcl::Indices& indices, StructureLabel label) {
    for (const auto i : indices) {
      pcl::PointStructure point;
      point.getVector3fMap() = (*parts.cloud)[i].getVector3fMap();
      point.label = static_cast<std::uint32_t>(label);
      point.room = 1;
      structure->push_back(point);
    }
  };
  add(*parts.ceiling, StructureLabel::Ceiling);
  add(*parts.floor, StructureLabel::Floor);
  add(*parts.details, StructureLabel::Detail);
  add(*parts.walls, StructureLabel::Wall);
  return structure;
}
// [label]

// [refine]
StructureCloud::Ptr
refine(const StructureCloud::ConstPtr& points,
       const std::shared_ptr<const pcl::sedr::Floorplan>& plan)
{
  pcl::StructureRefinement<pcl::PointStructure> refinement;
  refinement.setInputCloud(points);
  refinement.setFloorplan(plan);
  StructureCloud::Ptr refined(new StructureCloud);
  refinement.filter(*refined);
  if (refined->empty())
    giveUp(refinement);
  std::cout << "refined: " << refined->size() << " of " << points->size()
            << " points lie on the plan\n";
  return refined;
}
// [refine]

// [repair]
StructureCloud::Ptr
repair(const StructureCloud::ConstPtr& refined,
       const std::shared_ptr<const pcl::sedr::Floorplan>& plan)
{
  pcl::VerticalHoleRepair<pcl::PointStructure> hole_repair;
  hole_repair.setInputCloud(refined);
  hole_repair.setFloorplan(plan);
  StructureCloud::Ptr whole(new StructureCloud);
  hole_repair.filter(*whole);
  if (whole->empty())
    giveUp(hole_repair);
  std::cout << "repaired: " << whole->size() << " points, "
            << hole_repair.getRepairedIndices().size() << " of them new\n";
  return whole;
}
// [repair]

void
save(const char* path, const std::string& bytes)
{
  std::ofstream file(path, std::ios::binary);
  if (file << bytes << std::flush)
    return;
  std::cerr << path << " cannot be written\n";
  std::exit(2);
}

// [poisson]
void
makeMesh(const StructureCloud::ConstPtr& structure)
{
  pcl::StructuralPoisson<pcl::PointStructure> poisson;
  poisson.setInputCloud(structure);
  pcl::PolygonMesh mesh; // getMesh() has label and room of the faces too
  poisson.reconstruct(mesh);
  if (!poisson.isClosed())
    giveUp(poisson);
  save("mesh.ply", pcl::sedr::meshToPly(poisson.getMesh()));
  std::cout << "mesh: closed, " << mesh.polygons.size() << " triangles\n";
}
// [poisson]

// [solid]
void
makeSolid(const std::shared_ptr<const pcl::sedr::Floorplan>& plan)
{
  pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion;
  extrusion.setFloorplan(plan);
  pcl::PolygonMesh solid;
  extrusion.reconstruct(solid);
  if (!extrusion.isClosed())
    giveUp(extrusion);
  save("solid.ply", pcl::sedr::meshToPly(extrusion.getMesh()));
  std::cout << "solid: closed, " << solid.polygons.size() << " triangles\n";
}
// [solid]

// [chain]
void
run(const Cloud::ConstPtr& scan)
{
  Parts parts;
  parts.cloud = thin(scan);
  findPlanes(parts);
  removeOutliers(parts);
  findDetails(parts);
  recoverFloor(parts);
  growWalls(parts);
  const auto plan = fitPlan(parts, scan);
  save("floorplan.json", pcl::sedr::floorplanToJson(*plan));

  const auto structure = repair(refine(labelled(parts), plan), plan);
  pcl::io::savePCDFileBinary("structure.pcd", *structure); // throws if it cannot
  makeSolid(plan);
  makeMesh(structure);
}
// [chain]

} // namespace

int
main(int argc, char** argv)
{
  const Cloud::Ptr scan(new Cloud);
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *scan) < 0) {
    std::cerr << "usage: stage_by_stage SCAN.pcd\n";
    return 1;
  }
  try {
    run(scan);
  }
  catch (const std::runtime_error& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  return 0;
}
