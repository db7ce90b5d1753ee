// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A line in which facets of a ceiling meet. */
struct CeilingLine {
  PlanElement element;
  bool is_crease = false; ///< a ridge, hip or valley; otherwise a step or a bend
  std::string text;       ///< "ridge 4.35" or "valley 2.90"; usually empty
};

/** @brief The lines that a drawing of a ceiling shows, and the parts between them. */
struct CeilingLines {
  std::vector<CeilingLine> lines;
  /** Of the main ceiling, then of each detail: a number that facets without a line
   * between them have in common. */
  std::vector<std::size_t> part;
  /** Likewise: the detail that the drawing shows there, or -1 for the main ceiling.
   * Another one than itself where it is too small. */
  std::vector<int> shown;
  /** The borders of facets, by the details that are shown beside them, and whether they
   * are drawn as steps. */
  using Borders =
      std::map<std::pair<int, int>, std::vector<std::pair<PlanElement, bool>>>;
  Borders borders;

  /** @param detail as of PlanRoom::detailAt() */
  int shownFor(int detail) const { return shown[static_cast<std::size_t>(detail + 1)]; }

  /** @brief Returns whether two facets are parted by a step that is drawn, at their
   * border nearest to a place. */
  bool isStep(int a, int b, const Eigen::Vector2d& place) const;
};

/** @brief Returns the borders of the facets of a room's ceiling that can be seen and
 * can be drawn.
 *
 * A border of two facets is a line if along half of it there is a step or a bend, which
 * is more than three times what both are rough: the root of the sum of their squared
 * residuals. A part between lines that is too small for the drawing is shown as the
 * neighbour with the longest line in common. Where surfaces meet, a line is the curve
 * of their intersection; where there is a step, it is their border. Lines end where
 * others do, and at walls. What remains is straightened to `finest`, without bulges
 * smaller than a part. Arcs remain arcs.
 *
 * @param finest metres that a millimetre of paper stands for: parts narrower than
 * two of them or below 25 square ones and lines up to 30, but no more than a metre,
 * that lead nowhere are not drawn */
CeilingLines ceilingLines(const PlanRoom& room, double finest);

} // namespace pcl::sedr
