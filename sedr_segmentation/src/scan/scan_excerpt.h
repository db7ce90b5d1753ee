// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>

#include <array>
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

/** @brief Returns every k-th point of a scan, such that they are at most `most`. */
std::vector<Eigen::Vector3f>
excerptOf(const RowSource& scan, std::size_t most, unsigned threads);

/** @brief Moves points to another frame; non-finite ones stay so. O(n).
 * @param threads 0: all processors */
void movePoints(const BuildingFrame& frame,
                const PointView& points,
                unsigned threads,
                Eigen::Vector3f* moved);

/** @brief The rows of a scan in another frame: x, y and z, or all fields, of which the
 * others stay as they are. */
class MovedRows : public RowSource {
public:
  /** @param scan must outlive this object
   * @param threads 0: all processors
   * @param all_fields of a scan whose x, y and z are FLOAT32 */
  MovedRows(const RowSource& scan,
            const BuildingFrame& frame,
            unsigned threads,
            bool all_fields = false);

  const std::vector<pcl::PCLPointField>& fields() const override { return fields_; }
  std::size_t rowSize() const override { return row_size_; }
  std::size_t size() const override { return scan_.size(); }
  std::string problem() const override { return scan_.problem(); }
  void forEachPiece(const std::function<bool(const Piece&)>& see) const override;

private:
  const RowSource& scan_;
  BuildingFrame frame_;
  unsigned threads_;
  std::vector<pcl::PCLPointField> fields_;
  std::size_t row_size_;
  std::array<std::size_t, 3> offsets_{}; ///< of x, y and z
};

} // namespace pcl::sedr
