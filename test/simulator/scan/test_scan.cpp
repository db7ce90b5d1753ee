// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/sample_rooms.h"
#include "simulator/scan/scan.h"
#include "simulator/scene/scenes.h"
#include "simulator/truth/mesh_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace pcl::sedr::sim::test {
namespace {

Vec3
positionOf(const ScanPoint& point)
{
  return {point.x, point.y, point.z};
}

std::size_t
countOf(const Scan& scan, Label label)
{
  return std::count_if(scan.points.begin(), scan.points.end(),
                       [label](const ScanPoint& point) {
                         return point.label == static_cast<std::uint32_t>(label);
                       });
}

bool
sameBytes(const Scan& a, const Scan& b)
{
  const std::size_t size = a.points.size() * sizeof(ScanPoint);
  return a.points.size() == b.points.size() &&
         std::memcmp(a.points.data(), b.points.data(), size) == 0;
}

/** @brief Returns the distance to the faces of the point's own label and room. */
double
distanceToTruth(const ScanPoint& point, const Mesh& truth)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Face& face : truth.faces)
    if (static_cast<std::uint32_t>(face.label) == point.label &&
        face.room == point.room)
      nearest = std::min(nearest, distanceToFace(positionOf(point), truth, face));
  return nearest;
}

TEST(Scan, noiseFreeStructureLiesOnTheTruth)
{
  for (const Scene& scene : allScenes()) {
    ScanOptions options;
    options.noise = 0.0;
    options.rays_per_station = 2400 / scene.scanners.front().stations.size();
    Mesh truth = truthMesh(scene, 2e-5); // true arcs are up to this far from the chords
    for (Vec3& vertex : truth.vertices)
      vertex = placed(scene.placement, vertex);
    std::size_t structure = 0;
    for (const ScanPoint& point : scan(scene, options).points)
      if (point.label != 0) {
        EXPECT_LT(distanceToTruth(point, truth), 1e-4) << scene.name;
        ++structure;
      }
    EXPECT_GT(structure, 1000U) << scene.name;
  }
}

TEST(Scan, everyPointIsWithinTheRangeOfItsPosition)
{
  const Scene scene = sceneNamed("long_corridor");
  ScanOptions options;
  options.rays_per_station = 700;
  options.noise = 0.0;
  options.max_range = 1.5;
  const Scan scanned = scan(scene, options);
  std::size_t stations = 0;
  for (const Scanner& scanner : scene.scanners)
    stations += scanner.stations.size();
  ASSERT_EQ(scanned.positions.size(), stations);
  std::size_t next = 0;
  for (const ScanPosition& position : scanned.positions)
    for (std::size_t k = 0; k < position.points; ++k, ++next) {
      ASSERT_LT(next, scanned.points.size());
      EXPECT_LT(length(positionOf(scanned.points[next]) - position.place), 1.501);
    }
  EXPECT_EQ(next, scanned.points.size());
  EXPECT_GT(next, 1000U);
}

TEST(Scan, sameSeedGivesTheSameBytesForAnyNumberOfThreads)
{
  const Scene scene = sceneNamed("bls_room");
  ScanOptions options;
  options.rays_per_station = 700;
  options.threads = 1;
  const Scan one = scan(scene, options);
  for (const unsigned threads : {2U, 5U, 1000U}) {
    options.threads = threads;
    EXPECT_TRUE(sameBytes(one, scan(scene, options))) << threads;
  }
  options.seed = 2;
  EXPECT_FALSE(sameBytes(one, scan(scene, options)));
}

TEST(Scan, everyRayOfAClosedRoomReturnsAPoint)
{
  const Scene scene = makeScene(makeBoxRoom(5.0, 4.0, 3.0), {2.0, 1.5, 1.5}, 20000);
  const Scan result = scan(scene);
  EXPECT_EQ(result.points.size(), result.rays);
  EXPECT_NEAR(static_cast<double>(result.rays), 20000.0, 200.0);
  EXPECT_GT(countOf(result, Label::Ceiling), 0U);
  EXPECT_GT(countOf(result, Label::Floor), 0U);
  EXPECT_GT(countOf(result, Label::Wall), 0U);
  EXPECT_EQ(countOf(result, Label::Other), 0U);
}

TEST(Scan, noiseIsGaussianAlongTheRay)
{
  Scene scene = makeScene(makeBoxRoom(5.0, 4.0, 3.0), {2.0, 1.5, 1.5}, 40000);
  const Scan clean = scan(scene);
  scene.scanners.front().noise = 0.01;
  const Scan noisy = scan(scene);
  ASSERT_EQ(clean.points.size(), noisy.points.size());
  const Vec3 station = scene.scanners.front().stations.front();
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < clean.points.size(); ++i) {
    const Vec3 ray = positionOf(clean.points[i]) - station;
    const Vec3 error = positionOf(noisy.points[i]) - positionOf(clean.points[i]);
    const double along = dot(error, ray) / length(ray);
    EXPECT_LT(length(cross(error, ray)) / length(ray), 1e-5);
    sum += along;
    squares += along * along;
  }
  // Tolerances: four standard errors of mean and deviation of 40000 samples.
  const auto count = static_cast<double>(clean.points.size());
  EXPECT_NEAR(sum / count, 0.0, 2e-4);
  EXPECT_NEAR(std::sqrt(squares / count), 0.01, 1.5e-4);
}

TEST(Scan, densityFallsWithTheDistance)
{
  const Scene scene = makeScene(makeBoxRoom(9.0, 3.0, 3.0), {1.5, 1.5, 1.5}, 40000);
  std::size_t near = 0;
  std::size_t far = 0;
  for (const ScanPoint& point : scan(scene).points) {
    near += point.x < 1e-6F ? 1 : 0;
    far += point.x > 9.0F - 1e-6F ? 1 : 0;
  }
  // Walls of equal size at 1.5 and 7.5 m.
  EXPECT_GT(near, 10 * far);
  EXPECT_GT(far, 100U);
}

TEST(Scan, nothingIsRecordedBeyondTheRange)
{
  const Scene scene = makeScene(makeBoxRoom(9.0, 3.0, 3.0), {1.5, 1.5, 1.5}, 10000);
  ScanOptions options;
  options.max_range = 4.0;
  const Scan result = scan(scene, options);
  EXPECT_LT(result.points.size(), result.rays);
  for (const ScanPoint& point : result.points)
    EXPECT_LE(length(positionOf(point) - Vec3{1.5, 1.5, 1.5}), 4.0 + 1e-5);
}

/** @brief Returns a room with a window in its east wall, 5 m from a facade. */
Scene
windowScene(const Glazing& glazing)
{
  Room room = makeBoxRoom(4.0, 4.0, 3.0);
  Opening window{1, 0.5, 3.5, 0.5, 2.5, 0.2};
  window.glazing = glazing;
  room.openings.push_back(window);
  Scene scene = makeScene(room, {2.0, 2.0, 1.5}, 40000);
  Object facade;
  facade.boxes.push_back({{9.5, 2.0, 0.0}, {1.0, 60.0, 60.0}});
  scene.outside.push_back(facade);
  return scene;
}

TEST(Scan, glassReturnsAndMirrorsItsShares)
{
  const Scan result = scan(windowScene({0.3, 0.2}));
  std::size_t pane = 0;
  std::size_t facade = 0;
  std::size_t mirrored = 0;
  for (const ScanPoint& point : result.points) {
    if (point.x < 4.09F)
      continue;
    EXPECT_EQ(point.label, 0U);
    EXPECT_EQ(point.room, 0U);
    const bool on_pane = point.x < 4.11F;
    const bool on_facade = point.x > 8.999F;
    pane += on_pane ? 1 : 0;
    facade += on_facade ? 1 : 0;
    // The far wall of the mirrored room would be at x = 2 * 4.1 = 8.2.
    mirrored += !on_pane && !on_facade && point.x < 8.2001F ? 1 : 0;
  }
  const auto total = static_cast<double>(pane + facade + mirrored);
  ASSERT_GT(total, 1000.0);
  // Some of the rays that pass or are mirrored end on the reveals.
  EXPECT_NEAR(static_cast<double>(pane) / total, 0.3, 0.05);
  EXPECT_NEAR(static_cast<double>(mirrored) / total, 0.2, 0.05);
}

TEST(Scan, wallsSeenFromBehindAreNoStructure)
{
  // The back of the second room is visible through the window of the first.
  Scene scene = windowScene({0.0, 0.0});
  scene.outside.clear();
  Room shed = makeBoxRoom(1.0, 1.0, 3.0);
  shed.outline = rectangleLoop({8.0, 1.0}, {10.0, 3.0});
  scene.rooms.push_back(shed);
  std::size_t seen = 0;
  for (const ScanPoint& point : scan(scene).points) {
    EXPECT_NE(point.room, 2U);
    seen += point.x > 7.9F ? 1 : 0;
  }
  EXPECT_GT(seen, 50U);
}

TEST(Scan, ceilingsSeenFromAboveAreNoStructure)
{
  // The top of a lower room is visible through a window of an upper room.
  Room upper = makeBoxRoom(5.0, 5.0, 6.8);
  upper.floor.height = 4.0;
  upper.openings.push_back({1, 1.0, 4.0, 4.5, 6.0, 0.3});
  Scene scene = makeScene(upper, {4.2, 2.5, 5.6}, 40000);
  Room lower = makeBoxRoom(0.0, 0.0, 2.6);
  lower.outline = rectangleLoop({6.0, 0.0}, {12.0, 5.0});
  lower.details.push_back({rectangleLoop({8.0, 1.0}, {9.0, 4.0}), {3.0}}); // a recess
  scene.rooms.push_back(lower);
  std::size_t seen = 0;
  for (const ScanPoint& point : scan(scene).points) {
    EXPECT_NE(point.room, 2U);
    seen += point.x > 6.0F ? 1 : 0;
  }
  EXPECT_GT(seen, 500U);
}

TEST(Scan, placementTurnsAndShiftsThePoints)
{
  Scene scene = makeScene(makeBoxRoom(5.0, 4.0, 3.0), {2.0, 1.5, 1.5}, 2000);
  const Scan plain = scan(scene);
  scene.placement = {90.0, {10.0, 20.0, 30.0}};
  const Scan moved = scan(scene);
  ASSERT_EQ(plain.points.size(), moved.points.size());
  for (std::size_t i = 0; i < plain.points.size(); ++i) {
    EXPECT_NEAR(moved.points[i].x, 10.0F - plain.points[i].y, 1e-5F);
    EXPECT_NEAR(moved.points[i].y, 20.0F + plain.points[i].x, 1e-5F);
    EXPECT_NEAR(moved.points[i].z, 30.0F + plain.points[i].z, 1e-5F);
  }
}

TEST(Scan, progressEndsAtOne)
{
  const Scene scene = makeScene(makeBoxRoom(5.0, 4.0, 3.0), {2.0, 1.5, 1.5}, 2000);
  double last = 0.0;
  ScanOptions options;
  options.threads = 2;
  options.progress = [&last](double share) {
    EXPECT_GT(share, last);
    last = share;
  };
  scan(scene, options);
  EXPECT_DOUBLE_EQ(last, 1.0);
}

} // namespace
} // namespace pcl::sedr::sim::test
