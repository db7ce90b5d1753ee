// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "display_cloud.h"

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <map>
#include <unordered_map>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Decides what to remove for a view into the rooms from above: ceilings with
 * their details, and everything above.
 *
 * Labels decide if there are any; otherwise the floor plan, if it is known. It removes
 * what is above 15 cm below the ceiling at a place and below the next storey's floor.
 * Without both, nothing is removed. Details in the upper half of their room belong to
 * the ceiling; others are steps or niches. */
class CeilingRule {
public:
  CeilingRule() = default;

  /** @param plan may have no rooms */
  explicit CeilingRule(const Floorplan& plan);

  /** @brief Returns one flag per point, true if it is to be removed. */
  std::vector<bool> ofCloud(const DisplayCloud& cloud) const;

  /** @brief Returns one flag per triangle. */
  std::vector<bool> ofMesh(const TriangleMesh& mesh) const;

private:
  /** @brief The ceilings of a storey. */
  struct Storey {
    double floor = 0;                                          ///< metres
    double highest = -std::numeric_limits<double>::infinity(); ///< ceiling, metres
    std::unordered_map<CellKey, double> ceiling_at; ///< lowest ceiling by cell

    /** @brief Adds a ceiling to a cell and its neighbours, as risers of soffits and
     * tops of walls lie on the borders of cells. */
    void addCeiling(Cell cell, double height);
  };

  void addRoom(const PlanRoom& room, Storey& storey);

  /** @brief Returns whether a place is above the interior of its storey's rooms. */
  bool isAbove(const Eigen::Vector3d& p) const;

  /** @brief Returns the height above which a room's details belong to its ceiling. */
  double middleOf(std::uint32_t room, double otherwise) const;

  CellGrid grid_{0.1};
  std::vector<Storey> storeys_;                    ///< from the lowest up
  std::map<std::uint32_t, double> middle_of_room_; ///< heights, metres
};

} // namespace pcl::sedr::tools
