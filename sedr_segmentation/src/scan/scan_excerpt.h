// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_check.h"
#include <pcl/sedr_filters/row_source.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Takes the next points of a scan while `read` goes through them: adds them to
 * a sample of it, and every `step`-th, those that are not finite too, to an excerpt.
 * @param first number of the first of them in the whole scan */
void addToExcerpt(const PointView& points,
                  std::size_t first,
                  std::size_t step,
                  ScanSample& sample,
                  std::vector<Eigen::Vector3f>& excerpt,
                  const ScanSample::Read& read);

/** @brief A scan that is gone through once, and what is noted of it on the way: whether
 * it may be one of rooms in metres, and every k-th of its points. */
class ScanExcerpt : public RowSource {
public:
  /** @param scan must outlive this
   * @param most_points how many points are kept, see rawStep()
   * @param threads 0: as many as there are processors */
  ScanExcerpt(const RowSource& scan, std::size_t most_points, unsigned threads);

  const std::vector<pcl::PCLPointField>& fields() const override
  {
    return scan_.fields();
  }
  std::size_t rowSize() const override { return scan_.rowSize(); }
  std::size_t size() const override { return scan_.size(); }
  std::string problem() const override { return problem_; }

  /** @brief Goes through the scan, and no farther where it is so large that its unit
   * cannot be the metre: then it would not get any smaller by thinning. What is noted
   * is taken beside what `see` does with a piece, if it calls RowSource::Piece::beside,
   * or after it; std::logic_error if it calls that for a part of the rows. */
  void forEachPiece(const std::function<bool(const Piece&)>& see) const override;

  /** @brief Every k-th point, those that are not finite too. */
  std::shared_ptr<std::vector<Eigen::Vector3f>> points() const { return points_; }

private:
  /** @brief Shows a piece to `see`, and its rows to `see_run` meanwhile. */
  bool show(const Piece& piece,
            const SeeRun& see_run,
            const std::function<bool(const Piece&)>& see) const;

  /** @brief What is wrong with the whole scan, looked at without anything else. */
  std::string problemOfAll() const;

  const RowSource& scan_;
  std::size_t step_;
  unsigned threads_;
  mutable std::string problem_;
  mutable std::shared_ptr<std::vector<Eigen::Vector3f>> points_;
};

} // namespace sedr
} // namespace pcl
