// SPDX-License-Identifier: BSD-3-Clause
#include "floor_picture.h"
#include "pictures.h"
#include "plane_picture.h"
#include "region_picture.h"
#include "room_picture.h"
#include "slice_picture.h"
#include "thinning_picture.h"
#include "wall_picture.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace {

using namespace programs;
using namespace pcl::sedr;
using Eigen::Vector2d;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double cell = 0.05;

/** Adds points in the middle of cells; returns their indices. */
pcl::Indices
addPoints(Cloud& cloud, const CellSet& cells, float z)
{
  pcl::Indices indices;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Vector2d p = CellGrid(cell).centre(cells[i]);
    indices.push_back(static_cast<int>(cloud.size()));
    cloud.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), z);
  }
  return indices;
}

/** Returns the middle of a cell. */
Vector2d
at(int x, int y)
{
  return CellGrid(cell).centre({x, y});
}

TEST(RegionPicture, ShowsTheBinaryMapTheRegionsAndWhatIsKept)
{
  RegionMap map;
  map.cell_size = cell;
  map.cells = unite(block(0, 39, 0, 29), block(50, 54, 0, 4));
  map.regions = labelRegions(map.cells);
  map.number = {1, 0};
  map.threshold = 25;
  const Picture picture = drawRegions({map});
  const Vector2d kept = at(3, 25);
  const Vector2d removed = at(50, 4);
  EXPECT_EQ(colourAt(picture, 0, kept), colours::other);
  EXPECT_EQ(colourAt(picture, 0, removed), colours::other);
  EXPECT_NE(colourAt(picture, 1, kept), colourAt(picture, 1, removed));
  EXPECT_EQ(colourAt(picture, 2, kept), colours::ceiling);
  EXPECT_EQ(colourAt(picture, 2, removed), colours::removed);
  for (std::size_t panel = 0; panel < 3; ++panel)
    EXPECT_EQ(colourAt(picture, panel, at(45, 20)), colours::paper);
  EXPECT_GT(drawRegions({}).draw().size.x(), 0) << "of nothing too";
}

TEST(PlanePicture, ShowsPlanesByKindAndTheHistogramInTheirColours)
{
  Cloud cloud;
  std::vector<pcl::HorizontalPlane> planes(3);
  const double heights[] = {0, 0.8, 2.5};
  const CellSet cells[] = {block(0, 39, 0, 29), block(10, 19, 10, 19),
                           block(0, 39, 0, 29)};
  const LevelKind kinds[] = {LevelKind::Floor, LevelKind::Other, LevelKind::Ceiling};
  HeightHistogram histogram{0.05, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    planes[k].inliers.indices =
        addPoints(cloud, cells[k], static_cast<float>(heights[k]));
    planes[k].kind = kinds[k];
    planes[k].height = heights[k];
    planes[k].area = static_cast<double>(cells[k].size()) * cell * cell;
    histogram.bins.push_back({heights[k] - 0.025, cells[k].size()});
  }
  const Picture picture = drawPlanes(planes, histogram, PointView(cloud), cell);
  EXPECT_TRUE(panelOf(picture, 0).isChart());
  EXPECT_EQ(colourAt(picture, 0, {20, 0}), colours::floor);
  EXPECT_EQ(colourAt(picture, 0, {20, 0.8}), colours::other);
  EXPECT_EQ(colourAt(picture, 0, {20, 2.5}), colours::ceiling);
  EXPECT_EQ(colourAt(picture, 0, {20, 1.6}), colours::paper);
  EXPECT_EQ(colourAt(picture, 1, at(2, 2)), colours::ceiling);
  EXPECT_EQ(colourAt(picture, 2, at(2, 2)), colours::floor);
  EXPECT_EQ(colourAt(picture, 2, at(11, 18)), colours::other);
}

TEST(ThinningPicture, ShadesTellHowManyPointsLieInACell)
{
  Cloud scan;
  for (int k = 0; k < 60; ++k)
    addPoints(scan, block(0, 9, 0, 19), 0.01f * static_cast<float>(k));
  addPoints(scan, block(10, 19, 0, 19), 0);
  Cloud thinned;
  addPoints(thinned, block(0, 19, 0, 19), 0);
  const Picture picture = drawThinning(PointView(scan), PointView(thinned), cell);
  const Colour one = colourAt(picture, 1, at(5, 5));
  EXPECT_NE(one, colours::paper);
  EXPECT_EQ(colourAt(picture, 1, at(15, 5)), one);
  EXPECT_EQ(colourAt(picture, 0, at(15, 5)), one);
  EXPECT_LT(colourAt(picture, 0, at(5, 5)).blue, one.blue) << "more points, darker";
}

SliceDetails
oneTrial()
{
  SliceDetails analysis;
  analysis.ceiling = block(10, 39, 0, 29);
  SliceTrial trial;
  trial.number = 1;
  trial.fractions = {0.25};
  trial.heights = {1.9};
  trial.slice = block(-2, -1, 0, 29);
  trial.accepted = {block(0, 9, 0, 24)};
  trial.rejected = {block(2, 7, 27, 28)};
  analysis.trials = {trial};
  analysis.cells = block(0, 9, 0, 29);
  analysis.sizes = {300};
  analysis.refused = block(42, 44, 5, 9);
  analysis.trial = 1;
  return analysis;
}

TEST(SlicePicture, ShowsEveryTrialTheDetailsAndTheHeightsOfTheSlices)
{
  Cloud cloud;
  RoomSlices room{1, oneTrial(), {}, {}};
  room.ceiling = addPoints(cloud, room.analysis.ceiling, 2.5f);
  room.analysis.indices = addPoints(cloud, room.analysis.cells, 2.2f);
  addPoints(cloud, block(0, 39, 0, 29), 0);
  room.points.resize(cloud.size());
  std::iota(room.points.begin(), room.points.end(), 0);
  const Picture picture = drawSlices({room}, PointView(cloud), cell);
  const Colour ceiling = colourAt(picture, 0, at(30, 27));
  EXPECT_EQ(ceiling, lightened(colours::ceiling, 0.35));
  EXPECT_EQ(colourAt(picture, 0, at(-2, 20)), colours::wall) << "the slice";
  EXPECT_EQ(colourAt(picture, 0, at(1, 2)), colours::detail);
  EXPECT_EQ(colourAt(picture, 0, at(2, 27)), colours::removed);
  EXPECT_EQ(colourAt(picture, 0, at(1, 28)), colours::paper);
  EXPECT_EQ(colourAt(picture, 1, at(1, 28)), colours::detail);
  EXPECT_EQ(colourAt(picture, 1, at(43, 7)), colours::removed);
  // The section along x shows the slice at 1.9 m, and above it detail and ceiling.
  EXPECT_TRUE(panelOf(picture, 2).isChart());
  EXPECT_EQ(colourAt(picture, 2, {1.1, 1.9}), colours::wall);
  EXPECT_EQ(colourAt(picture, 2, at(3, 0) + Vector2d(0, 2.2 - 0.025)), colours::detail);
  EXPECT_EQ(colourAt(picture, 2, at(30, 0) + Vector2d(0, 2.5 - 0.025)),
            colours::ceiling);
  EXPECT_EQ(colourAt(picture, 2, at(30, 0) + Vector2d(0, -0.025)), colours::other);
}

TEST(SlicePicture, RoomsThatNeededNoSecondTrialAreFaintInIt)
{
  SliceDetails other;
  other.ceiling = block(60, 99, 0, 29);
  other.trials.resize(2);
  for (int t = 0; t < 2; ++t)
    other.trials[static_cast<std::size_t>(t)].number = t + 1;
  const Cloud cloud;
  const Picture picture =
      drawSlices({{1, oneTrial(), {}, {}}, {2, other, {}, {}}}, PointView(cloud), cell);
  EXPECT_EQ(colourAt(picture, 1, at(30, 20)), colours::faint);
  EXPECT_EQ(colourAt(picture, 1, at(70, 20)), lightened(colours::ceiling, 0.35));
}

TEST(FloorPicture, ShowsWhatARecoveryHasKeptFilledAndRemoved)
{
  auto cloud = std::make_shared<Cloud>();
  const auto ceiling = addPoints(*cloud, block(0, 39, 0, 29), 2.5f);
  const auto floor =
      addPoints(*cloud, unite(block(0, 24, 0, 29), block(45, 59, 0, 9)), 0);
  pcl::FloorProjectionRecovery<pcl::PointXYZ> recovery(true);
  recovery.setInputCloud(cloud);
  recovery.setIndices(pcl::make_shared<const pcl::Indices>(floor));
  recovery.setCeilingIndices(pcl::make_shared<const pcl::Indices>(ceiling));
  Cloud whole;
  recovery.filter(whole);
  const FloorCells cells = floorCellsOf(recovery);
  EXPECT_EQ(cells.seen.keys(), block(0, 24, 0, 29).keys());
  EXPECT_EQ(cells.recovered.keys(), block(25, 39, 0, 29).keys());
  EXPECT_EQ(cells.removed.keys(), block(45, 59, 0, 9).keys());
  const Picture picture = drawFloor({cells});
  EXPECT_EQ(colourAt(picture, 0, at(5, 5)), colours::floor);
  EXPECT_EQ(colourAt(picture, 0, at(50, 5)), colours::removed);
  EXPECT_NE(colourAt(picture, 0, at(30, 5)), colours::recovered);
  EXPECT_EQ(colourAt(picture, 1, at(5, 5)), colours::floor);
  EXPECT_EQ(colourAt(picture, 1, at(30, 5)), colours::recovered);
  EXPECT_EQ(colourAt(picture, 1, at(50, 5)), colours::paper);
}

TEST(WallPicture, PartsSeedsAndWallsAtTheSliceHeight)
{
  Cloud cloud;
  RoomWalls room;
  room.slice_height = 2;
  room.walls = {0, 1};
  cloud.emplace_back(0.f, 0.f, 2.3f);
  cloud.emplace_back(1.f, 0.f, 1.f);
  room.above = {2};
  cloud.emplace_back(2.f, 0.f, 2.5f);
  room.below = {3};
  cloud.emplace_back(3.f, 0.f, 0.f);
  room.details = {4};
  cloud.emplace_back(4.f, 0.f, 2.2f);
  room.boundary = {2, 3, 5, 6};
  cloud.emplace_back(5.f, 0.f, 2.5f); // of rims without support
  cloud.emplace_back(-1.f, 0.f, 2.5f);
  const Picture picture = drawWalls({room}, PointView(cloud));
  for (const std::size_t panel : {0u, 1u}) {
    const bool is_below = panel == 1;
    EXPECT_EQ(colourAt(picture, panel, {0, 0}) == colours::wall, !is_below);
    EXPECT_EQ(colourAt(picture, panel, {1, 0}) == colours::wall, is_below);
    EXPECT_EQ(colourAt(picture, 2, {static_cast<double>(panel), 0}), colours::wall);
  }
  EXPECT_EQ(colourAt(picture, 0, {2, 0}), colours::ceiling);
  EXPECT_EQ(colourAt(picture, 0, {5, 0}), colours::removed);
  EXPECT_EQ(colourAt(picture, 0, {3, 0}), colours::paper);
  EXPECT_EQ(colourAt(picture, 1, {3, 0}), colours::floor);
  EXPECT_EQ(colourAt(picture, 1, {2, 0}), colours::paper);
  EXPECT_EQ(colourAt(picture, 2, {4, 0}), colours::detail);
  room.slice_height = std::numeric_limits<double>::quiet_NaN();
  const Picture whole = drawWalls({room}, PointView(cloud));
  EXPECT_EQ(panelOf(whole, 1).title, "all walls: 2 points") << "nothing is below";
}

/** Adds profiles of a room with air from the floor to `ceiling`. */
void
addColumns(BuildingRoom& room, const CellSet& cells, float ceiling, bool is_seen)
{
  for (std::size_t i = 0; i < cells.size(); ++i)
    room.columns.push_back({cells[i], 0, ceiling, is_seen, true});
}

TEST(RoomPicture, ShowsRoomsByStoreyWhatWasHiddenOfThemAndTheirHeights)
{
  Building building;
  building.grid = CellGrid(cell);
  building.rooms.resize(3);
  addColumns(building.rooms[0], block(0, 29, 0, 29), 2.5, true);
  addColumns(building.rooms[1], block(32, 59, 0, 19), 4, true);
  addColumns(building.rooms[1], block(32, 59, 20, 29), 4, false);
  addColumns(building.rooms[2], block(0, 59, 0, 29), 2.5, true);
  const std::uint32_t storeys[] = {1, 1, 2};
  for (std::uint32_t r = 0; r < 3; ++r) {
    building.rooms[r].id = r + 1;
    building.rooms[r].storey = storeys[r];
  }
  for (const std::uint32_t number : {1u, 2u}) {
    PlanStorey storey;
    storey.number = number;
    building.storeys.push_back(storey);
  }
  const Picture picture = drawRooms(building);
  const Colour one = colourAt(picture, 0, at(2, 2));
  const Colour other = colourAt(picture, 0, at(40, 2));
  const Colour hidden = colourAt(picture, 0, at(55, 26));
  EXPECT_NE(one, other);
  EXPECT_LT(hidden.red + hidden.green + hidden.blue,
            other.red + other.green + other.blue);
  EXPECT_EQ(colourAt(picture, 0, at(30, 2)), colours::paper);
  EXPECT_NE(colourAt(picture, 2, at(30, 2)), colours::paper) << "of the upper storey";
  EXPECT_LT(colourAt(picture, 1, at(2, 2)).green, colourAt(picture, 1, at(40, 2)).green)
      << "the lower ceiling is darker";
}

} // namespace
