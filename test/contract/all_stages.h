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

/** The results of the stages in the sample room. */
struct StageFigures {
  std::size_t thinned = 0;
  std::size_t planes = 0;
  std::size_t regions = 0;
  std::size_t rooms = 0;
  std::size_t details = 0;
  std::size_t floor = 0;
  std::size_t walls = 0;
  double area = 0; ///< of the plan, square metres
  std::size_t refined = 0;
  std::size_t repaired = 0;
  double solid_volume = 0; ///< cubic metres
  double chain_volume = 0; ///< of the mesh of the chain, below 0: normals point inwards

  bool operator==(const StageFigures& o) const
  {
    return thinned == o.thinned && planes == o.planes && regions == o.regions &&
           rooms == o.rooms && details == o.details && floor == o.floor &&
           walls == o.walls && area == o.area && refined == o.refined &&
           repaired == o.repaired && solid_volume == o.solid_volume &&
           chain_volume == o.chain_volume;
  }
};

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

  pcl::ParallelVoxelGrid<PointT> grid;
  const auto thinned = std::make_shared<pcl::PointCloud<PointT>>();
  grid.setInputCloud(scan);
  grid.setDownsampleAllData(false);
  grid.filter(*thinned);
  figures.thinned = thinned->size();

  pcl::HorizontalPlaneDetection<PointT> detection;
  std::vector<pcl::HorizontalPlane> planes;
  detection.setInputCloud(thinned);
  EXPECT_TRUE(detection.segment(planes)) << detection.getErrorMessage();
  figures.planes = planes.size();
  if (planes.size() != 2)
    return figures;
  const pcl::PointIndices& floor_points = planes.front().inliers;
  const pcl::PointIndices& ceiling_points = planes.back().inliers;

  pcl::GridRegionOutlierRemoval<PointT> removal;
  pcl::Indices kept;
  removal.setInputCloud(thinned);
  removal.filter(kept);
  figures.regions = removal.getNumberOfRegions();

  pcl::RoomSegmentation<PointT> segmentation;
  std::vector<pcl::PointIndices> rooms;
  segmentation.setInputCloud(thinned);
  EXPECT_TRUE(segmentation.segment(rooms)) << segmentation.getErrorMessage();
  figures.rooms = rooms.size();

  pcl::GridSliceDetail<PointT> slices;
  const auto details = std::make_shared<pcl::PointIndices>();
  slices.setInputCloud(thinned);
  slices.setCeilingIndices(ceiling_points);
  slices.setFloorIndices(floor_points);
  EXPECT_TRUE(slices.segment(*details)) << slices.getErrorMessage();
  figures.details = details->indices.size();

  pcl::FloorProjectionRecovery<PointT> recovery;
  pcl::PointCloud<PointT> whole_floor;
  recovery.setInputCloud(thinned);
  recovery.setIndices(std::make_shared<pcl::Indices>(floor_points.indices));
  recovery.setCeilingIndices(ceiling_points);
  recovery.setDetailIndices(details);
  recovery.filter(whole_floor);
  figures.floor = whole_floor.size();

  pcl::CeilingBoundaryWallGrowing<PointT> growing;
  pcl::PointIndices walls;
  growing.setInputCloud(thinned);
  growing.setCeilingIndices(ceiling_points);
  growing.setFloorIndices(floor_points);
  growing.setDetailIndices(details);
  EXPECT_TRUE(growing.segment(walls)) << growing.getErrorMessage();
  figures.walls = walls.indices.size();

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
  figures.area = plan.rooms[0].area();

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
  figures.refined = refined->size();

  pcl::VerticalHoleRepair<PointT> repair;
  const auto repaired = std::make_shared<pcl::PointCloud<PointT>>();
  repair.setInputCloud(refined);
  repair.setFloorplan(plan);
  repair.setLabels(refinement.getLabels());
  repair.setRooms(refinement.getRooms());
  repair.filter(*repaired);
  EXPECT_EQ(repair.getErrorMessage(), "");
  figures.repaired = repaired->size();

  pcl::FloorplanExtrusion<PointT> extrusion;
  pcl::PolygonMesh mesh;
  extrusion.setFloorplan(plan);
  extrusion.reconstruct(mesh);
  EXPECT_TRUE(extrusion.isClosed()) << extrusion.getErrorMessage();
  figures.solid_volume = extrusion.getMesh().signedVolume();

  pcl::IndoorStructureReconstruction<PointT> chain;
  chain.setInputCloud(scan);
  chain.getStages().poisson.setDepth(5); // coarse, to save time
  chain.reconstruct(mesh);
  EXPECT_EQ(chain.getErrorMessage(), "");
  figures.chain_volume = chain.getStages().poisson.getMesh().signedVolume();
  return figures;
}

/** Expected figures of the sample room, for any point type. */
inline void
expectSampleRoom(const StageFigures& figures)
{
  EXPECT_GT(figures.thinned, 10000u);
  EXPECT_EQ(figures.regions, 1u);
  EXPECT_EQ(figures.rooms, 1u);
  EXPECT_EQ(figures.details, 0u);
  EXPECT_GT(figures.floor, 4400u); // about one point per cell of 4 x 3 m
  EXPECT_GT(figures.walls, 5000u);
  EXPECT_NEAR(figures.area, 12, 0.05);
  EXPECT_GT(figures.refined, 8000u);
  EXPECT_GT(figures.repaired, 16000u);
  EXPECT_NEAR(figures.solid_volume, 30, 0.15);
  EXPECT_NEAR(figures.chain_volume, -30, 1);
}

} // namespace contract
