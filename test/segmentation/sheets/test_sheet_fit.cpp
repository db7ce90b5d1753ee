// SPDX-License-Identifier: BSD-3-Clause
// Ceilings of many shapes in plans of rooms; test/pipeline has more, from scans.
#include "sheet_scenes.h"

#include "sedr_segmentation/src/sheets/sheet_fit.h"

#include <algorithm>
#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

double
tangent(double degrees)
{
  return std::tan(degrees * M_PI / 180);
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

TEST(CeilingShapes, ASteepGableNeedsNoRiserAtItsRidge)
{
  for (const double ridge : {2.3, 2.32, 2.35, 2.38}) {
    const Scene scene = sceneOf(
        9, 4.6, [&](double, double y) { return 3 + ridge - std::abs(y - ridge); });
    EXPECT_EQ(fittedRoom(scene).details.size(), 1u) << ridge;
  }
}

TEST(CeilingShapes, NoPlaneIsSteeperThanAPlanMayHold)
{
  // Hips of 2 m that steepen from 61.5 to 66.5 degrees: a plane that grows there turns.
  const double level = tangent(61.5);
  const double more = tangent(66.5) - level;
  const PlanLoop outline = rectangle(0, 0, 4, 4);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> off(0, 0.02);
    std::uniform_real_distribution<double> jitter(0, 0.04);
    std::vector<Eigen::Vector3d> points;
    for (double y = 0; y < 4; y += 0.04)
      for (double x = 0; x < 4; x += 0.04) {
        const Eigen::Vector2d p(x + jitter(random), y + jitter(random));
        const Eigen::Array2d from = p - 2 * (p / 2).array().floor().matrix();
        const double s = (from - 1).abs().maxCoeff();
        const double slope = level + s * more;
        points.emplace_back(p.x(), p.y(),
                            s * (level + s / 2 * more) +
                                off(random) * std::hypot(1, slope));
      }
    for (const bool is_floor : {false, true})
      for (const PlanSlab& facet :
           surfaceWithin(outline, points, SheetParameters::of({}, is_floor)).facets)
        EXPECT_GE(facet.plane[2], min_upward) << "seed " << seed << is_floor;
  }
}

TEST(CeilingShapes, AVaultAtAnAngleToTheWallsIsOneCylinder)
{
  const Eigen::Rotation2Dd turn(0.6);
  const Scene scene = sceneOf(6, 4, [&](double x, double y) {
    return segmental(0, 2 + (turn * Eigen::Vector2d(x - 3, y - 2)).y());
  });
  const PlanRoom room = fittedRoom(scene);
  EXPECT_TRUE(room.details.empty());
  ASSERT_TRUE(room.ceiling.curve);
  EXPECT_NEAR(room.ceiling.curve->across, 4, 0.04);
  EXPECT_LT(offBy(scene, room).mean, 0.0005);
}

TEST(CeilingShapes, AVaultIsACurveThoughItsPointsWereFoundAsCeilingAndDetails)
{
  Scene scene = sceneOf(
      5, 4, [](double x, double) { return 2.85 - 0.056 * std::pow(x - 2.5, 2); },
      0.002);
  std::vector<int>& ceiling = scene.parts.ceiling;
  const auto lower = std::partition(ceiling.begin(), ceiling.end(),
                                    [&](int i) { return scene.points[i].z() > 2.8F; });
  scene.parts.details.assign(lower, ceiling.end());
  ceiling.erase(lower, ceiling.end());
  const PlanRoom room = fittedRoom(scene);
  EXPECT_TRUE(room.details.empty());
  EXPECT_TRUE(room.ceiling.curve);
  EXPECT_LT(offBy(scene, room).beyond, 0.001);
}

TEST(CeilingShapes, AnOvalDomeIsOneEllipsoid)
{
  const Scene scene = sceneOf(6, 4, [](double x, double y) {
    return 2 + std::sqrt(1 - std::pow((x - 3) / 4, 2) - std::pow((y - 2) / 3.5, 2));
  });
  const PlanRoom room = fittedRoom(scene);
  EXPECT_TRUE(room.details.empty());
  EXPECT_LT(offBy(scene, room).mean, 0.0005);
}

TEST(CeilingShapes, ASmallDomeIsASphere)
{
  // Of 1.07 m radius over a circle of 0.84 m in a level ceiling.
  const Scene scene = sceneOf(6, 4, [](double x, double y) {
    const double square = std::pow(x - 1.8, 2) + std::pow(y - 2.2, 2);
    return 2.8 + (square < 0.84 * 0.84 ? std::sqrt(1.07 * 1.07 - square) -
                                             std::sqrt(1.07 * 1.07 - 0.84 * 0.84)
                                       : 0);
  });
  const PlanRoom room = fittedRoom(scene);
  ASSERT_EQ(room.details.size(), 1u);
  ASSERT_TRUE(room.details[0].slab.curve);
  EXPECT_TRUE(room.details[0].slab.curve->isSphere());
  EXPECT_NEAR(room.details[0].slab.curve->across, 1.07, 0.02);
}

TEST(CeilingShapes, NoiseOfTwoCentimetresMakesNoFurtherFacets)
{
  const Scene scene = sceneOf(
      6, 4, [](double, double y) { return 1 + tangent(40) * std::min(y, 4 - y); },
      0.02);
  const PlanRoom room = fittedRoom(scene);
  EXPECT_EQ(room.details.size(), 1U);
  EXPECT_LT(offBy(scene, room).mean, 0.001);
}

TEST(CeilingShapes, EachSideOfABeamBelowAVaultIsAtItsOwnFace)
{
  Scene scene = sceneOf(6, 4, [](double x, double y) {
    return std::abs(x - 3) < 0.2 ? 2.2 : segmental(x, y) - 1;
  });
  for (double y = 0.01; y < 4; y += 0.03) // more of one than of the other was seen
    scene.addRiser({2.79, y}, {2.81, y});
  const PlanRoom room = fittedRoom(scene);
  EXPECT_EQ(room.details.size(), 1U);
  for (const double x : {2.81, 3.0, 3.19})
    EXPECT_NEAR(room.ceilingAt({x, 2}), 2.2, 0.005) << x;
  for (const double x : {2.79, 3.21})
    EXPECT_NEAR(room.ceilingAt({x, 2}), 3, 0.005) << x;
}

TEST(CeilingShapes, StepsAreAsExactHoweverTheRoomIsTurned)
{
  for (const double degrees : {0, 17, 30, 45, 62}) {
    const Scene scene = sceneOf(
        6, 4,
        [](double x, double y) {
          return x > 1.42 && x < 2.63 && y > 1.17 && y < 2.81 ? 3.25 : 3.0;
        },
        0.01, degrees);
    const PlanRoom room = fittedRoom(scene);
    EXPECT_EQ(room.details.size(), 1U) << degrees;
    EXPECT_LT(offBy(scene, room).beyond, 0.002) << degrees;
  }
}

TEST(CeilingShapes, ABeamBelowASlopeEndsAtItsSidesThoughTheSlopeMeetsItBeside)
{
  // The slope would meet the beam's lower face 9 to 17 cm beside it.
  const auto roof = [](double y) { return 1 + tangent(50) * y; };
  for (const double side : {0.1, 0.15, 0.2}) {
    const Scene scene = sceneOf(
        6, 4,
        [&](double, double y) {
          return y > 1.5 && y < 1.8 ? roof(1.5) - side : roof(y);
        },
        0.01, 0, 1, false);
    EXPECT_LT(offBy(scene, fittedRoom(scene)).beyond, 0.01) << side;
  }
}

TEST(CeilingShapes, ADormerMeetsTheRoofUpToItsCheeks)
{
  // Near its upper corners its cheeks are low, and beside the line where it meets the
  // roof: they part nothing there.
  const double slope = 0.8;
  const double head = 1.4 / slope;
  const Scene scene = sceneOf(6, 4, [&](double x, double y) {
    return x > 2 && x < 4 && y < head ? 2.3 : 0.9 + slope * y;
  });
  const PlanRoom room = fittedRoom(scene);
  for (const double x : {2.03, 2.2, 2.4, 3.0, 3.6, 3.8, 3.97}) {
    EXPECT_NEAR(room.ceilingAt({x, head - 0.02}), 2.3, 0.005) << x;
    EXPECT_NEAR(room.ceilingAt({x, head + 0.06}), 2.3 + slope * 0.06, 0.005) << x;
  }
  EXPECT_LT(offBy(scene, room).beyond, 0.004);
}

TEST(CeilingShapes, ACoveGoesOverIntoTheLevelCeiling)
{
  // They touch: by the noise their surfaces may cross, or miss each other.
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const Scene scene = sceneOf(
        6, 4,
        [](double x, double) {
          const double off = std::max(0.0, 0.6 - x);
          return 2.3 + std::sqrt(0.49 - off * off);
        },
        0.01, 0, seed);
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

TEST(CeilingShapes, SmallSoffitsInALargeHallAreLevelFacets)
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

} // namespace
