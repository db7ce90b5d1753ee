// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../surface/sheet_grid.h"
#include "facet_choice.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

struct FurnishedFloor;

/** @brief A ceiling in facets. */
struct FacetSheet {
  static constexpr std::int32_t none = -1;

  SheetGrid grid;
  std::vector<std::uint8_t> is_inside; ///< of each cell: whether it is of the room,
                                       ///< and of no furniture
  std::vector<std::uint8_t> is_seen;   ///< whether a facet explains points in it
  std::vector<std::int32_t> label;     ///< facet of each cell, beside the room too
  std::vector<PlanSlab> facets; ///< the largest first; inliers and residual known
  double noise = 0;             ///< standard deviation of the points, metres

  /** @brief z of the facet above a place; beside the grid that of the nearest
   * place on it. */
  double heightAt(const Eigen::Vector2d& p) const;
};

/** @brief Returns the finite ones of some points. */
std::vector<Eigen::Vector3d> placesOf(const PointView& points,
                                      const std::vector<int>& indices);

/** @brief Describes the points of a ceiling by facets: planes of any tilt, cylinders
 * that lie, caps of spheres and ellipsoids, else heights on a grid.
 *
 * Which there are is a question of what they explain and what they cost: a facet stays
 * where it explains more, by an information criterion, than its parameters. Which cell
 * has which is decided for all at once, by minimum cuts, so that borders are short and
 * lie where facets meet. Lamps and beams of less than a facet's least area, places
 * without points and outliers go with what is around them.
 * @param points z up, metres; of a ceiling seen from below, thinned evenly
 * @param domain cells of the plan that are of the room, and around which
 * facets are known; as many as the grid has, see sheetGrid()
 * @param directions that the axes of vaults may have beside those that are seen, those
 * of the walls: radians
 * @param around all points in and near the room: a border is cheap where they show a
 * riser; may be empty
 * @param floor whose furniture is none of the facets; null: there is none
 * @return no facets where there are fewer than 50 points
 *
 * The same for any number of threads. O(n) a facet that is tried. */
FacetSheet fitSheet(const std::vector<Eigen::Vector3d>& points,
                    const SheetGrid& grid,
                    const std::vector<std::uint8_t>& domain,
                    const std::vector<double>& directions,
                    const SheetParameters& parameters = {},
                    const std::vector<Eigen::Vector3d>& around = {},
                    const FurnishedFloor* floor = nullptr);

/** @brief As above, over what a loop encloses, in cells along its walls. */
FacetSheet surfaceWithin(const PlanLoop& loop,
                         const std::vector<Eigen::Vector3d>& points,
                         const SheetParameters& parameters = {},
                         const std::vector<Eigen::Vector3d>& around = {});

/** @brief Whether a sheet has a facet in closed form that is no level plane. */
bool hasSlope(const FacetSheet& sheet);

/** @brief The heights of a sheet as a slab, of `spacing` metres or more. */
PlanSlab reliefOf(const FacetSheet& sheet, double spacing);

/** @brief The last fit: every facet of a sheet to the points of the scan near it, as
 * many of each cell, away from its borders; reliefs stay as they are.
 * @param indices those of the scan's points that count; empty: all. O(n). */
void refitToScan(FacetSheet& sheet,
                 const PointView& scan,
                 const std::vector<int>& indices,
                 const SheetParameters& parameters = {});

/** @brief Calls `use(cell, point)` for the points of a scan over a grid.
 * @param indices those that count; empty: all */
template <typename Use>
void
forAllOver(const SheetGrid& grid,
           const PointView& scan,
           const std::vector<int>& indices,
           Use use)
{
  const std::size_t size = indices.empty() ? scan.size() : indices.size();
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t i = indices.empty() ? k : static_cast<std::size_t>(indices[k]);
    const Eigen::Vector3d p = scan[i].cast<double>();
    if (const std::size_t cell = grid.at(p.head<2>());
        cell < grid.count() && scan.isFinite(i))
      use(cell, p);
  }
}

} // namespace pcl::sedr
