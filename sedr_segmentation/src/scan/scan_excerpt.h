// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>

#include <cstddef>
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

/** @brief Appends every `step`-th of the next points of a scan to an excerpt, including
 * non-finite ones.
 * @param first index of the first point in the whole scan */
void addToExcerpt(const PointView& points,
                  std::size_t first,
                  std::size_t step,
                  std::vector<Eigen::Vector3f>& excerpt);

/** @brief Moves points to another frame; non-finite ones stay so. O(n).
 * @param threads 0: all processors */
void movePoints(const BuildingFrame& frame,
                const PointView& points,
                unsigned threads,
                Eigen::Vector3f* moved);

/** @brief The coordinates of a scan in another frame. */
class MovedRows : public RowSource {
public:
  /** @param scan must outlive this object
   * @param threads 0: all processors */
  MovedRows(const RowSource& scan, const BuildingFrame& frame, unsigned threads);

  const std::vector<pcl::PCLPointField>& fields() const override { return fields_; }
  std::size_t rowSize() const override { return sizeof(Eigen::Vector3f); }
  std::size_t size() const override { return scan_.size(); }
  std::string problem() const override { return scan_.problem(); }
  void forEachPiece(const std::function<bool(const Piece&)>& see) const override;

private:
  const RowSource& scan_;
  BuildingFrame frame_;
  unsigned threads_;
  std::vector<pcl::PCLPointField> fields_;
};

} // namespace pcl::sedr
