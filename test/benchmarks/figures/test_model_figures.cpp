// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/figures/model_figures.h"
#include "benchmarks/benchmark_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace benchmark_test {
namespace {

// Areas of the room with a soffit of 2 x 1 m, 30 cm below the ceiling: floor, ceiling
// with underside, walls, risers.
constexpr double underside = 2.0;
constexpr double soffit_perimeter = 6.0;
constexpr double drop = 0.3;
constexpr double zone_width = 0.1; // by the definition of the bar
constexpr double true_area = 12 + 12 + 14 * 2.5 + soffit_perimeter * drop;

/** Compares the truth with a model whose soffit is lower by `shift`. */
ModelFigures
withSoffitMoved(double shift)
{
  return measureModel(truthOfRoom(roomWithSoffit(drop + shift)).mesh,
                      truthOfRoom(roomWithSoffit(drop)).mesh);
}

TEST(ModelFigures, of_the_truth_itself_are_perfect)
{
  const ModelFigures figures = withSoffitMoved(0);
  EXPECT_TRUE(figures.isMeasured());
  EXPECT_EQ(figures.components, 1u);
  EXPECT_TRUE(*figures.closed && *figures.edge_manifold && *figures.vertex_manifold &&
              *figures.closed_manifold);
  EXPECT_NEAR(figures.truth_to_mesh_max, 0, 1e-9);
  EXPECT_NEAR(figures.mesh_to_truth_max, 0, 1e-9);
  EXPECT_EQ(figures.truth_within_1cm, 1);
  EXPECT_EQ(figures.mesh_beyond_5cm, 0);
  EXPECT_EQ(figures.detail_within_1cm, 1);
}

TEST(ModelFigures, a_soffit_moved_by_3_cm_is_3_cm_off)
{
  constexpr double shift = 0.03;
  const ModelFigures figures = withSoffitMoved(shift);
  EXPECT_NEAR(figures.truth_to_mesh_max, shift, 1e-9);
  // The underside is 3 cm away, except near its rim, where the longer riser is nearer.
  const double rim = soffit_perimeter * shift;
  EXPECT_NEAR(figures.truth_to_mesh_mean,
              ((underside - rim) * shift + rim * shift / 2) / true_area, 2e-5);
  EXPECT_EQ(figures.truth_within_5cm, 1);
  EXPECT_EQ(figures.mesh_beyond_5cm, 0);
  EXPECT_EQ(figures.detail_within_5cm, 1);
  // The underside without a rim of 1 cm is farther than 1 cm.
  EXPECT_NEAR(figures.truth_within_1cm, 1 - 1.98 * 0.98 / true_area, 5e-4);
}

TEST(ModelFigures, a_soffit_moved_by_6_cm_shows_in_the_zone_of_details)
{
  constexpr double shift = 0.06;
  const ModelFigures figures = withSoffitMoved(shift);
  // The zone: underside, risers, and 10 cm of the ceiling around them.
  const double zone = underside + soffit_perimeter * drop +
                      soffit_perimeter * zone_width + M_PI * zone_width * zone_width;
  EXPECT_NEAR(figures.detail_within_5cm, 1 - 1.9 * 0.9 / zone, 2e-3);
  EXPECT_NEAR(figures.truth_within_5cm, 1 - 1.9 * 0.9 / true_area, 5e-4);
  // The model's whole underside, and the lowest centimetre of its risers.
  const double model_area = true_area + soffit_perimeter * shift;
  EXPECT_NEAR(figures.mesh_beyond_5cm,
              (underside + soffit_perimeter * 0.01) / model_area, 5e-4);
  EXPECT_NEAR(figures.mesh_to_truth_max, shift, 1e-9);
}

TEST(ModelFigures, columns_have_a_zone_too)
{
  sim::Room room = sim::test::makeBoxRoom(4.0, 3.0, 2.5);
  const TriangleMesh without = *truthOfRoom(room).mesh;
  room.columns.push_back(sim::rectangleLoop({2.0, 1.0}, {2.4, 1.4}));
  const SceneTruth truth = truthOfRoom(room);
  const ModelFigures figures =
      measureModel(std::make_shared<const TriangleMesh>(without), truth.mesh);
  // Its sides are missing, except within 5 cm of floor and ceiling.
  const double sides = 1.6 * 2.5;
  const double around = 2 * (1.6 * zone_width + M_PI * zone_width * zone_width);
  EXPECT_NEAR(figures.detail_within_5cm, 1 - 1.6 * 2.4 / (sides + around), 2e-3);
}

TEST(ModelFigures, without_details_have_no_zone)
{
  const auto truth = truthOfRoom(sim::test::makeBoxRoom(2.0, 2.0, 2.0)).mesh;
  const ModelFigures figures = measureModel(truth, truth);
  EXPECT_TRUE(std::isnan(figures.detail_within_5cm));
  EXPECT_TRUE(std::isnan(figures.detail_within_1cm));
}

TEST(ModelFigures, tell_an_open_mesh_and_a_second_component)
{
  const auto truth = truthOfRoom(sim::test::makeBoxRoom(2.0, 2.0, 2.0)).mesh;
  auto open = std::make_shared<TriangleMesh>(*truth);
  std::vector<bool> keep(open->triangles.size(), true);
  keep[0] = false;
  open->keepTriangles(keep);
  EXPECT_FALSE(*measureModel(open, truth).closed);
  EXPECT_FALSE(*measureModel(open, truth).closed_manifold);

  auto doubled = std::make_shared<TriangleMesh>(*truth);
  TriangleMesh other = *truth;
  for (auto& vertex : other.vertices)
    vertex.x() += 5;
  doubled->append(other);
  const ModelFigures figures = measureModel(doubled, truth);
  EXPECT_EQ(figures.components, 2u);
  EXPECT_TRUE(*figures.closed_manifold);
  EXPECT_NEAR(figures.mesh_beyond_5cm, 0.5, 1e-6);
}

TEST(ModelFigures, of_no_mesh_are_refused)
{
  const auto truth = truthOfRoom(sim::test::makeBoxRoom(2.0, 2.0, 2.0)).mesh;
  EXPECT_THROW(measureModel(std::make_shared<const TriangleMesh>(), truth),
               std::runtime_error);
}

TEST(SceneTruth, has_the_mesh_of_the_scan_with_its_labels)
{
  sim::Scene scene = sim::test::makeScene(roomWithSoffit(drop), {}, 1);
  scene.placement = {90.0, {10.0, 20.0, 1.0}};
  const SceneTruth truth = truthOf(scene);
  const auto box = truth.mesh->bounds();
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(7, 20, 1)));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(10, 24, 3.5)));
  EXPECT_NEAR(truth.mesh->area(), true_area, 1e-9);
  EXPECT_NEAR(detailsOf(*truth.mesh).area(), underside + soffit_perimeter * drop, 1e-9);
  ASSERT_EQ(truth.rooms.size(), 1u);
  EXPECT_NEAR(truth.rooms[0].volume, 30 - underside * drop, 1e-9);
}

} // namespace
} // namespace benchmark_test
