// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A point of the structure, in double precision. */
struct SurfacePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< unit, into the room
  StructureLabel label = StructureLabel::Other;
  std::uint32_t room = 0;
};

/** @brief The points of the structure, moved onto the plan. */
struct Refinement {
  std::vector<int> sources; ///< index of each point in the cloud, in input order
  std::vector<SurfacePoint> points; ///< where each point was moved
};

/** @brief Moves `points[indices]` onto the plan, see RoomSurfaces::snap(). `labels` and
 * `rooms` are as long as the cloud. The result does not depend on `threads`; 0 for all
 * processors.
 * @param farthest maximum distance that a point may move, metres */
Refinement refineToPlan(const PointView& points,
                        const std::vector<int>& indices,
                        const std::vector<std::uint32_t>& labels,
                        const std::vector<std::uint32_t>& rooms,
                        const Floorplan& plan,
                        double farthest,
                        unsigned threads);

/** @brief The spaces that the openings of a plan take up in their walls. */
class OpeningSpaces {
public:
  explicit OpeningSpaces(const Floorplan& plan);

  /** @brief Checks whether a place is in an opening or at most `margin` metres beside
   * it, or on its plane in a face of the wall. O(openings). */
  bool contains(const Eigen::Vector3d& place, double margin = 0) const;

private:
  struct Space {
    PlanOpening opening;
    double foot = 0;                               ///< z of the foot of its wall
    Eigen::Vector2d run = Eigen::Vector2d::Zero(); ///< of the wall, metres a metre up
  };

  std::vector<Space> spaces_;
};

/** @brief A point of a room after hole repair. */
struct RepairedPoint {
  SurfacePoint point;
  int source = -1; ///< index in the refined points, -1 for a point that fills a hole
};

/** @brief The maximum number of cells of the surfaces of a plan: 16 GB of them. */
constexpr double max_surface_cells = 2e8;

/** @brief Returns why the surfaces of a plan cannot be divided into cells of `size`
 * metres (above 0), a sentence with the estimated number of cells; empty if they can.
 * O(elements). */
std::string surfaceCellsProblem(const Floorplan& plan, double size);

/** @brief Returns one point for every cell of every room's surfaces (SurfaceCells): the
 * refined point of the cell, or a new one at its centre. Rooms follow in plan order.
 * surfaceCellsProblem() must be empty. */
std::vector<RepairedPoint> repairHoles(const std::vector<SurfacePoint>& refined,
                                       const Floorplan& plan,
                                       double cell_size);

/** @brief Floor points inside and outside the scope, and sources of missing cells. */
struct FloorRecovery {
  pcl::Indices kept;    ///< floor points inside the scope, in input order
  pcl::Indices removed; ///< the other floor points, non-finite ones included
  pcl::Indices
      sources; ///< points above the cells without floor, by cell, then by index
};

/** @brief Compares the cells of a floor with the scope of the rooms: the cells of
 * ceiling and details together (paper, section 2.3.1). A cell without floor is filled
 * from its ceiling points, or else its detail points. Non-finite points occupy no
 * cells. O(n log n).
 * @param cell_size metres, above 0 */
FloorRecovery recoverFloor(double cell_size,
                           const PointView& points,
                           const pcl::Indices& floor,
                           const pcl::Indices& ceiling,
                           const pcl::Indices& detail);

/** @brief Returns the mean z of finite points, metres; NaN for none. */
double meanHeight(const PointView& points, const pcl::Indices& indices);

} // namespace pcl::sedr
