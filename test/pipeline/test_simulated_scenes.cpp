// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scan.h"
#include "simulator/scene/scene.h"
#include "surface/drawing/drawn_plans.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <cstdint>

namespace {

namespace sim = pcl::sedr::sim;
using Reconstruction = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;

using sim::cloudOf;

pcl::PointCloud<pcl::PointXYZ>::ConstPtr
cloudOf(const std::string& scene, const sim::ScanOptions& options = {})
{
  return cloudOf(sim::sceneNamed(scene), options);
}

struct Expected {
  std::string scene;
  std::size_t rooms;
  std::size_t walls;
  std::size_t columns;
  std::size_t details;
  double area;       ///< square metres of all rooms
  double worst_mean; ///< metres from truth to mesh
};

std::ostream&
operator<<(std::ostream& stream, const Expected& e)
{
  return stream << e.scene;
}

class SimulatedScene : public testing::TestWithParam<Expected> {
protected:
  void expectPlan() const
  {
    const auto plan = chain_.getFloorplan();
    std::size_t walls = 0;
    std::size_t columns = 0;
    std::size_t details = 0;
    double area = 0;
    for (const auto& room : plan->rooms) {
      walls += room.boundary.elements.size();
      columns += room.columns.size();
      details += room.details.size();
      area += room.area();
    }
    EXPECT_EQ(plan->rooms.size(), GetParam().rooms);
    EXPECT_GE(walls, GetParam().walls);
    EXPECT_LE(walls, GetParam().walls + 1); // noise may part one
    EXPECT_EQ(columns, GetParam().columns);
    EXPECT_EQ(details, GetParam().details);
    EXPECT_NEAR(area, GetParam().area, 0.002 * GetParam().area);
  }

  /** @brief Expects unit normals into the room at all points of the structure. */
  void expectStructure() const
  {
    for (const auto& p : *chain_.getStructure()) {
      const Eigen::Vector3d normal = p.getNormalVector3fMap().cast<double>();
      EXPECT_NEAR(normal.norm(), 1, 1e-5);
      EXPECT_NE(p.label, 0u);
      ASSERT_TRUE(p.room >= 1 && p.room <= GetParam().rooms) << p.room;
      const auto& room = chain_.getFloorplan()->rooms[p.room - 1];
      const Eigen::Vector3d inside = p.getVector3fMap().cast<double>() + 0.05 * normal;
      EXPECT_TRUE(room.boundary.distance(inside.head<2>()) < 0.06 ||
                  room.contains(inside.head<2>()));
      EXPECT_GT(inside.z(), room.floor.heightAt(inside.head<2>()) - 0.01);
    }
  }

  void expectMesh() const
  {
    const auto figures =
        sim::figuresOf(chain_.getStages().poisson.getMesh(),
                       sim::truthInScan(sim::sceneNamed(GetParam().scene)));
    EXPECT_TRUE(figures.mesh.closed);
    EXPECT_EQ(figures.mesh.topology.components.size(), GetParam().rooms);
    EXPECT_GE(figures.truth_to_mesh->within_5cm, 0.97);
    EXPECT_LE(figures.truth_to_mesh->mean, GetParam().worst_mean);
    EXPECT_GE(figures.mesh_to_truth->within_5cm, 0.98);
  }

  /** @brief Expects the solid that programs make of the plan once it is a file. */
  void expectSolid() const
  {
    using namespace pcl::sedr;
    std::string problem;
    pcl::FloorplanExtrusion<pcl::PointXYZ> read;
    read.setFloorplan(
        floorplanFromJson(floorplanToJson(*chain_.getFloorplan()), problem));
    ASSERT_EQ(problem, "");
    pcl::PolygonMesh unused;
    read.reconstruct(unused);
    const auto& solid = chain_.getStages().extrusion.getMesh();
    EXPECT_EQ(read.getMesh().vertices, solid.vertices);
    EXPECT_EQ(read.getMesh().triangles, solid.triangles);
  }

  /** @brief Expects sections as long and as high as the plan is there, and elevations
   * as large as the walls of the solid, to a millimetre. */
  void expectDrawings() const
  {
    using namespace pcl::sedr;
    const auto plan = chain_.getFloorplan();
    const auto drawn = {DrawingFormat::Dxf};
    const SectionLine line = sectionThroughRooms(*plan);
    constexpr double step = 0.0005; // metres
    double area = 0;
    double length = 0;
    for (double s = -50; s < 50; s += step) {
      const Eigen::Vector2d p = line.from + s * (line.to - line.from).normalized();
      for (const PlanRoom& room : plan->rooms)
        if (room.contains(p)) {
          area += step * (room.ceilingAt(p) - room.floorAt(p));
          length += step;
        }
    }
    EXPECT_NEAR(sedr_test::outlinedArea(drawSection(*plan, line, drawn)[0]), area,
                0.001 * length);
    for (const PlanRoom& room : plan->rooms) {
      TriangleMesh solid;
      std::vector<SolidElement> elements;
      extrudeRoom(room, {}, solid, elements);
      double walls = 0;
      for (std::size_t t = 0; t < solid.triangles.size(); ++t)
        if (elements[solid.elements[t] - 1].name.find("_wall_") != std::string::npos)
          walls += solid.scaledNormal(t).norm() / 2;
      EXPECT_NEAR(sedr_test::outlinedArea(drawElevations(*plan, room.id, drawn)[0]),
                  walls, 0.001 * room.boundary.length());
    }
  }

  Reconstruction chain_;
};

TEST_P(SimulatedScene, has_the_plan_the_structure_and_the_closed_mesh_that_were_scanned)
{
  chain_.setInputCloud(cloudOf(GetParam().scene));
  pcl::PolygonMesh output;
  chain_.reconstruct(output);
  ASSERT_FALSE(output.polygons.empty()) << chain_.getErrorMessage();
  expectPlan();
  expectStructure();
  expectMesh();
  expectSolid();
  expectDrawings();
}

INSTANTIATE_TEST_SUITE_P(
    All,
    SimulatedScene,
    testing::Values(Expected{"bls_room", 1, 4, 0, 2, 29.76, 0.003},
                    Expected{"hls_hall", 1, 4, 5, 0, 168.65, 0.003},
                    Expected{"syn_flat", 4, 19, 0, 0, 98.85, 0.001}),
    [](const auto& scene) { return scene.param.scene; });

TEST(Chain, leaves_a_wall_of_windows_where_it_is)
{
  const auto wallsOf = [](const std::string& scene, const sim::ScanOptions& options) {
    Reconstruction chain;
    chain.setInputCloud(cloudOf(scene, options));
    EXPECT_TRUE(chain.findStructure()) << chain.getErrorMessage();
    std::size_t walls = 0;
    for (const auto& room : chain.getFloorplan()->rooms)
      walls += room.boundary.elements.size();
    return walls;
  };
  EXPECT_EQ(wallsOf("big_windows", sim::noiseAndSeed(0.01, 3)), 4U);
  EXPECT_EQ(wallsOf("l_room", sim::noiseAndSeed(0.005, 1)), 6U);
}

/** @brief Models two rooms side by side of which the eastern one has a wall of windows.
 * @param window its opening, from 0.12 to 4.62 m along the wall, without these
 * @return areas of the rooms, square metres */
std::vector<double>
areasBesideWindows(const std::string& window)
{
  const sim::Scene scene = sim::parseScene(R"({"format": "sedr-scene", "version": 1,
    "name": "windows", "summary": "a wall of windows", "rooms": [
      {"name": "west", "outline": [[0, 0], [5.7, 0], [5.7, 5.2], [0, 5.2]],
       "floor": 0, "ceiling": 3.28, "openings": [
         {"wall": 0, "from": 1, "to": 3, "sill": 0.9, "head": 2.1, "depth": 0.3,
          "glazing": {}}]},
      {"name": "east", "outline": [[5.86, 0.36], [10.6, 0.36], [10.6, 5.51], [5.86, 5.51]],
       "floor": 0, "ceiling": 3.28, "openings": [
         {"wall": 3, "from": 1.76, "to": 2.83, "sill": 0, "head": 2.1, "depth": 0.16,
          "leads_to": "west"},
         {"wall": 2, "from": 0.12, "to": 4.62, "glazing": {}, )" +
                                               window +
                                               R"(}]}],
    "scanners": [{"stations": [[2, 2, 1.6], [3.5, 3, 1.6], [8, 2, 1.6], [9, 3.5, 1.6]],
      "rays": 250000, "noise": 0.01, "jitter": 0.5}]})",
                                           "windows");
  Reconstruction chain;
  chain.setInputCloud(cloudOf(scene, sim::noiseAndSeed(0.01, 1)));
  EXPECT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  std::vector<double> areas;
  for (const auto& room : chain.getFloorplan()->rooms)
    areas.push_back(room.area());
  return areas;
}

TEST(Chain, leaves_a_wall_of_windows_where_its_lintel_is)
{
  // Neither at the pane nor at the blind, nor on the line of the other room's wall, 31
  // cm before it, however low the lintel is.
  for (const char* const window :
       {R"("sill": 0.05, "head": 2.7, "depth": 0.3)",
        R"("sill": 0.02, "head": 3.13, "depth": 0.25)",
        R"("sill": 0.5, "head": 3.18, "depth": 0.15)",
        R"("sill": 0.5, "head": 3.13, "depth": 0.25, "blind": 0.95)"}) {
    const std::vector<double> areas = areasBesideWindows(window);
    ASSERT_EQ(areas.size(), 2U) << window;
    EXPECT_NEAR(areas[0], 5.7 * 5.2, 0.1) << window;
    EXPECT_NEAR(areas[1], 4.74 * 5.15, 0.1) << window;
  }
}

} // namespace
