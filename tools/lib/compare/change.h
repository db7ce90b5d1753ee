// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

enum class ChangeKind { Appeared, Vanished, Moved };

const char* toString(ChangeKind kind);

/** @brief A difference between two plans. */
struct Change {
  ChangeKind kind = ChangeKind::Moved;
  std::string what; ///< "partition", "wall", "column", "soffit", "room", "door"
  std::vector<std::string> before; ///< elements of the first plan, named as in a solid
  std::vector<std::string> after;  ///< elements of the second plan
  double size = 0;        ///< length of walls (m), area of all else (square metres)
  bool is_length = false; ///< whether `size` is a length
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< of a moved element, metres
  std::vector<PlanLoop> outlines{}; ///< of the elements after; before, if they vanished

  /** @brief Returns the elements of the plan that has them: the first one, unless they
   * appeared. */
  std::vector<std::string>& names()
  {
    return kind == ChangeKind::Appeared ? after : before;
  }
  const std::vector<std::string>& names() const
  {
    return kind == ChangeKind::Appeared ? after : before;
  }
};

/** @brief Thresholds for changes. */
struct CompareSettings {
  double tolerance = 0.05;     ///< displacement, metres
  double minimum_length = 0.3; ///< of a piece of wall, metres
  double minimum_area = 0.1;   ///< of a slab, square metres
  double farthest = 1.5;       ///< maximum distance of corresponding elements, metres
};

} // namespace pcl::sedr::tools
