// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

enum class ChangeKind { Appeared, Vanished, Moved };

const char* toString(ChangeKind kind);

/** @brief A difference between two plans. */
struct Change {
  ChangeKind kind = ChangeKind::Moved;
  std::string what; ///< "partition", "wall", "column", "soffit", "room", "door"
  std::vector<std::string> before{}; ///< elements of the first plan, as in a solid
  std::vector<std::string> after{};  ///< elements of the second plan, as in a solid
  double size = 0;        ///< length of walls (m), area of all else (square metres)
  bool is_length = false; ///< whether `size` is a length
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< of a moved element, metres
  std::vector<PlanLoop> outlines{}; ///< of the elements after; before, if they vanished
};

/** @brief Thresholds for changes. */
struct CompareSettings {
  double tolerance = 0.05;     ///< displacement, metres
  double minimum_length = 0.3; ///< of a piece of wall, metres
  double minimum_area = 0.1;   ///< of a slab, square metres
  double farthest = 1.5;       ///< maximum distance of corresponding elements, metres
};

/** @brief Compares two plans of a building: rooms, walls, columns, slabs and their
 * details, openings, in this order. Both must be in the same frame. Plans that differ
 * by less than the tolerance have no changes. */
std::vector<Change> comparePlans(const Floorplan& before,
                                 const Floorplan& after,
                                 const CompareSettings& settings);

/** @brief Returns the shift in plan that explains why walls have moved, if nearly all
 * that it would move have and by as much: then the frames of the plans differ. */
std::optional<Eigen::Vector2d> commonShift(const Floorplan& before,
                                           const std::vector<Change>& changes,
                                           const CompareSettings& settings);

/** @brief Describes a change in a line: "moved partition by 0.30 m (x +0.30, y +0.00),
 * 3.0 m: room_1_wall_3, room_2_wall_1 -> room_1_wall_3, room_2_wall_1"; an opening as
 * "bricked up door, 1.80 m2: opening_3". */
std::string describe(const Change& change);

/** @brief Returns the changes as JSON, with the settings; metres and square metres. */
std::string changesToJson(const std::vector<Change>& changes,
                          const CompareSettings& settings);

} // namespace pcl::sedr::tools
