// SPDX-License-Identifier: BSD-3-Clause
#include "room_slabs.h"

#include "../details/height_map.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <cmath>

namespace pcl::sedr {

PlanSlab
slabOf(const PointView& points,
       const std::vector<int>& indices,
       const RoomFitParameters& parameters)
{
  return findLargerSlab(positionsOf(points, indices), parameters.slab_tolerance,
                        radians(parameters.priors.max_slab_tilt), parameters.seed,
                        parameters.threads);
}

SlabEvidence
ceilingEvidence(const PointView& points,
                const RoomEvidence& evidence,
                const RoomFitParameters& parameters,
                PlanSlab& ceiling)
{
  ceiling = slabOf(points, evidence.ceiling, parameters);
  if (evidence.details.empty())
    return {evidence.ceiling, {}, false};
  SlabEvidence slab = withFieldsOfMain(
      points, {evidence.ceiling, evidence.details, false}, ceiling, parameters);
  if (slab.main.size() > evidence.ceiling.size())
    ceiling = slabOf(points, slab.main, parameters);
  return slab;
}

SlabEvidence
floorEvidence(const PointView& points,
              const RoomEvidence& evidence,
              const PlanSlab& floor,
              const RoomFitParameters& parameters)
{
  SlabEvidence slab;
  slab.is_floor = true;
  for (const int i : evidence.floor) {
    const double d = distanceAbove(floor, points[static_cast<std::size_t>(i)]);
    (std::abs(d) <= parameters.slab_tolerance ? slab.main : slab.details).push_back(i);
  }
  return slab;
}

} // namespace pcl::sedr
