// SPDX-License-Identifier: BSD-3-Clause
#include "cast_rays.h"

#include "sedr_filters/src/rays/mirrored_points.h"

#include <gtest/gtest.h>

namespace {

using namespace sedr_test;
using Eigen::Vector3d;
using pcl::sedr::findMirroredPoints;
using pcl::sedr::MirroredPoints;
using pcl::sedr::PointView;
using pcl::sedr::ScanPositions;

/** A room of 6 x 5 x 2.6 m with some boxes, seen from one position. The wall at x = 6
 * has a pane of 3.4 x 2 m, which returns few of the rays. Behind it are a second room
 * and the mirror image of the first. */
class GlazedRoom {
public:
  double mirrored = 0.25; ///< share of the rays at the pane
  bool has_room_behind = false;

  void scanFrom(const Vector3d& place, unsigned seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    positions.push_back({rows.size(), place.cast<float>()});
    for (int i = 0; i < 150000; ++i) {
      const Vector3d direction = anyDirection(random);
      see(place, direction, uniform(random));
    }
  }

  MirroredPoints found(unsigned threads = 1) const { return found(positions, threads); }

  MirroredPoints found(const ScanPositions& from, unsigned threads) const
  {
    const PointView view(rows.data(), sizeof(Eigen::Vector3f), rows.size());
    return findMirroredPoints(view, view, 1, from, threads);
  }

  std::vector<Eigen::Vector3f> rows;
  std::vector<bool> is_image; ///< per row
  ScanPositions positions;

private:
  using Box = Eigen::AlignedBox3d;

  /** Returns the distance at which a ray enters a box. */
  static double entryTo(const Box& box, const Vector3d& from, const Vector3d& direction)
  {
    double low = 0;
    double high = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (box.min()[axis] - from[axis]) / direction[axis];
      const double b = (box.max()[axis] - from[axis]) / direction[axis];
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    }
    return low < high ? low : std::numeric_limits<double>::infinity();
  }

  static double rangeIn(const Box& room,
                        const std::vector<Box>& boxes,
                        const Vector3d& from,
                        const Vector3d& direction)
  {
    double range = exitFrom(room, from, direction);
    for (const Box& box : boxes)
      range = std::min(range, entryTo(box, from, direction));
    return range;
  }

  void see(const Vector3d& from, const Vector3d& direction, double fate)
  {
    const double range = rangeIn(room_, boxes_, from, direction);
    const Vector3d hit = from + range * direction;
    const bool is_pane = hit.x() > 5.9999 && hit.y() > 0.8 && hit.y() < 4.2 &&
                         hit.z() > 0.4 && hit.z() < 2.4;
    if (!is_pane || fate < 0.05)
      return add(hit, false);
    if (fate < 0.05 + mirrored) {
      const Vector3d turned(-direction.x(), direction.y(), direction.z());
      Vector3d image =
          hit + rangeIn(room_, boxes_, hit - 1e-6 * direction, turned) * turned;
      image.x() = 12 - image.x();
      return add(image, true);
    }
    if (has_room_behind)
      add(hit + rangeIn(behind_, boxes_behind_, hit + 1e-6 * direction, direction) *
                    direction,
          false);
  }

  void add(const Vector3d& p, bool is_image_of_another)
  {
    rows.push_back(p.cast<float>());
    is_image.push_back(is_image_of_another);
  }

  Box room_{Vector3d(0, 0, 0), Vector3d(6, 5, 2.6)};
  Box behind_{Vector3d(6, 0, 0), Vector3d(13, 5, 2.6)};
  std::vector<Box> boxes_{{Vector3d(1.5, 3.5, 0), Vector3d(2.2, 4, 1.9)},
                          {Vector3d(3.7, 0.4, 0), Vector3d(4.2, 1.2, 2.1)},
                          {Vector3d(0, 2, 0), Vector3d(0.5, 3, 2.2)}};
  std::vector<Box> boxes_behind_{{Vector3d(8.9, 3, 0), Vector3d(9.6, 4.4, 1.6)},
                                 {Vector3d(10.2, 0.3, 0), Vector3d(11, 1.5, 2.2)}};
};

std::size_t
countOf(const std::vector<std::uint8_t>& flags)
{
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
}

TEST(MirroredPoints, WhatAPaneShowsASecondTimeIsFoundAndNothingElse)
{
  GlazedRoom room;
  room.scanFrom({2.8, 2.4, 1.5}, 1);
  room.scanFrom({1.1, 1.2, 1.4}, 2);
  const MirroredPoints found = room.found();
  EXPECT_GE(found.mirrors, 1u);
  std::size_t images = 0;
  std::size_t missed = 0;
  for (std::size_t i = 0; i < room.rows.size(); ++i) {
    if (!room.is_image[i])
      EXPECT_EQ(found.of_rows[i], 0) << room.rows[i].transpose();
    else if (room.rows[i].x() > 6.5F) {
      ++images;
      missed += found.of_rows[i] == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(images, 1500u);
  EXPECT_LT(missed, images / 8);
  EXPECT_EQ(found.of_thinned, found.of_rows); // all points are retained here
}

TEST(MirroredPoints,
     WhatIsSeenThroughGlassThatDoesNotMirrorStaysIsMarkedAndItsRaysAreKept)
{
  GlazedRoom room;
  room.mirrored = 0;
  room.has_room_behind = true;
  room.scanFrom({2.8, 2.4, 1.5}, 1);
  const MirroredPoints found = room.found();
  ASSERT_EQ(found.behind.size(), room.rows.size());
  EXPECT_GT(found.rays, 1000u);
  EXPECT_EQ(found.lines.size(), found.rays);
  EXPECT_EQ(found.mirrors, 0u);
  EXPECT_EQ(countOf(found.of_rows), 0u);
  std::size_t behind = 0;
  std::size_t marked = 0;
  for (std::size_t i = 0; i < room.rows.size(); ++i) {
    if (room.rows[i].x() < 6.001F)
      EXPECT_EQ(found.behind[i], 0) << room.rows[i].transpose();
    else if (room.rows[i].x() > 6.5F) {
      ++behind;
      marked += found.behind[i];
    }
  }
  EXPECT_GT(behind, 5000u);
  EXPECT_GT(marked, behind * 9 / 10);
}

TEST(MirroredPoints, RaysThatMeetReflectionsAreNoLinesOfSight)
{
  GlazedRoom room;
  room.scanFrom({2.8, 2.4, 1.5}, 1);
  const MirroredPoints found = room.found();
  std::size_t beyond = 0;
  for (const pcl::sedr::SightLine& line : found.lines)
    beyond += line.to.x() > 6.5F ? 1 : 0;
  EXPECT_GT(found.rays - found.lines.size(), 100u);
  EXPECT_LT(beyond, (found.rays - found.lines.size()) / 5);
}

TEST(MirroredPoints, WhatIsSeenFreelyTooStays)
{
  GlazedRoom room;
  room.scanFrom({2.8, 2.4, 1.5}, 1);
  const std::size_t mirrored = countOf(room.found().of_rows);
  ASSERT_GT(mirrored, 300u);
  // The same points again, seen from a position behind the pane with nothing between.
  const std::size_t rows = room.rows.size();
  room.positions.push_back({rows, Eigen::Vector3f(9, 2.4F, 1.5F)});
  for (std::size_t i = 0; i < rows; ++i)
    if (room.is_image[i]) {
      room.rows.push_back(room.rows[i]);
      room.is_image.push_back(false);
    }
  EXPECT_LT(countOf(room.found().of_rows), mirrored / 20);
}

TEST(MirroredPoints, WithoutKnownPositionsNothingIsLeftOut)
{
  GlazedRoom room;
  room.scanFrom({2.8, 2.4, 1.5}, 1);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const ScanPositions& positions :
       {ScanPositions(), ScanPositions{{0, Eigen::Vector3f::Constant(nan)}},
        ScanPositions{{room.rows.size(), Eigen::Vector3f::Zero()}}}) {
    const MirroredPoints found = room.found(positions, 1);
    EXPECT_EQ(found.rays, 0u);
    EXPECT_EQ(countOf(found.of_rows), 0u);
  }
}

} // namespace
