// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_candidates.h"

#include "horizontal_levels.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A level during its detection. */
struct LevelDraft {
  PlanSlab slab;
  std::vector<double> relief; ///< within two tolerances of the plane, see reliefOf()
  std::vector<std::uint8_t> cells; ///< marks cells with a candidate on the plane
  std::vector<std::uint8_t> apart; ///< marks cells of other levels
};

/** @brief Splits a level whose connected regions lie in different planes, such as the
 * ceilings of two rooms a few centimetres apart that one tilted plane approximates.
 *
 * Every region of at least `minimum_cells`, without walls, is fitted separately. The
 * largest region stays in the level. The others stay, one by one, as long as one plane
 * fits all of them, as it does for levels less than a step apart. O(n).
 * @param columns    all points
 * @param candidates points not yet assigned to a level
 * @param[in,out] draft gets the plane of the regions that stay; the cells of the others
 * and around them are marked apart
 * @return whether the draft changed; its relief and cells are then out of date */
bool partLevel(const LevelColumns& columns,
               const std::vector<Candidate>& candidates,
               const LevelParameters& parameters,
               std::size_t minimum_cells,
               LevelDraft& draft);

} // namespace pcl::sedr
