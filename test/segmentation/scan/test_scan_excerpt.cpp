// SPDX-License-Identifier: BSD-3-Clause
#include "rows_in_pieces.h"
#include "sedr_filters/src/base/field_access.h"
#include "sedr_segmentation/src/scan/scan_excerpt.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <pcl/point_types.h>

#include <cmath>
#include <vector>

namespace {

using namespace pcl::sedr;

/** @brief Returns points (k, 0, 0), every 1000th not finite. */
std::vector<Eigen::Vector3f>
countedPoints(std::size_t n)
{
  std::vector<Eigen::Vector3f> points;
  for (std::size_t k = 0; k < n; ++k)
    points.emplace_back(static_cast<float>(k), k % 1000 == 0 ? std::nanf("") : 0.f, 0);
  return points;
}

PointView
part(const std::vector<Eigen::Vector3f>& points, std::size_t begin, std::size_t end)
{
  return {points[begin].data(), sizeof points[0], end - begin};
}

TEST(Excerpt, HasEveryKthPointWhateverThePieces)
{
  const std::vector<Eigen::Vector3f> points = countedPoints(3000);
  const std::vector<std::size_t> cuts{0, 3, 2001, 2002, 3000}; // some below a step
  for (const std::size_t step : {std::size_t{1}, std::size_t{7}}) {
    std::vector<Eigen::Vector3f> excerpt;
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c)
      addToExcerpt(part(points, cuts[c], cuts[c + 1]), cuts[c], step, excerpt);
    ASSERT_EQ(excerpt.size(), (points.size() - 1) / step + 1);
    for (std::size_t k = 0; k < excerpt.size(); ++k) {
      ASSERT_EQ(excerpt[k].x(), points[k * step].x()) << "step " << step;
      ASSERT_EQ(std::isnan(excerpt[k].y()), std::isnan(points[k * step].y()));
    }
  }
}

TEST(MovedRows, AreTheRowsOfTheScanInTheOtherFrame)
{
  pcl::PointCloud<pcl::PointXYZI> cloud;
  for (const Eigen::Vector3f& p : countedPoints(3000)) {
    cloud.emplace_back(p.x(), p.y(), p.z());
    cloud.back().intensity = p.x();
  }
  BuildingFrame frame;
  frame.rotation = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  frame.origin = {1, 2, 3};
  const sedr_test::RowsInPieces scan(cloud, 701);
  for (const bool all_fields : {false, true}) {
    const MovedRows moved(scan, frame, 2, all_fields);
    const auto* const intensity = findField(moved.fields(), "intensity");
    EXPECT_EQ(intensity != nullptr, all_fields);
    const std::vector<Eigen::Vector3f> points = excerptOf(moved, cloud.size(), 2);
    ASSERT_EQ(points.size(), cloud.size());
    for (std::size_t n = 0; n < cloud.size(); ++n) {
      const Eigen::Vector3d p = cloud[n].getVector3fMap().cast<double>();
      EXPECT_EQ(points[n].allFinite(), p.allFinite());
      if (p.allFinite()) {
        EXPECT_LT((frame.toScan(points[n].cast<double>()) - p).norm(), 1e-3);
      }
    }
    moved.forEachPiece([&](const RowSource::Piece& piece) {
      for (std::size_t i = 0; intensity && i < piece.size; ++i)
        EXPECT_EQ(readField(piece.rows + i * moved.rowSize() + intensity->offset,
                            intensity->datatype),
                  static_cast<double>(piece.first + i));
      return true;
    });
  }
}

} // namespace
