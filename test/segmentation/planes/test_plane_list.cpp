// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/planes/plane_list.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;

pcl::HorizontalPlane
plane(LevelKind kind, double height, double area)
{
  pcl::HorizontalPlane result;
  result.kind = kind;
  result.height = height;
  result.area = area;
  return result;
}

TEST(PlaneList, TheAreaOfRoomsIsThatOfWhatThereIsLessOf)
{
  EXPECT_EQ(areaOfRooms({}), 0);
  const std::vector<pcl::HorizontalPlane> planes{
      plane(LevelKind::Ceiling, 2.5, 12), plane(LevelKind::Ceiling, 2.2, 3),
      plane(LevelKind::Floor, 0, 9), plane(LevelKind::Other, 0.7, 50)};
  EXPECT_EQ(areaOfRooms(planes), 9);
  EXPECT_EQ(areaOfRooms({planes[0], planes[1]}), 0);
}

TEST(PlaneList, NamesTheLargestSixLargestFirst)
{
  std::vector<pcl::HorizontalPlane> planes;
  for (int k = 1; k <= 7; ++k)
    planes.push_back(plane(LevelKind::Other, 0.1 * k, k));
  planes[3].kind = LevelKind::Ceiling;
  planes[4].kind = LevelKind::Floor;
  EXPECT_EQ(listOf(planes), "0.70 m other 7.0 m2, 0.60 m other 6.0 m2, 0.50 m floor "
                            "5.0 m2, 0.40 m ceiling 4.0 m2, 0.30 m other 3.0 m2, 0.20 "
                            "m other 2.0 m2");
}

TEST(PlaneList, SaysWhatIsMissingOnlyWhereACeilingOrAFloorIs)
{
  const pcl::HorizontalPlane ceiling = plane(LevelKind::Ceiling, 2.5, 12);
  const pcl::HorizontalPlane floor = plane(LevelKind::Floor, 0, 12);
  EXPECT_EQ(missingKind({ceiling, floor}, 1.8), "");
  EXPECT_EQ(missingKind({ceiling}, 1.8),
            "of 1 horizontal planes 1 are ceilings and 0 floors; a ceiling needs a "
            "floor at least 1.80 m below it; found: 2.50 m ceiling 12.0 m2");
  EXPECT_NE(missingKind({floor, floor}, 2).find("0 are ceilings and 2 floors"),
            std::string::npos);
  EXPECT_NE(missingKind({}, 2), "");
}

} // namespace
