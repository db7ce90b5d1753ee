// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/refit/square_surfaces.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

using namespace pcl::sedr;

constexpr double farthest = 0.11; // metres off the face

/** A face scanned every 5 mm, and what stands before and behind it. */
class ScannedFace {
public:
  explicit ScannedFace(double noise)
      : noise_(0, noise)
  {}

  /** Adds a face parallel to y and z, `off` metres beside the one looked at. */
  void face(double width, double height, double off = 0)
  {
    for (double x = 0; x < width; x += spacing)
      for (double z = 0; z < height; z += spacing)
        add({x, z, off + noise_(random_)}, off == 0);
  }

  /** Adds a panel square to the face, in front of it. */
  void panel(double x, double height)
  {
    for (double off = 0; off < farthest; off += spacing)
      for (double z = 0; z < height; z += spacing)
        add({x + noise_(random_), z, -off}, false);
  }

  /** Adds a shelf or a lintel, behind it. */
  void shelf(double width, double z)
  {
    for (double off = 0; off < farthest; off += spacing)
      for (double x = 0; x < width; x += spacing)
        add({x, z + noise_(random_), off}, false);
  }

  /** Returns the share that is dropped of the points of the face, or of the others. */
  double dropped(bool of_face, const Priors& priors = {}) const
  {
    const std::vector<std::uint8_t> are =
        areOnSquareSurfaces(places_, farthest, priors);
    double all = 0;
    double dropped = 0;
    for (std::size_t i = 0; i < are.size(); ++i)
      if (is_face_[i] == of_face) {
        ++all;
        dropped += are[i];
      }
    return dropped / all;
  }

private:
  static constexpr double spacing = 0.005;

  void add(const Eigen::Vector3d& place, bool is_face)
  {
    places_.emplace_back(place.cast<float>());
    is_face_.push_back(is_face);
  }

  std::mt19937 random_{1};
  std::normal_distribution<double> noise_;
  std::vector<FacePlace> places_;
  std::vector<bool> is_face_;
};

TEST(SquareSurfaces, AFaceBetweenPanelsStays)
{
  for (const double noise : {0.002, 0.01})
    for (const double every : {0.9, 0.45}) {
      ScannedFace scan(noise);
      scan.face(4, 1.2);
      for (double x = 0.3; x < 4; x += every)
        scan.panel(x, 0.8);
      EXPECT_LT(scan.dropped(true), noise < 0.01 ? 0.1 : 0.12)
          << noise << " m, every " << every << " m";
      EXPECT_GT(scan.dropped(false), 0.9) << noise << " m, every " << every << " m";
    }
}

TEST(SquareSurfaces, RevealsAroundAPaneDoNotTellWhereItIs)
{
  for (const double noise : {0.002, 0.01}) {
    ScannedFace scan(noise);
    scan.face(1, 1.2);
    scan.panel(0, 1.2);
    scan.panel(1, 1.2);
    EXPECT_GT(scan.dropped(false), 0.9) << noise;
    EXPECT_LT(scan.dropped(true), 0.15) << noise;
    scan.shelf(1, 1.2);
    EXPECT_GT(scan.dropped(false), 0.9) << noise;
  }
}

TEST(SquareSurfaces, ANoisyFaceParallelToItIsNone)
{
  for (const double noise : {0.01, 0.02})
    for (const double off : {0.06, 0.08, 0.12}) {
      ScannedFace scan(noise);
      scan.face(2, 1.2);
      scan.face(2, 1.2, off);
      EXPECT_LT(scan.dropped(true), 0.05) << noise << " m, " << off << " m off";
    }
}

TEST(SquareSurfaces, AFaceAloneStays)
{
  ScannedFace scan(0.02);
  scan.face(2, 1.2);
  EXPECT_LT(scan.dropped(true), 0.001);
}

TEST(SquareSurfaces, WhatStandsBesideAFaceIsAsFarOffAsItsBand)
{
  ScannedFace scan(0.002);
  scan.face(2, 1.2);
  scan.panel(1, 1.2);
  Priors priors;
  EXPECT_GT(scan.dropped(false, priors), 0.9);
  priors.wall_band = 0.2; // beyond what is known
  EXPECT_EQ(scan.dropped(false, priors), 0);
}

} // namespace
