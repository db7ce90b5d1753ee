// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointField.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr {

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

} // namespace pcl::sedr
