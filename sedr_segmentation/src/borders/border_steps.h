// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheets/cell_points.h"
#include "border_part.h"
#include "sheet_cracks.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief Finds the straight steps between two facets that do not meet. What it refers
 * to must outlive it. */
class BorderSteps {
public:
  /** @param directions of the walls, radians */
  BorderSteps(const SheetCracks& cracks,
              const CellPoints& cells,
              const std::vector<double>& directions)
      : cracks_(cracks)
      , cells_(cells)
      , directions_(directions)
  {}

  /** @brief Adds the steps along some vertices of a chain to the chain's parts. */
  void append(const std::vector<Eigen::Vector2d>& vertices,
              const CrackChain& chain,
              std::vector<BorderPart>& parts) const;

private:
  Eigen::Vector2d alongWalls(const Eigen::Vector2d& way) const;
  double
  bestShift(const BorderPart& part, double length, const CrackChain& chain) const;

  const SheetCracks& cracks_;
  const CellPoints& cells_;
  const std::vector<double>& directions_;
};

} // namespace sedr
} // namespace pcl
