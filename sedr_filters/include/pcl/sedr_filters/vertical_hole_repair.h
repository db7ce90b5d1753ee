// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/impl/stage_filter.hpp>

namespace pcl {
/** @brief Fills the holes of a refined structure (paper, section 2.4). For each cell
 * along a wall, the empty cells between floor and ceiling are filled, which closes
 * doors, windows and parts hidden by furniture. The faces of columns, the risers of
 * details, floors and ceilings are filled likewise. Frame: z up, metres.
 *
 * The input is the output of StructureRefinement: points on the surfaces of the plan.
 * The output has one point for every cell of every surface: the scanned point nearest
 * to the cell's centre, or a new point there. So it covers the whole structure evenly.
 * Normals, labels and rooms are set where the point type has them; other fields of new
 * points are zero. Non-finite points and points on no surface are removed. O(n e + c)
 * for n points, e elements and c cells.
 *
 * A run fails without input or plan, with an index beyond the cloud, or if labels or
 * rooms differ in number from the points. It also fails if the grid size is not above 0
 * or would give more than 200 million cells. Then PCL_ERROR is printed, the output is
 * empty, all indices are removed, and getErrorMessage() gives the reason. */
template <typename PointT>
class VerticalHoleRepair : public sedr::PlanFilter<PointT> {
public:
  using Ptr = shared_ptr<VerticalHoleRepair<PointT>>;
  using ConstPtr = shared_ptr<const VerticalHoleRepair<PointT>>;
  using PointCloud = typename Filter<PointT>::PointCloud;

  /** @param extract_removed_indices whether getRemovedIndices() is filled: with points
   * in no cell, and points that share their cell with one nearer to its centre */
  explicit VerticalHoleRepair(bool extract_removed_indices = false)
      : sedr::PlanFilter<PointT>(extract_removed_indices)
  {
    this->filter_name_ = "VerticalHoleRepair";
  }

  /** @brief Sets the edge of a cell, metres, > 0. Default 0.05. */
  void setGridSize(double size) { grid_size_ = size; }
  double getGridSize() const { return grid_size_; }

  /** @brief Sets whether the openings of the plan stay open: their empty cells are not
   * filled. Default false, as in the paper. */
  void setKeepOpenings(bool keep) { keep_openings_ = keep; }
  bool getKeepOpenings() const { return keep_openings_; }

  /** @brief Returns the output indices of the points that fill holes, increasing. */
  const Indices& getRepairedIndices() const { return repaired_; }

protected:
  void applyFilter(PointCloud& output) override;

  void clearResults() override;

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using sedr::PlanFilter<PointT>::plan_;
  using sedr::PlanFilter<PointT>::sources_;
  using sedr::PlanFilter<PointT>::surface_points_;

  double grid_size_ = 0.05;
  bool keep_openings_ = false;
  Indices repaired_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_filters/impl/vertical_hole_repair.hpp>
#endif
