// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/stage_filter.h>

#include <cstdint>
#include <map>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief An upright surface after hole repair, unrolled: columns of cells along its
 * element, each from its lower to its upper end. */
struct RepairedStrip {
  /** @brief A column of equal cells. */
  struct Column {
    double low = 0;        ///< z, metres
    double high = 0;       ///< not above low where the column has no cells
    std::size_t first = 0; ///< its lowest cell, an index into the repaired points
    std::size_t cells = 0;
  };

  std::uint32_t room = 0;
  UprightKind kind = UprightKind::Wall;
  StructureLabel label = StructureLabel::Wall; ///< Wall, Column or Detail
  PlanElement element;
  std::vector<Column> columns; ///< of equal widths
};

/** @brief How much of a room no scanned point supports, at the density that the scan
 * has there: an empty cell counts only if it is farther from all points of its surface
 * than these are from one another. */
struct UnseenShares {
  double surface = 0; ///< of the cells of all its surfaces
  double walls = 0;   ///< of the length of its walls: less than a fifth of the height
};

} // namespace sedr

/** @brief Fills the holes of a refined structure (paper, section 2.4): per cell of a
 * wall, the empty cells in z between floor and ceiling are filled, so that doors,
 * windows and what furniture hid are closed; likewise the faces of columns, the risers
 * of details, floor and ceilings. Frame: z up, metres.
 *
 * The input is what StructureRefinement gives: points on the surfaces of the plan. The
 * output has one point for every cell of every surface: the scanned point nearest to
 * the cell's middle, or a new one there, so that it covers the structure evenly and
 * wholly. Normals, labels and rooms are set where the point type has them; other fields
 * of new points are zero. Non-finite points and points on no surface are removed. O(n e
 * + c) for n points, e elements and c cells.
 *
 * No input, no plan, a grid size that is not above 0 or so small that the plan would
 * have more than 200 million cells, an index beyond the cloud, labels or
 * rooms of another number than the points: PCL_ERROR, an empty output, all indices
 * removed, and getErrorMessage() says why.
 * @code
 * pcl::VerticalHoleRepair<pcl::PointStructure> repair;
 * repair.setInputCloud(refined);
 * repair.setFloorplan(plan);
 * repair.filter(*whole);
 * @endcode */
template <typename PointT>
class VerticalHoleRepair : public sedr::PlanFilter<PointT> {
public:
  using Ptr = shared_ptr<VerticalHoleRepair<PointT>>;
  using ConstPtr = shared_ptr<const VerticalHoleRepair<PointT>>;
  using PointCloud = typename Filter<PointT>::PointCloud;

  /** @param extract_removed_indices whether getRemovedIndices() is filled: with the
   * points that are in no cell, and those that share their cell with one nearer to its
   * middle */
  explicit VerticalHoleRepair(bool extract_removed_indices = false)
      : sedr::PlanFilter<PointT>(extract_removed_indices)
  {
    this->filter_name_ = "VerticalHoleRepair";
  }

  /** @brief Edge of a cell, metres, > 0. Default 0.05. */
  void setGridSize(double size) { grid_size_ = size; }
  double getGridSize() const { return grid_size_; }

  /** @brief Indices in the output of the points that fill holes, increasing: what was
   * not seen. */
  const Indices& getRepairedIndices() const { return repaired_; }

  /** @brief What the scan does not support, at its own density, of each room by its id:
   * less than was filled where the scan is sparser than the cells. */
  const std::map<std::uint32_t, sedr::UnseenShares>& getUnseenShares() const
  {
    return unseen_;
  }

  /** @brief Where the cells of walls, columns and risers are in the output of the last
   * run: with getSourceIndices(), which part of which wall was seen. */
  const std::vector<sedr::RepairedStrip>& getStrips() const { return strips_; }

protected:
  void applyFilter(PointCloud& output) override;

  void clearResults() override;

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using sedr::PlanFilter<PointT>::plan_;
  using sedr::PlanFilter<PointT>::sources_;
  using sedr::PlanFilter<PointT>::surface_points_;
  using sedr::PlanFilter<PointT>::fail;

  /** @brief Checks all that was set, and fills labels and rooms where none were. */
  bool validate(std::vector<std::uint32_t>& labels, std::vector<std::uint32_t>& rooms);

  double grid_size_ = 0.05;
  Indices repaired_;
  std::vector<sedr::RepairedStrip> strips_;
  std::map<std::uint32_t, sedr::UnseenShares> unseen_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_filters/impl/vertical_hole_repair.hpp>
#endif
