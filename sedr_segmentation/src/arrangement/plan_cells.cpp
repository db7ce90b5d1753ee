// SPDX-License-Identifier: BSD-3-Clause
#include "plan_cells.h"

#include "../curves/plan_curve.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double thinnest = 0.002; // metres, of a cell
constexpr double same_end = 1e-7;  // metres

/** @brief Returns the way from a place in a convex polygon to its edge. */
double
wayOut(const PlanCells::Polygon& polygon,
       const Eigen::Vector2d& p,
       const Eigen::Vector2d& way)
{
  double length = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d inward =
        leftOf(polygon[(i + 1) % polygon.size()] - polygon[i]);
    if (inward.dot(way) < 0)
      length = std::min(length, inward.dot(polygon[i] - p) / inward.dot(way));
  }
  return length;
}

} // namespace

PlanCells::PlanCells(const Eigen::AlignedBox2d& box,
                     const std::vector<PlanDivider>& dividers)
{
  Cell all;
  all.corners = {box.min(),
                 {box.max().x(), box.min().y()},
                 box.max(),
                 {box.min().x(), box.max().y()}};
  all.lines.assign(4, -1);
  cells_.push_back(std::move(all));
  nodes_.emplace_back();
  nodes_[0].cell = 0;
  for (const PlanDivider& divider : dividers)
    part(0, throughOpenEnds(divider));
  for (const Cell& cell : cells_) {
    polygons_.push_back(cell.corners);
    is_at_edge_.push_back(isAtEdge(cell) ? 1 : 0);
  }
  findBorders(cells_, dividers);
  cells_.clear();
  nodes_.clear();
}

bool
PlanCells::isAtEdge(const Cell& cell)
{
  return std::any_of(cell.lines.begin(), cell.lines.end(),
                     [](auto line) { return line < 0; });
}

const PlanCells::Cell&
PlanCells::cellAt(const Eigen::Vector2d& p) const
{
  std::size_t n = 0;
  while (nodes_[n].cell < 0)
    n = static_cast<std::size_t>(
        nodes_[n].normal.dot(p) < nodes_[n].offset ? nodes_[n].below : nodes_[n].above);
  return cells_[static_cast<std::size_t>(nodes_[n].cell)];
}

/** @brief Returns a divider that goes on up to the edges of the cells in which it ends.
 * If a wall ends before it and its faces go on as lines up to the edge of the plan, the
 * cell between them is within the room on one side of the divider and outside on the
 * other, so the divider goes on through it. */
PlanDivider
PlanCells::throughOpenEnds(PlanDivider divider) const
{
  const auto lengthen = [&](Eigen::Vector2d& end, const Eigen::Vector2d& way) {
    Eigen::Vector2d p = end - 10 * thinnest * way; // see partCell()
    const Cell* cell = &cellAt(p);
    double length = wayOut(cell->corners, p, way);
    do {
      end = p + length * way;
      p = end + thinnest * way;
      cell = &cellAt(p);
      length = wayOut(cell->corners, p, way);
    } while (length > 0 && length < divider.through && isAtEdge(*cell));
  };
  const Eigen::Vector2d way = (divider.end - divider.start).normalized();
  if (divider.through > 0 && (divider.end - divider.start).norm() > 20 * thinnest) {
    lengthen(divider.start, -way);
    lengthen(divider.end, way);
  }
  return divider;
}

/** @brief Parts the cells below a node that a divider enters. */
void
PlanCells::part(std::size_t node, const PlanDivider& divider)
{
  std::vector<std::size_t> open{node};
  while (!open.empty()) {
    const std::size_t n = open.back();
    open.pop_back();
    if (nodes_[n].cell >= 0) {
      partCell(n, divider);
      continue;
    }
    const double a = nodes_[n].normal.dot(divider.start) - nodes_[n].offset;
    const double b = nodes_[n].normal.dot(divider.end) - nodes_[n].offset;
    if (std::max(a, b) > 0)
      open.push_back(static_cast<std::size_t>(nodes_[n].above));
    if (std::min(a, b) < 0)
      open.push_back(static_cast<std::size_t>(nodes_[n].below));
  }
}

void
PlanCells::partCell(std::size_t node, const PlanDivider& divider)
{
  const auto c = static_cast<std::size_t>(nodes_[node].cell);
  const Cell cell = cells_[c];
  const std::size_t n = cell.corners.size();
  const Eigen::Vector2d way = (divider.end - divider.start).normalized();
  const Eigen::Vector2d normal = leftOf(way);
  const double offset = normal.dot(divider.start);
  std::vector<double> height(n);
  for (std::size_t i = 0; i < n; ++i)
    height[i] = normal.dot(cell.corners[i]) - offset;
  const auto [lowest, highest] = std::minmax_element(height.begin(), height.end());
  if (*lowest > -thinnest || *highest < thinnest)
    return;
  Cell parts[2];                 // to the left, to the right
  std::vector<double> crossings; // along the divider
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const bool is_left = height[i] >= 0;
    Cell& from = parts[is_left ? 0 : 1];
    from.corners.push_back(cell.corners[i]);
    from.lines.push_back(cell.lines[i]);
    if (is_left == (height[j] >= 0))
      continue;
    const Eigen::Vector2d place =
        cell.corners[i] +
        (cell.corners[j] - cell.corners[i]) * (height[i] / (height[i] - height[j]));
    crossings.push_back(way.dot(place - divider.start));
    // The part that is left goes back along the divider, the other begins anew.
    from.corners.push_back(place);
    from.lines.push_back(divider.line);
    Cell& to = parts[is_left ? 1 : 0];
    to.corners.push_back(place);
    to.lines.push_back(cell.lines[i]);
  }
  if (crossings.size() != 2)
    return;
  // The divider must be inside the cell for more than its end, or cross it.
  const double length = (divider.end - divider.start).norm();
  const auto [first, last] = std::minmax(crossings[0], crossings[1]);
  const double inside = std::min(length, last) - std::max(0.0, first);
  if (inside < std::min(10 * thinnest, last - first - same_end))
    return;
  for (Cell& part : parts) { // without edges of no length
    for (std::size_t i = 0; i < part.corners.size();) {
      const std::size_t j = (i + 1) % part.corners.size();
      if ((part.corners[j] - part.corners[i]).norm() > same_end ||
          part.corners.size() < 4) {
        ++i;
        continue;
      }
      part.corners.erase(part.corners.begin() + static_cast<std::ptrdiff_t>(i));
      part.lines.erase(part.lines.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  nodes_[node].normal = normal;
  nodes_[node].offset = offset;
  nodes_[node].cell = -1;
  cells_[c] = std::move(parts[0]);
  cells_.push_back(std::move(parts[1]));
  nodes_[node].above = static_cast<std::int64_t>(nodes_.size());
  nodes_.emplace_back();
  nodes_.back().cell = static_cast<std::int64_t>(c);
  nodes_[node].below = static_cast<std::int64_t>(nodes_.size());
  nodes_.emplace_back();
  nodes_.back().cell = static_cast<std::int64_t>(cells_.size() - 1);
}

void
PlanCells::findBorders(const std::vector<Cell>& cells,
                       const std::vector<PlanDivider>& dividers)
{
  struct Edge {
    double from;
    double to;
    std::uint32_t cell;
  };
  std::map<std::uint32_t, const PlanDivider*> of_line;
  for (const PlanDivider& divider : dividers)
    of_line.emplace(divider.line, &divider);
  std::map<std::uint32_t, std::array<std::vector<Edge>, 2>> edges; // left, right
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t i = 0; i < cells[c].corners.size(); ++i) {
      if (cells[c].lines[i] < 0)
        continue;
      const auto line = static_cast<std::uint32_t>(cells[c].lines[i]);
      const PlanDivider& divider = *of_line.at(line);
      const Eigen::Vector2d way = (divider.end - divider.start).normalized();
      const double a = way.dot(cells[c].corners[i] - divider.start);
      const double b =
          way.dot(cells[c].corners[(i + 1) % cells[c].corners.size()] - divider.start);
      edges[line][a < b ? 0 : 1].push_back(
          {std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(c)});
    }
  for (auto& [line, sides] : edges) {
    const PlanDivider& divider = *of_line.at(line);
    const Eigen::Vector2d way = (divider.end - divider.start).normalized();
    for (auto& side : sides)
      std::sort(side.begin(), side.end(),
                [](const Edge& a, const Edge& b) { return a.from < b.from; });
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < sides[0].size() && j < sides[1].size()) {
      const Edge& left = sides[0][i];
      const Edge& right = sides[1][j];
      const double from = std::max(left.from, right.from);
      const double to = std::min(left.to, right.to);
      if (to - from > same_end)
        borders_.push_back({line, divider.start + from * way, divider.start + to * way,
                            left.cell, right.cell});
      (left.to < right.to ? i : j) += 1;
    }
  }
}

} // namespace pcl::sedr
