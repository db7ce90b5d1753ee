// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/scan/surface.h"

#include <gtest/gtest.h>

namespace pcl::sedr::sim {
namespace {

Ray
rayTowards(Vec3 origin, Vec3 target)
{
  const Vec3 way = target - origin;
  return {origin, (1.0 / length(way)) * way};
}

/** @brief Expects that the ray from @p origin first hits @p shape at @p target. */
void
expectHit(const Shape& shape, Vec3 origin, Vec3 target)
{
  const auto t = intersect(shape, rayTowards(origin, target), 0.0);
  ASSERT_TRUE(t.has_value());
  EXPECT_NEAR(*t, length(target - origin), 1e-12);
}

void
expectMiss(const Shape& shape, Vec3 origin, Vec3 target)
{
  EXPECT_FALSE(intersect(shape, rayTowards(origin, target), 0.0).has_value());
}

TEST(Surface, slabPatchIsHitInsideItsOutlineOnly)
{
  const SlabPatch patch{{2.5},
                        rectangleLoop({0.0, 0.0}, {4.0, 3.0}),
                        {circleLoop({2.0, 1.0}, 0.5)}};
  expectHit(patch, {1.0, 1.0, 1.0}, {3.0, 2.5, 2.5});
  expectMiss(patch, {1.0, 1.0, 1.0}, {4.1, 2.0, 2.5});
  expectMiss(patch, {1.0, 1.0, 1.0}, {2.4, 1.1, 2.5}); // through the hole
  expectMiss(patch, {1.0, 1.0, 1.0}, {3.0, 2.5, 0.5}); // away from the patch
  expectMiss(patch, {1.0, 1.0, 2.5}, {3.0, 2.5, 2.5}); // in its plane
}

TEST(Surface, slabPatchMayTilt)
{
  // Rises by 0.1 m per metre along x: 2.5 m high at x = 1, 2.8 m at x = 4.
  const SlabPatch patch{{2.5, {0.1, 0.0}, {1.0, 0.0}},
                        rectangleLoop({0.0, 0.0}, {4.0, 3.0}),
                        {}};
  expectHit(patch, {1.0, 1.0, 1.0}, {1.0, 1.0, 2.5});
  expectHit(patch, {1.0, 1.0, 1.0}, {3.5, 2.0, 2.75});
  expectHit(patch, {2.0, 1.0, 4.0}, {0.0, 1.0, 2.4});
  expectMiss(patch, {1.0, 1.0, 1.0}, {4.1, 1.0, 2.81});
  const Bounds bounds = boundsOf(Shape{patch});
  EXPECT_NEAR(bounds.min.z, 2.4, 1e-12);
  EXPECT_NEAR(bounds.max.z, 2.8, 1e-12);
}

TEST(Surface, wallsEndOnTiltedPlanes)
{
  // The wall runs along x; its top rises from 2 m to 2.4 m, its foot from 0 to 0.2 m.
  const Element wall{{0.0, 0.0}, {4.0, 0.0}, 0.0};
  const Shape patch = verticalPatch(wall, {0.0, {0.05, 0.0}}, {2.0, {0.1, 0.0}});
  const Vec3 origin{2.0, 3.0, 1.5};
  expectHit(patch, origin, {0.5, 0.0, 2.04});
  expectMiss(patch, origin, {0.5, 0.0, 2.06});
  expectHit(patch, origin, {3.5, 0.0, 2.34});
  expectMiss(patch, origin, {3.5, 0.0, 2.36});
  expectHit(patch, origin, {3.0, 0.0, 0.16});
  expectMiss(patch, origin, {3.0, 0.0, 0.14});
}

TEST(Surface, tellsFromWhichSideItIsSeen)
{
  const auto side = [](const Shape& shape, Vec3 origin, Vec3 target) {
    return sideSeenFrom(shape, rayTowards(origin, target), length(target - origin));
  };
  const SlabPatch slab{{2.5, {0.1, 0.0}}, rectangleLoop({0.0, 0.0}, {4.0, 3.0}), {}};
  EXPECT_EQ(side(slab, {1.0, 1.0, 1.0}, {1.0, 1.0, 2.6}), Side::BelowOrRight);
  EXPECT_EQ(side(slab, {1.0, 1.0, 3.0}, {1.0, 1.0, 2.6}), Side::AboveOrLeft);
  // The ray is almost level, but the slab rises faster: it is seen from above.
  EXPECT_EQ(side(slab, {0.0, 1.0, 2.55}, {1.0, 1.0, 2.6}), Side::AboveOrLeft);

  const Shape plane = verticalPatch({{0.0, 0.0}, {4.0, 0.0}, 0.0}, {0.0}, {3.0});
  EXPECT_EQ(side(plane, {1.0, 1.0, 1.0}, {2.0, 0.0, 1.0}), Side::AboveOrLeft);
  EXPECT_EQ(side(plane, {1.0, -1.0, 1.0}, {2.0, 0.0, 1.0}), Side::BelowOrRight);
  for (const double bulge :
       {1.0, -1.0}) { // from (0, -2) to (0, 2) by (2, 0) or (-2, 0)
    const Shape arc = verticalPatch({{0.0, -2.0}, {0.0, 2.0}, bulge}, {0.0}, {3.0});
    const Side inside = bulge > 0.0 ? Side::AboveOrLeft : Side::BelowOrRight;
    const Vec3 on_arc{2.0 * bulge, 0.0, 1.0};
    EXPECT_EQ(side(arc, {0.0, 0.0, 1.0}, on_arc), inside) << bulge;
    EXPECT_NE(side(arc, {4.0 * bulge, 0.0, 1.0}, on_arc), inside) << bulge;
  }
  EXPECT_EQ(
      side(Box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}, {2.0, 0.0, 0.0}, {0.5, 0.0, 0.0}),
      Side::None);
}

TEST(Surface, planePatchHasRectangularHoles)
{
  const Element wall{{0.0, 2.0}, {3.0, 6.0}, 0.0}; // 5 m long, direction (0.6, 0.8)
  const Shape patch = verticalPatch(wall, {0.0}, {2.5}, {{1.0, 2.0, 0.8, 2.0}});
  const auto at = [](double s, double z) { return Vec3{0.6 * s, 2.0 + 0.8 * s, z}; };
  const Vec3 origin{4.0, 1.0, 1.5};
  expectHit(patch, origin, at(0.5, 1.0));
  expectHit(patch, origin, at(1.5, 0.7));
  expectHit(patch, origin, at(2.1, 1.0));
  expectHit(patch, {-3.0, 4.0, 1.5}, at(4.9, 2.4)); // from the other side
  expectMiss(patch, origin, at(1.5, 1.0));
  expectMiss(patch, origin, at(5.1, 1.0));
  expectMiss(patch, origin, at(0.5, 2.6));
}

TEST(Surface, arcPatchIsHitOnItsArcOnly)
{
  // The right half of a circle of radius 2 around the origin, counter-clockwise.
  const Shape patch = verticalPatch({{0.0, -2.0}, {0.0, 2.0}, 1.0}, {0.0}, {3.0},
                                    {{0.0, 1.0, 1.0, 2.0}});
  const auto at = [](double angle, double z) {
    return lifted(rotated({2.0, 0.0}, angle), z);
  };
  const Vec3 inside{0.1, 0.2, 1.4};
  expectHit(patch, inside, at(0.0, 1.0));
  expectHit(patch, inside, at(1.5, 2.9));
  expectHit(patch, inside, at(-1.2, 0.9));
  expectMiss(patch, inside, at(-1.2, 1.5)); // the hole: 0.37 rad * 2 m = 0.74 m
  expectMiss(patch, inside, at(2.0, 1.0));  // beyond the end of the arc
  expectMiss(patch, inside, at(0.3, 3.1));
  expectHit(patch, {5.0, 0.0, 1.0}, {2.0, 0.0, 1.0});  // from outside
  expectHit(patch, {-5.0, 0.0, 1.0}, {2.0, 0.0, 1.0}); // through the open half
}

TEST(Surface, clockwiseArcRunsTheOtherWay)
{
  const Shape patch = verticalPatch({{0.0, -2.0}, {0.0, 2.0}, -1.0}, {0.0}, {3.0},
                                    {{0.0, 1.0, 1.0, 2.0}});
  expectHit(patch, {0.0, 0.0, 1.5}, {-2.0, 0.0, 1.5});
  expectMiss(patch, {0.0, 0.0, 1.5}, {2.0, 0.0, 1.5});
  expectMiss(patch, {0.0, 0.0, 1.5}, {-2.0 * std::sin(0.3), -2.0 * std::cos(0.3), 1.5});
}

TEST(Surface, turnedBoxIsHitOnItsNearFace)
{
  const Box box{{2.0, 0.0, 1.0}, {2.0, 2.0, 2.0}, pi / 4.0};
  const double corner = 2.0 - std::sqrt(2.0);
  expectHit(box, {-1.0, 0.0, 1.0}, {corner, 0.0, 1.0});
  expectHit(box, {2.0, 0.0, 5.0}, {2.0, 0.0, 2.0});
  expectMiss(box, {-1.0, 1.5, 1.0}, {5.0, 1.5, 1.0});
  expectMiss(box, {-1.0, 0.0, 2.1}, {5.0, 0.0, 2.1});
  expectHit(box, {2.0, 0.0, 1.0}, {2.0, 0.0, 2.0}); // from inside: the exit point
}

TEST(Surface, cylinderIsHitOnMantleAndLids)
{
  const Cylinder cylinder{{1.0, 1.0, 0.5}, 0.5, 1.0};
  expectHit(cylinder, {-1.0, 1.0, 1.0}, {0.5, 1.0, 1.0});
  expectHit(cylinder, {1.2, 1.1, 3.0}, {1.2, 1.1, 1.5});
  expectHit(cylinder, {1.2, 1.1, 0.0}, {1.2, 1.1, 0.5});
  expectHit(cylinder, {1.0, 1.0, 3.0}, {1.4, 1.0, 1.5});
  expectMiss(cylinder, {-1.0, 1.0, 1.6}, {3.0, 1.0, 1.6});
  expectMiss(cylinder, {1.6, 1.0, 3.0}, {1.6, 1.0, 0.0});
}

TEST(Surface, hitsCloserThanTheStartAreSkipped)
{
  const Cylinder cylinder{{2.0, 0.0, 0.0}, 1.0, 2.0};
  const Ray ray{{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}};
  EXPECT_NEAR(*intersect(cylinder, ray, 0.0), 1.0, 1e-12);
  EXPECT_NEAR(*intersect(cylinder, ray, 1.5), 3.0, 1e-12);
  EXPECT_FALSE(intersect(cylinder, ray, 3.5).has_value());
}

TEST(Surface, boundsEncloseATurnedBox)
{
  const Bounds bounds =
      boundsOf(Shape{Box{{1.0, 2.0, 3.0}, {2.0, 2.0, 4.0}, pi / 4.0}});
  EXPECT_NEAR(bounds.min.x, 1.0 - std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(bounds.max.y, 2.0 + std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(bounds.max.z, 5.0, 1e-12);
}

} // namespace
} // namespace pcl::sedr::sim
