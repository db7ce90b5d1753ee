// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/sheet.h"
#include "../sheet/text_places.h"
#include "sheet_layout.h"

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::sedr {

constexpr double min_step = 0.05; ///< metres; less has no dimension of its own

/** @brief Returns the direction along a side of a drawing, to the right or upwards.
 * @param side unit vector away from the plan */
inline Eigen::Vector2d
wayAlong(const Eigen::Vector2d& side)
{
  return side.cwiseAbs().reverse();
}

/** @brief A row of dimensions beside a plan, between places that are visible from that
 * side without a wall in front. Metres, in the frame of the walls. */
struct DimensionChain {
  Eigen::Vector2d side = {0, -1};      ///< unit vector away from the plan
  std::vector<Eigen::Vector2d> places; ///< corners, in order along the side

  double along(std::size_t place) const { return places[place].dot(wayAlong(side)); }

  /** @brief Returns a dimension: from a place to the next one. */
  double length(std::size_t place) const { return along(place + 1) - along(place); }
};

/** @brief Returns the chains that a drawing needs, whatever its paper: bottom and left,
 * and the opposite sides where they differ. Chains with only the overall dimension are
 * omitted. Cost: walls times those that lie behind each other.
 * @param walls of all rooms, including arcs, metres
 * @param max_wall maximum thickness of a wall, metres: what is visible through a gap as
 * narrow is ignored */
std::vector<DimensionChain> wallChains(const std::vector<PlanElement>& walls,
                                       double max_wall);

/** @brief Returns a chain for each side with openings that lead outside and that no
 * room hides from it: along their jambs, from end to end of the plan.
 * @param frame of the chains
 * @param whole the rooms in it */
std::vector<DimensionChain> openingChains(const Floorplan& plan,
                                          const PlanFrame& frame,
                                          const Eigen::AlignedBox2d& whole);

/** @brief Removes places until neighbours are `least` metres apart: of the two nearest
 * to each other the one deeper in the plan. The others stay where they are. */
void dropSmallSteps(DimensionChain& chain, double least);

/** @brief A dimension on a sheet, millimetres. */
struct SheetDimension {
  Eigen::Vector2d from; ///< corners of the plan that it measures
  Eigen::Vector2d to;
  Eigen::Vector2d start; ///< ends of its dimension line
  Eigen::Vector2d end;
  double length = 0;               ///< metres
  std::optional<SheetText> text{}; ///< empty if there was no free space
};

/** @brief Returns the lines of a dimension: its own, and the extension lines to its
 * corners. */
std::vector<PlanElement> linesOf(const SheetDimension& dimension);

/** @brief Returns the ticks at the ends of the line of a dimension. */
std::vector<PlanElement> ticksOf(const SheetDimension& dimension);

/** @brief A row of dimensions beside a plan. */
struct DimensionRow {
  DimensionChain chain; ///< metres, in the frame of the walls
  double off = 0;       ///< distance from the box of the plan, millimetres
};

/** @brief Returns the rows around a plan, on any paper, from inside out: along openings
 * that lead outside, by wall where that says more than the overall dimension, and
 * overall.
 * @param turn of the plan on its sheet, radians
 * @param max_wall maximum thickness of a wall, metres */
std::vector<DimensionRow>
rowsAround(const Floorplan& plan, double turn, double max_wall);

/** @brief Returns the space that rows need around the box of the plan: below and to the
 * left, above and to the right; millimetres. */
Eigen::AlignedBox2d spaceOf(const std::vector<DimensionRow>& rows);

/** @brief Places the rows with their texts, which overlap neither lines nor each other.
 * A dimension whose text has no place is joined with the shorter one beside it, one
 * that is alone is left out: every one that is drawn can be read.
 * @param box of the plan on its sheet */
std::vector<SheetDimension> placedRows(std::vector<DimensionRow> rows,
                                       const Eigen::AlignedBox2d& box,
                                       const PlanFrame& frame,
                                       TextPlaces& places);

/** @brief Draws dimensions: a line with a tick at each end, extension lines to the
 * corners, and lengths. */
void addDimensions(Sheet& sheet, const std::vector<SheetDimension>& dimensions);

} // namespace pcl::sedr
