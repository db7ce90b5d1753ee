// SPDX-License-Identifier: BSD-3-Clause
#include "all_stages.h"

#include <pcl/sedr_filters/point_types.h>

#include <boost/preprocessor/seq/enum.hpp>

namespace contract {

template <typename PointT>
class AllPointTypes : public ::testing::Test {};

using PointTypes = ::testing::Types<BOOST_PP_SEQ_ENUM(SEDR_POINT_TYPES)>;
TYPED_TEST_SUITE(AllPointTypes, PointTypes);

TYPED_TEST(AllPointTypes, HaveCompiledStagesThatFindTheSameInTheSamePoints)
{
  static const StageFigures of_plain_points = runAllStages<pcl::PointXYZ>();
  EXPECT_EQ(runAllStages<TypeParam>(), of_plain_points);
}

TYPED_TEST(AllPointTypes, TellWherePointsHaveNoNormals)
{
  const auto cloud = std::make_shared<pcl::PointCloud<TypeParam>>();
  cloud->resize(1000);
  pcl::StructuralPoisson<TypeParam> poisson;
  poisson.setInputCloud(cloud);
  EXPECT_FALSE(poisson.makeMesh());
  EXPECT_NE(poisson.getErrorMessage(), "");
  if (!pcl::traits::has_normal<TypeParam>::value) {
    EXPECT_EQ(poisson.getErrorMessage(), "the type of the points has no normals");
  }
}

} // namespace contract
