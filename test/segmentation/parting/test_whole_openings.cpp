// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/air/ceiling_dip.h"
#include "sedr_segmentation/src/parting/whole_openings.h"

#include "parted_scenes.h"

#include <algorithm>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** The number of the room at a place of a scene. */
using RoomAt = std::function<int(double x, double y)>;

/** A scene parted by hand, with what is told of its openings. */
class Wholes {
public:
  Wholes(const AirScene& scene, const RoomAt& room_at)
      : air_(scene)
      , dip_(dipOfCeiling(air_.gaps, 5))
      , labels_(labelsOf(scene, room_at))
      , rooms_(air_.gaps, parameters_, labels_)
      , measures_(air_.gaps, dip_, parameters_)
      , wholes_(air_.gaps, parameters_, rooms_, measures_, labels_)
  {}

  /** Returns the number of the room at a place. */
  std::uint32_t at(double x, double y) { return labels_.roomOf(air_.at(x, y, 1)); }

  RoomPair between(double x0, double y0, double x1, double y1)
  {
    return std::minmax(at(x0, y0), at(x1, y1));
  }

  /** Returns whether the largest opening of a border is part of a door out of a room.
   * @param wider it is by so much, with others behind columns */
  bool isPartOfDoor(std::uint32_t room, const RoomPair& border, double wider = 0)
  {
    MeasuredOpening opening = largestOf(border);
    EXPECT_FALSE(opening.has_ends) << "a part that is a whole";
    EXPECT_GE(opening.dip, parameters_.min_lintel);
    opening.width += wider;
    return wholes_.isPartOfDoor(room, opening);
  }

  /** Returns whether the largest opening of a border, of which the other room sees no
   * wall at an end, is part of a door out of a room. */
  bool isPartOfDoorIfHalfSeen(std::uint32_t room, const RoomPair& border)
  {
    MeasuredOpening opening = largestOf(border);
    EXPECT_TRUE(opening.has_ends);
    opening.has_ends = false;
    return wholes_.isPartOfDoor(room, opening);
  }

  std::vector<RoomPair> join(const RoomPair& pair)
  {
    rooms_.join(pair);
    return wholes_.afterJoining(pair);
  }

private:
  MeasuredOpening largestOf(const RoomPair& border)
  {
    auto openings = openingsOf(air_.gaps, rooms_.between(border).crossings, 0);
    const auto largest = std::max_element(
        openings.begin(), openings.end(),
        [](const auto& a, const auto& b) { return a.size() < b.size(); });
    return measures_.measure(*largest, labels_);
  }

  std::vector<std::int32_t> labelsOf(const AirScene& scene, const RoomAt& room_at) const
  {
    std::vector<std::int32_t> label;
    for (std::uint32_t g = 0; g < air_.gaps.size(); ++g) {
      const Eigen::Vector2d at =
          air_.columns.grid().centre(air_.columns.cellOf(air_.gaps[g].column));
      const Eigen::Vector2d from = at - scene.place(0, 0);
      label.push_back(
          room_at(from.dot(scene.place(1, 0)), from.dot(scene.place(0, 1))));
    }
    return label;
  }

  SceneAir air_;
  PartingParameters parameters_;
  std::vector<float> dip_;
  RoomLabels labels_;
  RoomBorders rooms_;
  OpeningMeasures measures_;
  WholeOpenings wholes_;
};

/** Adds a room of 4 m x 8 m and a hall of 6 m x 8 m, with a passage between them. */
void
addRoomBesideHall(AirScene& scene, Hole passage)
{
  for (const auto& [x0, x1] : {std::pair(0.05, 4.05), std::pair(4.15, 10.15)}) {
    scene.slab(x0, 0.05, x1, 8.05, 0.01);
    scene.slab(x0, 0.05, x1, 8.05, 2.81);
    for (const double y : {0.05, 8.05})
      scene.wall(x0, y, x1, y, 0.01, 2.81);
  }
  for (const double x : {0.05, 10.15})
    scene.wall(x, 0.05, x, 8.05, 0.01, 2.81);
  scene.partition(4.05, 0.05, 8.05, 0.01, 2.81, passage);
}

/** The room is 0; the hall is split into 1, 2, ... at y. */
RoomAt
hallSplitAt(const std::vector<double>& splits)
{
  return [splits](double x, double y) {
    return x < 4.1 ? 0
                   : 1 + static_cast<int>(
                             std::count_if(splits.begin(), splits.end(),
                                           [&](double split) { return y > split; }));
  };
}

TEST(WholeOpenings, AreDoorsThoughTheirPartsHaveNoEnds)
{
  forBothTurns([](AirScene& scene) {
    addRoomBesideHall(scene, {2.45, 5.65, 2.41});
    Wholes wholes(scene, hallSplitAt({4.05}));
    const std::uint32_t room = wholes.at(2, 4);
    for (const double y : {2.0, 6.0}) {
      const RoomPair border = wholes.between(2, 4, 7, y);
      EXPECT_TRUE(wholes.isPartOfDoor(room, border)) << y;
      EXPECT_FALSE(wholes.isPartOfDoor(wholes.at(7, y), border))
          << "the other side is the part itself " << y;
      EXPECT_FALSE(wholes.isPartOfDoor(room, border, 2)) << "a piece is no whole " << y;
    }
  });
}

TEST(WholeOpenings, AreNoPartsOfThemselves)
{
  forBothTurns([](AirScene& scene) {
    addRoomBesideHall(scene, {2.45, 5.65, 2.41});
    Wholes wholes(scene, hallSplitAt({}));
    const RoomPair border = wholes.between(2, 4, 7, 4);
    for (const double x : {2.0, 7.0})
      EXPECT_FALSE(wholes.isPartOfDoorIfHalfSeen(wholes.at(x, 4), border)) << x;
  });
}

TEST(WholeOpenings, AreNoneIfWiderThanPassages)
{
  forBothTurns([](AirScene& scene) {
    addRoomBesideHall(scene, {1.45, 6.65, 2.41});
    Wholes wholes(scene, hallSplitAt({4.05}));
    for (const double y : {2.0, 6.0})
      EXPECT_FALSE(wholes.isPartOfDoor(wholes.at(2, 4), wholes.between(2, 4, 7, y)));
  });
}

TEST(WholeOpenings, AreNoneWithoutJambs)
{
  forBothTurns([](AirScene& scene) {
    for (const double x : {0.05, 4.15}) { // below a beam that is as long as the room
      scene.slab(x, 0.05, x + 4, 3.05, 0.01);
      scene.slab(x, 0.05, x + 4, 3.05, 2.81);
    }
    scene.sides(0.05, 0.05, 8.15, 3.05, 0.01, 2.81);
    scene.slab(4.05, 0.05, 4.15, 3.05, 0.01);
    scene.hanging(4.05, 0.05, 4.15, 3.05, 2.41, 2.81);
    Wholes wholes(scene, [](double x, double y) {
      return x < 4.1 ? 0 : y < 1.55 ? 1 : 2;
    });
    for (const double y : {0.5, 2.5})
      EXPECT_FALSE(wholes.isPartOfDoor(wholes.at(2, 1), wholes.between(2, 1, 7, y)));
  });
}

TEST(WholeOpenings, ThatTouchAtACornerAreNone)
{
  forBothTurns([](AirScene& scene) {
    // A corner of 3 m x 3 m of a hall, below beams on both sides, 0.5 m of wall at the
    // far ends of these.
    scene.room(0.05, 0.05, 8.05, 8.05, 0.01, 2.81);
    scene.hanging(3.05, 0.55, 3.15, 3.15, 2.41, 2.81);
    scene.hanging(0.55, 3.05, 3.15, 3.15, 2.41, 2.81);
    scene.sides(3.05, 0.05, 3.15, 0.55, 0.01, 2.81);
    scene.sides(0.05, 3.05, 0.55, 3.15, 0.01, 2.81);
    Wholes wholes(scene, [](double x, double y) {
      return x < 3.1 && y < 3.1 ? 0 : x > y ? 1 : 2;
    });
    const std::uint32_t corner = wholes.at(1, 1);
    EXPECT_FALSE(wholes.isPartOfDoor(corner, wholes.between(1, 1, 6, 2)));
    EXPECT_FALSE(wholes.isPartOfDoor(corner, wholes.between(1, 1, 2, 6)));
  });
}

TEST(WholeOpenings, ThatHaveAJambInAThirdRoomAreJudgedAnewWhenItIsJoined)
{
  forBothTurns([](AirScene& scene) {
    addRoomBesideHall(scene, {2.45, 5.65, 2.41});
    // The passage leads to 1 and 2; 3, which follows on 2, has the jamb beside it.
    Wholes wholes(scene, [](double x, double y) {
      return x < 4.1 ? 0 : y < 4.05 ? 1 : y < 5.65 ? 2 : 3;
    });
    const std::uint32_t room = wholes.at(2, 4);
    const RoomPair first = wholes.between(2, 4, 7, 2);
    ASSERT_TRUE(wholes.isPartOfDoor(room, first)) << "there is one beside 1";
    const std::vector<RoomPair> changed = wholes.join(wholes.between(7, 5, 7, 7));
    EXPECT_EQ(changed, std::vector<RoomPair>{first});
    EXPECT_TRUE(wholes.isPartOfDoor(room, first));
  });
}

} // namespace
