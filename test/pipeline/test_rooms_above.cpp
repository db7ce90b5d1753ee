// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scan.h"
#include "simulator/scene/queries.h"
#include "simulator/scene/scenes.h"

#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>

namespace {

namespace sim = pcl::sedr::sim;

struct RoomsAbove {
  std::string scene;
  std::size_t min_rooms;
  std::size_t max_rooms; ///< what meets without a lintel may be one room or two
};

std::ostream&
operator<<(std::ostream& stream, const RoomsAbove& e)
{
  return stream << e.scene;
}

/** @brief A scan of rooms above each other, and the model of it. */
class Storeys : public testing::TestWithParam<RoomsAbove> {
protected:
  void SetUp() override
  {
    chain_.setInputCloud(sim::cloudOf(scene_));
    ASSERT_TRUE(chain_.findStructure()) << chain_.getErrorMessage();
  }

  const pcl::sedr::Floorplan& plan() const { return *chain_.getFloorplan(); }

  /** @brief Expects a room around a scanner, with its floor and its ceiling there. */
  void expectRoomAround(const sim::Vec3& station) const
  {
    const sim::Vec2 place = sim::plan(station);
    const sim::Room& room = scene_.rooms[sim::roomAt(scene_, station) - 1];
    const sim::Vec3 at = sim::placed(scene_.placement, station);
    const auto found =
        std::find_if(plan().rooms.begin(), plan().rooms.end(), [&](const auto& r) {
          return r.contains(at.head<2>()) && r.floorAt(at.head<2>()) < at.z() &&
                 r.ceilingAt(at.head<2>()) > at.z();
        });
    ASSERT_TRUE(found != plan().rooms.end())
        << "no room around the scanner in " << room.name;
    const double lift = scene_.placement.shift.z();
    EXPECT_NEAR(found->ceilingAt(at.head<2>()), room.ceilingAt(place) + lift, 0.01)
        << room.name;
    if (room.contains(place) && room.floorDetailAt(place) < 0) {
      EXPECT_NEAR(found->floorAt(at.head<2>()), room.floorAt(place) + lift, 0.01)
          << room.name;
    }
  }

  /** @brief Expects the solids where walls, floor and ceiling of a room are. Not where
   * it has an opening or a void, nor below the steps of its floor, which stairs hide.
   * @param number of the room, from 1 */
  void expectSolid(std::uint32_t number)
  {
    const auto figures = sim::figuresOf(
        chain_.getStages().extrusion.getMesh(),
        sim::facesOf(scene_,
                     [number](const sim::SceneMesh& all, std::size_t t) {
                       return all.mesh.rooms[t] == number &&
                              all.surfaces[t] == sim::Surface::Structure &&
                              all.mesh.labels[t] !=
                                  static_cast<std::uint32_t>(sim::Label::Detail);
                     }),
        0.05);
    EXPECT_LE(figures.truth_to_mesh->mean, 0.0005) << scene_.rooms[number - 1].name;
  }

  sim::Scene scene_ = sim::sceneNamed(GetParam().scene);
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain_;
};

TEST_P(Storeys, keepTheirRoomsWallsAndHeightsWhereTheyAreOpenToEachOther)
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
  for (const sim::Scanner& scanner : scene_.scanners)
    for (const sim::Vec3& station : scanner.stations)
      expectRoomAround(station);
  for (std::uint32_t number = 1; number <= scene_.rooms.size(); ++number)
    expectSolid(number);
  for (const pcl::sedr::PlanWarning& warning : chain_.getModel().warnings)
    EXPECT_TRUE(warning.kind != pcl::sedr::WarningKind::GuessedWall)
        << pcl::sedr::sentenceOf(warning);
}

INSTANTIATE_TEST_SUITE_P(AboveEachOther,
                         Storeys,
                         testing::Values(RoomsAbove{"two_storeys", 4, 4},
                                         RoomsAbove{"stacked_rooms", 2, 2},
                                         RoomsAbove{"split_level", 4, 4},
                                         RoomsAbove{"atrium", 10, 10}),
                         [](const auto& scene) { return scene.param.scene; });

} // namespace
