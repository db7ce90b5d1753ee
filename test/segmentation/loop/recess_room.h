// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_loops.h"

namespace sedr_test {

/** A room of 5 m x 4 m with a recess 2 m wide in the wall y = 4, up to the ceiling. */
inline pcl::sedr::PlanLoop
withRecess(double depth)
{
  return polygon({{0, 0},
                  {5, 0},
                  {5, 4},
                  {3.5, 4},
                  {3.5, 4 + depth},
                  {1.5, 4 + depth},
                  {1.5, 4},
                  {0, 4}});
}

} // namespace sedr_test
