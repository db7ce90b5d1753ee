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
  std::size_t walls =
      0; ///< of one room below a ceiling of a shape; 0: not of this kind
  std::size_t facets = 0; ///< of its ceiling besides the main one
  double radius = 0;      ///< of their curves; 0: none
};

/** @brief The scan of a scene, and the model of it. */
class ScenePlan : public testing::TestWithParam<ExpectedPlan> {
protected:
  void SetUp() override
  {
    if (GetParam().walls > 0)
      for (sim::Scanner& scanner : scene_.scanners)
        scanner.noise = 0.01;
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

  sim::Scene scene_ =
      sim::sceneNamed(GetParam().walls > 0 ? std::string(CEILING_SCENES) + "/" +
                                                 GetParam().scene + ".json"
                                           : GetParam().scene);
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
  if (GetParam().walls == 0)
    return;
  const pcl::sedr::PlanRoom& room = plan().rooms[0];
  EXPECT_EQ(room.boundary.elements.size(), GetParam().walls);
  EXPECT_EQ(room.details.size(), GetParam().facets);
  for (int d = -1; d < static_cast<int>(room.details.size()); ++d)
    if (const auto& curve = room.ceilingSlab(d).curve) {
      EXPECT_NEAR(curve->across, GetParam().radius, 0.01 * GetParam().radius);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         ScenePlan,
                         testing::Values(ExpectedPlan{"two_storeys", 4},
                                         ExpectedPlan{"stacked_rooms", 2},
                                         ExpectedPlan{"split_level", 4},
                                         ExpectedPlan{"atrium", 10},
                                         ExpectedPlan{"niches", 1},
                                         ExpectedPlan{"closet", 3},
                                         ExpectedPlan{"cluttered_room", 1},
                                         ExpectedPlan{"leaning_slab", 2},
                                         ExpectedPlan{"round_room", 1},
                                         ExpectedPlan{"diagonal_rooms", 2},
                                         ExpectedPlan{"gable_attic", 1, 4, 1},
                                         ExpectedPlan{"shed_roof", 1, 6},
                                         ExpectedPlan{"hip_roof", 1, 4, 3},
                                         ExpectedPlan{"barrel_vault", 1, 4, 0, 2.5},
                                         ExpectedPlan{"segmental_vault", 1, 4, 0, 4},
                                         ExpectedPlan{"dome", 1, 4, 1, 3},
                                         ExpectedPlan{"jack_arches", 1, 4, 3, 1.84}),
                         [](const auto& scene) { return scene.param.scene; });

} // namespace
