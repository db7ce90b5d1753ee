// SPDX-License-Identifier: BSD-3-Clause
// Positions of a scanner that the scan contradicts.
#include "cast_rays.h"
#include "sedr_filters/src/rays/mirrored_points.h"
#include "sedr_filters/src/rays/sight_lines.h"

#include <gtest/gtest.h>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <utility>
#include <vector>

namespace {

using namespace sedr_test;
using Eigen::Vector3d;
using Eigen::Vector3f;
using pcl::sedr::findMirroredPoints;
using pcl::sedr::MirroredPoints;
using pcl::sedr::PointView;
using pcl::sedr::ScanPositions;

/** Two rooms side by side, with a pane of 3.4 x 2 m between them, or
 * none, and a scanner in the middle of each. */
class TwoRooms {
public:
  /** @param returned share of the rays that the pane returns; 1: a wall
   * @param untrue number of scans of both rooms before these that are told to be taken
   * from places outside */
  explicit TwoRooms(double returned, int untrue = 0)
      : returned_(returned)
  {
    for (int k = 0; k <= untrue; ++k)
      for (const double x : {3., 9.2}) {
        scanFrom({x, 2.4, 1.5});
        if (k < untrue)
          positions.back().place = Vector3f(static_cast<float>(3 * k), -20, 1.5F);
      }
  }

  /** @param voxel edge of those that are thinned to one point; 0: all points */
  MirroredPoints found(const ScanPositions& from, float voxel = 0) const
  {
    pcl::PointCloud<pcl::PointXYZ> thinned = *rows_;
    if (voxel > 0) {
      pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
      grid.setInputCloud(rows_);
      grid.setLeafSize(voxel, voxel, voxel);
      grid.filter(thinned);
    }
    return findMirroredPoints(PointView(thinned), PointView(*rows_), 1, from, 2);
  }

  ScanPositions positions;

private:
  void scanFrom(const Vector3d& place)
  {
    positions.push_back({rows_->size(), place.cast<float>()});
    for (int i = 0; i < 50000; ++i)
      see(place, anyDirection(random_));
  }

  void see(Vector3d from, const Vector3d& direction)
  {
    bool is_first = from.x() < middle;
    Vector3d hit = from + exitFrom(roomOf(is_first), from, direction) * direction;
    const bool is_pane = std::abs(hit.x() - middle) < 0.11 && hit.y() > 0.8 &&
                         hit.y() < 4.2 && hit.z() > 0.4 && hit.z() < 2.4;
    if (is_pane && uniform_(random_) >= returned_) {
      is_first = !is_first;
      from = hit + 0.2 / std::abs(direction.x()) * direction;
      hit = from + exitFrom(roomOf(is_first), from, direction) * direction;
    }
    const Vector3f p = hit.cast<float>();
    rows_->push_back({p.x(), p.y(), p.z()});
  }

  static Eigen::AlignedBox3d roomOf(bool is_first)
  {
    return is_first ? Eigen::AlignedBox3d(Vector3d(0, 0, 0), Vector3d(6, 5, 2.6))
                    : Eigen::AlignedBox3d(Vector3d(6.2, -2, 0), Vector3d(14, 5, 3.1));
  }

  static constexpr double middle = 6.1;
  double returned_;
  pcl::PointCloud<pcl::PointXYZ>::Ptr rows_{new pcl::PointCloud<pcl::PointXYZ>};
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> uniform_{0, 1};
};

TEST(TruePlaces, TheCornerOfARoomIsNone)
{
  constexpr float voxel = 0.05F;
  const TwoRooms rooms(1);
  for (const Vector3f& corner : {Vector3f(0, 0, 0), Vector3f(0.04F, 0.05F, 0)}) {
    ScanPositions positions = rooms.positions;
    positions[0].place = corner;
    const MirroredPoints found = rooms.found(positions, voxel);
    ASSERT_EQ(found.untrue.size(), 1u);
    EXPECT_EQ(found.untrue[0], corner);
  }
}

TEST(TruePlaces, AreToldFromOthersInVoxelsOfOneDecimetreToo)
{
  constexpr float voxel = 0.1F;
  for (const double returned : {0.05, 0.2, 1.})
    EXPECT_TRUE(
        TwoRooms(returned).found(TwoRooms(returned).positions, voxel).untrue.empty())
        << returned;
  const TwoRooms rooms(1);
  EXPECT_EQ(rooms.found({rooms.positions[0]}, voxel).untrue.size(), 1u);
}

TEST(TruePlaces, UntrueOnesDoNotTakeTheRaysOfTrueOnesThatFollow)
{
  // As many as count in a cube of 10 cm.
  const TwoRooms rooms(1, 4);
  const MirroredPoints found = rooms.found(rooms.positions);
  EXPECT_EQ(found.untrue.size(), 4u);
  const TwoRooms alone(1);
  const std::size_t expected = alone.found(alone.positions).rays;
  EXPECT_GT(found.rays, expected * 9 / 10);
}

TEST(TruePlaces, ThoseOfOtherScansAndThoseOutsideAreUntrueOneByOne)
{
  const TwoRooms rooms(1);
  ScanPositions swapped = rooms.positions;
  std::swap(swapped[0].place, swapped[1].place);
  EXPECT_EQ(rooms.found(swapped).untrue.size(), 2u);
  ScanPositions outside = rooms.positions;
  outside[1].place = Vector3f(9, -20, 1.5F);
  const MirroredPoints found = rooms.found(outside);
  ASSERT_EQ(found.untrue.size(), 1u);
  EXPECT_EQ(found.untrue[0], outside[1].place);
  EXPECT_GT(found.rays, 1000u); // those of the other
}

TEST(TruePlaces, AreBelowAGlassRoofInAScanThatWasCutToIt)
{
  // Steps of a third of a degree in both angles, below a roof of 5.6 m x 4.6 m that
  // returns a tenth of the rays, and another 3 m above it.
  const Eigen::AlignedBox3d room(Vector3d(0, 0, 0), Vector3d(6, 5, 2.6));
  const Eigen::AlignedBox3d whole(Vector3d(0, 0, 0), Vector3d(6, 5, 5.6));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Vector3f> rows;
  ScanPositions positions;
  for (const Vector3d& place : {Vector3d(2, 2.4, 1.5), Vector3d(4.2, 2.7, 1.5)}) {
    positions.push_back({rows.size(), place.cast<float>()});
    const double step = M_PI / 540;
    for (double up = M_PI / 6; up < M_PI / 2; up += step)
      for (double around = -M_PI / 4; around < M_PI / 4; around += step) {
        const Vector3d direction(std::cos(up) * std::cos(around),
                                 std::cos(up) * std::sin(around), std::sin(up));
        Vector3d hit = place + exitFrom(room, place, direction) * direction;
        const bool is_pane = hit.z() > 2.59 && std::abs(hit.x() - 3) < 2.8 &&
                             std::abs(hit.y() - 2.5) < 2.3;
        if (is_pane && uniform(random) > 0.1)
          hit = place + exitFrom(whole, place, direction) * direction;
        rows.push_back(hit.cast<float>());
      }
  }
  const PointView view(rows.data(), sizeof(Vector3f), rows.size());
  EXPECT_TRUE(findMirroredPoints(view, view, 1, positions, 2).untrue.empty());
}

TEST(TruePlaces, OneFarAwayIsUntrue)
{
  const MirroredPoints found = TwoRooms(1).found({{0, {691600, 5336000, 500}}}, 0.05F);
  EXPECT_EQ(found.untrue.size(), 1u);
  EXPECT_TRUE(found.lines.empty());
}

using pcl::sedr::Levelling;
using pcl::sedr::SightLine;
using pcl::sedr::SightLines;

/** Rays from some places to points all around. */
std::vector<SightLine>
randomLines(std::size_t n)
{
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  std::uniform_real_distribution<float> range(0.3F, 8);
  const std::vector<Vector3f> places{{0, 0, 0}, {2, 1, 0.5F}, {-3, 4, 1}};
  std::vector<SightLine> lines;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3f from = places[i % places.size()];
    const Vector3f way(normal(random), normal(random), normal(random));
    lines.push_back({from, from + range(random) * way.normalized()});
  }
  return lines;
}

/** Returns whether a ray goes through, ray by ray. */
bool
pierced(const std::vector<SightLine>& lines,
        const Vector3d& place,
        const Vector3d& normal,
        double radius)
{
  return std::any_of(lines.begin(), lines.end(), [&](const SightLine& line) {
    const Vector3d from = line.from.cast<double>();
    const Vector3d to = line.to.cast<double>();
    const double start = (from - place).dot(normal);
    const double end = (to - place).dot(normal);
    if (std::abs(start) <= 0.15 || std::abs(end) <= 0.15 || start * end > 0)
      return false;
    const double share = start / (start - end);
    return (from + share * (to - from) - place).norm() <= radius;
  });
}

TEST(SightLines, PierceAsRayByRayInEveryDirection)
{
  const std::vector<SightLine> lines = randomLines(30000);
  const SightLines sight(lines);
  EXPECT_EQ(sight.size(), lines.size());
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  int through = 0;
  for (int i = 0; i < 300; ++i) {
    Vector3d place(3 * normal(random), 3 * normal(random), 2 * normal(random));
    if (i % 10 == 0)
      place.head<2>() = Eigen::Vector2d(0.01 * normal(random), 0); // above a place
    const Vector3d across =
        Vector3d(normal(random), normal(random), normal(random)).normalized();
    const bool expected = pierced(lines, place, across, 0.05);
    EXPECT_EQ(sight.across(place, across, 0.05).through > 0, expected)
        << place.transpose();
    through += expected ? 1 : 0;
  }
  EXPECT_GT(through, 30);
  EXPECT_LT(through, 270);
}

TEST(SightLines, WithoutRaysAndOfNaNTellNothing)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const SightLines sight({{{0, 0, nan}, {1, 1, 1}}, {{1, 1, 1}, {1, 1, 1}}});
  EXPECT_EQ(sight.size(), 0u);
  EXPECT_EQ(sight.across({1, 1, 1}, Vector3d::UnitX(), 1).through, 0u);
}

} // namespace
