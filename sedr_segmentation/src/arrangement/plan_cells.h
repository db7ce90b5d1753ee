// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A straight piece of a curve that parts the plan. */
struct PlanDivider {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  std::uint32_t line = 0; ///< dividers of one line have one number
  double through = 0;     ///< maximum width, metres, of cells beyond its ends that are
                          ///< open to the edge of the plan and that it parts too
};

/** @brief Where two cells meet: a stretch of a line. */
struct CellBorder {
  std::uint32_t line = 0;
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  std::uint32_t left = 0;  ///< cell to the left of the way from start to end
  std::uint32_t right = 0; ///< cell to its right

  double length() const { return (end - start).norm(); }
};

/** @brief The convex cells into which dividers part a rectangle, and where they meet. A
 * divider parts each cell that it enters from side to side, so its last pieces go on up
 * to the next line, or on, see PlanDivider::through. */
class PlanCells {
public:
  using Polygon = std::vector<Eigen::Vector2d>; ///< counter-clockwise

  /** @brief O(dividers x cells that they part, log). */
  PlanCells(const Eigen::AlignedBox2d& box, const std::vector<PlanDivider>& dividers);

  const std::vector<Polygon>& polygons() const { return polygons_; }
  const std::vector<CellBorder>& borders() const { return borders_; }

  /** @brief Checks whether a cell is at the edge of the rectangle. */
  bool isAtEdge(std::size_t cell) const { return is_at_edge_[cell] != 0; }

private:
  struct Cell {
    Polygon corners;
    std::vector<std::int64_t> lines; ///< of the edge from each corner on; box: -1
  };

  /** @brief A cut of the plane: at or above 0 is `above`. Leaves have none. */
  struct Node {
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();
    double offset = 0;
    std::int64_t below = -1;
    std::int64_t above = -1;
    std::int64_t cell = -1;
  };

  static bool isAtEdge(const Cell& cell);
  const Cell& cellAt(const Eigen::Vector2d& p) const;
  PlanDivider throughOpenEnds(PlanDivider divider) const;
  void part(std::size_t node, const PlanDivider& divider);
  void partCell(std::size_t node, const PlanDivider& divider);
  void findBorders(const std::vector<Cell>& cells,
                   const std::vector<PlanDivider>& dividers);

  std::vector<Cell> cells_;
  std::vector<Node> nodes_;
  std::vector<Polygon> polygons_;
  std::vector<CellBorder> borders_;
  std::vector<std::uint8_t> is_at_edge_;
};

} // namespace pcl::sedr
