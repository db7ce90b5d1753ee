// SPDX-License-Identifier: BSD-3-Clause
#include "part_of_scan.h"

#include "sedr_segmentation/src/scan/scan_excerpt.h"

namespace pcl::sedr::tools {

PartOfScan::PartOfScan(const ThinOrder& order, unsigned threads)
    : order_(order)
    , threads_(threads)
{}

void
PartOfScan::forEachPiece(
    const std::function<bool(const PointView&, std::size_t first)>& see) const
{
  bool goes_on = true;
  for (const RowRange& range : order_.ranges) {
    const ScanFile file(range.path, order_.settings);
    RowCoordinates coordinates(file.fields(), file.rowSize());
    if (goes_on)
      file.forEachPiece(range.begin, range.end, [&](const RowSource::Piece& piece) {
        goes_on = see(coordinates.of(piece.rows, piece.size, threads_),
                      range.first + piece.first - range.begin);
        return goes_on;
      });
  }
}

void
PartOfScan::thin(bool stops_early)
{
  const std::size_t begin = order_.ranges.empty() ? 0 : order_.ranges.front().first;
  ScanSample sample(order_.rows, begin);
  sums_ = std::make_unique<VoxelSums>(order_.inverse_leaf.array());
  excerpt_.clear();
  has_stopped_ = false;
  std::size_t looked_at = 0;
  forEachPiece([&](const PointView& points, std::size_t first) {
    addToExcerpt(points, first, order_.excerpt_step, sample, excerpt_,
                 [&](const RowSource::SeeRun& see_run) {
                   sums_->add(points, threads_, see_run);
                 });
    // Checked whenever the number of points has doubled, which costs almost nothing.
    const std::size_t seen = first + points.size() - begin;
    if (stops_early && seen >= 2 * looked_at) {
      looked_at = seen;
      has_stopped_ = sample.isTooLarge();
    }
    return !has_stopped_;
  });
  finite_ = sample.finite() - begin;
  sample_ = sample.points();
  if (has_stopped_)
    sums_.reset();
}

void
PartOfScan::count()
{
  ScanSample sample(order_.rows);
  forEachPiece([&](const PointView& points, std::size_t) {
    sample.add(points, threads_);
    return true;
  });
  finite_ = sample.finite();
}

std::vector<Eigen::Vector3f>
PartOfScan::sampleAfter(std::size_t finite_before) const
{
  ScanSample sample(order_.rows, finite_before);
  forEachPiece([&](const PointView& points, std::size_t) {
    sample.add(points, threads_);
    return true;
  });
  return sample.points();
}

std::vector<VoxelSum>
PartOfScan::takeVoxels()
{
  std::vector<VoxelSum> voxels = sums_->take(threads_);
  sums_.reset();
  return voxels;
}

} // namespace pcl::sedr::tools
