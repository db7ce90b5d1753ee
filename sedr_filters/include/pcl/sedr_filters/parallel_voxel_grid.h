// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/filters/filter.h>
#include <pcl/sedr_filters/row_source.h>
#include <pcl/sedr_filters/stage_filter.h>
#include <pcl/sedr_filters/voxel_grid_settings.h>

#include <vector>

namespace pcl {

/** @brief Thins a cloud to the mean of the points of each voxel (paper, section 2.2): a
 * drop-in for pcl::VoxelGrid that uses all processors and works at any extent.
 *
 * Voxels, means and the order of the output are those of pcl::VoxelGrid: voxel
 * floor(coordinate / leaf), sorted by z, then y, then x. x, y and z are summed exactly,
 * as whole steps of 2^-30 leaves (see doc/parallel_voxel_grid.md), so that neither the
 * order of the points nor the number of threads matters; up to 2^31 points a voxel
 * cannot overflow them. The means are right to the last digit of a float, but for 2^-30
 * leaves beside 0. The other fields are averaged as pcl::CentroidPoint does (colours by
 * channel, normals made unit length, labels and rooms by majority), or left at their
 * defaults with setDownsampleAllData(false).
 *
 * An empty cloud, or one of nothing but NaN, gives an empty output. Non-finite points
 * are skipped. A leaf that is not above 0, an unknown filter field or an index beyond
 * the cloud: PCL_ERROR, an empty output, all indices removed, and getErrorMessage()
 * says why. The removed indices are those that took part in no output point:
 * non-finite, outside the limits, or in a voxel with too few points.
 *
 * O(n) for n points, some 50 bytes a voxel beside input and output (up to 350 where
 * each lies far from all others), nothing a point. Where other fields are averaged, a
 * second pass and what pcl::CentroidPoint takes a voxel. The same bytes for any number
 * of threads.
 * @code
 * pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
 * grid.setInputCloud(scan);
 * grid.setLeafSize(0.05f, 0.05f, 0.05f);
 * grid.filter(*thinned);
 * @endcode */
template <typename PointT>
class ParallelVoxelGrid : public sedr::StageFilter<PointT>,
                          public sedr::VoxelGridSettings {
public:
  using Ptr = shared_ptr<ParallelVoxelGrid<PointT>>;
  using ConstPtr = shared_ptr<const ParallelVoxelGrid<PointT>>;
  using PointCloud = typename Filter<PointT>::PointCloud;

  /** @param extract_removed_indices whether getRemovedIndices() is filled */
  explicit ParallelVoxelGrid(bool extract_removed_indices = false)
      : sedr::StageFilter<PointT>(extract_removed_indices)
  {
    filter_name_ = "ParallelVoxelGrid";
  }

  /** @brief Writes one point a voxel to `output`, which may be the input. */
  void filter(PointCloud& output);

  /** @brief The same for a cloud that comes in pieces and need not stand in memory: x,
   * y and z alone, as setDownsampleAllData(false) gives them, the same bytes. No input
   * cloud, indices or removed indices are used. It is gone through once. */
  void filter(const sedr::RowSource& source, PointCloud& output);

  /** @brief Index in the output of the point of the voxel that holds `p`, -1 if there
   * is none or the layout was not saved. */
  int getCentroidIndex(const PointT& p) const
  {
    return getCentroidIndexAt(getGridCoordinates(p.x, p.y, p.z));
  }

  /** @brief Indices in the output of the voxels at `relative_coordinates` (3 x n) from
   * the voxel of `reference_point`, -1 for the empty ones. */
  std::vector<int>
  getNeighborCentroidIndices(const PointT& reference_point,
                             const Eigen::MatrixXi& relative_coordinates) const;

protected:
  using Filter<PointT>::filter_name_;
  using Filter<PointT>::input_;
  using Filter<PointT>::indices_;
  using Filter<PointT>::removed_indices_;
  using sedr::StageFilter<PointT>::fail;

  void applyFilter(PointCloud& output) override;

  void clearResults() override;

private:
  /** @brief Thins `indices` of the input, or (null) all of it.
   * @return false after a failure */
  bool thinCloud(const pcl::Indices* indices, PointCloud& output);

  bool validate(const pcl::Indices* indices);

  /** @brief Writes the means of x, y and z of the voxels that are kept. */
  void writeMeans(const sedr::ThinnedVoxels& voxels, PointCloud& output) const;

  /** @brief Whether the filter field, if there is one, lets a point pass. */
  bool isWithinLimits(std::size_t i) const;

  pcl::Indices indicesWithinLimits(const pcl::Indices* indices) const;

  /** @brief Averages all fields of the points of each voxel. */
  void averageFields(const sedr::ThinnedVoxels& voxels,
                     const pcl::Indices* indices,
                     PointCloud& output) const;

  pcl::PCLPointField limited_field_; ///< of the filter, while there is one
};

/** @brief The same for a cloud of any fields: every field is averaged, integers rounded
 * to the nearest, `rgb` and `rgba` by channel, `label` and `room` by majority, normals
 * made unit length. x, y and z may be FLOAT32 or FLOAT64; voxels are told apart in
 * float. */
template <>
class PCL_EXPORTS ParallelVoxelGrid<pcl::PCLPointCloud2>
    : public Filter<pcl::PCLPointCloud2>,
      public sedr::VoxelGridSettings,
      public sedr::StageError {
public:
  using Ptr = shared_ptr<ParallelVoxelGrid<pcl::PCLPointCloud2>>;
  using ConstPtr = shared_ptr<const ParallelVoxelGrid<pcl::PCLPointCloud2>>;

  explicit ParallelVoxelGrid(bool extract_removed_indices = false)
      : Filter<pcl::PCLPointCloud2>(extract_removed_indices)
  {
    filter_name_ = "ParallelVoxelGrid";
  }

  /** @brief Writes one point a voxel to `output`, which may be the input. */
  void filter(PCLPointCloud2& output);

  /** @brief The same for a cloud that comes in pieces and need not stand in memory: the
   * same bytes. No input cloud, indices or removed indices are used. It is gone through
   * once, or twice where other fields than x, y and z as FLOAT32 are averaged. */
  void filter(const sedr::RowSource& source, PCLPointCloud2& output);

protected:
  void applyFilter(PCLPointCloud2& output) override;

private:
  /** @brief Thins `indices` of the rows of the first piece, or (null) all pieces.
   * @return false after a failure */
  bool thin(const sedr::RowSource& source,
            const pcl::Indices* indices,
            PCLPointCloud2& output);

  /** @brief Writes the means of x, y and z, where they are FLOAT32. */
  void writeMeans(const sedr::VoxelSums& sums, PCLPointCloud2& output) const;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_filters/impl/parallel_voxel_grid.hpp>
#endif
