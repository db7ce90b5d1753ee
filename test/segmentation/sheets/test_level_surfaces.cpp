// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/labelling/minimum_cut.h"
#include "segmentation/plan/room_evidence.h"

#include <array>
#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** What is vertical between two heights that was not seen. */
enum class Hidden { Nothing, Risers, RisersAndWalls };

/** Returns the plan of a room of which all but some vertical faces was seen. */
PlanRoom
seenOf(const PlanRoom& truth, double noise = 0, Hidden hidden = Hidden::Nothing)
{
  RoomPoints points(0.05, noise);
  return fitted(points, points.room(truth, [&](const Eigen::Vector3d& p) {
    const double to_wall = truth.boundary.distance(p.head<2>());
    return hidden == Hidden::Nothing || p.z() < 2.25 || p.z() > 2.45 ||
           (hidden == Hidden::Risers && to_wall < 0.02);
  }));
}

TEST(LevelSurface, ARecessHasRisersOrWallsAboveTheCeilingAndASoffitARiser)
{
  const auto countOf = [](const PlanLoop& part, Hidden hidden, double ceiling = 2.2) {
    PlanRoom room = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), ceiling);
    room.details = {detailOf(part, 4.7 - ceiling)};
    return seenOf(room, 0, hidden).details.size();
  };
  const PlanLoop step = rectangle(0.01, 2.81, 5.01, 4.01);
  const PlanLoop coffer = rectangle(1.51, 1.01, 3.51, 3.01);
  EXPECT_EQ(countOf(step, Hidden::Nothing), 1u);
  EXPECT_EQ(countOf(coffer, Hidden::Nothing), 1u);
  EXPECT_EQ(countOf(step, Hidden::Risers), 1u) << "walls on three sides";
  EXPECT_EQ(countOf(coffer, Hidden::Risers), 0u) << "a missing tile";
  EXPECT_EQ(countOf(step, Hidden::RisersAndWalls), 0u) << "a reflection";
  EXPECT_EQ(countOf(step, Hidden::Risers, 2.5), 1u) << "deeper than a shelf";
  const PlanLoop shelf = rectangle(0.01, 3.11, 5.01, 4.01);
  EXPECT_EQ(countOf(shelf, Hidden::Nothing, 2.5), 1u) << "a soffit";
  EXPECT_EQ(countOf(shelf, Hidden::Risers, 2.5), 0u) << "a shelf, though below walls";
}

TEST(LevelSurface, BeamsBelowASoffitPartItIntoFields)
{
  PlanRoom room = roomOf(rectangle(0.01, 0.01, 6.01, 5.01), 2.7);
  const PlanDetail soffit = detailOf(rectangle(0.01, 3.51, 6.01, 5.01), 2.35);
  const std::vector<PlanLoop> beams{rectangle(2.01, 3.51, 2.26, 5.01),
                                    rectangle(4.01, 3.51, 4.26, 5.01)};
  room.details = {soffit, detailOf(beams[0], 2.2), detailOf(beams[1], 2.2)};
  for (const double noise : {0.0, 0.01}) {
    const PlanRoom found = seenOf(room, noise);
    EXPECT_EQ(found.details.size(), 5u) << noise;
    for (const double x : {1.0, 3.0, 5.0})
      EXPECT_NEAR(found.ceilingAt({x, 4.2}), 2.35, 0.005) << noise << ' ' << x;
    for (const PlanLoop& beam : beams)
      EXPECT_NEAR(found.ceilingAt({beam.elements[0].start.x() + 0.12, 4.2}), 2.2, 0.01)
          << noise;
  }
}

TEST(LevelSurface, SmallPiecesBelowACeilingAwayFromTheWallsAreLampsOthersDetails)
{
  struct Piece {
    PlanLoop outline;
    double drop;
    bool is_detail;
  };
  for (const Piece& piece :
       {Piece{rectangle(2.01, 2.01, 3.21, 2.61), 0.12, false},
        Piece{rectangle(2.01, 2.01, 3.21, 2.61), 0.3, false}, // on a rod
        Piece{rectangle(2.01, 2.01, 3.21, 3.01), 0.12, true}, // larger
        Piece{rectangle(0.26, 2.01, 1.46, 2.61), 0.12, false},
        Piece{rectangle(0.06, 2.01, 1.26, 2.61), 0.12, true}, // at the wall
        Piece{rectangle(0.01, 3.01, 0.61, 4.01), 0.08, true},
        Piece{rectangle(2.01, 2.01, 3.21, 2.31), 0.05, false}, // a panel
        Piece{rectangle(3.91, 0.01, 5.01, 4.01), 0.05, true},  // a soffit
        Piece{rectangle(2.01, 2.01, 3.21, 2.61), -0.12, true}, // coffers
        Piece{rectangle(1.01, 1.01, 1.61, 2.21), -0.03, true},
        Piece{rectangle(3.01, 1.01, 3.61, 2.21), -0.05, true},
        Piece{rectangle(1.51, 1.01, 3.51, 2.51), -0.25, true}}) {
    PlanRoom truth = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 2.5);
    truth.details = {detailOf(piece.outline, 2.5 - piece.drop)};
    SCOPED_TRACE(testing::Message()
                 << piece.outline.elements[0].start.transpose() << ": " << piece.drop);
    const PlanRoom room = seenOf(truth, 0.002);
    ASSERT_EQ(room.details.size(), piece.is_detail ? 1u : 0u);
    if (piece.is_detail) {
      const PlanDetail& found = room.details[0];
      EXPECT_NEAR(found.slab.heightAt(piece.outline.elements[0].start),
                  2.5 - piece.drop, 0.002);
      EXPECT_NEAR(found.boundary.area(), piece.outline.area(), 0.1);
      EXPECT_LT(cornerError(found.boundary, piece.outline), 0.055);
    }
  }
}

TEST(LevelSurface, NoFloorLiesAboveWhatWasSeen)
{
  // A chest before half of a stage hides the floor, and all but the upper edge of its
  // riser.
  const PlanLoop loop = rectangle(0.01, 0.01, 5.01, 4.01);
  const PlanLoop stage = rectangle(3.01, 0.01, 5.01, 4.01);
  const PlanLoop chest = rectangle(2.21, 0.01, 3.01, 2.01);
  RoomPoints points(0.05, 0);
  RoomParts parts;
  parts.floor =
      joined(points.slab(loop, 0,
                         [&](double x, double y) {
                           return !stage.contains({x, y}) && !chest.contains({x, y});
                         }),
             points.slab(stage, 1.4));
  parts.ceiling = points.slab(loop, 3.5);
  for (const PlanElement& wall : loop.elements)
    parts.walls = joined(parts.walls, points.wall(wall, 1.4, 3.5));
  points.slab(chest, 1.2);
  points.wall(chest.elements[3], 0, 1.2);
  points.wall(chest.elements[2], 0, 1.2);
  points.wall(segment({3.01, 4.01}, {3.01, 2.01}), 0, 1.4);
  points.wall(chest.elements[1], 1.2, 1.4);
  const PlanRoom room = fitted(points, parts);
  for (const double x : {1.95, 2.35, 2.6, 2.85})
    EXPECT_NEAR(room.floorAt({x, 1}), 0, 0.01) << x;
  EXPECT_NEAR(room.floorAt({3.15, 1}), 1.4, 0.01);
}

TEST(LevelSurface, AFloorsPartsAreOfASquareMetreAndNoRugs)
{
  struct Piece {
    double width; ///< a third of its length, metres
    double height;
    bool is_part;
  };
  for (const Piece& piece : {Piece{0.5, 0.3, false}, Piece{0.7, 0.3, true},
                             Piece{0.7, 0.04, false}, Piece{0.7, 0.05, true}}) {
    PlanRoom room = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 2.5);
    room.floor_details = {
        detailOf(rectangle(2.01, 1.01, 2.01 + piece.width, 1.01 + 3 * piece.width),
                 piece.height)};
    EXPECT_EQ(seenOf(room).floor_details.size(), piece.is_part ? 1u : 0u)
        << piece.width << ' ' << piece.height;
  }
}

struct PairCosts {
  std::size_t a;
  std::size_t b;
  std::array<double, 4> costs; // no no, no yes, yes no, yes yes
};

TEST(BinaryEnergy, FindsTheLeastOfAllAnswers)
{
  constexpr std::size_t variables = 8;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> cost(-1, 1);
  for (int round = 0; round < 50; ++round) {
    BinaryEnergy energy(variables);
    std::vector<double> yes;
    for (std::size_t v = 0; v < variables; ++v) {
      yes.push_back(cost(random));
      energy.addTerm(v, 0.25, 0.25 + yes.back());
    }
    std::vector<PairCosts> pairs;
    for (std::size_t a = 0; a < variables; ++a)
      for (std::size_t b = a + 1; b < variables; b += 2) {
        PairCosts pair{a, b, {cost(random), cost(random), cost(random), cost(random)}};
        // Equal labels must not cost more than different ones.
        const double excess =
            pair.costs[0] + pair.costs[3] - pair.costs[1] - pair.costs[2];
        if (excess > 0)
          pair.costs[1] += excess;
        energy.addPair(a, b, pair.costs[0], pair.costs[1], pair.costs[2],
                       pair.costs[3]);
        pairs.push_back(pair);
      }
    const auto costOf = [&](unsigned answers) {
      double sum = 0;
      for (std::size_t v = 0; v < variables; ++v)
        sum += (answers >> v & 1U) != 0 ? yes[v] : 0;
      for (const PairCosts& pair : pairs)
        sum += pair.costs[2 * (answers >> pair.a & 1U) + (answers >> pair.b & 1U)];
      return sum;
    };
    double least = std::numeric_limits<double>::infinity();
    for (unsigned answers = 0; answers < 1U << variables; ++answers)
      least = std::min(least, costOf(answers));
    const auto found = energy.minimise();
    unsigned answers = 0;
    for (std::size_t v = 0; v < variables; ++v)
      answers |= found[v] ? 1U << v : 0U;
    EXPECT_NEAR(costOf(answers), least, 1e-9);
  }
}

TEST(BinaryEnergy, QuestionsThatCostNothingMayBeAnsweredAnyhow)
{
  EXPECT_EQ(BinaryEnergy(3).minimise().size(), 3U);
  EXPECT_TRUE(BinaryEnergy(0).minimise().empty());
}

} // namespace
