// SPDX-License-Identifier: BSD-3-Clause
#include "../sheets/sheet_scenes.h"

#include "sedr_segmentation/src/borders/border_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using namespace pcl::sedr;
using sheet_test::fitted;
using sheet_test::Scene;
using sheet_test::sceneOf;

TEST(BorderSteps, ARiserCountsForTheBorderAtItsFoot)
{
  // A level dormer meets a roof; its cheeks end there. A border of three sides.
  const double slope = 0.8;
  const double head = 1.4 / slope;
  Scene scene = sceneOf(6, 4, [&](double x, double y) {
    return x > 2 && x < 4 && y < head ? 2.3 : 0.9 + slope * y;
  });
  for (const double x : {2.0, 4.0})
    for (double y = 0.01; y < head; y += 0.01)
      for (double z = 0.9 + slope * y; z < 2.3; z += 0.01)
        scene.risers.emplace_back(x, y, z);
  const FacetSheet sheet = fitted(scene);
  const CellCracks cracks = cracksOf(sheet.grid, sheet.label);
  const SheetCracks pieces{sheet, cracks};
  const CellPoints cells(sheet.grid, sheet.is_inside, scene.points);
  const CellPoints vertical(sheet.grid, sheet.is_inside, scene.risers);
  const std::vector<double> directions;
  const BorderSteps steps(pieces, cells, vertical, directions);
  const auto chain = std::find_if(
      cracks.chains.begin(), cracks.chains.end(),
      [](const CrackChain& other) { return other.left >= 0 && other.right >= 0; });
  ASSERT_NE(chain, cracks.chains.end());
  std::vector<Eigen::Vector2d> places;
  for (double y = 0.25; y < head; y += 0.1)
    places.emplace_back(2, y);
  for (double x = 2; x < 4.05; x += 0.1)
    places.emplace_back(x, head);
  const std::vector<bool> has_riser = steps.risersAlong(places, *chain);
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k].y() < head - 0.2) {
      EXPECT_TRUE(has_riser[k]) << places[k].transpose();
    }
    else if (places[k].x() > 2.15 && places[k].x() < 3.85) {
      EXPECT_FALSE(has_riser[k]) << places[k].transpose();
    }
  }
}

} // namespace
