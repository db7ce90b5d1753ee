// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/row_source.h>
#include <pcl/sedr_segmentation/scan_check.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <string>

namespace pcl {
namespace sedr {

/** @brief Adds every `step`-th point of a scan to an excerpt, those that are not finite
 * too.
 * @param points a piece of the scan
 * @param first number of the first of them in the whole scan */
void addExcerpt(const PointView& points,
                std::size_t first,
                std::size_t step,
                pcl::PointCloud<pcl::PointXYZ>& excerpt);

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
   * cannot be the metre: then it would not get any smaller by thinning. */
  void forEachPiece(const std::function<bool(const Piece&)>& see) const override;

  /** @brief Every k-th point, those that are not finite too. */
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr points() const { return points_; }

private:
  /** @brief What is wrong with the whole scan, looked at without anything else. */
  std::string problemOfAll() const;

  const RowSource& scan_;
  std::size_t step_;
  unsigned threads_;
  mutable std::string problem_;
  mutable pcl::PointCloud<pcl::PointXYZ>::Ptr points_;
};

} // namespace sedr
} // namespace pcl
