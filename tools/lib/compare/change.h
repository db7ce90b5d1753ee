// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

enum class ChangeKind { Appeared, Vanished, Moved };

const char* toString(ChangeKind kind);

/** @brief One thing that is no longer as it was. */
struct Change {
  ChangeKind kind = ChangeKind::Moved;
  std::string what; ///< "partition", "wall", "column", "soffit", "room"
  std::vector<std::string>
      before;                     ///< elements of the first plan, as a solid names them
  std::vector<std::string> after; ///< of the second one
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< of what moved, metres
  double size = 0;        ///< length of walls (m), area of all else (square metres)
  bool is_length = false; ///< what `size` is
};

/** @brief From when on something counts as a change. */
struct CompareSettings {
  double tolerance = 0.05;     ///< metres off its place
  double minimum_length = 0.3; ///< of a piece of wall, metres
  double minimum_area = 0.1;   ///< of a slab, square metres
  double farthest = 1.5; ///< metres: what is farther from where it was is another thing
};

} // namespace tools
} // namespace sedr
} // namespace pcl
