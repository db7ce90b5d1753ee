// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "slice_scene.h"

#include <vector>

namespace pcl::sedr {

/** @brief Uppermost runs of the profiles that are not ceiling: undersides (short runs)
 * and risers (long runs). */
struct Tops {
  CellMask undersides;
  CellMask risers;
  std::vector<float> height; ///< lower end of the uppermost run per cell
  std::vector<double> mean;  ///< mean height of that run's points
};

/** @brief Finds the tops. Strips of undersides narrower than three cells are left out,
 * except beams, as the wall above a window or door ends in such a strip. */
Tops findTops(const SliceScene& scene);

/** @brief Returns the regions of undersides of one height, each in its own box.
 * Neighbours differ by less than the tolerance in height, and steps separate regions: a
 * window head may be a few centimetres below a soffit. */
std::vector<CellMask> regionsOfOneHeight(const SliceScene& scene, const Tops& tops);

} // namespace pcl::sedr
