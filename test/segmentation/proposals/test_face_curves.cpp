// SPDX-License-Identifier: BSD-3-Clause
// What the shapes of whole plans do not show of their faces.
#include "../../plan_loops.h"
#include "sedr_segmentation/src/proposals/face_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace sedr_test;
using pcl::sedr::FaceCurve;
using pcl::sedr::FaceCurves;
using pcl::sedr::PlanLoop;

/** Returns places on a loop, eight at each, as a scan of a wall gives. */
std::vector<Eigen::Vector2d>
placesOn(const std::vector<PlanLoop>& loops, double noise, double spacing = 0.05)
{
  std::mt19937 random(7);
  std::normal_distribution<double> off(0, noise);
  std::vector<Eigen::Vector2d> places;
  for (const PlanLoop& loop : loops)
    for (const auto& e : loop.elements)
      for (double s = spacing / 2; s < e.length(); s += spacing)
        for (int k = 0; k < 8; ++k)
          places.emplace_back(e.pointAt(s) + Eigen::Vector2d(off(random), off(random)));
  return places;
}

TEST(FaceCurves, OfSparseScansAreTheSame)
{
  const PlanLoop room = polygon({{0, 0}, {6, 0}, {6, 3}, {3, 3}, {3, 5}, {0, 5}});
  for (const double spacing : {0.05, 0.1, 0.16})
    for (const double degrees : {0, 33}) {
      const FaceCurves found = pcl::sedr::faceCurves(
          {placesOn({placed(room, degrees, {1.013, -7.021})}, 0.003, spacing), {}, 1});
      EXPECT_EQ(found.curves.size(), 6U) << spacing << " m, turned by " << degrees;
      double length = 0;
      for (const FaceCurve& face : found.curves)
        length += face.to - face.from;
      EXPECT_NEAR(length, room.length(), 6 * 1.5 * spacing) << spacing;
    }
}

TEST(FaceCurves, OfWhichLittleOfTheHeightWasSeenTellLittle)
{
  const PlanLoop room = rectangle(0, 0, 5, 4);
  std::vector<Eigen::Vector2d> places = placesOn({room}, 0.003);
  const std::size_t walls = places.size();
  for (const Eigen::Vector2d& p : placesOn({{{segment({2, 0.5}, {2.7, 0.5})}}}, 0.003))
    places.push_back(p);
  for (const auto& [share, curves] : {std::pair(1.F, 5U), std::pair(0.1F, 4U)}) {
    std::vector<float> shares(places.size(), share);
    std::fill_n(shares.begin(), walls, 1.F);
    EXPECT_EQ(pcl::sedr::faceCurves({places, shares, 1}).curves.size(), curves)
        << share;
  }
}

TEST(FaceCurves, OfExactPlacesHaveRadiiThatMayBe)
{
  // Chords of a circle, and lines, without any noise.
  for (const double length : {0.1, 0.2, 0.4}) {
    std::vector<Eigen::Vector2d> places = placesOn({rectangle(0, 0, 6, 5)}, 0);
    for (double s = 0; s < length; s += 0.01) {
      places.emplace_back(2 + s, 2);
      places.emplace_back(4 + s, 3 + s * s / 2);
    }
    for (const FaceCurve& face : pcl::sedr::faceCurves({places, {}, 1}).curves) {
      EXPECT_TRUE(face.curve.point.allFinite());
      EXPECT_LT(face.curve.radius, 25);
      EXPECT_LT(face.to - face.from, 2 * M_PI * 25);
    }
  }
}

} // namespace
