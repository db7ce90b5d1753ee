// SPDX-License-Identifier: BSD-3-Clause
#include "room_evidence.h"
#include "sedr_segmentation/src/sheets/floor_pieces.h"

#include <ostream>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using sedr_test::PlanEvidence; // not those of the library
using sedr_test::RoomPoints;

/** A room of 8 m x 6 m with parts of its floor. */
struct FloorShape {
  const char* name;
  std::vector<PlanDetail> parts;
  double slope = 0; ///< of the main floor along x
};

std::ostream&
operator<<(std::ostream& stream, const FloorShape& shape)
{
  return stream << shape.name;
}

PlanRoom
roomWith(const FloorShape& shape)
{
  PlanRoom room = roomOf(rectangle(0.01, 0.01, 8.01, 6.01), 3.4);
  room.floor = slabAt(0, shape.slope);
  room.floor_details = shape.parts;
  return room;
}

/** Returns a strip that rises along x from the floor at 2.01. */
PlanDetail
ramp(double degrees, double end = 5.01)
{
  const double slope = std::tan(degrees * M_PI / 180);
  PlanDetail part = detailOf(rectangle(2.01, 4.51, end, 6.01), 0);
  part.slab = slabAt(-2.01 * slope, slope);
  return part;
}

PlanDetail
platformAfter(const PlanDetail& ramp)
{
  const double end = ramp.boundary.elements[0].end.x();
  return detailOf(rectangle(end, 4.51, 8.01, 6.01), ramp.slab.heightAt({end, 5}));
}

class FloorShapes : public testing::TestWithParam<FloorShape> {};

/** Returns the share of the floor that is farther than a centimetre from the truth. */
double
shareOff(const PlanRoom& found, const PlanRoom& truth)
{
  int off = 0;
  int count = 0;
  for (double y = 0.05; y < 6; y += 0.031)
    for (double x = 0.05; x < 8; x += 0.031) {
      off += std::abs(found.floorAt({x, y}) - truth.floorAt({x, y})) > 0.01 ? 1 : 0;
      ++count;
    }
  return static_cast<double>(off) / count;
}

TEST_P(FloorShapes, AreInThePlan)
{
  const PlanRoom truth = roomWith(GetParam());
  RoomPoints points(0.05, 0.005);
  const RoomParts parts = points.room(truth);
  RoomParts found = parts;
  found.floor =
      floorPoints(points.view(), parts.floor, points.all(), slabAt(0), 0.07, {});
  EXPECT_GE(found.floor.size(), parts.floor.size() * 97 / 100);
  const PlanRoom room = fitted(points, found);
  EXPECT_EQ(room.floor_details.size(), truth.floor_details.size());
  EXPECT_LE(shareOff(room, truth), 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    Floors,
    FloorShapes,
    testing::Values(
        FloorShape{"platform", {detailOf(rectangle(5.01, 0.01, 8.01, 6.01), 0.3)}},
        FloorShape{"step", {detailOf(rectangle(5.01, 0.01, 8.01, 6.01), 0.1)}},
        FloorShape{"step of 5 cm", {detailOf(rectangle(5.01, 0.01, 8.01, 6.01), 0.05)}},
        FloorShape{"dais", {detailOf(rectangle(3.01, 2.01, 5.01, 3.71), 0.12)}},
        FloorShape{"stage", {detailOf(rectangle(5.01, 0.01, 8.01, 6.01), 1.2)}},
        FloorShape{"high stage", {detailOf(rectangle(5.01, 0.01, 8.01, 6.01), 1.6)}},
        FloorShape{"pit", {detailOf(rectangle(2.01, 1.01, 5.01, 4.01), -0.6)}},
        FloorShape{"deep pit", {detailOf(rectangle(2.01, 1.01, 5.01, 4.01), -2.2)}},
        FloorShape{"small pit", {detailOf(rectangle(2.01, 1.01, 4.01, 2.21), -1)}},
        FloorShape{"ramp of 6 degrees", {ramp(6), platformAfter(ramp(6))}},
        FloorShape{"ramp of 10 degrees", {ramp(10), platformAfter(ramp(10))}},
        FloorShape{"ramp with a small landing",
                   {ramp(10, 7.51), platformAfter(ramp(10, 7.51))}},
        FloorShape{"ramp with a landing",
                   {ramp(10, 6.41), platformAfter(ramp(10, 6.41))}},
        FloorShape{"sloping hall", {}, std::tan(5 * M_PI / 180)}));

/** Things of one height on the floor, with the floor hidden in a part. */
struct Furniture {
  const char* name;
  std::vector<PlanLoop> outlines;
  double height;
  double clear = 0; ///< between the floor and the sides
  PlanLoop hidden{};
};

TEST(FloorPoints, OfFurnitureAreNone)
{
  for (const Furniture& things :
       {Furniture{"table", {rectangle(3.01, 2.01, 5.01, 3.01)}, 0.75, 0.75},
        Furniture{"block of desks", {rectangle(0.81, 2.01, 7.21, 3.61)}, 0.74, 0.3},
        Furniture{"table for a hall", {rectangle(0.01, 0.51, 8.01, 5.51)}, 0.75, 0.75},
        Furniture{"desks 3 cm from each other",
                  {rectangle(0.81, 2.01, 2.41, 3.61), rectangle(2.44, 2.01, 4.04, 3.61),
                   rectangle(4.07, 2.01, 5.67, 3.61), rectangle(5.7, 2.01, 7.3, 3.61)},
                  0.74,
                  0.3},
        Furniture{"bed", {rectangle(3.01, 0.01, 5.01, 2.01)}, 0.5},
        Furniture{"row of wardrobes", {rectangle(0.01, 5.21, 8.01, 6.01)}, 2},
        Furniture{"double row of shelves", {rectangle(1.01, 2.01, 7.01, 3.21)}, 2},
        Furniture{"booth", {rectangle(3.01, 2.01, 5.21, 4.21)}, 2.3},
        Furniture{"pallets", {rectangle(3.01, 2.01, 5.41, 3.21)}, 0.15},
        Furniture{"mattress", {rectangle(3.01, 2.01, 5.01, 3.41)}, 0.2},
        Furniture{"low bed", {rectangle(3.01, 2.01, 5.01, 3.81)}, 0.27},
        Furniture{"chest", {rectangle(6.01, 2.01, 7.01, 2.81)}, 0.45},
        Furniture{"beds, two of them side by side",
                  {rectangle(0.01, 0.01, 2.51, 2.21), rectangle(4.01, 0.01, 5.61, 2.01),
                   rectangle(6.21, 0.01, 7.81, 2.01)},
                  0.5},
        Furniture{
            "beds that hide the floor between them",
            {rectangle(2.01, 0.01, 3.41, 2.01), rectangle(4.61, 0.01, 6.01, 2.01)},
            0.5,
            0,
            rectangle(3.41, 0.01, 4.61, 2.01)}}) {
    RoomPoints points(0.05, 0.005);
    const PlanRoom room = roomWith({"plain", {}});
    std::vector<int> ends = points.slab(room.boundary, 0, [&](double x, double y) {
      const auto isIn = [&](const PlanLoop& loop) { return loop.contains({x, y}); };
      return !isIn(things.hidden) &&
             std::none_of(things.outlines.begin(), things.outlines.end(), isIn);
    });
    const std::size_t floor = ends.size();
    points.slab(room.boundary, 3.4);
    points.slab(rectangle(2.01, 2.31, 2.51, 2.81), 40); // what a mirror shows
    for (const PlanLoop& outline : things.outlines) {
      if (things.clear > 0)
        points.slab(outline, 0);
      for (const int i : points.slab(outline, things.height))
        ends.push_back(i);
      for (const PlanElement& side : outline.elements)
        if (things.hidden.elements.empty() ||
            things.hidden.distance((side.start + side.end) / 2) > 0.01)
          points.wall(side, std::max(0.05, things.clear), things.height);
    }
    EXPECT_EQ(
        floorPoints(points.view(), ends, points.all(), slabAt(0), 0.07, {}).size(),
        floor)
        << things.name;
  }
}

TEST(FloorPoints, OfABedBehindAChestBesideAPlatformOfItsHeightAreNone)
{
  RoomPoints points(0.05, 0.005);
  const PlanLoop things = rectangle(2.61, 2.01, 5.01, 4.01);
  std::vector<int> ends =
      points.slab(rectangle(0.01, 0.01, 5.01, 6.01), 0, [&](double x, double y) {
        return !things.contains({x, y});
      });
  points.slab(rectangle(0.01, 0.01, 8.01, 6.01), 3.4);
  std::size_t last = 0; // ends that are of no bed
  for (const auto& [outline, height] :
       {std::pair{rectangle(4.61, 2.01, 5.01, 4.01), 0.9},
        {rectangle(5.01, 0.01, 8.01, 6.01), 0.5},
        {rectangle(2.61, 2.01, 4.61, 4.01), 0.5}}) {
    last = ends.size();
    for (const int i : points.slab(outline, height))
      ends.push_back(i);
    for (const PlanElement& side : outline.elements)
      points.wall(side, 0.05, height);
  }
  const std::vector<int> floor =
      floorPoints(points.view(), ends, points.all(), slabAt(0), 0.07, {});
  EXPECT_GT(floor.size(), last * 9 / 10); // all but the chest
  EXPECT_LT(floor.back(), ends[last]);
}

} // namespace
