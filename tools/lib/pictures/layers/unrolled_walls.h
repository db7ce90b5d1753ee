// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "canvas.h"

#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A wall, the face of a column, a riser or a side of a niche with a name; what
 * is above and below a niche in one wall is one. */
struct NamedStrip {
  std::vector<const RepairedStrip*> parts;
  std::string name; ///< "2.3": wall 3 of room 2; c columns, d risers, s steps, n niches
  double length = 0;
  double low = 0;  ///< least z of its cells, metres
  double high = 0; ///< greatest

  const PlanElement& element() const { return parts.front()->element; }
  UprightKind kind() const { return parts.front()->kind; }
};

/** @brief Names the strips that have cells; the walls of a room in the order in which
 * one sees them who turns to the right. `strips` must stay where they are. */
std::vector<NamedStrip> nameStrips(const std::vector<RepairedStrip>& strips);

/** @brief Boxes of cells, those seen and those filled apart. */
struct StripBoxes {
  std::vector<Box> seen;
  std::vector<Box> filled;
};

/** @brief The cells of a strip as they look from inside, its lower left corner at
 * `origin`.
 * @param is_seen of every repaired point */
StripBoxes boxesOf(const NamedStrip& strip,
                   const std::vector<bool>& is_seen,
                   const Eigen::Vector2d& origin);

/** @brief Where strips stand that are broken into lines like words; metres, the first
 * line ends at y = 0, the others are below. */
struct StripLines {
  std::vector<Eigen::Vector2d> origins; ///< lower left corner of each strip
  Box view;                             ///< with room for names
};

/** @brief Breaks strips into lines so that they are largest on a sheet of that width
 * and height, in any unit. */
StripLines breakIntoLines(const std::vector<NamedStrip>& strips,
                          double sheet_width,
                          double sheet_height);

/** @brief How high above its origin the name of a strip stands, metres. */
double nameHeight(const NamedStrip& strip);

} // namespace tools
} // namespace sedr
} // namespace pcl
