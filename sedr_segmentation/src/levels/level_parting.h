// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_candidates.h"

#include "horizontal_levels.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A level that is being looked for: its plane, and what it does not reach. */
struct LevelDraft {
  PlanSlab slab;
  std::vector<double> relief;      ///< two tolerances about the plane, see reliefOf()
  std::vector<std::uint8_t> cells; ///< marks those with a candidate on the plane
  std::vector<std::uint8_t> apart; ///< marks those at a level of their own
};

/** @brief Parts a level whose connected regions lie in different planes: the ceilings
 * of two rooms, a few centimetres apart, which one leaning plane comes near to as well.
 *
 * Every region of at least `minimum_cells`, walls left out, is fitted by itself. The
 * largest keeps the level, and so do the others, one by one, as long as one plane fits
 * all of them: as two levels less than a step apart have one between them. O(n).
 * @param columns    all points
 * @param candidates those that no level has taken yet
 * @param[in,out] draft gets the plane of the regions that stay, and the others' cells,
 *   with those around them, apart
 * @return whether there were others; then its relief and cells are out of date */
bool partLevel(const LevelColumns& columns,
               const std::vector<Candidate>& candidates,
               const LevelParameters& parameters,
               std::size_t minimum_cells,
               LevelDraft& draft);

} // namespace sedr
} // namespace pcl
