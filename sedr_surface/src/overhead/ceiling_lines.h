// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <string>
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
  /** Of the main ceiling, then of each detail: whether a drawing gives it to its
   * neighbour, as too small or too sparse. */
  std::vector<bool> is_given;
};

/** @brief Returns the borders of the facets of a room's ceiling that can be seen and
 * can be drawn.
 *
 * A border of two facets is a line if along half of it there is a step or a bend, which
 * is more than three times what both are rough: the root of the sum of their squared
 * residuals. A part between lines
 * that is too small for the drawing goes to the neighbour with the longest line in
 * common, one of sparse facets, see sparseFacets(), to the largest. Where two surfaces
 * meet, a line is the curve of their intersection. What remains is straightened to
 * `finest`, without bulges smaller than a part. Arcs remain arcs.
 *
 * @param finest metres that a millimetre of paper stands for: parts narrower than
 * two of them or below 25 square ones and lines up to 30, but no more than a metre,
 * that lead nowhere are not drawn */
CeilingLines ceilingLines(const PlanRoom& room, double finest);

} // namespace pcl::sedr
