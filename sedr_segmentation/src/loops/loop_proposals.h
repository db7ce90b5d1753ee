// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../faces/wall_lines.h"
#include "loop_candidates.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the runs of equal labels around a cycle: first place and length. */
std::vector<std::pair<std::size_t, std::size_t>>
labelRuns(const std::vector<std::size_t>& labels);

/** @brief Proposes curves for the loops of a storey: the lines of its walls, then the
 * lines and circles through windows of samples that these do not explain, each grown
 * along its support; lines in main directions where nothing was seen; all of them also
 * turned into a main direction. Sets the main directions.
 * @param lines on which the regions were cut */
std::vector<LoopCandidate> proposedCurves(const std::vector<LoopContour>& contours,
                                          const std::vector<WallLine>& lines,
                                          CandidateMaker& maker);

} // namespace pcl::sedr
