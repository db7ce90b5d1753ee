// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_surface/src/poisson/room_poisson.h"

#include <dlfcn.h>

#include <stdexcept>

// Replaces the function of sedr_surface.

pcl::sedr::RoomSurface
pcl::sedr::surfaceOf(const RoomSamples& samples,
                     const RoomPoissonParameters& parameters)
{
  using Function = RoomSurface (*)(const RoomSamples&, const RoomPoissonParameters&);
  static const auto next = reinterpret_cast<Function>(
      dlsym(RTLD_NEXT, "_ZN3pcl4sedr9surfaceOfERKNS0_11RoomSamplesERKNS0_"
                       "21RoomPoissonParametersE"));
  if (samples.room == 2 || !next)
    throw std::runtime_error("its ceiling has come down");
  return next(samples, parameters);
}
