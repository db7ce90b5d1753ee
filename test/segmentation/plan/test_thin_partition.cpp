// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/plan/room_territory.h"

#include "room_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Two rooms with a partition of 10 cm between y = 0 and y = 0.1, from x = 0 to x = 2,
 * turned about z. The upper room has its face of the partition and the ceiling beyond
 * the ends of this wall. The lower one has the ceiling up to the partition. */
class Partition {
public:
  explicit Partition(double degrees)
      : turn_(degrees * M_PI / 180)
  {
    constexpr double from_wall = 0.05;
    scopes_ = {ceiling(-1, -0.01), ceiling(0.1 + from_wall, 1)};
    face(0.1, 0, upper_);
  }

  /** Adds the lower room's own face above a height. */
  void addLowerFace(double from) { face(0, from, lower_); }

  /** Returns the rooms of the points of the upper and of the lower face. */
  std::pair<std::vector<std::int32_t>, std::vector<std::int32_t>> rooms() const
  {
    const RoomTerritory territory(CellGrid(0.05), scopes_);
    EXPECT_EQ(territory.problem(), "");
    const auto rooms = territory.roomsAt(points_.view(), 1);
    const auto of = [&](const std::vector<int>& indices) {
      std::vector<std::int32_t> found;
      for (const int i : indices)
        found.push_back(rooms[static_cast<std::size_t>(i)]);
      return found;
    };
    return {of(upper_), of(lower_)};
  }

private:
  static constexpr double step = 0.045;

  Eigen::Vector2d turned(double x, double y) const
  {
    return Eigen::Rotation2Dd(turn_) * Eigen::Vector2d(x, y) +
           Eigen::Vector2d(0.013, 0.021); // no face along a line of the grid
  }

  CellSet ceiling(double low, double high) const
  {
    RoomPoints points;
    for (double x = 0; x <= 2; x += step / 2)
      for (double y = low; y <= high; y += step / 2) {
        const Eigen::Vector2d p = turned(x, y);
        points.point(p.x(), p.y(), 2.5);
      }
    return CellSet(CellGrid(0.05), points.view(), points.all());
  }

  /** Adds noisy points of a wall within the ends of the partition. */
  void face(double y, double from, std::vector<int>& indices)
  {
    constexpr double noise = 0.01;
    int k = 0;
    for (double x = 0.2; x <= 1.8; x += step)
      for (double z = from; z <= 2.4; z += step) {
        // A deterministic normal distribution: its quantiles in a shuffled order.
        const double u = (++k * 89 % 997 + 0.5) / 997;
        const Eigen::Vector2d p =
            turned(x, y + noise * std::log(u / (1 - u)) * std::sqrt(3) / M_PI);
        indices.push_back(points_.point(p.x(), p.y(), z));
      }
  }

  double turn_;
  RoomPoints points_;
  std::vector<CellSet> scopes_;
  std::vector<int> upper_;
  std::vector<int> lower_;
};

double
shareOf(std::int32_t room, const std::vector<std::int32_t>& rooms)
{
  return static_cast<double>(std::count(rooms.begin(), rooms.end(), room)) /
         static_cast<double>(rooms.size());
}

TEST(ThinPartition, AFaceWhoseOtherSideWasNotSeenIsOfOneRoomHoweverItIsTurned)
{
  for (double degrees = 0; degrees < 180; degrees += 7.3)
    EXPECT_GT(shareOf(1, Partition(degrees).rooms().first), 0.9) << degrees;
}

TEST(ThinPartition, BothFacesOfAThinPartitionStayApart)
{
  for (const double from : {0.0, 2.0}) // a wardrobe hides the lower part
    for (double degrees = 0; degrees < 180; degrees += 7.3) {
      Partition partition(degrees);
      partition.addLowerFace(from);
      const auto [upper, lower] = partition.rooms();
      EXPECT_GT(shareOf(1, upper), 0.9) << degrees;
      EXPECT_GT(shareOf(0, lower), 0.9) << degrees;
    }
}

TEST(ClusterBoxes, OneThatGrowsIsJoinedWithThoseItThenMeets)
{
  // The third meets the second; both together surround the first.
  const auto clusters =
      clusterBoxes({{{2, 2}, {4, 4}}, {{10, 0}, {14, 20}}, {{0, 16}, {11, 20}}}, 0);
  ASSERT_EQ(clusters.size(), 1u);
  EXPECT_EQ(clusters[0].count(), 15u * 21u);
}

} // namespace
