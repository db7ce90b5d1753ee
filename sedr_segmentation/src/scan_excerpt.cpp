// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/plan_refit.h>
#include <pcl/sedr_segmentation/scan_excerpt.h>

namespace pcl {
namespace sedr {

void
addExcerpt(const PointView& points,
           std::size_t first,
           std::size_t step,
           pcl::PointCloud<pcl::PointXYZ>& excerpt)
{
  for (std::size_t i = (step - first % step) % step; i < points.size(); i += step) {
    const Eigen::Vector3f p = points[i];
    excerpt.emplace_back(p.x(), p.y(), p.z());
  }
}

ScanExcerpt::ScanExcerpt(const RowSource& scan,
                         std::size_t most_points,
                         unsigned threads)
    : scan_(scan)
    , step_(rawStep(scan.size(), most_points))
    , threads_(threads)
    , points_(new pcl::PointCloud<pcl::PointXYZ>)
{}

void
ScanExcerpt::forEachPiece(const std::function<bool(const Piece&)>& see) const
{
  problem_.clear();
  points_->clear();
  points_->reserve(scan_.size() / step_ + 1);
  ScanSample sample(scan_.size());
  RowCoordinates coordinates(scan_.fields(), scan_.rowSize());
  std::size_t looked_at = 0;
  scan_.forEachPiece([&](const Piece& piece) {
    const PointView points = coordinates.of(piece.rows, piece.size, threads_);
    sample.add(points, threads_);
    addExcerpt(points, piece.first, step_, *points_);
    // Whenever twice as much has been seen, which costs next to nothing.
    const std::size_t seen = piece.first + piece.size;
    if (seen >= 2 * looked_at && seen < scan_.size()) {
      looked_at = seen;
      if (sample.isTooLarge())
        problem_ = problemOfAll();
    }
    return problem_.empty() && see(piece);
  });
  if (problem_.empty())
    problem_ = sample.problem();
}

std::string
ScanExcerpt::problemOfAll() const
{
  ScanSample sample(scan_.size());
  RowCoordinates coordinates(scan_.fields(), scan_.rowSize());
  scan_.forEachPiece([&](const Piece& piece) {
    sample.add(coordinates.of(piece.rows, piece.size, threads_), threads_);
    return true;
  });
  return sample.problem();
}

} // namespace sedr
} // namespace pcl
