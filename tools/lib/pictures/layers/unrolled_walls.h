// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "canvas.h"

#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A wall, column face, riser or niche side with a name. The parts above and
 * below a niche in one wall are merged. */
struct NamedStrip {
  std::vector<const RepairedStrip*> parts;
  std::string name; ///< "2.3": wall 3 of room 2; c columns, d risers, s steps, n niches
  double length = 0;
  double low = 0;  ///< minimum z of its cells, metres
  double high = 0; ///< maximum z, metres

  const PlanElement& element() const { return parts.front()->element; }
  VerticalKind kind() const { return parts.front()->kind; }
};

/** @brief Names the strips that have cells; the walls of a room in clockwise order.
 * `strips` must stay valid. */
std::vector<NamedStrip> nameStrips(const std::vector<RepairedStrip>& strips);

/** @brief Boxes of seen and filled cells. */
struct StripBoxes {
  std::vector<Box> seen;
  std::vector<Box> filled;
};

/** @brief Returns the cells of a strip seen from inside, with its lower left corner at
 * `origin`.
 * @param is_seen per repaired point */
StripBoxes boxesOf(const NamedStrip& strip,
                   const std::vector<bool>& is_seen,
                   const Eigen::Vector2d& origin);

/** @brief Positions of strips that are broken into lines like words; metres. The first
 * line ends at y = 0, the others are below. */
struct StripLines {
  std::vector<Eigen::Vector2d> origins; ///< lower left corner of each strip
  Box view;                             ///< with space for names
};

/** @brief Breaks strips into lines so that they are largest on a sheet of this width
 * and height, in any unit. */
StripLines breakIntoLines(const std::vector<NamedStrip>& strips,
                          double sheet_width,
                          double sheet_height);

/** @brief Returns the height of a strip's name above its origin, metres. */
double nameHeight(const NamedStrip& strip);

} // namespace pcl::sedr::tools
