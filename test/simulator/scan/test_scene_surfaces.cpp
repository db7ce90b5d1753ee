// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/sample_rooms.h"
#include "simulator/scan/scene_surfaces.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pcl::sedr::sim::test {
namespace {

constexpr double kNotHit = -1.0;

/** @brief Returns two rooms of 4 x 3 m with a door in the 10 cm between them. */
Scene
twoRooms()
{
  Room left = makeBoxRoom(4.0, 3.0, 2.5);
  Room right = left;
  right.outline = rectangleLoop({4.1, 0.0}, {8.1, 3.0});
  Opening door{1, 1.0, 1.9, 0.0, 2.05, 0.1};
  door.leads_to = 1;
  left.openings.push_back(door);
  Scene scene;
  scene.rooms = {left, right};
  return scene;
}

Hit
hitFrom(const RayCaster& caster, Vec3 origin, Vec3 target)
{
  const Vec3 way = target - origin;
  const Ray ray{origin, (1.0 / length(way)) * way};
  return caster.nearest(ray, 0.0, 100.0).value_or(Hit{kNotHit, nullptr});
}

TEST(SceneSurfaces, doorIsCutIntoTheWallsOfBothRooms)
{
  const auto openings = openingsByRoom(twoRooms());
  ASSERT_EQ(openings[0].size(), 1U);
  ASSERT_EQ(openings[1].size(), 1U);
  const Opening& other = openings[1].front();
  EXPECT_EQ(other.wall, 3U);
  EXPECT_EQ(other.leads_to, std::size_t{0});
  EXPECT_NEAR(other.from, 3.0 - 1.9, 1e-9);
  EXPECT_NEAR(other.to, 3.0 - 1.0, 1e-9);
}

TEST(SceneSurfaces, raysPassTheDoorAndMeetItsReveals)
{
  const RayCaster caster(surfacesOf(twoRooms()));
  const Hit through = hitFrom(caster, {1.0, 1.5, 1.0}, {8.1, 1.5, 1.0});
  EXPECT_NEAR(through.distance, 7.1, 1e-9);
  EXPECT_EQ(through.surface->label, Label::Wall);
  EXPECT_EQ(through.surface->room, 2U);

  for (const Vec3 target : {Vec3{4.05, 1.0, 1.0},    // jamb
                            Vec3{4.05, 1.9, 1.0},    // jamb
                            Vec3{4.05, 1.5, 2.05},   // head
                            Vec3{4.05, 1.5, 0.0}}) { // threshold
    const Hit reveal = hitFrom(caster, {1.0, 1.5, 1.0}, target);
    ASSERT_NE(reveal.surface, nullptr);
    EXPECT_NEAR(reveal.distance, length(target - Vec3{1.0, 1.5, 1.0}), 1e-9);
    EXPECT_EQ(reveal.surface->label, Label::Other);
    EXPECT_EQ(reveal.surface->room, 0U);
  }
  EXPECT_EQ(hitFrom(caster, {1.0, 1.5, 1.0}, {4.0, 0.9, 1.0}).surface->room, 1U);
}

TEST(SceneSurfaces, roomsAreTightBesideTheirOpenings)
{
  // Rays from inside the right room in all directions: the only exit is the door.
  const RayCaster caster(surfacesOf(twoRooms()));
  const Vec3 origin{6.0, 1.2, 1.3};
  for (int i = 0; i < 2000; ++i) {
    const double z = -0.999 + 1.998 * i / 1999.0;
    const Vec2 level = std::sqrt(1.0 - z * z) * rotated({1.0, 0.0}, 2.39996 * i);
    const auto hit = caster.nearest({origin, lifted(level, z)}, 0.0, 100.0);
    ASSERT_TRUE(hit.has_value()) << i;
    EXPECT_LT(hit->distance, 8.0) << i;
  }
}

TEST(SceneSurfaces, detailsAndColumnsCarryTheirLabels)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.details.push_back({rectangleLoop({0.0, 0.0}, {1.0, 4.0}), {2.5}});
  room.columns.push_back(circleLoop({3.0, 2.0}, 0.35));
  const RayCaster caster(surfacesOf(makeScene(room, {}, 1)));
  const auto label = [&caster](Vec3 target) {
    const Hit hit = hitFrom(caster, {2.0, 2.0, 1.5}, target);
    return hit.surface == nullptr ? Label::Other : hit.surface->label;
  };
  EXPECT_EQ(label({0.5, 2.0, 2.5}), Label::Detail);
  EXPECT_EQ(label({1.0, 2.0, 2.75}), Label::Detail);
  EXPECT_EQ(label({1.5, 2.0, 3.0}), Label::Ceiling);
  EXPECT_EQ(label({0.0, 2.0, 2.2}), Label::Wall);
  EXPECT_EQ(label({2.65, 2.0, 1.5}), Label::Column);
  EXPECT_EQ(label({2.0, 3.0, 0.0}), Label::Floor);
}

TEST(SceneSurfaces, nichesAndPlatformsAreDetails)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.floor_details.push_back({rectangleLoop({0.0, 0.0}, {1.0, 4.0}), {0.2}});
  room.niches.push_back({1, 1.0, 3.0, 0.8, 2.0, 0.4}); // in the wall at x = 5
  const RayCaster caster(surfacesOf(makeScene(room, {}, 1)));
  for (const Vec3 target : {Vec3{0.5, 2.0, 0.2},    // on the platform
                            Vec3{1.0, 2.0, 0.1},    // its riser
                            Vec3{5.4, 2.0, 1.5},    // the back of the niche
                            Vec3{5.2, 1.0, 1.5},    // its sides
                            Vec3{5.2, 3.0, 1.5},    //
                            Vec3{5.2, 2.0, 0.8},    // its bottom
                            Vec3{5.2, 2.0, 2.0}}) { // and its lid
    const Vec3 eye{2.0, 2.0, 1.5};
    const Hit hit = hitFrom(caster, eye, target);
    ASSERT_NE(hit.surface, nullptr);
    EXPECT_NEAR(hit.distance, length(target - eye), 1e-9);
    EXPECT_EQ(hit.surface->label, Label::Detail);
    EXPECT_EQ(hit.surface->room, 1U);
    EXPECT_EQ(sideSeenFrom(hit.surface->shape,
                           {eye, (1.0 / hit.distance) * (target - eye)}, hit.distance),
              hit.surface->front);
  }
  EXPECT_EQ(hitFrom(caster, {2.0, 2.0, 1.5}, {5.0, 0.9, 1.5}).surface->label,
            Label::Wall);
}

TEST(SceneSurfaces, openingKeepsItsPlaceOnAWallThatASoffitDivides)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.details.push_back({rectangleLoop({1.0, 0.0}, {3.0, 1.0}), {2.5}});
  room.openings.push_back({0, 2.5, 3.5, 1.0, 2.0, 0.2}); // half of it below the soffit
  const RayCaster caster(surfacesOf(makeScene(room, {}, 1)));
  const auto is_open = [&caster](double x) {
    return hitFrom(caster, {x, 2.0, 1.5}, {x, 0.0, 1.5}).surface == nullptr;
  };
  for (const double x : {0.5, 1.5, 2.49, 3.51, 4.5})
    EXPECT_FALSE(is_open(x)) << x;
  for (const double x : {2.51, 2.9, 3.1, 3.49})
    EXPECT_TRUE(is_open(x)) << x;
}

TEST(SceneSurfaces, curvedWallsHaveOpeningsToo)
{
  Room room = makeBoxRoom(4.0, 4.0, 3.0);
  room.outline[1].bulge = 0.4;
  const Element wall = elementOf(room.outline, 1);
  const double middle = 0.5 * lengthOf(wall);
  room.openings.push_back({1, middle - 0.5, middle + 0.5, 1.0, 2.0, 0.3});
  const RayCaster caster(surfacesOf(makeScene(room, {}, 1)));
  const double top = 4.0 + 0.4 * 2.0; // sagitta: bulge times half the chord
  EXPECT_NEAR(hitFrom(caster, {1.0, 2.0, 0.5}, {9.0, 2.0, 0.5}).distance, top - 1.0,
              1e-9);
  EXPECT_EQ(hitFrom(caster, {1.0, 2.0, 1.5}, {9.0, 2.0, 1.5}).surface, nullptr);
  const Hit sill = hitFrom(caster, {1.0, 2.0, 1.5}, {top + 0.15, 2.0, 1.0});
  EXPECT_EQ(sill.surface->label, Label::Other);
}

TEST(SceneSurfaces, rejectsOpeningsThatFitNowhere)
{
  Scene scene = twoRooms();
  scene.rooms[0].openings.front().depth = 0.2; // the other room begins after 0.1
  EXPECT_THROW(surfacesOf(scene), std::invalid_argument);
  scene = twoRooms();
  scene.rooms[0].openings.front().to = 3.2; // the wall is 3 m long
  EXPECT_THROW(surfacesOf(scene), std::invalid_argument);
  scene = twoRooms();
  scene.rooms[0].openings.front().leads_to = 7;
  EXPECT_THROW(surfacesOf(scene), std::invalid_argument);
  scene = twoRooms();
  scene.rooms[0].openings.front().wall = 4;
  EXPECT_THROW(surfacesOf(scene), std::invalid_argument);
}

} // namespace
} // namespace pcl::sedr::sim::test
