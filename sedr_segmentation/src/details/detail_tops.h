// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "slice_scene.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief The tops of the columns that are not ceiling: undersides (short runs) in
 * regions of one height, and risers (long runs). */
struct Tops {
  CellMask undersides;
  CellMask risers;
  std::vector<float> height; ///< lower end of the uppermost run of each cell
  std::vector<double> mean;  ///< of the points of that run
};

/** @brief Strips of undersides narrower than three cells are left out, but beams: the
 * wall above a window or a door ends in such a strip. */
Tops findTops(const SliceScene& scene);

/** @brief Regions of undersides in which neighbours differ by less than the tolerance
 * in height and that no step parts, each in a box of its own: the head of a window may
 * be a few centimetres below a soffit. */
std::vector<CellMask> regionsOfOneHeight(const SliceScene& scene, const Tops& tops);

} // namespace sedr
} // namespace pcl
