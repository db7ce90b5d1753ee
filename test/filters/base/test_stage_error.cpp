// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/stage_error.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;

class Stage : public StageError {
public:
  bool run(int value)
  {
    clearError();
    return value > 0 ||
           fail("Stage", "the value must be above 0, it is " + std::to_string(value));
  }
};

TEST(StageError, IsThatOfTheLastRun)
{
  Stage stage;
  EXPECT_EQ(stage.getErrorMessage(), "");
  EXPECT_FALSE(stage.run(-3));
  EXPECT_EQ(stage.getErrorMessage(), "the value must be above 0, it is -3");
  EXPECT_TRUE(stage.run(1));
  EXPECT_EQ(stage.getErrorMessage(), "");
}

TEST(Indices, ThatACloudHasNotAreToldAndLeftOut)
{
  EXPECT_EQ(indicesProblem({}, 0), "");
  EXPECT_EQ(indicesProblem({0, 9, 9}, 10), "");
  EXPECT_EQ(indicesProblem({0, 12, 10}, 10),
            "index 12 is out of range, the cloud has 10 points");
  EXPECT_EQ(indicesProblem({-1}, 1), "index -1 is out of range, the cloud has 1 point");
  EXPECT_EQ(indicesInRange({9, -1, 0, 10}, 10), (pcl::Indices{9, 0}));
}

} // namespace
