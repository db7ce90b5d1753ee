// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "storey_energy.h"

#include <vector>

namespace pcl::sedr {

/** @brief Fits the outlines of the rooms of a storey by one labelling of the cells
 * between its lines and arcs (StoreyEnergy): alpha-expansions (Boykov, Veksler and
 * Zabih 2001), then lines are left out while that costs less. Outlines are closed and
 * do not cross, and neighbours share their lines.
 * @param[in,out] rooms get outlines and columns; those without a cell get none */
void labelStorey(const StoreyEvidence& evidence,
                 const StoreyEnergy& energy,
                 std::vector<PlanRoom>& rooms);

} // namespace pcl::sedr
