// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_check.h"
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the step k, at least 1, such that every k-th of `points` gives at
 * most `most` points. The selection needs no further thinning. */
inline std::size_t
rawStep(std::size_t points, std::size_t most)
{
  return most > 0 && points > most ? (points + most - 1) / most : 1;
}

/** @brief Adds the next points of a scan to a sample during the pass `read`, and every
 * `step`-th one, including non-finite ones, to an excerpt.
 * @param first index of the first point in the whole scan */
void addToExcerpt(const PointView& points,
                  std::size_t first,
                  std::size_t step,
                  ScanSample& sample,
                  std::vector<Eigen::Vector3f>& excerpt,
                  const ScanSample::Read& read);

/** @brief A scan that is read once, with a check of its unit and size and an excerpt of
 * every k-th point. */
class ScanExcerpt : public RowSource {
public:
  /** @param scan must outlive this object
   * @param max_points maximum number of points to keep, see rawStep()
   * @param threads 0: all processors */
  ScanExcerpt(const RowSource& scan, std::size_t max_points, unsigned threads);

  const std::vector<pcl::PCLPointField>& fields() const override
  {
    return scan_.fields();
  }
  std::size_t rowSize() const override { return scan_.rowSize(); }
  std::size_t size() const override { return scan_.size(); }
  std::string problem() const override { return problem_; }

  /** @brief Reads the scan; stops if it is too large for the unit to be the metre, as
   * thinning would not reduce it. The points are recorded while `see` processes a
   * piece, if it calls RowSource::Piece::beside, else after it. Throws std::logic_error
   * if `see` calls that for only a part of the rows. */
  void forEachPiece(const std::function<bool(const Piece&)>& see) const override;

  /** @brief Returns every k-th point, including non-finite ones. */
  std::shared_ptr<std::vector<Eigen::Vector3f>> points() const { return points_; }

private:
  /** @brief Passes a piece to `see` and its rows to `see_run`. */
  bool show(const Piece& piece,
            const SeeRun& see_run,
            const std::function<bool(const Piece&)>& see) const;

  /** @brief Checks the whole scan in a separate pass; returns its problem. */
  std::string problemOfAll() const;

  const RowSource& scan_;
  std::size_t step_;
  unsigned threads_;
  mutable std::string problem_;
  mutable std::shared_ptr<std::vector<Eigen::Vector3f>> points_;
};

} // namespace pcl::sedr
