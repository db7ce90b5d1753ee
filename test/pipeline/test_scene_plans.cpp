// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scan.h"
#include "simulator/scene/queries.h"
#include "simulator/scene/scenes.h"

#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace {

namespace sim = pcl::sedr::sim;

struct ExpectedRooms {
  std::string scene;
  std::size_t min_rooms;
  std::size_t max_rooms; ///< what meets without a lintel may be one room or two
};

std::ostream&
operator<<(std::ostream& stream, const ExpectedRooms& e)
{
  return stream << e.scene;
}

/** @brief The scan of a scene, and the model of it. */
class ScenePlan : public testing::TestWithParam<ExpectedRooms> {
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

  sim::Scene scene_ = sim::sceneNamed(GetParam().scene);
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain_;
};

TEST_P(ScenePlan, hasTheRoomsWallsHeightsAndNichesThatWereScanned)
{
  EXPECT_GE(plan().rooms.size(), GetParam().min_rooms);
  EXPECT_LE(plan().rooms.size(), GetParam().max_rooms);
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
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         ScenePlan,
                         testing::Values(ExpectedRooms{"two_storeys", 4, 4},
                                         ExpectedRooms{"stacked_rooms", 2, 2},
                                         ExpectedRooms{"split_level", 4, 4},
                                         ExpectedRooms{"atrium", 10, 10},
                                         ExpectedRooms{"niches", 1, 1},
                                         ExpectedRooms{"closet", 3, 3},
                                         ExpectedRooms{"cluttered_room", 1, 1},
                                         ExpectedRooms{"leaning_slab", 2, 2},
                                         ExpectedRooms{"round_room", 1, 1},
                                         ExpectedRooms{"diagonal_rooms", 2, 2}),
                         [](const auto& scene) { return scene.param.scene; });

} // namespace
