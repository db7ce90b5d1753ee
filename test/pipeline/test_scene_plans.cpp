// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scan.h"
#include "simulator/scene/scene.h"

#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

namespace sim = pcl::sedr::sim;

struct ExpectedPlan {
  std::string scene;
  std::size_t rooms;
  std::string shape{};    ///< of a room as a scene file has it; empty: a built-in scene
  std::size_t walls = 0;  ///< of that room
  std::size_t facets = 0; ///< of its ceiling besides the main one
  double radius = 0;      ///< of their curves; 0: none
};

constexpr const char* eight_by_five = R"("outline": {"rectangle": [[0, 0], [8, 5]]},)";
constexpr const char* seven_by_five = R"("outline": {"rectangle": [[0, 0], [7, 5]]},)";

/** @brief Returns a scene of a furnished room with a door and a window, scanned on a
 * walk with 1 cm of noise. */
sim::Scene
roomOfShape(const std::string& shape)
{
  const std::string text = R"({
    "format": "sedr-scene", "version": 1, "name": "room", "summary": "a room",
    "rooms": [{
      "name": "room", "floor": 0, )" +
                           shape + R"(,
      "openings": [
        {"wall": 3, "from": 2.1, "to": 3, "head": 2.05, "depth": 0.25,
         "leaf": {"hinge": "from", "angle": 90},
         "lobby": {"depth": 2.4, "margin": 1.4, "height": 2.6}},
        {"wall": 1, "from": 1.6, "to": 2.4, "sill": 0.9, "head": 2.1, "depth": 0.3,
         "glazing": {}}],
      "furniture": [
        {"table": {"at": [2.6, 2.9], "size": [1.8, 0.9, 0.74]}},
        {"chair": {"at": [2.3, 3.65]}},
        {"block": {"wall": 2, "s": 1.2, "size": [1.4, 0.4, 0.7]}},
        {"block": {"wall": 0, "s": 1.25, "size": [2, 1.2, 0.5]}},
        {"lamp": {"at": [3.6, 2.2], "drop": 0.9, "radius": 0.2}}]}],
    "outside": [
      {"block": {"name": "ground", "at": [5, 2], "floor": -0.6, "size": [80, 80, 0.2]}},
      {"block": {"name": "facade", "at": [4, -14], "floor": -0.4, "size": [40, 1, 8]}}],
    "scanners": [{
      "walk": {"path": [[1.2, 1.4], [5.2, 1.4], [3.4, 2.4], [1.2, 3.6], [1.2, 2]],
               "count": 32, "height": 1.5, "sway": 0.04},
      "rays": 50000, "jitter": 1, "max_range": 40, "noise": 0.01}],
    "placement": {"yaw": -17, "shift": [6, 2, 1]}})";
  return sim::parseScene(text, "shape");
}

/** @brief The scan of a scene, and the model of it. */
class ScenePlan : public testing::TestWithParam<ExpectedPlan> {
protected:
  void SetUp() override
  {
    chain_.setInputCloud(sim::cloudOf(scene_));
    ASSERT_TRUE(chain_.findStructure()) << chain_.getErrorMessage();
  }

  const pcl::sedr::Floorplan& plan() const { return *chain_.getFloorplan(); }

  /** @brief Expects the solids where walls, floor and ceiling of a room are. Not where
   * it has an opening or a void, nor below the steps of its floor, which stairs hide.
   * @param number of the room, from 1 */
  void expectSolid(std::uint32_t number)
  {
    const auto figures = sim::figuresOf(
        chain_.getStages().extrusion.getMesh(),
        sim::facesOf(scene_, [number](const sim::SceneMesh& all, std::size_t t) {
          return all.mesh.rooms[t] == number &&
                 all.surfaces[t] == sim::Surface::Structure &&
                 all.mesh.labels[t] != static_cast<std::uint32_t>(sim::Label::Detail);
        }));
    EXPECT_LE(figures.truth_to_mesh->mean, 0.0005) << scene_.rooms[number - 1].name;
    EXPECT_TRUE(chain_.getStages().extrusion.getReports()[number - 1].closed);
  }

  /** @brief Expects ceilings and floors of the plan at the heights of the scene, but
   * for voids and for a fiftieth of the places, along the edges of details. */
  void expectHeights() const
  {
    constexpr double step = 0.1;
    constexpr double to_walls = 0.05;
    const sim::Vec3& shift = scene_.placement.shift;
    const auto floor_voids = sim::floorVoidsOf(scene_);
    std::size_t places = 0;
    std::size_t right = 0;
    for (std::size_t r = 0; r < scene_.rooms.size(); ++r) {
      const sim::Room& room = scene_.rooms[r];
      std::vector<sim::Loop> voids = floor_voids[r];
      for (const sim::CeilingVoid& hole : room.voids)
        voids.push_back(hole.loop);
      const sim::Box2 box = pcl::sedr::boundsOf(room.boundary);
      for (double x = box.min().x(); x < box.max().x(); x += step)
        for (double y = box.min().y(); y < box.max().y(); y += step) {
          const sim::Vec2 p(x, y);
          if (!room.contains(p) || room.boundary.distance(p) < to_walls ||
              std::any_of(voids.begin(), voids.end(),
                          [&](const sim::Loop& hole) { return hole.contains(p); }))
            continue;
          const sim::Vec2 at = sim::placed(scene_.placement, p);
          ++places;
          right += std::any_of(
              plan().rooms.begin(), plan().rooms.end(), [&](const auto& found) {
                return found.contains(at) &&
                       std::abs(found.ceilingAt(at) - room.ceilingAt(p) - shift.z()) <
                           0.01 &&
                       std::abs(found.floorAt(at) - room.floorAt(p) - shift.z()) < 0.01;
              });
        }
    }
    EXPECT_GE(static_cast<double>(right), 0.98 * static_cast<double>(places));
  }

  /** @brief Expects the niches of the scene, with their backs and heights, and no
   * others. */
  void expectNiches() const
  {
    const sim::Placement& placement = scene_.placement;
    std::vector<pcl::sedr::PlanNiche> found;
    for (const pcl::sedr::PlanRoom& room : plan().rooms)
      found.insert(found.end(), room.niches.begin(), room.niches.end());
    std::size_t niches = 0;
    for (const sim::Room& room : scene_.rooms)
      for (const sim::WallGap& niche : room.wall_niches) {
        ++niches;
        const sim::Element back =
            sim::offsetRight(sim::faceOf(room, niche), niche.depth);
        const sim::Vec2 start = sim::placed(placement, back.start);
        const sim::Vec2 end = sim::placed(placement, back.end);
        EXPECT_TRUE(
            std::any_of(found.begin(), found.end(),
                        [&](const auto& other) {
                          return other.boundary.distance(start) < 0.02 &&
                                 other.boundary.distance(end) < 0.02 &&
                                 std::abs(other.bottom.heightAt(start) - niche.sill -
                                          placement.shift.z()) < 0.01 &&
                                 std::abs(other.top.heightAt(start) - niche.head -
                                          placement.shift.z()) < 0.01;
                        }))
            << niche.from << " m along wall " << niche.wall;
      }
    EXPECT_EQ(found.size(), niches);
  }

  sim::Scene scene_ = GetParam().shape.empty() ? sim::sceneNamed(GetParam().scene)
                                               : roomOfShape(GetParam().shape);
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain_;
};

TEST_P(ScenePlan, hasTheRoomsWallsHeightsAndNichesThatWereScanned)
{
  ASSERT_EQ(plan().rooms.size(), GetParam().rooms);
  double true_area = 0;
  for (const sim::Room& room : scene_.rooms)
    true_area += room.boundary.area();
  double area = 0;
  for (const pcl::sedr::PlanRoom& room : plan().rooms)
    area += room.area();
  EXPECT_NEAR(area, true_area, 0.002 * true_area);
  for (std::uint32_t number = 1; number <= scene_.rooms.size(); ++number)
    expectSolid(number);
  expectHeights();
  expectNiches();
  for (const pcl::sedr::PlanWarning& warning : chain_.getModel().warnings)
    EXPECT_TRUE(warning.kind != pcl::sedr::WarningKind::GuessedWall)
        << pcl::sedr::sentenceOf(warning);
  if (GetParam().shape.empty())
    return;
  const pcl::sedr::PlanRoom& room = plan().rooms[0];
  EXPECT_EQ(room.boundary.elements.size(), GetParam().walls);
  EXPECT_EQ(room.details.size(), GetParam().facets);
  for (int d = -1; d < static_cast<int>(room.details.size()); ++d)
    if (const auto& curve = room.ceilingSlab(d).curve) {
      EXPECT_NEAR(curve->across, GetParam().radius, 0.01 * GetParam().radius);
    }
}

const std::string slope = R"({"height": 2.4, "slope": 30, "towards": )";

/** @brief Returns an arch of 1.5 m from x on, 0.16 m high. */
std::string
archFrom(double x)
{
  return R"({"loop": {"rectangle": [[)" + std::to_string(x) + ", 0], [" +
         std::to_string(x + 1.5) + R"(, 5]]}, "vault": {"at": [)" +
         std::to_string(x + 0.75) +
         R"(, 0], "direction": 90, "height": 0.8197916795825584, "radius": 1.84}})";
}

INSTANTIATE_TEST_SUITE_P(
    Scenes,
    ScenePlan,
    testing::Values(
        ExpectedPlan{"two_storeys", 4},
        ExpectedPlan{"stacked_rooms", 2},
        ExpectedPlan{"split_level", 4},
        ExpectedPlan{"atrium", 10},
        ExpectedPlan{"niches", 1},
        ExpectedPlan{"closet", 3},
        ExpectedPlan{"cluttered_room", 1},
        ExpectedPlan{"leaning_slab", 2},
        ExpectedPlan{"round_room", 1},
        ExpectedPlan{"diagonal_rooms", 2},
        ExpectedPlan{"gable_attic", 1,
                     std::string(seven_by_five) +
                         R"("ceiling": {"height": 0.9, "slope": 40, "towards": 90},
          "facets": [{"loop": {"rectangle": [[0, 2.5], [7, 5]]},
            "height": {"height": 0.9, "slope": 40, "towards": -90, "at": [0, 5]}}])",
                     4, 1},
        ExpectedPlan{
            "shed_roof", 1,
            R"("outline": [[7, 3], [4.5, 3], [4.5, 5.5], [0, 5.5], [0, 0], [7, 0]],
          "ceiling": {"height": 2.2, "slope": 18, "towards": 0, "at": [0, 0]})",
            6},
        ExpectedPlan{"hip_roof", 1,
                     seven_by_five + (R"("ceiling": )" + slope) + R"(90},
          "facets": [
            {"loop": [[0, 5], [2.5, 2.5], [4.5, 2.5], [7, 5]], "height": )" +
                         slope + R"(-90, "at": [0, 5]}},
            {"loop": [[0, 0], [2.5, 2.5], [0, 5]], "height": )" +
                         slope + R"(0, "at": [0, 0]}},
            {"loop": [[7, 0], [7, 5], [4.5, 2.5]], "height": )" +
                         slope + R"(180, "at": [7, 0]}}])",
                     4, 3},
        ExpectedPlan{"barrel_vault", 1, std::string(eight_by_five) + R"("ceiling": 1.2,
          "facets": [{"loop": {"rectangle": [[0, 0], [8, 5]]},
            "vault": {"at": [0, 2.5], "direction": 0, "height": 1.2, "radius": 2.5}}])",
                     4, 0, 2.5},
        ExpectedPlan{"segmental_vault", 1,
                     std::string(eight_by_five) + R"("ceiling": 2.3,
          "facets": [{"loop": {"rectangle": [[0, 0], [8, 5]]},
            "vault": {"at": [0, 2.5], "direction": 0, "height": -0.8224989991991993,
                      "radius": 4}}])",
                     4, 0, 4},
        ExpectedPlan{"dome", 1,
                     R"("outline": {"rectangle": [[0, 0], [6.4, 5.4]]}, "ceiling": 2.8,
          "facets": [{"dome": {"at": [3.2, 2.7], "height": 0.56393202250021, "radius": 3,
                               "rim": 2}}])",
                     4, 1, 3},
        ExpectedPlan{"jack_arches", 1,
                     R"("outline": {"rectangle": [[0, 0], [6, 5]]}, "ceiling": 2.5,
          "facets": [)" + archFrom(0) +
                         ", " + archFrom(1.5) + ", " + archFrom(3) + ", " +
                         archFrom(4.5) + "]",
                     4, 3, 1.84}),
    [](const auto& scene) { return scene.param.scene; });

} // namespace
