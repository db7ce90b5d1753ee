// SPDX-License-Identifier: BSD-3-Clause
#include "scan_excerpt.h"
#include "sedr_filters/src/base/parallel.h"

#include <atomic>
#include <stdexcept>

namespace pcl::sedr {

void
addToExcerpt(const PointView& points,
             std::size_t first,
             std::size_t step,
             ScanSample& sample,
             std::vector<Eigen::Vector3f>& excerpt,
             const ScanSample::Read& read)
{
  const auto upTo = [&](std::size_t end) { return (first + end + step - 1) / step; };
  const std::size_t before = excerpt.size();
  excerpt.resize(before + upTo(points.size()) - upTo(0));
  sample.add(points, [&](const RowSource::SeeRun& count) {
    read([&](std::size_t begin, std::size_t end) {
      count(begin, end);
      for (std::size_t k = upTo(begin); k < upTo(end); ++k)
        excerpt[before + k - upTo(0)] = points[k * step - first];
    });
  });
}

ScanExcerpt::ScanExcerpt(const RowSource& scan,
                         std::size_t max_points,
                         unsigned threads)
    : scan_(scan)
    , step_(rawStep(scan.size(), max_points))
    , threads_(threads)
    , points_(new std::vector<Eigen::Vector3f>)
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
    bool goes_on = true;
    addToExcerpt(points, piece.first, step_, sample, *points_,
                 [&](const SeeRun& see_run) { goes_on = show(piece, see_run, see); });
    // Checked whenever the amount read has doubled, so the cost is negligible.
    const std::size_t seen = piece.first + piece.size;
    if (seen >= 2 * looked_at && seen < scan_.size()) {
      looked_at = seen;
      if (sample.isTooLarge())
        problem_ = problemOfAll();
    }
    return problem_.empty() && goes_on;
  });
  if (problem_.empty())
    problem_ = sample.problem();
}

bool
ScanExcerpt::show(const Piece& piece,
                  const SeeRun& see_run,
                  const std::function<bool(const Piece&)>& see) const
{
  constexpr std::size_t rows_at_once = std::size_t{1} << 16;
  std::atomic<std::size_t> seen{0};
  Piece shown = piece;
  shown.beside = [&](std::size_t begin, std::size_t end) {
    seen += end - begin;
    see_run(begin, end);
  };
  const bool goes_on = see(shown);
  if (seen == 0)
    parallelBlocks(piece.size, rows_at_once, threads_, see_run);
  else if (seen != piece.size)
    throw std::logic_error("of " + std::to_string(piece.size) + " rows of a piece " +
                           std::to_string(seen) + " were shown: all or none must be");
  return goes_on;
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

} // namespace pcl::sedr
