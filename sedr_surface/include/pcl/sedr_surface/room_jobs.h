// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/sedr_surface/impl/room_samples.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace pcl::sedr {

/** @brief Input of wall growing for one room; indices are into `points`, increasing. */
struct WallJob {
  std::uint32_t room = 0;
  std::vector<Eigen::Vector3f> points; ///< metres
  pcl::Indices candidates;             ///< points that may be wall
  pcl::Indices ceiling;
  pcl::Indices floor;
  pcl::Indices details;
  BoundaryOptions boundary;
  WallGrowingOptions growing;
};

struct FoundWalls {
  pcl::Indices walls;  ///< into the job's points, increasing
  std::string problem; ///< why the stage failed for the room, or empty
};

/** @brief Input of refinement and hole repair for one room. */
struct RepairJob {
  PlanRoom plan;
  std::vector<Eigen::Vector3f> points; ///< labelled points, metres
  std::vector<std::uint32_t> labels;   ///< of each of them
  double maximum_distance = 0;         ///< see StructureRefinement
  double grid_size = 0;                ///< see VerticalHoleRepair
};

struct RepairedRoom {
  std::vector<OrientedPoint> points;
  std::vector<std::uint32_t> labels; ///< of each of them
  std::size_t refined = 0;           ///< number of points moved to the plan
  std::size_t filled = 0;            ///< number of points added in holes
  UnseenShares unseen;               ///< shares that the scan does not support
  std::string problem;               ///< why a stage failed for the room, or empty
};

/** @brief Returns the points of a repaired room as a cloud. */
pcl::PointCloud<pcl::PointStructure> cloudOf(std::uint32_t room,
                                             const RepairedRoom& repaired);

/** @brief Input of surface reconstruction for one room. */
struct SurfaceJob {
  RoomSamples samples;
  RoomPoissonParameters parameters;
};

/** @brief All input of one stage for one room, as plain values, so that another process
 * or machine can work on it. */
using RoomJob = std::variant<WallJob, RepairJob, SurfaceJob>;

/** @brief The result of a job whose worker failed. */
struct LostRoom {
  std::string reason; ///< a sentence
};

/** @brief The result of a job: LostRoom, or the type that matches the job. */
using RoomResult = std::variant<LostRoom, FoundWalls, RepairedRoom, RoomSurface>;

/** @brief Returns the room of a job. */
std::uint32_t roomOf(const RoomJob& job);

/** @brief Runs a job and gives the same bytes as the stage itself. `threads` (0: all
 * processors) replaces the number in the job and does not affect the result. */
RoomResult workOn(const RoomJob& job, unsigned threads);

/** @brief Interface of workers that process rooms on behalf of a chain. */
class RoomWorkers {
public:
  virtual ~RoomWorkers() = default;

  /** @brief Runs jobs.
   * @param sizes amount of work of each job, in any unit; the largest start first
   * @param job makes a job; called once for each, when a worker is free
   * @param take receives a job's number and result, in any order; calls of `job` and
   * `take` never overlap */
  virtual void work(const std::vector<std::size_t>& sizes,
                    const std::function<RoomJob(std::size_t)>& job,
                    const std::function<void(std::size_t, RoomResult)>& take) = 0;
};

} // namespace pcl::sedr
