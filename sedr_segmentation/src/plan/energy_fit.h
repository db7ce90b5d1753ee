// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../faces/room_cells.h"
#include "../sheets/sheet_fit.h"
#include "room_shares.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Returns what was seen along the outline of a room and of its columns, a
 * sample a cell. O(samples x points near them).
 * @param near distance of surfaces from their line, metres */
std::vector<FittedBoundary> outlineSamples(const PlanRoom& room,
                                           const RoomCells& cells,
                                           double spacing,
                                           double near);

/** @brief Measures the noise of walls: the scatter about lines of 1.2 m, and how far
 * deviations from them are correlated (their autocorrelation, summed). */
WallNoise wallNoise(const std::vector<FittedBoundary>& boundaries, double spacing);

/** @brief What an outline and the air that was seen do not share, square metres. */
struct OutlineCover {
  double lost = 0;   ///< seen outside of all outlines, not in a reveal
  double unseen = 0; ///< inside, though nobody saw it
};

/** @brief Compares the outline of a room with the air that was seen of it.
 * @param others all rooms of the storey
 * @param max_wall thickness: what is nearer to the outline is a reveal, metres
 * O(cells x elements). */
OutlineCover coverOf(const PlanRoom& room,
                     const std::vector<const PlanRoom*>& others,
                     const RoomCells& cells,
                     const CellGrid& grid,
                     double max_wall);

/** @brief The ceiling, or the floor, of a room that is more than a plane. */
struct RoomSheet {
  std::uint32_t room = 0; ///< PlanRoom::id
  std::vector<Eigen::Vector3d> points;
  FacetSheet sheet{}; ///< fitted to them
  bool is_floor = false;
};

/** @brief Sets the facets of ceilings and floors.
 * @param scan the points that the facets are fitted to, the raw ones if known
 * @param indices those to use; empty: all */
void giveCeilings(std::vector<RoomSheet> sheets,
                  const PointView& scan,
                  const std::vector<int>& indices,
                  unsigned threads,
                  Floorplan& plan);

/** @brief The rooms of a plan as they are labelled. */
struct FittedPlan {
  Floorplan plan;
  std::string problem;               ///< why there is no room, a sentence; else empty
  std::vector<PlanWarning> warnings; ///< rooms that could not be fitted
  std::vector<FittedBoundary> boundaries; ///< boundary points of walls and columns
  std::vector<WallNoise> noise;           ///< of the walls of each storey
  /** @brief The ceilings and floors that are more than a plane. giveCeilings() makes
   * their facets when the walls are final; until then they are reliefs. */
  std::vector<RoomSheet> sheets;
};

/** @brief Fits all rooms of a plan: outlines by StoreyEnergy, ceilings and floors by
 * the facets' energy.
 * @param scan the raw scan, may be empty; it tells glass from walls
 * @param scan_indices the points of it to use; empty: all */
FittedPlan fitPlanByEnergy(const PointView& points,
                           const PlanEvidence& evidence,
                           const PointView& scan,
                           const std::vector<int>& scan_indices,
                           const RoomFitParameters& parameters);

} // namespace pcl::sedr
