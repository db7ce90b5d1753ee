// SPDX-License-Identifier: BSD-3-Clause
#include "../poisson/room_poisson.h"
#include <pcl/sedr_surface/room_jobs.h>

#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/structure_refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>

#include <memory>

namespace pcl::sedr {

namespace {

pcl::IndicesConstPtr
shared(const pcl::Indices& indices)
{
  return pcl::IndicesConstPtr(new pcl::Indices(indices));
}

FoundWalls
done(const WallJob& job, unsigned threads)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  cloud->reserve(job.points.size());
  for (const auto& p : job.points)
    cloud->emplace_back(p.x(), p.y(), p.z());
  pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ> growing;
  growing.setInputCloud(cloud);
  growing.setIndices(shared(job.candidates));
  growing.setCeilingIndices(shared(job.ceiling));
  growing.setFloorIndices(shared(job.floor));
  growing.setDetailIndices(shared(job.details));
  growing.setNumberOfNeighbors(job.boundary.neighbours);
  growing.setAngleThreshold(job.boundary.angle);
  growing.setDistanceThreshold(job.growing.distance);
  growing.setSliceHeight(job.growing.slice_height);
  growing.setFloorHeight(job.growing.floor_height);
  growing.setMinimumSupport(job.growing.minimum_support);
  growing.setNumberOfThreads(threads);
  FoundWalls found;
  pcl::PointIndices unused;
  if (growing.segment(unused))
    found.walls = growing.getWallIndices();
  else
    found.problem = growing.getErrorMessage();
  return found;
}

pcl::PointCloud<pcl::PointStructure>::Ptr
labelledCloud(const RepairJob& job)
{
  pcl::PointCloud<pcl::PointStructure>::Ptr cloud(
      new pcl::PointCloud<pcl::PointStructure>);
  cloud->reserve(job.points.size());
  for (std::size_t i = 0; i < job.points.size(); ++i) {
    pcl::PointStructure p;
    p.getVector3fMap() = job.points[i];
    p.label = job.labels[i];
    p.room = job.plan.id;
    cloud->push_back(p);
  }
  return cloud;
}

RepairedRoom
done(const RepairJob& job, unsigned threads)
{
  const auto plan = std::make_shared<const Floorplan>(Floorplan{{job.plan}});
  RepairedRoom room;
  pcl::StructureRefinement<pcl::PointStructure> refinement;
  refinement.setInputCloud(labelledCloud(job));
  refinement.setFloorplan(plan);
  refinement.setMaximumDistance(job.maximum_distance);
  refinement.setNumberOfThreads(threads);
  pcl::PointCloud<pcl::PointStructure>::Ptr refined(
      new pcl::PointCloud<pcl::PointStructure>);
  refinement.filter(*refined);
  room.problem = refinement.getErrorMessage();
  room.refined = refined->size();
  if (!room.problem.empty())
    return room;

  pcl::VerticalHoleRepair<pcl::PointStructure> repair;
  repair.setInputCloud(refined);
  repair.setFloorplan(plan);
  repair.setGridSize(job.grid_size);
  pcl::PointCloud<pcl::PointStructure> whole;
  repair.filter(whole);
  room.problem = repair.getErrorMessage();
  room.filled = repair.getRepairedIndices().size();
  if (const auto unseen = repair.getUnseenShares(); unseen.count(job.plan.id) > 0)
    room.unseen = unseen.at(job.plan.id);
  room.points.reserve(whole.size());
  room.labels.reserve(whole.size());
  for (const auto& p : whole) {
    room.points.push_back({p.getVector3fMap(), p.getNormalVector3fMap()});
    room.labels.push_back(p.label);
  }
  return room;
}

RoomSurface
done(const SurfaceJob& job, unsigned threads)
{
  RoomPoissonParameters parameters = job.parameters;
  parameters.threads = threads;
  return surfaceOf(job.samples, parameters);
}

} // namespace

pcl::PointCloud<pcl::PointStructure>
cloudOf(std::uint32_t room, const RepairedRoom& repaired)
{
  pcl::PointCloud<pcl::PointStructure> cloud;
  cloud.reserve(repaired.points.size());
  for (std::size_t i = 0; i < repaired.points.size(); ++i) {
    pcl::PointStructure p;
    p.getVector3fMap() = repaired.points[i].position;
    p.getNormalVector3fMap() = repaired.points[i].normal;
    p.label = repaired.labels[i];
    p.room = room;
    cloud.push_back(p);
  }
  return cloud;
}

std::uint32_t
roomOf(const RoomJob& job)
{
  if (const auto* walls = std::get_if<WallJob>(&job))
    return walls->room;
  if (const auto* repair = std::get_if<RepairJob>(&job))
    return repair->plan.id;
  return std::get<SurfaceJob>(job).samples.room;
}

RoomResult
workOn(const RoomJob& job, unsigned threads)
{
  return std::visit([&](const auto& one) -> RoomResult { return done(one, threads); },
                    job);
}

} // namespace pcl::sedr
