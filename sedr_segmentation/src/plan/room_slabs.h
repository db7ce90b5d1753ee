// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../details/detail_fit.h"
#include "room_shares.h"

#include <vector>

namespace pcl::sedr {

/** @brief Fits the plane of a slab, with RANSAC at the small tolerance first, as the
 * detection's tolerance is wide. */
PlanSlab slabOf(const PointView& points,
                const std::vector<int>& indices,
                const RoomFitParameters& parameters);

/** @brief Returns the ceiling's points and fits its main slab to all of its fields. */
SlabEvidence ceilingEvidence(const PointView& points,
                             const RoomEvidence& evidence,
                             const RoomFitParameters& parameters,
                             PlanSlab& ceiling);

/** @brief Returns the floor's points; those off the main plane are details. */
SlabEvidence floorEvidence(const PointView& points,
                           const RoomEvidence& evidence,
                           const PlanSlab& floor,
                           const RoomFitParameters& parameters);

} // namespace pcl::sedr
