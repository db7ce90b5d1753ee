// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_curve.h"
#include "plan_adjustment.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

enum class UnknownKind {
  Line,   ///< of walls: shift to the left, turn about its point, run for a metre up
  Circle, ///< of walls: centre in x and y, radius
  Plane   ///< of a slab: height above its point, slopes in x and y
};

/** @brief A surface with three unknowns, and what is known of them. */
struct Unknown {
  UnknownKind kind = UnknownKind::Line;
  Eigen::Vector2d point = Eigen::Vector2d::Zero(); ///< middle of the part in use, or
                                                   ///< centre of the circle
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< of a line, unit
  double radius = 0;                                    ///< of a circle
  double height = 0; ///< z at the point of a plane, at which a line is where it is
  double run = 0;    ///< of a line: metres to the left for each metre up
  Eigen::Vector2d slope = Eigen::Vector2d::Zero(); ///< of a plane
  double half = 0;        ///< half extent of the part in use, metres
  double foot = 0;        ///< z of a wall's foot
  bool may_tilt = false;  ///< of a line: a room's wall
  bool is_tilted = false; ///< its run is free
  bool is_kept = false;   ///< where it was given, without ties
  bool is_wall = false;   ///< a room's face: the room is to the left of the line
  std::size_t room = 0;   ///< index in the plan

  double count = 0;     ///< points of its patches; 0: not seen
  double noise = 0;     ///< standard deviation of its points, metres
  double spread = 0;    ///< standard deviation of its patches, metres
  double deviation = 0; ///< distance within which 95 % of its points lie, metres
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero(); ///< inverse covariance, alone
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< with its ties

  bool isSeen() const { return count > 0; }

  /** @brief Returns the distance of a point, positive to the left, outside or above. */
  double distance(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector2d to = p.head<2>() - point;
    if (kind == UnknownKind::Circle)
      return to.norm() - radius;
    if (kind == UnknownKind::Plane)
      return (p.z() - height - slope.dot(to)) / std::sqrt(1 + slope.squaredNorm());
    return (to.dot(leftOf(direction)) - run * (p.z() - height)) /
           std::sqrt(1 + run * run);
  }

  /** @brief Returns the accuracy of the surface at a place in plan. */
  SurfaceAccuracy accuracyAt(const Eigen::Vector2d& place) const;

  /** @brief Returns the negative derivative of the distance by the unknowns. */
  Eigen::Vector3d row(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector2d to = p.head<2>() - point;
    Eigen::Vector3d row;
    if (kind == UnknownKind::Circle)
      row << to.normalized(), 1;
    else if (kind == UnknownKind::Plane)
      row = Eigen::Vector3d(1, to.x(), to.y()) / std::sqrt(1 + slope.squaredNorm());
    else
      row = Eigen::Vector3d(1, to.dot(direction), p.z() - height) /
            std::sqrt(1 + run * run);
    return row;
  }

  void move(const Eigen::Vector3d& step);

  /** @brief Describes the same wall by its line at another height. */
  void describeAt(double z);

  PlanCurve curve() const;
};

/** @brief A loop of the plan and the unknown of each of its elements. */
struct UnknownLoop {
  PlanLoop* loop = nullptr;
  PlanRoom* walls_of = nullptr; ///< the room whose boundary it is
  std::size_t room = 0;         ///< index in the plan
  std::vector<std::size_t> of_element;
};

/** @brief A plane of the plan. */
struct UnknownSlab {
  PlanSlab* slab = nullptr;
  std::size_t unknown = 0;
  std::size_t parent = 0; ///< unknown of the room's main floor or ceiling
  bool is_floor = false;  ///< it is seen from above
};

/** @brief All unknowns of a plan; `plan` must not move in memory. */
class PlanUnknowns {
public:
  PlanUnknowns(Floorplan& plan, const AdjustmentParameters& p);

  std::vector<Unknown> all;
  std::vector<UnknownLoop> loops;
  std::vector<UnknownSlab> slabs;

  /** @brief Describes walls by their feet, as the plan does. Those of the plan that
   * were given a tilt and have none are moved to where they stand below the ceiling. */
  void standOnFeet();

  /** @brief Writes the moved planes, the tilts of walls and, of seen surfaces, the
   * counts and residuals. */
  void write() const;

  /** @brief Returns the information of an unknown before any point is seen. */
  Eigen::Matrix3d prior(const Unknown& u) const;

private:
  void addRoom(PlanRoom& room, std::size_t index);
  void addLoop(PlanLoop& loop, std::size_t room, std::size_t first, bool is_wall);
  void addSlab(PlanSlab& slab,
               const PlanLoop& loop,
               std::size_t room,
               std::size_t parent,
               bool is_floor);
  std::size_t unknownOf(const PlanElement& e, std::size_t first);
  void describeBelowCeilings();

  const AdjustmentParameters& parameters_;
};

} // namespace pcl::sedr
