// SPDX-License-Identifier: BSD-3-Clause
#include "../sheets/sheet_scenes.h"

#include "sedr_segmentation/src/borders/border_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace {

using namespace pcl::sedr;
using sheet_test::fitted;
using sheet_test::Scene;
using sheet_test::sceneOf;

PlanSlab
levelAt(double height)
{
  PlanSlab slab;
  slab.plane << 0, 0, 1, -height;
  return slab;
}

/** A cylinder along x above y = 1, of a radius of 0.6 m. */
PlanSlab
coveWithCrownAt(double height)
{
  SlabCurve curve;
  curve.kind = CurveKind::Cylinder;
  curve.setDirection(0);
  curve.centre = {0, 1};
  curve.across = curve.up = 0.6;
  curve.base = height - 0.6;
  PlanSlab slab = levelAt(height);
  slab.curve = std::make_shared<const SlabCurve>(curve);
  return slab;
}

TEST(BorderPart, AVaultThatMissesTheCeilingByNoiseTouchesItAtItsCrown)
{
  const PlanSlab level = levelAt(3);
  for (const double miss : {0.001, 0.005, -0.001}) {
    const PlanSlab cove = coveWithCrownAt(3 - miss);
    BorderPart part;
    part.one = &cove;
    part.other = &level;
    if (miss > 0) {
      EXPECT_FALSE(part.project({2, 0.93}, 0.25)) << "they do not meet";
    }
    part.touches = true;
    const auto place = part.project({2, 0.93}, 0.25);
    ASSERT_TRUE(place) << miss;
    EXPECT_NEAR(place->x(), 2, 1e-9);
    EXPECT_NEAR(place->y(), 1, 1e-6);
  }
}

TEST(BorderPart, WhatIsFartherApartOrIsNoVaultTouchesNothing)
{
  const PlanSlab level = levelAt(3);
  const PlanSlab cove = coveWithCrownAt(2.98);
  const PlanSlab other = levelAt(2.999);
  BorderPart part;
  part.touches = true;
  part.one = &cove;
  part.other = &level;
  EXPECT_FALSE(part.project({2, 0.93}, 0.25));
  part.one = &other;
  EXPECT_FALSE(part.project({2, 0.93}, 0.25));
}

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
