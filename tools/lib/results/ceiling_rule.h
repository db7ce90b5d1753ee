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

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What has to go for a look into the rooms from above: the ceilings with their
 * details, and whatever lies over them.
 *
 * A label says it where there is one; else the floor plan, if it is known: all that is
 * higher than 15 cm below the ceiling at that place and lower than the floor of the
 * next storey. Without both nothing goes. Details go with the ceiling where they are in
 * the upper half of their room: others are steps or niches. */
class CeilingRule {
public:
  CeilingRule() = default;

  /** @param plan may be without rooms */
  explicit CeilingRule(const Floorplan& plan);

  /** @brief One flag a point, true for what has to go. */
  std::vector<bool> ofCloud(const DisplayCloud& cloud) const;

  /** @brief One flag a triangle. */
  std::vector<bool> ofMesh(const TriangleMesh& mesh) const;

private:
  /** @brief The ceilings of a storey. */
  struct Storey {
    double floor = 0;                                          ///< metres
    double highest = -std::numeric_limits<double>::infinity(); ///< ceiling, metres
    std::unordered_map<CellKey, double> ceiling_at;            ///< the lowest, by cell

    /** @brief A ceiling over a cell, and over its neighbours: a soffit's riser and a
     * wall's top stand on the border of cells. */
    void addCeiling(Cell cell, double height);
  };

  void addRoom(const PlanRoom& room, Storey& storey);

  /** @brief Whether a place lies above the inside of the rooms of its storey. */
  bool isAbove(const Eigen::Vector3d& p) const;

  /** @brief Height above which a room's details are of its ceiling. */
  double middleOf(std::uint32_t room, double otherwise) const;

  CellGrid grid_{0.1};
  std::vector<Storey> storeys_;                    ///< from the lowest up
  std::map<std::uint32_t, double> middle_of_room_; ///< heights, metres
};

} // namespace tools
} // namespace sedr
} // namespace pcl
