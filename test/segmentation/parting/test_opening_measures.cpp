// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/parting/room_borders.h"
#include "sedr_segmentation/src/parting/room_opening.h"

#include "parted_scenes.h"

#include <array>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** The jambs of a doorway of 0.9 m through a wall of 50 cm between two rooms, which
 * meet at x within it. */
std::array<double, 2>
jambsOfRoomsThatMeetAt(AirScene& scene, double x)
{
  for (const double z : {0.01, 2.51}) {
    scene.slab(0.05, 0.05, 3.05, 3.05, z);
    scene.slab(3.05, 1.05, 3.55, 1.95, z);
    scene.slab(3.55, 0.05, 6.55, 3.05, z);
  }
  for (const auto& [x0, x1] : {std::pair(0.05, 3.05), std::pair(3.55, 6.55)}) {
    scene.wall(x0, 0.05, x1, 0.05, 0.01, 2.51);
    scene.wall(x0, 3.05, x1, 3.05, 0.01, 2.51);
  }
  for (const double side : {0.05, 6.55})
    scene.wall(side, 0.05, side, 3.05, 0.01, 2.51);
  for (const double face : {3.05, 3.55}) {
    scene.wall(face, 0.05, face, 1.05, 0.01, 2.51);
    scene.wall(face, 1.95, face, 3.05, 0.01, 2.51);
  }
  for (const double side : {1.05, 1.95})
    scene.wall(3.05, side, 3.55, side, 0.01, 2.51);
  const SceneAir air(scene);
  std::vector<std::int32_t> label(air.gaps.size());
  for (std::uint32_t g = 0; g < air.gaps.size(); ++g)
    label[g] = (air.columns.grid().centre(air.columns.cellOf(air.gaps[g].column)) -
                scene.place(x, 0))
                           .dot(scene.place(1, 0)) < 0
                   ? 0
                   : 1;
  RoomLabels labels(std::move(label));
  const auto crossings = waysBetween(air.gaps, labels);
  const std::vector<float> no_dip(air.gaps.size(), 0.0F);
  const PartingParameters parameters;
  const MeasuredOpening opening = OpeningMeasures(air.gaps, no_dip, parameters)
                                      .measure(crossings.begin()->second, labels);
  return {opening.jamb_a, opening.jamb_b};
}

TEST(OpeningMeasures, FindTheJambsWhereverInAWallTwoRoomsMeet)
{
  for (const double x : {3.1, 3.3, 3.5})
    forBothTurns([x](AirScene& scene) {
      const std::array<double, 2> jambs = jambsOfRoomsThatMeetAt(scene, x);
      EXPECT_NEAR(jambs[0], 1, 0.3) << "the wall beside the door is 1 m, " << x;
      EXPECT_NEAR(jambs[1], 1, 0.3) << x;
    });
}

} // namespace
