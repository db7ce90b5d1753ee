// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/scan/scene_surfaces.h"
#include "simulator/scene/vaults.h"
#include "simulator/truth/mesh_measures.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pcl::sedr::sim::test {
namespace {

Room
roomBelow(std::vector<SlabDetail> facets)
{
  Room room;
  room.name = "room";
  room.outline = rectangleLoop({0, 0}, {6, 4});
  room.ceiling.height = 2.5;
  room.details = std::move(facets);
  return room;
}

Mesh
truthOf(const Room& room)
{
  Scene scene;
  scene.rooms.push_back(room);
  return truthMesh(scene);
}

TEST(Vaults, aBarrelHoldsHalfACylinder)
{
  const Vault vault{{0, 2}, 0.0, 1.2, 2.0};
  const Mesh mesh = truthOf(roomBelow(facetsOf(vault, rectangleLoop({0, 0}, {6, 4}))));
  EXPECT_TRUE(isClosedManifold(mesh));
  EXPECT_NEAR(signedVolume(mesh), 6 * (4 * 1.2 + pi * 2), 0.002);
  // The last centimetres above the springing lines are as steep as the walls.
  EXPECT_NEAR(areaOf(mesh, Label::Ceiling), 6 * pi * 2, 0.3);
  EXPECT_EQ(areaOf(mesh, Label::Detail), 0.0);
}

TEST(Vaults, aDomeHoldsACapOfASphere)
{
  const double base = 2.5 - std::sqrt(9.0 - 1.5 * 1.5);
  const Mesh mesh = truthOf(roomBelow(facetsOf(Dome{{3, 2}, base, 3.0, 1.5})));
  const double h = 3.0 - (2.5 - base);
  EXPECT_TRUE(isClosedManifold(mesh));
  EXPECT_NEAR(signedVolume(mesh), 6 * 4 * 2.5 + pi * h * h * (3.0 - h / 3.0), 0.003);
}

TEST(Vaults, aScaledDomeHoldsACapOfAnEllipsoid)
{
  Dome dome{{3, 2}, 0, 3.0, 1.5};
  dome.along = 0.9;
  dome.across = 0.6;
  dome.up = 0.5;
  dome.direction = 0.4;
  dome.height = 2.5 - dome.up * std::sqrt(9.0 - 1.5 * 1.5);
  const Mesh mesh = truthOf(roomBelow(facetsOf(dome)));
  const double h = 3.0 - std::sqrt(9.0 - 1.5 * 1.5);
  EXPECT_TRUE(isClosedManifold(mesh));
  EXPECT_NEAR(signedVolume(mesh),
              6 * 4 * 2.5 + 0.9 * 0.6 * 0.5 * pi * h * h * (3.0 - h / 3.0), 0.003);
}

TEST(Vaults, facetsStrayByTenthsOfAMillimetre)
{
  const Vault vault{{0, 2}, 0.3, -1.0, 5.0};
  for (const SlabDetail& facet : facetsOf(vault, rectangleLoop({0, 0}, {6, 4}))) {
    Vec2 middle{};
    for (const LoopVertex& vertex : facet.loop)
      middle =
          middle + (1.0 / static_cast<double>(facet.loop.size())) * vertex.position;
    const double off = cross(Vec2{std::cos(0.3), std::sin(0.3)}, middle - vault.at);
    EXPECT_NEAR(heightAt(facet.slab, middle), -1.0 + std::sqrt(25.0 - off * off),
                1.2 * kFacetTolerance);
    EXPECT_TRUE(facet.is_facet);
  }
}

TEST(Vaults, mustReachTheSidesOfTheirLoop)
{
  EXPECT_THROW(facetsOf(Vault{{0, 2}, 0.0, 1.2, 1.9}, rectangleLoop({0, 0}, {6, 4})),
               std::invalid_argument);
  Loop round = circleLoop({0, 0}, 1.0);
  EXPECT_THROW(facetsOf(Vault{{0, 0}, 0.0, 1.2, 1.9}, round), std::invalid_argument);
}

} // namespace
} // namespace pcl::sedr::sim::test
