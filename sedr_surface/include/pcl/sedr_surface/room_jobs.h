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

namespace pcl {
namespace sedr {

/** @brief A room whose walls are to be found; indices are into `points`, increasing. */
struct WallJob {
  std::uint32_t room = 0;
  std::vector<Eigen::Vector3f> points; ///< metres
  pcl::Indices candidates;             ///< for walls
  pcl::Indices ceiling;
  pcl::Indices floor;
  pcl::Indices details;
  BoundaryOptions boundary;
  WallGrowingOptions growing;
};

struct FoundWalls {
  pcl::Indices walls;  ///< into the job's points, increasing
  std::string problem; ///< why the stage could not do the room, or empty
};

/** @brief A room whose points are to be moved to its plan, and its holes to be filled.
 */
struct RepairJob {
  PlanRoom plan;
  std::vector<Eigen::Vector3f> points; ///< those with a label, metres
  std::vector<std::uint32_t> labels;   ///< of each of them
  double maximum_distance = 0;         ///< of StructureRefinement
  double grid_size = 0;                ///< of VerticalHoleRepair
};

struct RepairedRoom {
  std::vector<OrientedPoint> points;
  std::vector<std::uint32_t> labels; ///< of each of them
  std::size_t refined = 0;           ///< points that were moved to the plan
  std::size_t filled = 0;            ///< points that fill holes
  UnseenShares unseen;               ///< what the scan does not support
  std::string problem;               ///< why a stage could not do the room, or empty
};

/** @brief The points of a repaired room as a cloud. */
pcl::PointCloud<pcl::PointStructure> cloudOf(std::uint32_t room,
                                             const RepairedRoom& repaired);

/** @brief A room whose surface is to be made. */
struct SurfaceJob {
  RoomSamples samples;
  RoomPoissonParameters parameters;
};

/** @brief What is to be done for one room, with all that it takes and nothing else:
 * plain values, which may be worked on in another process or on another machine. */
using RoomJob = std::variant<WallJob, RepairJob, SurfaceJob>;

/** @brief A room of which nothing came back: who worked on it has failed. */
struct LostRoom {
  std::string reason; ///< a sentence
};

/** @brief What came of a job: LostRoom, or what belongs to the kind of job. */
using RoomResult = std::variant<LostRoom, FoundWalls, RepairedRoom, RoomSurface>;

/** @brief The room of a job. */
std::uint32_t roomOf(const RoomJob& job);

/** @brief Does a job as the stages themselves do: the same bytes, for any number of
 * `threads` (0: all processors), which take the place of those in the job. */
RoomResult workOn(const RoomJob& job, unsigned threads);

/** @brief Somebody who works on rooms in the place of a chain. */
class RoomWorkers {
public:
  virtual ~RoomWorkers() = default;

  /** @brief Has jobs done.
   * @param sizes how much work each of them is, in any unit: the largest are begun
   * first
   * @param job makes a job; called once for each, when somebody is free for it
   * @param take is handed a job's number and result, in any order; neither is called
   * while another call of either runs */
  virtual void work(const std::vector<std::size_t>& sizes,
                    const std::function<RoomJob(std::size_t)>& job,
                    const std::function<void(std::size_t, RoomResult)>& take) = 0;
};

} // namespace sedr
} // namespace pcl
