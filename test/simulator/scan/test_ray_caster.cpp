// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/scan/random.h"
#include "simulator/scan/ray_caster.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pcl::sedr::sim {
namespace {

double
between(RayRandom& random, double low, double high)
{
  return low + (high - low) * random.uniform();
}

Vec3
pointIn(RayRandom& random, double half)
{
  const double x = between(random, -half, half);
  const double y = between(random, -half, half);
  return {x, y, between(random, -half, half)};
}

std::vector<Surface>
scatteredBoxes(std::size_t count)
{
  RayRandom random(7, 0, 0);
  std::vector<Surface> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 size = pointIn(random, 1.2);
    const Box box{pointIn(random, 5.0),
                  {std::abs(size.x), std::abs(size.y), std::abs(size.z)},
                  between(random, 0.0, pi)};
    boxes.push_back({box, Label::Other, static_cast<std::uint32_t>(i)});
  }
  return boxes;
}

TEST(RayCaster, findsTheSameHitAsTryingEverySurface)
{
  const std::vector<Surface> boxes = scatteredBoxes(200);
  const RayCaster caster(boxes);
  std::size_t hits = 0;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    RayRandom random(1, 2, i);
    const Vec3 origin = pointIn(random, 6.0);
    const Vec3 way = pointIn(random, 1.0);
    const Ray ray{origin, (1.0 / length(way)) * way};
    double nearest = 8.0;
    for (const Surface& surface : boxes)
      nearest = std::min(nearest, intersect(surface.shape, ray, 0.1).value_or(nearest));
    const auto hit = caster.nearest(ray, 0.1, 8.0);
    ASSERT_EQ(hit.has_value(), nearest < 8.0) << i;
    if (hit) {
      ASSERT_DOUBLE_EQ(hit->distance, nearest) << i;
      ++hits;
    }
  }
  EXPECT_GT(hits, 500U);
}

TEST(RayCaster, hasNoHitWithoutSurfacesOrBeyondTheRange)
{
  const Ray ray{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  EXPECT_FALSE(RayCaster({}).nearest(ray, 0.0, 100.0).has_value());
  const RayCaster caster({{Box{{5.5, 0.0, 0.0}, {1.0, 1.0, 1.0}}, Label::Other, 0}});
  EXPECT_FALSE(caster.nearest(ray, 0.0, 4.9).has_value());
  EXPECT_TRUE(caster.nearest(ray, 0.0, 5.1).has_value());
}

} // namespace
} // namespace pcl::sedr::sim
