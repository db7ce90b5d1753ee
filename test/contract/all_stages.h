// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/contract.h"

#include <pcl/common/io.h>
#include <pcl/sedr_filters/floor_projection_recovery.h>
#include <pcl/sedr_filters/grid_region_outlier_removal.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/structure_refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>
#include <pcl/sedr_segmentation/grid_slice_detail.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>
#include <pcl/sedr_segmentation/opening_detection.h>
#include <pcl/sedr_segmentation/room_segmentation.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <gtest/gtest.h>

namespace contract {

/** Numbers of points, areas and volumes that the stages find in the sample room. */
using StageFigures = std::vector<double>;

/** Runs all twelve stages on the sample room, one after the other, for any point type.
 * The results of a stage are passed to the next one unchanged. */
template <typename PointT>
StageFigures
runAllStages()
{
  using pcl::sedr::StructureLabel;
  const auto scan = std::make_shared<pcl::PointCloud<PointT>>();
  const Cloud::ConstPtr room = sampleRoom();
  for (const auto& p : *room) {
    PointT point{};
    point.x = p.x;
    point.y = p.y;
    point.z = p.z;
    scan->push_back(point);
  }
  StageFigures figures;
  const auto note = [&](auto figure, double least, double most) {
    figures.push_back(static_cast<double>(figure));
    EXPECT_GE(figures.back(), least) << "figure " << figures.size();
    EXPECT_LE(figures.back(), most) << "figure " << figures.size();
  };

  pcl::ParallelVoxelGrid<PointT> grid;
  const auto thinned = std::make_shared<pcl::PointCloud<PointT>>();
  grid.setInputCloud(scan);
  grid.setDownsampleAllData(false);
  grid.filter(*thinned);
  note(thinned->size(), 10000, 1e5);

  pcl::HorizontalPlaneDetection<PointT> detection;
  std::vector<pcl::HorizontalPlane> planes;
  detection.setInputCloud(thinned);
  EXPECT_TRUE(detection.segment(planes)) << detection.getErrorMessage();
  note(planes.size(), 2, 2);
  if (planes.size() != 2)
    return figures;
  const pcl::PointIndices& floor_points = planes.front().inliers;
  const pcl::PointIndices& ceiling_points = planes.back().inliers;

  pcl::GridRegionOutlierRemoval<PointT> removal;
  pcl::Indices kept;
  removal.setInputCloud(thinned);
  removal.filter(kept);
  note(removal.getNumberOfRegions(), 1, 1);

  pcl::RoomSegmentation<PointT> segmentation;
  std::vector<pcl::PointIndices> rooms;
  segmentation.setInputCloud(thinned);
  EXPECT_TRUE(segmentation.segment(rooms)) << segmentation.getErrorMessage();
  note(rooms.size(), 1, 1);

  pcl::GridSliceDetail<PointT> slices;
  const auto details = std::make_shared<pcl::PointIndices>();
  slices.setInputCloud(thinned);
  slices.setCeilingIndices(ceiling_points);
  slices.setFloorIndices(floor_points);
  EXPECT_TRUE(slices.segment(*details)) << slices.getErrorMessage();
  note(details->indices.size(), 0, 0);

  pcl::FloorProjectionRecovery<PointT> recovery;
  pcl::PointCloud<PointT> whole_floor;
  recovery.setInputCloud(thinned);
  recovery.setIndices(std::make_shared<pcl::Indices>(floor_points.indices));
  recovery.setCeilingIndices(ceiling_points);
  recovery.setDetailIndices(details);
  recovery.filter(whole_floor);
  note(whole_floor.size(), 4400, 1e5); // about one point per cell of 4 x 3 m

  pcl::CeilingBoundaryWallGrowing<PointT> growing;
  pcl::PointIndices walls;
  growing.setInputCloud(thinned);
  growing.setCeilingIndices(ceiling_points);
  growing.setFloorIndices(floor_points);
  growing.setDetailIndices(details);
  EXPECT_TRUE(growing.segment(walls)) << growing.getErrorMessage();
  note(walls.indices.size(), 5000, 1e5);

  pcl::FloorplanFitting<PointT> fitting;
  pcl::sedr::Floorplan plan;
  fitting.setInputCloud(thinned);
  fitting.setCeilingIndices(segmentation.getPoints(StructureLabel::Ceiling));
  fitting.setFloorIndices(segmentation.getPoints(StructureLabel::Floor));
  fitting.setWallIndices(walls);
  fitting.setDetailIndices(details);
  fitting.setRooms(segmentation.getBuilding().room_of);
  fitting.setRawCloud(scan);
  EXPECT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  if (plan.rooms.size() != 1)
    return figures;
  note(plan.rooms[0].area(), 11.95, 12.05);

  pcl::OpeningDetection<PointT> openings;
  openings.setInputCloud(scan);
  EXPECT_TRUE(openings.segment(plan)) << openings.getErrorMessage();

  pcl::StructureRefinement<PointT> refinement;
  const auto refined = std::make_shared<pcl::PointCloud<PointT>>();
  refinement.setInputCloud(thinned);
  refinement.setFloorplan(plan);
  refinement.setLabels(segmentation.getBuilding().label_of);
  refinement.setRooms(segmentation.getBuilding().room_of);
  refinement.filter(*refined);
  EXPECT_EQ(refinement.getErrorMessage(), "");
  note(refined->size(), 8000, 1e5);

  pcl::VerticalHoleRepair<PointT> repair;
  const auto repaired = std::make_shared<pcl::PointCloud<PointT>>();
  repair.setInputCloud(refined);
  repair.setFloorplan(plan);
  repair.setLabels(refinement.getLabels());
  repair.setRooms(refinement.getRooms());
  repair.filter(*repaired);
  EXPECT_EQ(repair.getErrorMessage(), "");
  note(repaired->size(), 16000, 1e5);

  pcl::FloorplanExtrusion<PointT> extrusion;
  pcl::PolygonMesh mesh;
  extrusion.setFloorplan(plan);
  extrusion.reconstruct(mesh);
  EXPECT_TRUE(extrusion.isClosed()) << extrusion.getErrorMessage();
  note(extrusion.getMesh().signedVolume(), 29.85, 30.15);

  pcl::IndoorStructureReconstruction<PointT> chain;
  chain.setInputCloud(scan);
  chain.getStages().poisson.setDepth(5); // coarse, to save time
  chain.reconstruct(mesh);
  EXPECT_EQ(chain.getErrorMessage(), "");
  // Below 0: normals point inwards.
  note(chain.getStages().poisson.getMesh().signedVolume(), -31, -29);
  return figures;
}

} // namespace contract
