// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheets/sheet_fit.h"
#include "../surface/sheet_grid.h"

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A corner of cells, by its column and row. */
struct CrackVertex {
  int x = 0;
  int y = 0;

  bool operator==(const CrackVertex& o) const { return x == o.x && y == o.y; }
  bool operator<(const CrackVertex& o) const { return y != o.y ? y < o.y : x < o.x; }
};

/** @brief A line along cells' sides from one place where three pieces meet to the next,
 * or round a piece within another one: then it ends where it starts. */
struct CrackChain {
  std::vector<CrackVertex> vertices;
  std::int32_t left = -1; ///< piece on the left of the way; -1: beside the grid
  std::int32_t right = -1;
};

/** @brief A chain as it is walked around a piece. */
struct ChainUse {
  std::size_t chain = 0;
  bool forward = true;
};

/** @brief Cells of a grid in pieces, and the lines between these. */
struct CellCracks {
  std::vector<std::int32_t> piece;     ///< of each cell
  std::vector<std::size_t> first_cell; ///< of each piece
  std::vector<CrackChain> chains;
  std::vector<std::vector<std::vector<ChainUse>>> loops; ///< of each piece, which is on
                                                         ///< the left of them
};

/** @brief Parts cells by labels into pieces that hang together by their sides, and
 * finds the lines between them. O(n). */
CellCracks cracksOf(const SheetGrid& grid, const std::vector<std::int32_t>& label);

/** @brief The pieces of a sheet and what lies beside the vertices between them. What it
 * refers to must outlive it. */
struct SheetCracks {
  static constexpr double reach = 2.5; ///< cells that a label may be off, where seen

  const FacetSheet& sheet;
  const CellCracks& cracks;

  double cellSize() const { return sheet.grid.size; }

  Eigen::Vector2d placeOf(const CrackVertex& v) const
  {
    return sheet.grid.placeOf(v.x, v.y);
  }

  const PlanSlab& facetOf(std::int32_t piece) const
  {
    const std::size_t cell = cracks.first_cell[static_cast<std::size_t>(piece)];
    return sheet.facets[static_cast<std::size_t>(sheet.label[cell])];
  }

  /** @brief Whether a cell at the vertex is of the room. */
  bool isInside(const CrackVertex& v) const { return anyMarked(sheet.is_inside, v, 1); }

  /** @brief How far from the vertex the border may lie, metres. */
  double reachAt(const CrackVertex& v) const
  {
    return cellSize() * (anyMarked(sheet.is_seen, v, 2) ? reach : 4 * reach);
  }

private:
  /** @brief Whether any of the cells up to `around` from a vertex is marked. */
  bool anyMarked(const std::vector<std::uint8_t>& marks,
                 const CrackVertex& v,
                 int around) const
  {
    for (int y = v.y - around; y < v.y + around; ++y)
      for (int x = v.x - around; x < v.x + around; ++x)
        if (sheet.grid.holds(x, y) && marks[sheet.grid.indexOf(x, y)] != 0)
          return true;
    return false;
  }
};

constexpr double border_tolerance = 2e-4; ///< metres that a border may be off

/** @brief A part of a border that follows one line: that on which two facets meet, or
 * a straight step. */
struct BorderPart {
  const PlanSlab* one = nullptr; ///< null: of a step
  const PlanSlab* other = nullptr;
  Eigen::Vector2d through = Eigen::Vector2d::Zero();
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> samples;

  bool meets() const { return one != nullptr; }

  /** @brief Which side of the line a place lies on, about how far, and the unit way to
   * more. */
  std::pair<double, Eigen::Vector2d> sideOf(const Eigen::Vector2d& p) const;

  /** @brief The place of the line that is nearest, if there is one within `farthest`
   * metres. */
  std::optional<Eigen::Vector2d> project(const Eigen::Vector2d& from,
                                         double farthest) const;
};

/** @brief Where the lines of two parts cross, at most `farthest` metres from `near`;
 * nothing where they are nearly parallel. */
std::optional<Eigen::Vector2d> crossing(const BorderPart& a,
                                        const BorderPart& b,
                                        const Eigen::Vector2d& near,
                                        double farthest);

} // namespace pcl::sedr
