// SPDX-License-Identifier: BSD-3-Clause
#include "rows_in_pieces.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_segmentation/src/scan/scan_excerpt.h"

#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace {

using pcl::sedr::addToExcerpt;
using pcl::sedr::parallelBlocks;
using pcl::sedr::PointView;
using pcl::sedr::RowSource;
using pcl::sedr::ScanExcerpt;
using pcl::sedr::ScanSample;
using sedr_test::RowsInPieces;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/** @brief Returns points (k, 0, 0), every 1000th not finite; `last` has the largest
 * float, which makes sums overflow. */
std::vector<Eigen::Vector3f>
countedPoints(std::size_t n, std::size_t last)
{
  std::vector<Eigen::Vector3f> points;
  for (std::size_t k = 0; k < n; ++k)
    points.emplace_back(static_cast<float>(k), k % 1000 == 0 ? nan : 0.f, 0);
  points[last].setConstant(std::numeric_limits<float>::max());
  return points;
}

PointView
part(const std::vector<Eigen::Vector3f>& points, std::size_t begin, std::size_t end)
{
  return {points[begin].data(), sizeof points[0], end - begin};
}

TEST(Excerpt, HasEveryKthPointWhateverThePiecesAndThreads)
{
  // Pieces of several blocks per thread, and some shorter than a step.
  const std::vector<Eigen::Vector3f> points = countedPoints(300000, 299999);
  const std::vector<std::size_t> cuts{0, 3, 200001, 200002, 300000};
  for (const std::size_t step : {std::size_t{1}, std::size_t{7}})
    for (const unsigned threads : {1u, 4u}) {
      std::vector<Eigen::Vector3f> excerpt;
      ScanSample sample(points.size());
      for (std::size_t c = 0; c + 1 < cuts.size(); ++c)
        addToExcerpt(part(points, cuts[c], cuts[c + 1]), cuts[c], step, sample, excerpt,
                     [&](const RowSource::SeeRun& see_run) {
                       parallelBlocks(cuts[c + 1] - cuts[c], 50000, threads, see_run);
                     });
      EXPECT_EQ(sample.finite(), 299700u);
      ASSERT_EQ(excerpt.size(), (points.size() - 1) / step + 1);
      for (std::size_t k = 0; k < excerpt.size(); ++k) {
        ASSERT_EQ(excerpt[k].x(), points[k * step].x()) << "step " << step;
        ASSERT_EQ(std::isnan(excerpt[k].y()), std::isnan(points[k * step].y()));
      }
    }
}

/** @brief A lattice of points in 4 x 3 x 2.5 m. */
pcl::PointCloud<pcl::PointXYZ>
latticeRoom()
{
  pcl::PointCloud<pcl::PointXYZ> room;
  for (int k = 0; k < 50000; ++k)
    room.push_back({0.1F * static_cast<float>(k % 41),
                    0.1F * static_cast<float>(k % 31),
                    0.1F * static_cast<float>(k % 26)});
  return room;
}

TEST(ScanExcerpt, IsTheSameWhetherItIsTakenBesideOrAfterwards)
{
  const auto cloud = latticeRoom();
  const RowsInPieces room(cloud, 7001);
  const auto callBeside = [](const RowSource::Piece& piece) {
    const std::size_t half = piece.size / 2;
    piece.beside(half, piece.size);
    piece.beside(0, half);
    return true;
  };
  const auto doNot = [](const RowSource::Piece&) { return true; };
  for (const std::function<bool(const RowSource::Piece&)>& see :
       {std::function<bool(const RowSource::Piece&)>(callBeside),
        std::function<bool(const RowSource::Piece&)>(doNot)}) {
    const ScanExcerpt excerpt(room, 10000, 2);
    excerpt.forEachPiece(see);
    EXPECT_EQ(excerpt.problem(), "");
    ASSERT_EQ(excerpt.points()->size(), 10000u);
    for (std::size_t k = 0; k < 10000; ++k)
      ASSERT_EQ((*excerpt.points())[k], cloud[5 * k].getVector3fMap()) << k;
  }
}

TEST(ScanExcerpt, OfAPieceAllRowsMustBeShownOrNone)
{
  const RowsInPieces room(latticeRoom(), 7001);
  const ScanExcerpt excerpt(room, 10000, 2);
  const auto showMost = [](const RowSource::Piece& piece) {
    piece.beside(0, piece.size - 1);
    return true;
  };
  EXPECT_THROW(excerpt.forEachPiece(showMost), std::logic_error);
}

TEST(ScanExcerpt, GoesNoFartherThanItIsAskedTo)
{
  const RowsInPieces room(latticeRoom(), 7001);
  const ScanExcerpt excerpt(room, 10000, 2);
  std::size_t pieces = 0;
  excerpt.forEachPiece([&](const RowSource::Piece&) { return ++pieces < 3; });
  EXPECT_EQ(pieces, 3u);
}

TEST(ScanSample, CountsThePointsThatAreFinite)
{
  std::vector<Eigen::Vector3f> points = countedPoints(70000, 1);
  ScanSample sample(points.size());
  sample.add(part(points, 0, points.size()), 2);
  EXPECT_EQ(sample.finite(), 69930u);
  points[69999].z() = -std::numeric_limits<float>::infinity();
  ScanSample again(points.size());
  again.add(part(points, 0, points.size()), 2);
  EXPECT_EQ(again.finite(), 69929u);
}

} // namespace
