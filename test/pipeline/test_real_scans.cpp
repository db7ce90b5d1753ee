// SPDX-License-Identifier: BSD-3-Clause
// Models of the scans in the folder SEDR_DATA, which model_real_scan.cmake makes once
// for all tests, with figures of doc/real_scans.md.
#include "tools/run_program.h"

#include <pcl/common/transforms.h>
#include <pcl/io/pcd_io.h>
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <utility>

namespace {

using namespace pcl::sedr;
using namespace programs;

std::string
dataFile(const std::string& name)
{
  const char* folder = std::getenv("SEDR_DATA");
  return (std::filesystem::path(folder ? folder : "") / name).string();
}

/** The model of a scan; its plan has no rooms if there is none. */
struct Model {
  explicit Model(const std::string& scan)
      : folder(std::string(REAL_MODELS) + "/" + scan + "/")
  {
    if (!std::filesystem::exists(folder + "floorplan.json"))
      return;
    std::string problem;
    plan = floorplanFromJson(bytesOf(folder + "floorplan.json"), problem);
    EXPECT_EQ(problem, "");
  }

  MeshTopology topologyOf(const std::string& name) const
  {
    TriangleMesh mesh;
    EXPECT_EQ(loadMesh(folder + name, mesh), "");
    return checkTopology(mesh);
  }

  std::string folder;
  Floorplan plan;
};

#define SEDR_MODEL_OR_SKIP(model, scan)                                                \
  const Model model(scan);                                                             \
  if (model.plan.rooms.empty() && !std::filesystem::exists(dataFile(scan ".pcd")))     \
  GTEST_SKIP() << "no " << (scan) << ".pcd in the folder that SEDR_DATA names"

TEST(RealScan, synth1_has_its_four_rooms_with_corners_to_the_centimetre)
{
  SEDR_MODEL_OR_SKIP(model, "synth1");
  // Corners of the planes fitted to the scan's walls: see the data's description.
  const std::vector<Eigen::Vector2d> corners{
      {-1.4, -2.8},  {2.4, -2.8},  {2.4, 1.0},  {1.4, 1.9},  {-1.4, 1.9},
      {2.5, -2.8},   {5.9, -2.8},  {5.9, 1.9},  {3.5, 1.9},  {2.5, 1.0},
      {-1.4, -11.9}, {0.3, -11.9}, {0.3, -4.4}, {5.9, -4.4}, {5.9, -2.9},
      {-1.4, -2.9},  {0.4, -9.9},  {5.9, -9.9}, {5.9, -5.6}, {0.4, -5.6}};
  EXPECT_EQ(model.plan.rooms.size(), 4u);
  std::size_t walls = 0;
  for (const auto& room : model.plan.rooms)
    for (const auto& wall : room.boundary.elements) {
      ++walls;
      double nearest = 1;
      for (const auto& corner : corners)
        nearest = std::min(nearest, (corner - wall.start).norm());
      EXPECT_LT(nearest, 0.01) << wall.start.transpose();
    }
  EXPECT_EQ(walls, corners.size());
}

TEST(RealScan, stepped_room_keeps_its_step_and_closes)
{
  SEDR_MODEL_OR_SKIP(model, "stepped_room");
  ASSERT_EQ(model.plan.rooms.size(), 1u);
  const PlanRoom& room = model.plan.rooms[0];
  EXPECT_EQ(room.boundary.elements.size(), 4u);
  ASSERT_EQ(room.details.size(), 1u);
  const Eigen::Vector2d below(2, 2);
  EXPECT_EQ(room.detailAt(below), 0);
  EXPECT_NEAR(room.ceiling.heightAt(below) - room.ceilingAt(below), 0.5, 0.05);
  EXPECT_TRUE(model.topologyOf("mesh.ply").isClosedManifold());
}

TEST(RealScan, apartment_rooms_close_but_for_six_handles_at_most)
{
  SEDR_MODEL_OR_SKIP(model, "apartment");
  // Some passages without doors may be separate rooms.
  ASSERT_GE(model.plan.rooms.size(), 12u);
  ASSERT_LE(model.plan.rooms.size(), 15u);
  const MeshTopology topology = model.topologyOf("mesh.ply");
  EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
  EXPECT_EQ(topology.components.size(), model.plan.rooms.size());
  const std::int64_t handles = (model.topologyOf("solid.ply").euler_characteristic -
                                topology.euler_characteristic) /
                               2;
  EXPECT_GE(handles, 0);
  EXPECT_LE(handles, 6);
}

/** The places along the walls and columns of a plan, one each 5 cm, with their normals.
 */
std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>
placesOnWalls(const Floorplan& plan)
{
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> places;
  for (const PlanRoom& room : plan.rooms) {
    std::vector<PlanLoop> loops = room.columns;
    loops.push_back(room.boundary);
    for (const PlanLoop& loop : loops)
      for (const PlanElement& e : loop.elements)
        for (double s = 0.025; s < e.length(); s += 0.05)
          places.emplace_back(e.pointAt(s), e.normalAt(s));
  }
  return places;
}

/** The share of the walls of a plan that another has within 3 cm and 10 degrees. */
double
sharedWalls(const Floorplan& plan, const Floorplan& other)
{
  const auto walls = placesOnWalls(plan);
  const auto others = placesOnWalls(other);
  const auto shared = std::count_if(walls.begin(), walls.end(), [&](const auto& wall) {
    return std::any_of(others.begin(), others.end(), [&](const auto& o) {
      return (o.first - wall.first).squaredNorm() < 0.06 * 0.06 &&
             std::abs(o.second.dot(wall.first - o.first)) < 0.03 &&
             std::abs(o.second.dot(wall.second)) > std::cos(M_PI / 18);
    });
  });
  return static_cast<double>(shared) / static_cast<double>(walls.size());
}

/** The share of the openings of a plan of which another has one of the same kind within
 * 0.3 m. */
double
sharedOpenings(const Floorplan& plan, const Floorplan& other)
{
  const auto middleOf = [](const PlanOpening& o) {
    return Eigen::Vector2d((o.start + o.end) / 2);
  };
  const auto isShared = [&](const PlanOpening& opening) {
    return std::any_of(other.openings.begin(), other.openings.end(),
                       [&](const auto& o) {
                         return o.kind == opening.kind &&
                                (middleOf(o) - middleOf(opening)).norm() < 0.3;
                       });
  };
  return static_cast<double>(
             std::count_if(plan.openings.begin(), plan.openings.end(), isShared)) /
         static_cast<double>(plan.openings.size());
}

TEST(RealScan, apartment_has_the_same_walls_and_openings_if_it_is_turned)
{
  SEDR_MODEL_OR_SKIP(model, "apartment");
  const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  ASSERT_EQ(pcl::io::loadPCDFile(dataFile("apartment.pcd"), *cloud), 0);
  const Eigen::Affine3f turn(Eigen::AngleAxisf(0.5F, Eigen::Vector3f::UnitZ()));
  pcl::transformPointCloud(*cloud, *cloud, turn);
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain;
  chain.setInputCloud(cloud);
  ASSERT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  const Eigen::Rotation2Dd back(-0.5);
  Floorplan turned = *chain.getFloorplan();
  for (PlanRoom& room : turned.rooms) {
    room.columns.push_back(room.boundary);
    for (PlanLoop& loop : room.columns)
      for (PlanElement& e : loop.elements)
        for (Eigen::Vector2d* p : {&e.start, &e.end, &e.centre})
          *p = back * *p;
    room.boundary.elements.clear();
  }
  for (PlanOpening& o : turned.openings)
    for (Eigen::Vector2d* p : {&o.start, &o.end})
      *p = back * *p;
  EXPECT_GT(sharedWalls(model.plan, turned), 0.9);
  EXPECT_GT(sharedWalls(turned, model.plan), 0.9);
  EXPECT_GT(sharedOpenings(model.plan, turned), 0.8);
  EXPECT_GT(sharedOpenings(turned, model.plan), 0.8);
}

/** The plan of the points of a scan whose y is at most `end`. */
Floorplan
planOfPart(const std::string& scan, float end)
{
  const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (pcl::io::loadPCDFile(dataFile(scan + ".pcd"), *cloud) != 0)
    return {};
  cloud->erase(std::remove_if(cloud->begin(), cloud->end(),
                              [end](const auto& p) { return p.y > end; }),
               cloud->end());
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain;
  chain.setInputCloud(cloud);
  EXPECT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  return *chain.getFloorplan();
}

/** What is known of a scan and its plan; an interval has both ends. */
struct KnownScan {
  using Interval = std::array<double, 2>;

  std::string name;
  Interval rooms;
  Interval area{0, 1e9};  ///< of all rooms, square metres
  Interval walls{0, 1e9}; ///< of all rooms
  std::size_t storeys = 1;
  float end = 0; ///< of y of the points that are modelled here; 0: see Model
};

std::ostream&
operator<<(std::ostream& stream, const KnownScan& scan)
{
  return stream << scan.name;
}

class RealScans : public testing::TestWithParam<KnownScan> {};

TEST_P(RealScans, have_their_rooms_with_sound_outlines)
{
  const KnownScan& known = GetParam();
  const Floorplan plan =
      known.end > 0 ? planOfPart(known.name, known.end) : Model(known.name).plan;
  if (plan.rooms.empty() && !std::filesystem::exists(dataFile(known.name + ".pcd")))
    GTEST_SKIP() << "no " << known.name << ".pcd in the folder that SEDR_DATA names";
  double area = 0;
  double walls = 0;
  for (const auto& room : plan.rooms) {
    EXPECT_EQ(outlineProblem(room.boundary), "") << "room " << room.id;
    area += room.area();
    walls += static_cast<double>(room.boundary.elements.size());
  }
  const auto expectIn = [](const KnownScan::Interval& interval, double found) {
    EXPECT_GE(found, interval[0]);
    EXPECT_LE(found, interval[1]);
  };
  expectIn(known.rooms, static_cast<double>(plan.rooms.size()));
  expectIn(known.area, area);
  expectIn(known.walls, walls);
  ASSERT_EQ(plan.storeys.size(), known.storeys);
  if (known.storeys == 2) {
    EXPECT_NEAR(plan.storeys[0].floor, 0.0, 0.05);
    EXPECT_NEAR(plan.storeys[1].floor, 2.7, 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    RealScans,
    testing::Values(KnownScan{"office_labelled", {1, 1}, {35.5, 36.3}, {12, 1e9}},
                    KnownScan{"vaulted_studio", {1, 1}},
                    // No bays. Its drawings take longer than its plan.
                    KnownScan{"dome_hall", {1, 1}, {560, 640}, {0, 64}, 1, 1e9F},
                    // Half of it: the other half is like it.
                    KnownScan{"office_floor", {4, 1e9}, {1200, 1e9}, {0, 1e9}, 1, 31},
                    KnownScan{"ifc_house/scan", {6, 9}, {0, 1e9}, {0, 1e9}, 2}));

/** Returns the numbers after `start` in the last line that begins with it. */
std::vector<double>
figuresAfter(const std::string& start, const std::string& text)
{
  std::istringstream lines(text);
  std::vector<double> figures;
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, start.size(), start) != 0)
      continue;
    std::istringstream words(line.substr(start.size()));
    figures.clear();
    for (double figure = 0; words >> figure;)
      figures.push_back(figure);
  }
  return figures;
}

TEST(RealScan, synth1_lies_on_the_model_as_closely_as_on_its_reference)
{
  SEDR_MODEL_OR_SKIP(model, "synth1");
  const auto figuresOf = [](const std::string& mesh, const std::string& near) {
    const ProgramRun result =
        run(MESH_EVALUATION,
            {mesh, "--cloud", dataFile("synth1.pcd"), "--labels", "2", "--near",
             dataFile("synth1_rooms.obj"), "--near-distance", near});
    return figuresAfter("cloud to model", result.out);
  };
  // Points, mean, rms, median, p95, p99, max, all but the first in centimetres.
  const auto own = figuresOf(dataFile("synth1_rooms.obj"), "0.05");
  const auto ours = figuresOf(model.folder + "solid.ply", "0.05");
  ASSERT_GE(own.size(), 7u);
  ASSERT_GE(ours.size(), 7u);
  EXPECT_LE(ours[1], 0.06 + own[1]);
  // Furniture edges up to 5 cm off the reference are as far from any model.
  const auto nearest = figuresOf(model.folder + "solid.ply", "0.03");
  ASSERT_GE(nearest.size(), 7u);
  EXPECT_LE(nearest[6], 3.0);
}

TEST(RealScan, office_ceiling_floor_and_walls_are_found)
{
  SEDR_MODEL_OR_SKIP(model, "office_labelled");
  const auto scored = run(PYTHON, {LABEL_GRADES, model.folder + "structure.pcd",
                                   dataFile("office_labelled.pcd"), "--map",
                                   "0=1,1=2,2=3,3=3,4=3,5=3,6=0"});
  // True, predicted, recall, precision, precision of the structure's points, in %.
  for (const auto& [label, recall] :
       {std::pair<std::string, double>{"ceiling", 94}, {"floor", 95}, {"wall", 88}}) {
    const auto figures = figuresAfter(label, scored.out);
    ASSERT_EQ(figures.size(), 5u) << scored.out << scored.err;
    EXPECT_GE(figures[2], recall) << label;
  }
}

} // namespace
