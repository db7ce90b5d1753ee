// SPDX-License-Identifier: BSD-3-Clause
// What rays find: distances, labels and shares known in closed form.
#include "sample_scenes.h"
#include "simulator/scan/scan.h"
#include "simulator/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::sedr::sim::test {
namespace {

Vec3
placeOf(const ScanPoint& point)
{
  return {point.x, point.y, point.z};
}

/** @brief Counts the points of a label and room within a box. */
std::size_t
countWithin(const Scan& scan, Label label, std::uint32_t room, Vec3 low, Vec3 high)
{
  const Eigen::AlignedBox3d box(low, high);
  std::size_t count = 0;
  for (const ScanPoint& p : scan.points)
    count += p.room == room && p.label == static_cast<std::uint32_t>(label) &&
             box.contains(placeOf(p));
  return count;
}

TEST(Scan, everyRayOfAClosedRoomEndsOnItsSurfaces)
{
  const Scan result = scan(read(boxFile()));
  EXPECT_EQ(result.points.size(), result.rays);
  EXPECT_NEAR(static_cast<double>(result.rays), 20000, 200);
  for (const ScanPoint& p : result.points) {
    const auto near = [](double a, double b) { return std::abs(a - b) < 1e-5; };
    EXPECT_EQ(p.room, 1U);
    EXPECT_TRUE(p.label == 1 ? near(p.z, 3)
                : p.label == 2
                    ? near(p.z, 0)
                    : near(p.x, 0) || near(p.x, 5) || near(p.y, 0) || near(p.y, 4));
  }
}

TEST(Scan, noiseIsGaussianAlongTheRay)
{
  const Scene scene = read(boxFile());
  ScanOptions options;
  options.rays_per_station = 40000;
  const Scan clean = scan(scene, options);
  options.noise = 0.01;
  const Scan noisy = scan(scene, options);
  ASSERT_EQ(clean.points.size(), noisy.points.size());
  double sum = 0;
  double squares = 0;
  for (std::size_t i = 0; i < clean.points.size(); ++i) {
    const Vec3 ray =
        (placeOf(clean.points[i]) - scene.scanners[0].stations[0]).normalized();
    const Vec3 error = placeOf(noisy.points[i]) - placeOf(clean.points[i]);
    EXPECT_LT(error.cross(ray).norm(), 1e-5);
    sum += error.dot(ray);
    squares += std::pow(error.dot(ray), 2);
  }
  // Tolerances: four standard errors of mean and deviation of 40000 samples.
  const auto count = static_cast<double>(clean.points.size());
  EXPECT_NEAR(sum / count, 0, 2e-4);
  EXPECT_NEAR(std::sqrt(squares / count), 0.01, 1.5e-4);
}

TEST(Scan, pointsAreGroupedByPositionAndWithinTheRange)
{
  const Scene scene = sceneNamed("long_corridor");
  ScanOptions options;
  options.rays_per_station = 700;
  options.noise = 0;
  options.max_range = 1.5;
  const Scan result = scan(scene, options);
  std::size_t next = 0;
  for (const ScanPosition& position : result.positions)
    for (std::size_t k = 0; k < position.points; ++k, ++next)
      EXPECT_LT((placeOf(result.points.at(next)) - position.place).norm(), 1.501);
  EXPECT_EQ(next, result.points.size());
  EXPECT_GT(next, 1000U);
}

TEST(Scan, placementTurnsAndShiftsThePoints)
{
  Scene scene = read(boxFile());
  const Scan plain = scan(scene);
  scene.placement = {90, {10, 20, 30}};
  const Scan moved = scan(scene);
  ASSERT_EQ(plain.points.size(), moved.points.size());
  for (std::size_t i = 0; i < plain.points.size(); ++i) {
    const ScanPoint& p = plain.points[i];
    EXPECT_LT((placeOf(moved.points[i]) - Vec3(10 - p.y, 20 + p.x, 30 + p.z)).norm(),
              1e-5);
  }
}

/** @brief Returns a room with a window of 3 x 2 m in its east wall at x = 5, the pane
 * at x = 5.1, and a facade at x = 9. */
json
windowFile(const std::string& glazing)
{
  return with(boxFile(), R"({
      "/rooms/0/openings": [{"wall": 1, "from": 0.5, "to": 3.5, "sill": 0.5, "head": 2.5,
                             "depth": 0.2, "glazing": )" +
                             glazing + R"(}],
      "/outside": [{"object": {"boxes": [{"center": [9.5, 2, 0], "size": [1, 90, 90]}]}}],
      "/scanners/0/rays": 40000})");
}

TEST(Scan, glassReturnsAndMirrorsItsShares)
{
  const Scan result =
      scan(read(windowFile(R"({"return_share": 0.3, "mirror_share": 0.2})")));
  const auto count = [&](double low, double high) {
    return static_cast<double>(
        countWithin(result, Label::Other, 0, {low, -90, -90}, {high, 90, 90}));
  };
  const double pane = count(5.09, 5.11);
  const double facade = count(8.999, 9.001);
  // The far wall of the mirrored room is at x = 2 * 5.1.
  const double mirrored = count(5.21, 10.2001) - facade;
  const double total = pane + facade + mirrored;
  ASSERT_GT(total, 1000);
  // Some of the rays that pass or are mirrored end on the reveals.
  EXPECT_NEAR(pane / total, 0.3, 0.05);
  EXPECT_NEAR(mirrored / total, 0.2, 0.05);
}

TEST(Scan, structureSeenFromBehindIsNone)
{
  json file = windowFile("{}");
  file["rooms"][0]["openings"][0].erase("glazing");
  file["rooms"][1] = json::parse(
      R"({"name": "shed", "outline": {"rectangle": [[7, 1], [8, 3]]}, "floor": 0,
          "ceiling": 3})");
  const Scan result = scan(read(file));
  EXPECT_GT(countWithin(result, Label::Other, 0, {6.9, 1, 0}, {7.1, 3, 3}), 50U);
  for (const ScanPoint& p : result.points)
    EXPECT_NE(p.room, 2U);
}

TEST(Scan, objectsHaveTheirRoomAndNichesAreDetails)
{
  const Scan result = scan(read(with(boxFile(), R"({
      "/rooms/0/furniture": [{"block": {"at": [3.5, 2], "size": [1, 1, 1]}}],
      "/rooms/0/columns": [{"circle": [1, 3], "radius": 0.3}],
      "/rooms/0/niches": [{"wall": 1, "from": 1, "to": 3, "sill": 1.2, "head": 2,
                           "depth": 0.4}]})")));
  const Vec3 low(-1, -1, -1);
  const Vec3 high(6, 6, 6);
  EXPECT_GT(countWithin(result, Label::Other, 1, {2.99, 1.49, 0}, {4.01, 2.51, 1.01}),
            500U);
  EXPECT_EQ(countWithin(result, Label::Other, 1, low, high),
            countWithin(result, Label::Other, 1, {2.99, 1.49, 0}, {4.01, 2.51, 1.01}));
  EXPECT_GT(countWithin(result, Label::Detail, 1, {5.39, 1, 1.2}, {5.41, 3, 2}), 100U);
  EXPECT_GT(countWithin(result, Label::Column, 1, {0.69, 2.69, 0}, {1.31, 3.31, 3}),
            100U);
}

TEST(Scan, voidsShowTheRoomAbove)
{
  const Scan seen = scan(read(twoStoreyFile()));
  const Vec3 low(1, 3.6, 2.55);
  const Vec3 high(4.5, 4.8, 2.65);
  EXPECT_EQ(countWithin(seen, Label::Ceiling, 1, low, high), 0U);
  EXPECT_GT(countWithin(seen, Label::Wall, 2, {0, 4.9, 2.9}, {6, 5.1, 5.4}), 50U);
  EXPECT_GT(countWithin(seen, Label::Other, 0, {0.99, 3.5, 2.6}, {4.6, 4.9, 2.9}), 20U);
}

TEST(Scan, plenumsAreSeenThroughMissingTilesOnly)
{
  const Scan seen = scan(read(with(boxFile(), R"({"/rooms/0/plenum": 0.4,
      "/rooms/0/voids": [{"loop": {"rectangle": [[2, 2.6], [2.6, 3.2]]}}],
      "/scanners/0/rays": 50000})")));
  EXPECT_EQ(countWithin(seen, Label::Ceiling, 1, {2, 2.6, 2.9}, {2.6, 3.2, 3.1}), 0U);
  EXPECT_GT(countWithin(seen, Label::Other, 0, {0, 0, 3.39}, {5, 4, 3.41}), 100U);
  for (const ScanPoint& point : seen.points)
    EXPECT_LT(point.z, 3.4001F);
}

} // namespace
} // namespace pcl::sedr::sim::test
