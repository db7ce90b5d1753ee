// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/row_source.h>

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

class ThinnedVoxels;
class VoxelSums;

/** @brief What all ParallelVoxelGrid have in common, whatever their points: the
 * parameters of pcl::VoxelGrid, and the layout of the voxels after a run. */
class VoxelGridSettings {
public:
  /** @brief Edges of a voxel, metres; the fourth value is ignored. */
  void setLeafSize(const Eigen::Vector4f& leaf_size)
  {
    leaf_size_ = leaf_size.head<3>();
  }

  /** @brief Edges of a voxel along x, y and z, metres (default 0.05 each). */
  void setLeafSize(float lx, float ly, float lz) { leaf_size_ = {lx, ly, lz}; }

  Eigen::Vector3f getLeafSize() const { return leaf_size_; }

  /** @brief Whether all fields are averaged (default), or x, y and z alone. */
  void setDownsampleAllData(bool downsample) { downsample_all_data_ = downsample; }

  bool getDownsampleAllData() const { return downsample_all_data_; }

  /** @brief Voxels with fewer points give none (default 0). */
  void setMinimumPointsNumberPerVoxel(unsigned int min_points_per_voxel)
  {
    min_points_per_voxel_ = min_points_per_voxel;
  }

  unsigned int getMinimumPointsNumberPerVoxel() const { return min_points_per_voxel_; }

  /** @brief Whether voxels that points scattered in the air explain give none (default
   * false). Only a dense scan tells them from surfaces, see doc/parallel_voxel_grid.md;
   * others keep all. */
  void setRemoveStrays(bool remove_strays) { removes_strays_ = remove_strays; }

  bool getRemoveStrays() const { return removes_strays_; }

  /** @brief Voxels of fewer points were taken for strays in the last run; 0: none. */
  unsigned int getStrayLimit() const { return stray_limit_; }

  /** @brief Whether to keep which voxel became which point (default false): 12 bytes a
   * voxel. */
  void setSaveLeafLayout(bool save_leaf_layout)
  {
    save_leaf_layout_ = save_leaf_layout;
  }

  bool getSaveLeafLayout() const { return save_leaf_layout_; }

  /** @brief Uses only points whose field `field_name` lies within the limits; empty:
   * all. */
  void setFilterFieldName(const std::string& field_name)
  {
    filter_field_name_ = field_name;
  }

  const std::string& getFilterFieldName() const { return filter_field_name_; }

  /** @brief The limits, both included; a value of NaN lies neither inside nor outside.
   */
  void setFilterLimits(double limit_min, double limit_max)
  {
    filter_limit_min_ = limit_min;
    filter_limit_max_ = limit_max;
  }

  void getFilterLimits(double& limit_min, double& limit_max) const
  {
    limit_min = filter_limit_min_;
    limit_max = filter_limit_max_;
  }

  /** @brief Whether to use the points outside the limits instead (default false). */
  void setFilterLimitsNegative(bool limit_negative)
  {
    filter_limit_negative_ = limit_negative;
  }

  bool getFilterLimitsNegative() const { return filter_limit_negative_; }

  /** @brief Threads to use, 0 = all processors (default). The result is the same, byte
   * for byte. */
  void setNumberOfThreads(unsigned int threads) { threads_ = threads; }

  unsigned int getNumberOfThreads() const { return threads_; }

  /** @brief Smallest voxel coordinates of the last run; saturated where an int is too
   * small. */
  Eigen::Vector3i getMinBoxCoordinates() const { return min_box_; }

  /** @brief Largest voxel coordinates of the last run; saturated where an int is too
   * small. */
  Eigen::Vector3i getMaxBoxCoordinates() const { return max_box_; }

  /** @brief Voxels along x, y and z of the box; saturated where an int is too small. */
  Eigen::Vector3i getNrDivisions() const;

  /** @brief (1, nx, nx ny) for nx by ny by nz voxels; saturated where an int is too
   * small. */
  Eigen::Vector3i getDivisionMultiplier() const;

  /** @brief Voxel of a finite position (metres); saturated where an int is too small.
   */
  Eigen::Vector3i getGridCoordinates(float x, float y, float z) const;

  /** @brief Index of the point that came of voxel `ijk`; -1 if the voxel is empty,
   * outside, or the layout was not saved. O(log n). */
  int getCentroidIndexAt(const Eigen::Vector3i& ijk) const;

  /** @brief The layout as pcl::VoxelGrid gives it: entry (i - min_x) + (j - min_y) nx +
   * (k - min_z) nx ny holds the index of the point of voxel (i, j, k), -1 if it is
   * empty. Made when asked for; empty, with a PCL_ERROR, where it would hold more than
   * 2^27 entries. */
  std::vector<int> getLeafLayout() const;

protected:
  VoxelGridSettings() = default;
  ~VoxelGridSettings() = default;

  /** @brief What is wrong with the parameters, a sentence; empty if nothing is. */
  std::string parameterProblem() const;

  Eigen::Array3f inverseLeaf() const
  {
    return Eigen::Array3f::Ones() / leaf_size_.array();
  }

  bool passesLimits(double value) const
  {
    if (filter_limit_negative_)
      return value <= filter_limit_min_ || value >= filter_limit_max_;
    return value >= filter_limit_min_ && value <= filter_limit_max_;
  }

  /** @brief The same of the field of a point at `where`, a number of type `datatype`
   * (PCLPointField). */
  bool passesLimits(const std::uint8_t* where, std::uint8_t datatype) const;

  /** @brief Forgets what the last run left. */
  void clearLayout();

  /** @brief What keeps rows from being thinned, a sentence; empty if nothing does. */
  std::string rowsProblem(const RowSource& source) const;

  /** @brief Calls `see(piece, points, indices)` for every piece of a source without a
   * problem: its coordinates, and which of them count, null for all. `indices` choose
   * among the rows of a single piece, null: all. */
  void forEachPiece(const RowSource& source,
                    const pcl::Indices* indices,
                    const std::function<void(const RowSource::Piece&,
                                             const PointView&,
                                             const pcl::Indices*)>& see) const;

  /** @brief Adds up the points that count. */
  void
  addRows(const RowSource& source, const pcl::Indices* indices, VoxelSums& sums) const;

  /** @brief Thins `points[indices]`, null: all; keeps the box, and the layout if asked
   * for. */
  ThinnedVoxels thin(const PointView& points, const pcl::Indices* indices);

  /** @brief Thins all rows of a source without a problem. */
  ThinnedVoxels thin(const RowSource& source);

  /** @brief Sorts the voxels of all points that were added up, and leaves out those
   * that hold too few; keeps the box, and the layout if asked for.
   * @return how many are left */
  std::size_t finish(VoxelSums& sums);

private:
  Eigen::Vector3f leaf_size_ = Eigen::Vector3f::Constant(0.05f);
  bool downsample_all_data_ = true;
  bool save_leaf_layout_ = false;
  unsigned int min_points_per_voxel_ = 0;
  bool removes_strays_ = false;
  unsigned int threads_ = 0;
  std::string filter_field_name_;
  double filter_limit_min_ = std::numeric_limits<float>::lowest();
  double filter_limit_max_ = std::numeric_limits<float>::max();
  bool filter_limit_negative_ = false;

  unsigned int stray_limit_ = 0;
  Eigen::Vector3i min_box_ = Eigen::Vector3i::Zero();
  Eigen::Vector3i max_box_ = Eigen::Vector3i::Zero();
  std::vector<Eigen::Vector3i> layout_; ///< voxel of each output point, in their order
};

} // namespace sedr
} // namespace pcl
