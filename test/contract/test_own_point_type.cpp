// SPDX-License-Identifier: BSD-3-Clause
// With this macro the headers of all stages include their templates.
#define PCL_NO_PRECOMPILE

#include <pcl/memory.h>
#include <pcl/pcl_macros.h>

/** A point type for which no library has compiled classes. */
struct EIGEN_ALIGN16 WeighedPoint {
  PCL_ADD_POINT4D
  float weight;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

POINT_CLOUD_REGISTER_POINT_STRUCT(WeighedPoint,
                                  (float, x, x)(float, y, y)(float, z, z)(float,
                                                                          weight,
                                                                          weight))

#include "all_stages.h"

namespace contract {

TEST(OwnPointType, AllStagesWorkWithItAsWithThoseTheyAreCompiledFor)
{
  EXPECT_EQ(runAllStages<WeighedPoint>(), runAllStages<pcl::PointXYZ>());
}

} // namespace contract
