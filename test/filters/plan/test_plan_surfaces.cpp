// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_filters/src/plan/plan_surfaces.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;
using Eigen::Vector3d;

/** 4 m x 3 m, 2.5 m high. */
PlanRoom
box()
{
  return roomOf(rectangle(0, 0, 4, 3), 2.5, 7);
}

/** Returns the vertical surface through a place of the plan with a label, preferably
 * one with a span. */
const VerticalSurface*
through(const std::vector<VerticalSurface>& surfaces,
        const Vector2d& place,
        StructureLabel label)
{
  const VerticalSurface* found = nullptr;
  for (const auto& surface : surfaces) {
    if (surface.label != label || surface.element->distance(place) > 1e-9)
      continue;
    const VerticalSpan span = surface.spanAt(surface.element->project(place));
    if (span.high > span.low) {
      EXPECT_EQ(found, nullptr) << "one surface only at " << place.transpose();
      found = &surface;
    }
  }
  return found;
}

/** Expects heights and normal of the only surface through a place; NaN: no surface. */
void
expectSpan(const PlanRoom& room,
           const Vector2d& place,
           StructureLabel label,
           double low,
           double high,
           const Vector3d& normal)
{
  const auto surfaces = verticalSurfaces(room);
  const VerticalSurface* surface = through(surfaces, place, label);
  ASSERT_NE(surface, nullptr) << place.transpose();
  const double s = surface->element->project(place);
  EXPECT_NEAR(surface->spanAt(s).low, low, 1e-9) << place.transpose();
  EXPECT_NEAR(surface->spanAt(s).high, high, 1e-9) << place.transpose();
  EXPECT_NEAR((surface->normalAt(s) - normal).norm(), 0, 1e-9) << place.transpose();
}

void
expectNoRiser(const PlanRoom& room, const Vector2d& place)
{
  const auto surfaces = verticalSurfaces(room);
  EXPECT_EQ(through(surfaces, place, StructureLabel::Detail), nullptr)
      << place.transpose();
}

SurfacePoint
snapped(const PlanRoom& room, const Vector3d& p, StructureLabel label, double farthest)
{
  SurfacePoint point;
  EXPECT_TRUE(RoomSurfaces(room, farthest).snap(p, label, point)) << p.transpose();
  return point;
}

bool
isRefused(const PlanRoom& room,
          const Vector3d& p,
          StructureLabel label,
          double farthest)
{
  SurfacePoint point;
  return !RoomSurfaces(room, farthest).snap(p, label, point);
}

constexpr auto Wall = StructureLabel::Wall;
constexpr auto Detail = StructureLabel::Detail;
constexpr auto Column = StructureLabel::Column;
constexpr auto Ceiling = StructureLabel::Ceiling;
constexpr auto Floor = StructureLabel::Floor;

TEST(VerticalSurfaces, AreWallsThenColumnsThenRisers)
{
  PlanRoom room = box();
  room.columns = {reversed(circle({1, 1}, 0.2))};
  room.details = {detailOf(rectangle(2, 0, 4, 3), 2.2)};
  room.details[0].holes = {reversed(rectangle(3, 1, 3.5, 2))};
  const auto surfaces = verticalSurfaces(room);
  ASSERT_EQ(surfaces.size(), 4u + 1u + 4u + 4u);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    EXPECT_EQ(surfaces[i].label, i < 4 ? Wall : i < 5 ? Column : Detail);
}

TEST(WallSpan, EndsAtTheSoffitAboveAndReachesIntoARecess)
{
  PlanRoom room = box();
  room.details = {detailOf(rectangle(3, 0, 4, 3), 2.1),
                  detailOf(rectangle(0, 0, 1, 1), 2.8)};
  expectSpan(room, {2, 0}, Wall, 0, 2.5, {0, 1, 0});
  expectSpan(room, {3.5, 0}, Wall, 0, 2.1, {0, 1, 0});
  expectSpan(room, {4, 1.5}, Wall, 0, 2.1, {-1, 0, 0});
  expectSpan(room, {0.5, 0}, Wall, 0, 2.8, {0, 1, 0});
}

TEST(RiserSpan, OfASoffitFacesTheMainCeiling)
{
  PlanRoom room = box();
  room.details = {detailOf(rectangle(3, 0, 4, 3), 2.1)};
  expectSpan(room, {3, 1.5}, Detail, 2.1, 2.5, {-1, 0, 0});
}

TEST(RiserSpan, EdgesOnWallsAndColumnsAreNone)
{
  PlanRoom room = box();
  room.columns = {reversed(rectangle(3, 1, 3.4, 1.4))};
  room.details = {detailOf(rectangle(3, 0, 4, 3), 2.1)};
  expectNoRiser(room, {4, 1.5});
  expectNoRiser(room, {3.5, 0});
  expectNoRiser(room, {3, 1.2}); // the column's face
  expectSpan(room, {3, 0.5}, Detail, 2.1, 2.5, {-1, 0, 0});
}

TEST(RiserSpan, BetweenTwoDetailsThereIsOneAndItFacesTheHigher)
{
  for (const bool lower_first : {true, false}) {
    PlanRoom room = box();
    room.details = {detailOf(rectangle(2, 0, 3, 3), lower_first ? 1.9 : 2.2),
                    detailOf(rectangle(3, 0, 4, 3), lower_first ? 2.2 : 1.9)};
    // through() fails the test if both details have a riser there.
    expectSpan(room, {3, 1.5}, Detail, 1.9, 2.2, {lower_first ? 1.0 : -1.0, 0.0, 0.0});
    expectSpan(room, {2, 1.5}, Detail, lower_first ? 1.9 : 2.2, 2.5, {-1, 0, 0});
  }
}

TEST(SnapToRoom, SlabPointsMoveToThePlaneAndKeepTheirPlace)
{
  PlanRoom room = box();
  room.ceiling = slabAt(2.4, 0.1);
  const SurfacePoint top = snapped(room, {2, 1, 2.55}, Ceiling, 0.1);
  EXPECT_NEAR((top.position - Vector3d(2, 1, 2.6)).norm(), 0, 1e-12);
  EXPECT_NEAR((top.normal - Vector3d(0.1, 0, -1).normalized()).norm(), 0, 1e-12)
      << "square to the plane, downwards";
  EXPECT_EQ(top.label, Ceiling);
  const SurfacePoint ground = snapped(room, {2, 1, -0.05}, Floor, 0.1);
  EXPECT_NEAR((ground.position - Vector3d(2, 1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((ground.normal - Vector3d(0, 0, 1)).norm(), 0, 1e-12);
  EXPECT_EQ(ground.label, Floor);
}

TEST(SnapToRoom, DetailPointsGoToTheUndersideOrTheRiserWhicheverIsNearer)
{
  PlanRoom room = box();
  room.details = {detailOf(rectangle(3, 0, 4, 3), 2.1)};
  const SurfacePoint under = snapped(room, {3.05, 1, 2.13}, Detail, 0.15);
  EXPECT_NEAR((under.position - Vector3d(3.05, 1, 2.1)).norm(), 0, 1e-12);
  EXPECT_NEAR((under.normal - Vector3d(0, 0, -1)).norm(), 0, 1e-12);
  EXPECT_EQ(under.label, Detail);
  for (const double x : {2.96, 3.04}) {
    const SurfacePoint riser = snapped(room, {x, 1, 2.3}, Detail, 0.15);
    EXPECT_NEAR((riser.position - Vector3d(3, 1, 2.3)).norm(), 0, 1e-12);
    EXPECT_NEAR((riser.normal - Vector3d(-1, 0, 0)).norm(), 0, 1e-12);
    EXPECT_EQ(riser.label, Detail);
  }
  // A point labelled detail below the main ceiling belongs to the ceiling.
  EXPECT_EQ(snapped(room, {1, 1, 2.45}, Detail, 0.15).label, Ceiling);
  // A point labelled ceiling below the soffit belongs to the soffit.
  EXPECT_EQ(snapped(room, {3.5, 1, 2.15}, Ceiling, 0.15).label, Detail);
}

TEST(SnapToRoom, RefusesWallPointsAboveTheCeilingOrBelowTheFloor)
{
  PlanRoom room = box();
  room.details = {detailOf(rectangle(3, 0, 4, 3), 2.1)};
  EXPECT_TRUE(isRefused(room, {4, 1, 2.3}, Wall, 0.1)) << "above the soffit";
  EXPECT_TRUE(isRefused(room, {0, 1, 2.7}, Wall, 0.1));
  EXPECT_TRUE(isRefused(room, {0, 1, -0.2}, Wall, 0.1));
  EXPECT_NEAR(snapped(room, {0, 1, 2.55}, Wall, 0.1).position.z(), 2.5, 1e-12);
}

} // namespace
