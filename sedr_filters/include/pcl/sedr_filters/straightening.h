// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the run of each wall of a room: metres into the room for each metre
 * up, the tangent of its tilt; 0 if vertical. */
std::vector<double> wallRuns(const PlanRoom& room);

/** @brief Checks whether any wall of a room is tilted. */
bool isTilted(const PlanRoom& room);

/** @brief Returns a room with the same feet and vertical walls. */
PlanRoom withVerticalWalls(PlanRoom room);

/** @brief Returns the boundary of a room at height `z`, with tilted walls at their
 * position there. Corners lie where two walls meet. If a wall has no length at that
 * height, the loop crosses itself. */
PlanLoop boundaryAt(const PlanRoom& room, double z);

/** @brief Returns the maximum height of the tops of a room's tilted walls. */
double headOf(const PlanRoom& room);

/** @brief Moves the ends of moved elements and their neighbours to where they meet. */
void rejoin(PlanLoop& loop, const std::vector<bool>& is_moved);

/** @brief A tilted wall face, or a vertical one near it that must not move. */
struct TiltedFace {
  Eigen::Vector2d start = Eigen::Vector2d::Zero(); ///< in plan, at height `head`
  Eigen::Vector2d end = Eigen::Vector2d::Zero();   ///< in plan, at height `head`
  double run = 0;  ///< metres to the left for each metre up: tangent of the tilt
  double low = 0;  ///< z of its foot; points below do not move
  double head = 0; ///< z of its top; points above do not move
  double before_start = 0.1; ///< extension before its start, metres
  double beyond_end = 0.1;   ///< extension beyond its end, metres
};

/** @brief The map between the scan, where some walls are tilted, and a frame in which
 * these walls are vertical; heights do not change.
 *
 * At every height a tilted wall moves to its position at its head. The space on each
 * side of it is stretched or compressed, up to the next parallel wall or over at least
 * one metre. At its ends this follows the walls that it meets, so they stay planes.
 * Algorithms for vertical walls can therefore be used in that frame.
 *
 * @code
 * const Straightening map(tiltedFaces(plan));
 * const Eigen::Vector3d there = map.straighten(p);
 * assert(map.back(there).isApprox(p));
 * @endcode
 *
 * O(n) for each point and n faces; the identity without faces. */
class Straightening {
public:
  Straightening() = default;
  explicit Straightening(std::vector<TiltedFace> faces);

  bool isIdentity() const { return groups_.empty(); }

  /** @brief Maps a place of the scan into the frame of vertical walls. */
  Eigen::Vector3d straighten(const Eigen::Vector3d& p) const;

  /** @brief Maps a place of that frame back into the scan. */
  Eigen::Vector3d back(const Eigen::Vector3d& p) const;

  /** @brief Returns the unit normal in the scan of a surface whose normal at `p` is
   * `normal` in the frame of vertical walls. */
  Eigen::Vector3d normalBack(const Eigen::Vector3d& p,
                             const Eigen::Vector3d& normal) const;

private:
  /** @brief Indices of tilted faces that are roughly parallel. */
  using Group = std::vector<std::size_t>;

  /** @brief Direction of the deformation at one end of a face. */
  struct End {
    double skew = 0;  ///< metres along the face for a metre to its left
    double along = 0; ///< position along the face from which it holds outwards
  };

  /** @brief Returns the directions of the walls that a face meets at its start and end.
   */
  std::array<End, 2> endsOf(std::size_t face) const;

  Eigen::Vector3d
  move(const Group& group, const Eigen::Vector3d& p, bool is_forth) const;

  std::vector<TiltedFace> faces_;
  std::vector<std::array<End, 2>> ends_; ///< the two ends of each face
  std::vector<Group> groups_;
};

/** @brief Returns the plan with vertical walls, each at its position at headOf() its
 * room. Details move with them. */
Floorplan straightened(const Floorplan& plan);

/** @brief Returns all straight walls as faces; none if no wall is tilted. */
std::vector<TiltedFace> tiltedFaces(const Floorplan& plan);

} // namespace pcl::sedr
