// SPDX-License-Identifier: BSD-3-Clause
#include "air_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room of 4 m x 3 m, 2.5 m high, and in it points at 2 m, in every second row and
 * column of those that a surface would have. */
AirScene
roomWithLayer(const PlanLoop& loop)
{
  AirScene scene;
  scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  scene.points.slab(loop, 2.01, [](double x, double y) {
    return std::lround(x / 0.05 - 0.5) % 2 == 0 && std::lround(y / 0.05 - 0.5) % 2 == 0;
  });
  return scene;
}

/** Height of the air over a place, metres, with or without a look at veils. */
double
heightAt(const AirScene& scene, double x, double y, bool knows_veils)
{
  const VoxelColumns fine(scene.points.view(), {}, 0.05, 0.05, 1);
  const VoxelColumns columns = fine.halved(1);
  const AirGaps air(columns, columns, SceneAir::parametersFor(1),
                    knows_veils ? &fine : nullptr);
  const std::uint32_t column = columns.columnAt(columns.grid().at(x, y));
  return air.height(air.first(column));
}

TEST(Veils, EndNoAirWhereTheCeilingIsSeenThroughThem)
{
  const AirScene scene = roomWithLayer(rectangle(1.05, 1.05, 2.05, 2.05));
  EXPECT_NEAR(heightAt(scene, 1.5, 1.5, false), 1.95, 1e-9) << "up to the points";
  EXPECT_NEAR(heightAt(scene, 1.5, 1.5, true), 2.45, 1e-9) << "up to the ceiling";
}

TEST(Veils, AreNoHeadsOfOpeningsInThickWalls)
{
  AirScene scene = roomWithLayer(rectangle(1.05, 1.05, 1.55, 2.05));
  scene.sides(1.05, 1.05, 1.55, 2.05, 2.01, 2.51);
  EXPECT_NEAR(heightAt(scene, 1.3, 1.5, true), 1.95, 1e-9);
}

} // namespace
