// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheets/sheet_fit.h"
#include "../surface/cell_points.h"
#include "cell_cracks.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace pcl::sedr {

/** @brief Finds the straight steps between two facets that do not meet. What it refers
 * to must outlive it. */
class BorderSteps {
public:
  /** @param cells the points of the ceiling
   * @param risers points of what is vertical in it
   * @param directions of the walls, radians */
  BorderSteps(const SheetCracks& cracks,
              const CellPoints& cells,
              const CellPoints& risers,
              const std::vector<double>& directions)
      : cracks_(cracks)
      , cells_(cells)
      , risers_(risers)
      , directions_(directions)
      , deviation_(std::max(0.003, 2 * cracks.sheet.noise))
  {}

  /** @brief Adds the steps along some vertices of a chain to the chain's parts. */
  void append(const std::vector<Eigen::Vector2d>& vertices,
              const CrackChain& chain,
              std::vector<BorderPart>& parts) const;

  /** @brief Whether the points about a place of a chain are as well explained by the
   * lower one of its two facets everywhere, or by the higher one, as by that of their
   * cells: else these step there, though their surfaces cross nearby. No free form's.
   */
  bool mayMeet(const Eigen::Vector2d& place, const CrackChain& chain) const;

private:
  double misfit(std::int32_t piece, const Eigen::Vector3d& p) const;
  bool isBetween(const Eigen::Vector3d& p, const CrackChain& chain) const;
  bool isLeftLower(const BorderPart& part, const CrackChain& chain) const;
  Eigen::Vector2d alongWalls(const Eigen::Vector2d& way) const;
  struct Profile;
  Profile
  profileAcross(const BorderPart& part, double length, const CrackChain& chain) const;
  double
  bestShift(const BorderPart& part, double length, const CrackChain& chain) const;

  const SheetCracks& cracks_;
  const CellPoints& cells_;
  const CellPoints& risers_;
  const std::vector<double>& directions_;
  double deviation_; ///< of points from their facet, metres
};

/** @brief The parts of a chain, as far as it is in the room: where its two facets meet,
 * the line of one height with a sample a vertex, elsewhere straight steps. None beside
 * the grid. O(vertices and points near steps). */
std::vector<BorderPart>
partsOf(const CrackChain& chain, const SheetCracks& cracks, const BorderSteps& steps);

} // namespace pcl::sedr
