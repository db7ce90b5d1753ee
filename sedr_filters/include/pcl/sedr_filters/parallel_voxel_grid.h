// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PCLPointField.h>
#include <pcl/sedr_filters/impl/stage_filter.hpp>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Common part of all ParallelVoxelGrid classes: the parameters of
 * pcl::VoxelGrid. */
class VoxelGridSettings {
public:
  /** @brief Sets the edges of a voxel, metres; the fourth value is ignored. */
  void setLeafSize(const Eigen::Vector4f& leaf_size)
  {
    leaf_size_ = leaf_size.head<3>();
  }

  /** @brief Sets the edges of a voxel along x, y and z, metres (default 0.05 each). */
  void setLeafSize(float lx, float ly, float lz) { leaf_size_ = {lx, ly, lz}; }
  Eigen::Vector3f getLeafSize() const { return leaf_size_; }

  /** @brief Sets whether all fields are averaged (default), or only x, y and z. */
  void setDownsampleAllData(bool downsample) { downsample_all_data_ = downsample; }

  /** @brief Sets the minimum number of points of an output voxel (default 0). */
  void setMinimumPointsNumberPerVoxel(unsigned int min_points_per_voxel)
  {
    min_points_per_voxel_ = min_points_per_voxel;
  }
  unsigned int getMinimumPointsNumberPerVoxel() const { return min_points_per_voxel_; }

  /** @brief Sets whether voxels explained by points scattered in the air are dropped
   * (default false), see doc/parallel_voxel_grid.md. */
  void setRemoveStrays(bool remove_strays) { removes_strays_ = remove_strays; }
  bool getRemoveStrays() const { return removes_strays_; }

  /** @brief Returns the number of points that were dropped as strays. */
  std::size_t getStrayPoints() const { return strays_; }

  /** @brief Sets the number of threads, 0 for all processors (default). The result is
   * identical byte for byte. */
  void setNumberOfThreads(unsigned int threads) { threads_ = threads; }
  unsigned int getNumberOfThreads() const { return threads_; }

protected:
  /** @brief Where thin() writes its points. */
  struct ThinnedRows {
    const std::vector<pcl::PCLPointField>& fields;
    std::size_t row_size;
    std::function<std::uint8_t*(std::size_t rows)> make; ///< returns so many rows
    bool only_places = false; ///< the rows have other fields than those of the source
  };

  VoxelGridSettings() = default;
  ~VoxelGridSettings() = default;

  /** @brief Thins the rows of a source.
   * @param indices the rows to use, of a source of one piece; null: all
   * @param[out] removed the rows used that lie in no voxel kept; may be null
   * @return why they cannot be thinned, as a sentence; empty if they are */
  std::string thin(const RowSource& source,
                   const pcl::Indices* indices,
                   const ThinnedRows& output,
                   pcl::Indices* removed = nullptr);

  std::size_t strays_ = 0; ///< of the last run

private:
  Eigen::Array3f inverseLeaf() const
  {
    return Eigen::Array3f::Ones() / leaf_size_.array();
  }

  std::string problemOf(const RowSource& source, const pcl::Indices* indices) const;

  Eigen::Vector3f leaf_size_ = Eigen::Vector3f::Constant(0.05f);
  bool downsample_all_data_ = true;
  unsigned int min_points_per_voxel_ = 0;
  bool removes_strays_ = false;
  unsigned int threads_ = 0;
};

} // namespace sedr

/** @brief Thins a cloud to the mean of the points of each voxel (paper, section 2.2).
 * Replaces pcl::VoxelGrid; uses all processors and works at any extent.
 *
 * Voxels, means and output order are those of pcl::VoxelGrid: voxel floor(coordinate /
 * leaf), sorted by z, then y, then x. x, y and z are summed exactly, as integer
 * multiples of 2^-30 leaves (see doc/parallel_voxel_grid.md). So the result depends
 * neither on the order of the points nor on the number of threads, and up to 2^31
 * points a voxel cannot overflow. The means are exact to the last digit of a float,
 * except for an error of 2^-30 leaves near 0. The other fields are averaged as
 * pcl::CentroidPoint does (colours by channel, normals made unit length, labels,
 * rooms and owners by majority; fields of own point types, too), or left at their
 * defaults with setDownsampleAllData(false).
 *
 * An empty cloud, or one with only NaN points, gives an empty output. Points that are
 * not finite, or 2^30 leaves from 0 and farther (53,000 km at 5 cm), are skipped. A run
 * fails with a leaf that is not above 0 or an index beyond the cloud. Then PCL_ERROR is
 * printed, the output is empty, all indices are removed, and getErrorMessage() gives
 * the reason. Otherwise the removed indices are the points that are non-finite or in a
 * voxel with too few points.
 *
 * Time O(n) for n points. Memory beside input and output: about 70 bytes a voxel at any
 * extent. Averaging other fields takes a second pass and 8 bytes a value and voxel. */
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

  /** @brief Thins a cloud that is read in pieces and need not fit in memory. Gives only
   * x, y and z, byte for byte as with setDownsampleAllData(false). Ignores input cloud,
   * indices and removed indices. Reads the source once. */
  void filter(const sedr::RowSource& source, PointCloud& output);

protected:
  using Filter<PointT>::filter_name_;
  using Filter<PointT>::input_;
  using Filter<PointT>::indices_;
  using Filter<PointT>::removed_indices_;
  using sedr::StageFilter<PointT>::fail;

  void applyFilter(PointCloud& output) override;

  void clearResults() override;

private:
  bool thinInto(PointCloud& output,
                const sedr::RowSource& source,
                const pcl::Indices* indices,
                bool only_places);
};

/** @brief ParallelVoxelGrid for clouds with any fields. Every field is averaged:
 * integers are rounded to the nearest, `rgb` and `rgba` averaged by channel, `label`,
 * `room` and `owner` decided by majority, normals made unit length. x, y and z may be
 * FLOAT32 or FLOAT64; the voxel of a point is computed in float. */
template <>
class PCL_EXPORTS ParallelVoxelGrid<pcl::PCLPointCloud2>
    : public sedr::VoxelGridSettings, public sedr::StageError {
public:
  /** @brief Thins a cloud that is read in pieces and need not fit in memory. Reads the
   * source once, or twice if fields other than FLOAT32 x, y and z are averaged. */
  void filter(const sedr::RowSource& source, PCLPointCloud2& output);
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_filters/impl/parallel_voxel_grid.hpp>
#endif
