// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_parts.h"

#include "sedr_filters/src/voxels/voxel_sums.h"
#include "sedr_segmentation/src/scan/scan_check.h"
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What a rank is to thin. */
struct ThinOrder {
  std::vector<RowRange> ranges; ///< in the order of the scan
  std::size_t rows = 0;         ///< of the whole scan
  std::size_t excerpt_step = 1; ///< every so many rows are kept as they are
  ScanSettings settings;        ///< how its files are read
  Eigen::Vector3f inverse_leaf = Eigen::Vector3f::Ones(); ///< per metre
  bool removes_strays = false; ///< see ParallelVoxelGrid::setRemoveStrays()
};

/** @brief A part of a scan, and what is made of it in one pass. */
class PartOfScan {
public:
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;

  PartOfScan(const ThinOrder& order, unsigned threads);

  /** @brief Adds up its voxels and keeps its excerpt.
   * @param stops_early whether it gives up when the part seems so large that the metre
   * cannot be the unit, and would not get any smaller; then there are no voxels */
  void thin(bool stops_early);

  bool hasStopped() const { return has_stopped_; }

  /** @brief Counts its finite points; thin() does so too, unless it stops. */
  void count();

  std::size_t finite() const { return finite_; }

  /** @brief The points of a ScanSample of the whole scan that lie in this part, when so
   * many finite points of the scan come before. */
  std::vector<Eigen::Vector3f> sampleAfter(std::size_t finite_before) const;

  /** @brief The same from the last pass, for a scan in which every row before this part
   * is finite. */
  const std::vector<Eigen::Vector3f>& sample() const { return sample_; }

  /** @brief The sorted voxels; they are gone then. */
  std::vector<VoxelSum> takeVoxels();

  const std::vector<Eigen::Vector3f>& excerpt() const { return excerpt_; }

private:
  void forEachPiece(
      const std::function<bool(const PointView&, std::size_t first)>& see) const;

  ThinOrder order_;
  unsigned threads_;
  std::size_t finite_ = 0;
  bool has_stopped_ = false;
  std::vector<Eigen::Vector3f> sample_;
  std::unique_ptr<VoxelSums> sums_;
  std::vector<Eigen::Vector3f> excerpt_;
};

} // namespace tools
} // namespace sedr
} // namespace pcl
