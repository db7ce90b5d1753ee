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

namespace pcl::sedr::tools {

/** @brief Input of thinning on one rank. */
struct ThinOrder {
  std::vector<RowRange> ranges; ///< in the order of the scan
  std::size_t rows = 0;         ///< of the whole scan
  std::size_t excerpt_step = 1; ///< step of the rows that are also kept unchanged
  ScanSettings settings;        ///< for reading its files
  Eigen::Vector3f inverse_leaf = Eigen::Vector3f::Ones(); ///< per metre
  bool removes_strays = false; ///< see ParallelVoxelGrid::setRemoveStrays()
};

/** @brief A part of a scan, and the results of one pass over it. */
class PartOfScan {
public:
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;

  PartOfScan(const ThinOrder& order, unsigned threads);

  /** @brief Sums its voxels and collects its excerpt.
   * @param stops_early whether to stop, without voxels, if the part seems so large that
   * the unit cannot be the metre and thinning would not reduce it */
  void thin(bool stops_early);

  bool hasStopped() const { return has_stopped_; }

  /** @brief Counts its finite points, as thin() does unless it stops. */
  void count();

  std::size_t finite() const { return finite_; }

  /** @brief Returns the points of a ScanSample of the whole scan within this part,
   * given the number of finite points before it. */
  std::vector<Eigen::Vector3f> sampleAfter(std::size_t finite_before) const;

  /** @brief As above from the last pass, for a scan with only finite rows before this
   * part. */
  const std::vector<Eigen::Vector3f>& sample() const { return sample_; }

  /** @brief Moves out the sorted voxels. */
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

} // namespace pcl::sedr::tools
