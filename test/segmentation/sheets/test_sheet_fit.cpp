// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_scenes.h"

#include "sedr_segmentation/src/borders/sheet_plan.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace {

using namespace pcl::sedr;
using namespace sheet_test;

double
tangent(double degrees)
{
  return std::tan(degrees * M_PI / 180);
}

double
gable(double, double y)
{
  return 1 + tangent(40) * std::min(y, 4 - y);
}

/** A vault along x: half an ellipse, or the upper part of one. */
struct Vault {
  double base, across, up;
  double operator()(double, double y) const
  {
    return base + up * std::sqrt(std::max(0.0, 1 - std::pow((y - 2) / across, 2)));
  }
};

/** The segment of a circle of 4 m radius that starts with a slope of 30 degrees. */
const Vault segmental{0, 4, 4};

TEST(FitSheet, AFloorOfPointsAtAnyHeightHasNoFacet)
{
  const Scene scene = sceneOf(2, 2, [](double x, double y) {
    const double mixed =
        43758.5453 * std::sin(12.9898 * std::floor(5 * x) + 78.233 * std::floor(5 * y));
    return 30 * (mixed - std::floor(mixed)); // in squares of 20 cm
  });
  const FacetSheet sheet = fitted(scene, SheetParameters::of({}, true));
  EXPECT_TRUE(sheet.facets.empty());
  EXPECT_TRUE(sheet.label.empty());
}

TEST(FitSheet, AFloorThatSagsIsOnePlaneAndAGentleRampIsNone)
{
  const SheetParameters floor = SheetParameters::of({}, true);
  const Scene sagging = sceneOf(
      6, 4, [](double x, double) { return 0.02 * std::abs(x - 2.5); }, 0.002);
  EXPECT_EQ(fitted(sagging, floor).facets.size(), 1U);
  const Scene ramp = sceneOf(
      8, 4, [](double x, double) { return 0.06 * std::clamp(x - 2, 0.0, 3.0); }, 0.002);
  EXPECT_EQ(fitted(ramp, floor).facets.size(), 3U);
}

TEST(FitSheet, AShedRoofIsOnePlane)
{
  const Scene scene =
      sceneOf(6, 4, [](double x, double) { return 2 + tangent(15) * x; });
  const FacetSheet sheet = fitted(scene);
  ASSERT_EQ(sheet.facets.size(), 1U);
  EXPECT_LT(offBy(scene, fittedRoom(scene)).mean, 0.0005);
}

TEST(FitSheet, ASteepGableNeedsNoRiserAtItsRidge)
{
  for (const double ridge : {2.3, 2.32, 2.35, 2.38}) {
    const Scene gable = sceneOf(
        9, 4.6, [&](double, double y) { return 3 + ridge - std::abs(y - ridge); });
    std::vector<Eigen::Vector3d> around; // the ridge is higher than most of the room
    std::copy_if(gable.points.begin(), gable.points.end(), std::back_inserter(around),
                 [](const auto& p) { return p.z() < 4.5; });
    const FacetSheet sheet =
        surfaceWithin(gable.room.boundary, gable.points, {}, around);
    EXPECT_EQ(sheet.facets.size(), 2u) << ridge;
  }
}

TEST(FitSheet, NoPlaneIsSteeperThanAPlanMayHold)
{
  // Hips of 2 m that steepen from 61.5 to 66.5 degrees: a plane that grows there turns.
  const double level = tangent(61.5);
  const double more = tangent(66.5) - level;
  for (int seed = 1; seed <= 3; ++seed) {
    const Scene hips = sceneOf(
        4, 4,
        [&](double x, double y) {
          const double s = std::max(std::abs(x - 2 * std::floor(x / 2) - 1),
                                    std::abs(y - 2 * std::floor(y / 2) - 1));
          return s * (level + s / 2 * more);
        },
        0.02, seed);
    for (const bool is_floor : {false, true})
      for (const PlanSlab& facet :
           fitted(hips, SheetParameters::of({}, is_floor)).facets)
        EXPECT_GE(facet.plane[2], min_upward) << "seed " << seed << is_floor;
  }
}

TEST(FitSheet, AVaultAtAnAngleToTheWallsIsOneCylinder)
{
  const Eigen::Rotation2Dd turn(0.6);
  const Scene scene = sceneOf(6, 4, [&](double x, double y) {
    return segmental(0, 2 + (turn * Eigen::Vector2d(x - 3, y - 2)).y());
  });
  const FacetSheet sheet = fitted(scene);
  ASSERT_EQ(sheet.facets.size(), 1U);
  ASSERT_TRUE(sheet.facets[0].curve);
  EXPECT_NEAR(sheet.facets[0].curve->across, 4, 0.04);
  EXPECT_LT(offBy(scene, fittedRoom(scene)).mean, 0.0005);
}

TEST(FitSheet, AnOvalDomeIsOneEllipsoid)
{
  const Scene scene = sceneOf(6, 4, [](double x, double y) {
    return 2 + std::sqrt(1 - std::pow((x - 3) / 4, 2) - std::pow((y - 2) / 3.5, 2));
  });
  const FacetSheet sheet = fitted(scene);
  ASSERT_EQ(sheet.facets.size(), 1U);
  EXPECT_LT(offBy(scene, fittedRoom(scene)).mean, 0.0005);
}

/** Height of a dome of 1.07 m radius over a circle of 0.84 m in a level ceiling. */
double
smallDome(double x, double y)
{
  const double square = std::pow(x - 1.8, 2) + std::pow(y - 2.2, 2);
  return square < 0.84 * 0.84 ? 2.8 + std::sqrt(1.07 * 1.07 - square) -
                                    std::sqrt(1.07 * 1.07 - 0.84 * 0.84)
                              : 2.8;
}

/** Returns its room; the points of the dome are noisier than those of the level
 * ceiling, whose voxels are full. */
Scene
roomBelowSmallDome()
{
  Scene scene = sceneOf(6, 4, smallDome, 0.001);
  const Scene noisy = sceneOf(6, 4, smallDome, 0.013);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (smallDome(noisy.points[i].x(), noisy.points[i].y()) > 2.8)
      scene.points[i] = noisy.points[i];
  return scene;
}

TEST(FitSheet, ASmallDomeIsASphereInCoarseCellsToo)
{
  const Scene scene = roomBelowSmallDome();
  for (const double size : {0.1, 0.15}) {
    SheetParameters parameters;
    parameters.cell_size = size;
    const FacetSheet sheet = fitted(scene, parameters);
    ASSERT_EQ(sheet.facets.size(), 2u) << size;
    ASSERT_TRUE(sheet.facets[1].curve) << size;
    EXPECT_TRUE(sheet.facets[1].curve->isSphere()) << size;
    EXPECT_NEAR(sheet.facets[1].curve->across, 1.07, 0.02) << size;
  }
}

TEST(FitSheet, NoiseOfTwoCentimetresMakesNoFurtherFacets)
{
  const Scene scene = sceneOf(6, 4, gable, 0.02);
  const PlanRoom room = fittedRoom(scene);
  EXPECT_EQ(room.details.size(), 1U);
  EXPECT_LT(offBy(scene, room).mean, 0.001);
}

TEST(FitSheet, ABeamIsAFacetWithStepsOnBothSides)
{
  const Scene scene = sceneOf(6, 4, [](double x, double y) {
    return std::abs(x - 3) < 0.2 ? 2.2 : segmental(x, y) - 1;
  });
  const PlanRoom room = fittedRoom(scene);
  EXPECT_EQ(room.details.size(), 1U);
  EXPECT_NEAR(room.ceilingAt({3.15, 2}), 2.2, 0.005);
  EXPECT_NEAR(room.ceilingAt({3.25, 2}), 3, 0.005);
}

TEST(FitSheet, EachSideOfABeamIsAtItsOwnFaceThoughMoreOfTheOtherWasSeen)
{
  Scene scene = sceneOf(6, 4, [](double x, double y) {
    return std::abs(x - 3) < 0.2 ? 2.2 : segmental(x, y) - 1;
  });
  for (const auto& [x, spacing] :
       {std::pair<double, double>(2.8, 0.03), std::pair<double, double>(3.2, 0.04)})
    for (double y = 0.01; y < 4; y += spacing)
      for (double z = 2.2; z < 3; z += spacing)
        scene.risers.emplace_back(x + 0.003 * std::sin(97 * y + 31 * z), y, z);
  const PlanRoom room = fittedRoom(scene);
  for (const double x : {2.81, 3.0, 3.19})
    EXPECT_NEAR(room.ceilingAt({x, 2}), 2.2, 0.005) << x;
  for (const double x : {2.79, 3.21})
    EXPECT_NEAR(room.ceilingAt({x, 2}), 3, 0.005) << x;
}

TEST(FitSheet, StepsAreAsExactHoweverTheRoomIsTurned)
{
  const Scene scene = sceneOf(6, 4, [](double x, double y) {
    return x > 1.42 && x < 2.63 && y > 1.17 && y < 2.81 ? 3.25 : 3.0;
  });
  for (const double degrees : {0, 17, 30, 45, 62}) {
    const Scene other = turned(scene, degrees * M_PI / 180);
    const PlanRoom room = fittedRoom(other);
    EXPECT_EQ(room.details.size(), 1U) << degrees;
    EXPECT_LT(offBy(other, room).beyond, 0.002) << degrees;
  }
}

TEST(FitSheet, ABeamBelowASlopeEndsAtItsSidesThoughTheSlopeMeetsItBeside)
{
  // The slope would meet the beam's lower face 9 to 17 cm beside it.
  for (const double side : {0.1, 0.15, 0.2}) {
    const auto roof = [](double y) { return 1 + tangent(50) * y; };
    Scene scene = sceneOf(6, 4, [&](double, double y) {
      return y > 1.5 && y < 1.8 ? roof(1.5) - side : roof(y);
    });
    for (const double y : {1.5, 1.8})
      for (double x = 0.01; x < 6; x += 0.04)
        for (double z = roof(1.5) - side; z < roof(y); z += 0.04)
          scene.risers.emplace_back(x, y + 0.005 * std::sin(97 * x + 31 * z), z);
    const PlanRoom room = fittedRoom(scene);
    EXPECT_LT(offBy(scene, room).beyond, 0.01) << side;
    scene.risers.clear();
    EXPECT_LT(offBy(scene, fittedRoom(scene)).beyond, 0.01) << side;
  }
}

TEST(FitSheet, ADormerMeetsTheRoofUpToItsCheeks)
{
  // Near its upper corners its cheeks are low, and beside the line where it meets the
  // roof: they part nothing there.
  const double slope = 0.8;
  const double head = 1.4 / slope;
  Scene scene = sceneOf(6, 4, [&](double x, double y) {
    return x > 2 && x < 4 && y < head ? 2.3 : 0.9 + slope * y;
  });
  for (const double x : {2.0, 4.0})
    for (double y = 0.01; y < head; y += 0.01)
      for (double z = 0.9 + slope * y; z < 2.3; z += 0.02)
        scene.risers.emplace_back(x + 0.005 * std::sin(97 * y + 31 * z), y, z);
  const PlanRoom room = fittedRoom(scene);
  for (const double x : {2.03, 2.2, 2.4, 3.0, 3.6, 3.8, 3.97}) {
    EXPECT_NEAR(room.ceilingAt({x, head - 0.02}), 2.3, 0.005) << x;
    EXPECT_NEAR(room.ceilingAt({x, head + 0.06}), 2.3 + slope * 0.06, 0.005) << x;
  }
  EXPECT_LT(offBy(scene, room).beyond, 0.004);
}

TEST(FitSheet, ACoveGoesOverIntoTheLevelCeiling)
{
  // They touch: by the noise their surfaces may cross, or miss each other.
  for (const int seed : {1, 2, 3, 4}) {
    const Scene scene = sceneOf(
        6, 4,
        [](double x, double) {
          const double off = std::max(0.0, 0.6 - x);
          return 2.3 + std::sqrt(0.49 - off * off);
        },
        0.01, seed);
    const Off off = offBy(scene, fittedRoom(scene));
    EXPECT_LT(off.mean, 0.0015) << seed;
    EXPECT_LT(off.beyond, 0.001) << seed;
  }
}

/** Height of a vault over a hall with level soffits of 0.8 m x 0.7 m between piers,
 * each at a height of its own. */
double
vaultWithSoffits(double x, double y)
{
  for (int k = 0; k < 4; ++k)
    if (std::abs(x - (k % 2 == 0 ? 3 : 13)) < 0.4 &&
        std::abs(y - (k < 2 ? 2.05 : 9.05)) < 0.35)
      return 3 + 0.1 * k;
  return 4 + std::sqrt(144 - (y - 6) * (y - 6)) - 12;
}

TEST(FitSheet, SmallSoffitsInALargeHallAreLevelFacets)
{
  const Scene scene = sceneOf(16, 12, vaultWithSoffits);
  const PlanRoom room = fittedRoom(scene);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(room.ceilingAt({k % 2 == 0 ? 3 : 13, k < 2 ? 2.05 : 9.05}), 3 + 0.1 * k,
                0.005)
        << k;
  EXPECT_EQ(room.details.size(), 4U);
  EXPECT_LT(offBy(scene, room).beyond, 0.01);
}

TEST(PointsOfRisers, AreNoneOfTheWalls)
{
  const Scene scene = sceneOf(6, 4, [](double x, double) { return x < 3 ? 2.2 : 2.8; });
  const FacetSheet sheet = fitted(scene);
  pcl::PointCloud<pcl::PointXYZ> riser;
  pcl::PointCloud<pcl::PointXYZ> wall;
  for (float z = 2.25F; z < 2.77F; z += 0.05F)
    for (float at = 0.5F; at < 3.5F; at += 0.05F) {
      riser.push_back({3, at, z});
      wall.push_back({at, 0.02F, z});
    }
  EXPECT_EQ(pointsOfRisers(sheet, PointView(riser), {}).size(), riser.size());
  EXPECT_TRUE(pointsOfRisers(sheet, PointView(wall), {}).empty());
}

TEST(FitSheet, TooFewPointsOrTooSmallAnAreaMakeNoSheet)
{
  EXPECT_TRUE(
      fitted(sceneOf(0.4, 0.4, [](double, double) { return 3; })).facets.empty());
  Scene scene = sceneOf(6, 4, gable);
  scene.points.clear();
  EXPECT_TRUE(fitted(scene).facets.empty());
}

} // namespace
