// SPDX-License-Identifier: BSD-3-Clause
#include "pictures.h"
#include "plan_loops.h"
#include "stage_pictures.h"

#include <pcl/sedr_filters/impl/refinement.h>

#include <gtest/gtest.h>

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
  const Picture picture = drawRegions(map);
  const Vector2d kept = at(3, 25);
  const Vector2d removed = at(50, 4);
  EXPECT_EQ(colourAt(picture, 0, kept), colours::other);
  EXPECT_EQ(colourAt(picture, 0, removed), colours::other);
  EXPECT_NE(colourAt(picture, 1, kept), colourAt(picture, 1, removed));
  EXPECT_EQ(colourAt(picture, 2, kept), colours::ceiling);
  EXPECT_EQ(colourAt(picture, 2, removed), colours::removed);
  for (std::size_t panel = 0; panel < 3; ++panel)
    EXPECT_EQ(colourAt(picture, panel, at(45, 20)), colours::paper);
  EXPECT_GT(drawRegions(RegionMap()).draw().size.x(), 0) << "of nothing too";
}

TEST(PlanePicture, ShowsPlanesByKind)
{
  Cloud cloud;
  std::vector<pcl::HorizontalPlane> planes(3);
  const CellSet cells[] = {block(0, 39, 0, 29), block(10, 19, 10, 19),
                           block(0, 39, 0, 29)};
  const LevelKind kinds[] = {LevelKind::Floor, LevelKind::Other, LevelKind::Ceiling};
  for (std::size_t k = 0; k < 3; ++k) {
    planes[k].inliers.indices = addPoints(cloud, cells[k], static_cast<float>(k));
    planes[k].kind = kinds[k];
    planes[k].area = static_cast<double>(cells[k].size()) * cell * cell;
  }
  const Picture picture = drawPlanes(planes, PointView(cloud), cell);
  EXPECT_EQ(colourAt(picture, 0, at(2, 2)), colours::ceiling);
  EXPECT_EQ(colourAt(picture, 1, at(2, 2)), colours::floor);
  EXPECT_EQ(colourAt(picture, 1, at(11, 18)), colours::other);
}

/** A cloud as a source of rows. */
class CloudRows : public RowSource {
public:
  explicit CloudRows(const Cloud& cloud)
      : cloud_(cloud)
  {
    for (const char* name : {"x", "y", "z"}) {
      fields_.emplace_back();
      fields_.back().name = name;
      fields_.back().offset = static_cast<pcl::uindex_t>(4 * (fields_.size() - 1));
      fields_.back().datatype = pcl::PCLPointField::FLOAT32;
      fields_.back().count = 1;
    }
  }
  const std::vector<pcl::PCLPointField>& fields() const override { return fields_; }
  std::size_t rowSize() const override { return sizeof(pcl::PointXYZ); }
  std::size_t size() const override { return cloud_.size(); }
  void forEachPiece(const std::function<bool(const Piece&)>& see) const override
  {
    see({reinterpret_cast<const std::uint8_t*>(cloud_.data()), 0, cloud_.size()});
  }

private:
  const Cloud& cloud_;
  std::vector<pcl::PCLPointField> fields_;
};

TEST(ThinningPicture, ShadesTellHowManyPointsLieInACell)
{
  Cloud scan;
  for (int k = 0; k < 60; ++k)
    addPoints(scan, block(0, 9, 0, 19), 0.01f * static_cast<float>(k));
  addPoints(scan, block(10, 19, 0, 19), 0);
  Cloud thinned;
  addPoints(thinned, block(0, 19, 0, 19), 0);
  const Picture picture = drawThinning(CloudRows(scan), PointView(thinned), cell);
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
  analysis.trial = 1;
  return analysis;
}

TEST(SlicePicture, ShowsEveryTrialAndTheDetails)
{
  const Picture picture = drawSlices({oneTrial()}, cell);
  EXPECT_EQ(colourAt(picture, 0, at(30, 27)), lightened(colours::ceiling, 0.35));
  EXPECT_EQ(colourAt(picture, 0, at(-2, 20)), colours::wall) << "the slice";
  EXPECT_EQ(colourAt(picture, 0, at(1, 2)), colours::detail);
  EXPECT_EQ(colourAt(picture, 0, at(2, 27)), colours::removed);
  EXPECT_EQ(colourAt(picture, 0, at(1, 28)), colours::paper);
  EXPECT_EQ(colourAt(picture, 1, at(1, 28)), colours::detail);
}

TEST(SlicePicture, RoomsThatNeededNoSecondTrialAreFaintInIt)
{
  SliceDetails other;
  other.ceiling = block(60, 99, 0, 29);
  other.trials.resize(2);
  for (int t = 0; t < 2; ++t)
    other.trials[static_cast<std::size_t>(t)].number = t + 1;
  const Picture picture = drawSlices({oneTrial(), other}, cell);
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

TEST(WallPicture, ShowsSeedsAndWhatTheyBecame)
{
  Cloud cloud;
  for (int k = 0; k < 6; ++k)
    cloud.emplace_back(static_cast<float>(k), 0.f, 1.f);
  RoomWalls room;
  room.boundary = {0, 1, 5};
  room.seeds = {0, 5};
  room.walls = {2};
  room.details = {3};
  room.candidates = {2, 3, 4};
  const Picture picture = drawWalls({room}, PointView(cloud));
  EXPECT_EQ(colourAt(picture, 0, {0, 0}), colours::ceiling);
  EXPECT_EQ(colourAt(picture, 0, {1, 0}), colours::removed) << "no seed";
  EXPECT_EQ(colourAt(picture, 0, {2, 0}), colours::paper);
  EXPECT_EQ(colourAt(picture, 1, {2, 0}), colours::wall);
  EXPECT_EQ(colourAt(picture, 1, {3, 0}), colours::detail);
  EXPECT_EQ(colourAt(picture, 1, {4, 0}), colours::faint);
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

/** 4 m x 3 m x 2.5 m. */
PlanRoom
boxRoom()
{
  PlanRoom room;
  room.id = 1;
  room.boundary = sedr_test::rectangle(0, 0, 4, 3);
  room.ceiling.plane[3] = -2.5;
  return room;
}

TEST(PlanPicture, TellsBoundaryPointsOnAWallFromOthers)
{
  FittedBoundary boundary;
  for (const double support : {1.0, 0.0})
    boundary.samples.push_back(
        {Vector2d(1 + support, 1), Vector2d(1 + support, 1), Vector2d(1, 0), support});
  const Picture picture = drawPlan({{boxRoom()}}, {boundary});
  EXPECT_EQ(colourAt(picture, 0, {2, 1}), colours::wall);
  EXPECT_EQ(colourAt(picture, 0, {1, 1}), colours::recovered);
  EXPECT_EQ(colourAt(picture, 1, {2, 0}), colours::ink) << "a segment";
  EXPECT_EQ(colourAt(picture, 1, {3, 1}), colours::paper);
}

TEST(RefinementPicture, ShowsPointsWhereTheyWereAndWhereTheyWent)
{
  RefinedWalls walls;
  walls.moved = {{{1, 0.1}, {1, 0}, StructureLabel::Wall},
                 {{2, 0.6}, {2, 0.5}, StructureLabel::Column}};
  walls.removed = {{3, 0.3}};
  const Picture picture = drawRefinement(walls, {{boxRoom()}});
  EXPECT_EQ(colourAt(picture, 0, {1, 0.1}), colours::wall);
  EXPECT_EQ(colourAt(picture, 0, {3, 0.3}), colours::removed);
  EXPECT_EQ(colourAt(picture, 1, {1, 0.1}), colours::paper);
  EXPECT_EQ(colourAt(picture, 1, {1, 0}), colours::wall);
  EXPECT_EQ(colourAt(picture, 1, {2, 0.5}), colours::column);
  EXPECT_EQ(colourAt(picture, 1, {3, 0.3}), colours::paper);
}

TEST(RepairPicture, ShowsHowMuchOfEachStretchOfAWallWasFilled)
{
  // Points on all surfaces except a door in the wall at y = 0, from x = 1 to 2.
  const Floorplan plan{{boxRoom()}};
  std::vector<SurfacePoint> seen;
  for (const auto& whole : repairHoles({}, plan, 0.05)) {
    const Eigen::Vector3d& p = whole.point.position;
    if (p.y() != 0 || p.x() < 1 || p.x() > 2 || p.z() > 2)
      seen.push_back(whole.point);
  }
  RepairedSurfaces surfaces;
  for (const auto& point : repairHoles(seen, plan, 0.05, &surfaces.strips))
    surfaces.is_seen.push_back(point.source >= 0);
  const Picture picture = drawRepair(surfaces, plan);
  EXPECT_EQ(colourAt(picture, 0, {3, 0}), colours::wall) << "the plan";
  EXPECT_EQ(colourAt(picture, 0, {1.5, 0}),
            mixed(colours::wall, colours::recovered, 0.8));
}

TEST(MeshPicture, ShowsTheSidesThatFaceTheViewer)
{
  // An upward floor and a downward ceiling.
  TriangleMesh mesh;
  for (const double z : {0.0, 2.5})
    for (const auto& p :
         {Vector2d(0, 0), Vector2d(4, 0), Vector2d(4, 4), Vector2d(0, 4)})
      mesh.vertices.emplace_back(p.x(), p.y(), z);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}};
  const auto floor = static_cast<std::uint32_t>(StructureLabel::Floor);
  const auto ceiling = static_cast<std::uint32_t>(StructureLabel::Ceiling);
  mesh.labels = {floor, floor, ceiling, ceiling};
  const Picture picture = drawMesh(mesh);
  for (std::size_t panel = 0; panel < 2; ++panel) {
    const Box view = panelOf(picture, panel).view();
    const Colour middle = colourAt(picture, panel, view.center());
    EXPECT_EQ(middle.blue > middle.red, panel == 0)
        << "the floor is seen from above, the ceiling from below";
  }
}

} // namespace
