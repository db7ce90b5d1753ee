// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/parting/room_borders.h"

#include "parted_scenes.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** The columns of wall between two rooms, which a place is of or not. */
std::size_t
wallsBetween(const SceneAir& air,
             const std::function<bool(const Eigen::Vector3d&)>& is_of_first)
{
  std::vector<std::int32_t> label(air.gaps.size());
  for (std::uint32_t g = 0; g < air.gaps.size(); ++g) {
    const Eigen::Vector2d at =
        air.columns.grid().centre(air.columns.cellOf(air.gaps[g].column));
    const double z = air.columns.heightOf(air.gaps[g].low);
    label[g] = is_of_first({at.x(), at.y(), z}) ? 0 : 1;
  }
  RoomLabels labels(std::move(label));
  const RoomBorders borders(air.gaps, PartingParameters(), labels);
  const auto border = borders.borders().find({0, 1});
  return border == borders.borders().end() ? 0 : border->second.walls;
}

TEST(RoomBorders, HaveWallsWhereWallsStand)
{
  AirScene scene;
  addTwoRooms(scene, {1.05, 1.95, 2.11});
  const SceneAir air(scene);
  EXPECT_NEAR(wallsBetween(air, [](const auto& p) { return p.x() < 4.1; }), 21, 2)
      << "3 m but for a door of 0.9 m";
}

TEST(RoomBorders, HaveNoneAtTheEdgeOfAGallery)
{
  AirScene scene;
  scene.room(0.05, 0.05, 6.05, 3.05, 0.01, 4.31);
  scene.slab(3.05, 0.05, 6.05, 3.05, 2.11);
  const SceneAir air(scene);
  EXPECT_EQ(wallsBetween(air, [](const auto& p) { return p.z() < 1; }), 0u);
}

} // namespace
