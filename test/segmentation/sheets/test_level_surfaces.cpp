// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/borders/sheet_plan.h"
#include "sedr_segmentation/src/labelling/minimum_cut.h"
#include "sedr_segmentation/src/plan/room_shares.h"
#include "sedr_segmentation/src/sheets/sheet_fit.h"
#include "segmentation/plan/room_evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** What is vertical between two heights that was not seen. */
enum class Hidden { Nothing, Risers, RisersAndWalls };

/** Returns the details of the ceiling or floor of a room known except for them. */
std::vector<PlanDetail>
detailsOf(const PlanRoom& truth,
          bool is_floor = false,
          double noise = 0,
          Hidden hidden = Hidden::Nothing)
{
  RoomPoints points(0.05, noise);
  const RoomParts parts = points.room(truth);
  std::vector<int> own = is_floor ? parts.floor : parts.ceiling;
  for (const int i : parts.details)
    if ((points[i].z() < truth.ceiling.heightAt({0, 0}) / 2) == is_floor)
      own.push_back(i);
  own = seenPoints(points.view(), CellGrid(0.05), own, is_floor);
  const auto isHidden = [&](int i) {
    const Eigen::Vector3f p = points[i];
    const double to_wall = truth.boundary.distance(p.head<2>().cast<double>());
    return hidden != Hidden::Nothing && p.z() > 2.25 && p.z() < 2.45 &&
           (hidden == Hidden::RisersAndWalls || to_wall > 0.02);
  };
  std::vector<int> seen = points.all();
  seen.erase(std::remove_if(seen.begin(), seen.end(), isHidden), seen.end());
  const std::vector<Eigen::Vector3d> places = placesOf(points.view(), own);
  FacetSheet surface =
      surfaceWithin(truth.boundary, places, SheetParameters::of({}, is_floor),
                    placesOf(points.view(), seen));
  refitToScan(surface, points.view(), seen);
  PlanRoom room = truth;
  giveCeiling(surface, places, pointsOfRisers(surface, points.view(), seen), room,
              is_floor);
  return is_floor ? room.floor_details : room.details;
}

TEST(LevelSurface, TheEdgesOfASoffitAreTheWallsAndItsRiser)
{
  PlanRoom room = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 2.5);
  room.details = {detailOf(rectangle(0.01, 3.21, 5.01, 4.01), 2.2)};
  for (const double noise : {0.0, 0.01}) {
    const auto details = detailsOf(room, false, noise);
    ASSERT_EQ(details.size(), 1u) << noise;
    EXPECT_EQ(details[0].boundary.elements.size(), 4u);
    EXPECT_LT(cornerError(details[0].boundary, room.details[0].boundary),
              0.002 + noise / 2);
    EXPECT_NEAR(details[0].slab.heightAt({2, 3.6}), 2.2, 0.001 + noise / 10);
    EXPECT_TRUE(details[0].holes.empty());
  }
}

TEST(LevelSurface, ARecessHasRisersOrWallsAboveTheCeilingAndASoffitARiser)
{
  const auto countOf = [](const PlanLoop& part, Hidden hidden, double ceiling = 2.2) {
    PlanRoom room = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), ceiling);
    room.details = {detailOf(part, 4.7 - ceiling)};
    return detailsOf(room, false, 0, hidden).size();
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
    PlanRoom found = room;
    found.details = detailsOf(room, false, noise);
    EXPECT_EQ(found.details.size(), 5u) << noise;
    for (const double x : {1.0, 3.0, 5.0})
      EXPECT_NEAR(found.ceilingAt({x, 4.2}), 2.35, 0.005) << noise << ' ' << x;
    for (const PlanLoop& beam : beams)
      EXPECT_NEAR(found.ceilingAt({beam.elements[0].start.x() + 0.12, 4.2}), 2.2, 0.01)
          << noise;
  }
}

TEST(LevelSurface, ASmallPieceBelowACeilingAwayFromTheWallsIsALamp)
{
  struct Piece {
    PlanLoop outline;
    double drop;
    bool is_lamp;
  };
  for (const Piece& piece : {
           Piece{rectangle(2.01, 2.01, 3.21, 2.61), 0.12, true},
           Piece{rectangle(2.01, 2.01, 3.21, 2.61), 0.3, true},   // on a rod
           Piece{rectangle(2.01, 2.01, 3.21, 3.01), 0.12, false}, // larger
           Piece{rectangle(0.26, 2.01, 1.46, 2.61), 0.12, true},
           Piece{rectangle(0.11, 2.01, 1.31, 2.61), 0.12, false},  // at the wall
           Piece{rectangle(2.01, 2.01, 3.21, 2.61), -0.12, false}, // a coffer
       }) {
    PlanRoom room = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 2.5);
    room.details = {detailOf(piece.outline, 2.5 - piece.drop)};
    EXPECT_EQ(detailsOf(room).size(), piece.is_lamp ? 0u : 1u)
        << piece.outline.elements[0].start.transpose() << ": " << piece.drop;
  }
}

TEST(LevelSurface, NoFloorLiesAboveWhatWasSeen)
{
  // A chest before half of a stage hides the floor, and all but the upper edge of its
  // riser.
  const PlanRoom room = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 3.5);
  const PlanLoop stage = rectangle(3.01, 0.01, 5.01, 4.01);
  const PlanLoop chest = rectangle(2.21, 0.01, 3.01, 2.01);
  RoomPoints points(0.05, 0);
  std::vector<int> floor = points.slab(room.boundary, 0, [&](double x, double y) {
    return !stage.contains({x, y}) && !chest.contains({x, y});
  });
  for (const int i : points.slab(stage, 1.4))
    floor.push_back(i);
  points.slab(chest, 1.2);
  points.wall(chest.elements[3], 0, 1.2);
  points.wall(chest.elements[2], 0, 1.2);
  points.wall(segment({3.01, 4.01}, {3.01, 2.01}), 0, 1.4);
  points.wall(chest.elements[1], 1.2, 1.4);
  const FacetSheet surface = surfaceWithin(
      room.boundary, placesOf(points.view(), floor), SheetParameters::of({}, true),
      placesOf(points.view(), points.all()));
  for (const double x : {1.95, 2.35, 2.6, 2.85})
    EXPECT_NEAR(surface.heightAt({x, 1}), 0, 0.01) << x;
  EXPECT_NEAR(surface.heightAt({3.15, 1}), 1.4, 0.01);
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
    EXPECT_EQ(detailsOf(room, true).size(), piece.is_part ? 1u : 0u)
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
