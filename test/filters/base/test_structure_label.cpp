// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/structure_label.h>

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace pcl::sedr;

TEST(StructureLabel, TheNumbersOfFilesHaveNames)
{
  const char* const names[] = {"other", "ceiling", "floor", "wall", "detail", "column"};
  for (std::uint32_t value = 0; value < 6; ++value)
    EXPECT_EQ(std::string(toString(static_cast<StructureLabel>(value))), names[value]);
  EXPECT_EQ(std::string(toString(static_cast<StructureLabel>(77))), "other");
}

TEST(SurfacePoint, IsOfNoRoomAndFacesUpUnlessToldOtherwise)
{
  const SurfacePoint point;
  EXPECT_EQ(point.label, StructureLabel::Other);
  EXPECT_EQ(point.room, 0u);
  EXPECT_EQ(point.normal, Eigen::Vector3d::UnitZ());
}

} // namespace
