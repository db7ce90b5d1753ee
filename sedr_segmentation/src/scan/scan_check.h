// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_set.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_segmentation/building.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the problem of a scan as a whole, a sentence with numbers; empty if
 * it may show rooms in metres. Problems are too few finite points, too small a scan, or
 * too large for the unit to be the metre. Uses at most 100,000 of the
 * points.
 * @param indices of the points to use; null: all */
std::string scanProblem(const PointView& points,
                        const std::vector<int>* indices = nullptr,
                        const Priors& priors = {});

/** @brief Returns the cell size, metres, at least `size`, at which a scan fills the
 * cells of its ceilings.
 *
 * The fill of a square of 20 by 20 cells is the occupied share of its cells between two
 * occupied ones in a row or grid column. Hidden parts of a ceiling leave gaps many
 * cells wide, which do not count; a sparse scan leaves single empty cells everywhere.
 * Independently scattered points fill 1 - exp(-density * size^2) of the cells. If the
 * median fill is below 98 %, cells are enlarged such that a square at the 10 % quantile
 * would reach 97 %. The limit is 2.5 times `size`. The result is rounded up to
 * a whole part of a metre, or down where that exceeds the limit, so that cells are the
 * same in frames that are whole metres apart. Squares are weighted by their occupied
 * cells, as reflections in windows may be large but have few points.
 * @param ceilings occupied cells, of edge `size`. O(n log n) for n cells. */
double cellSizeFor(const std::vector<CellSet>& ceilings,
                   double size,
                   const Priors& priors = {});

/** @brief What a scan lacks for a model of rooms. */
struct MissingSurfaces {
  double scatter = 0; ///< of half of the points about planes of 0.3 m at least, metres
  bool is_noisy = false; ///< it is twice the noise of slabs: the points are strewn
  std::string reason;    ///< a sentence; empty if there is a floor below a ceiling
};

/** @brief Returns whether thinned points lie on surfaces, and whether they show a floor
 * and a ceiling: level surfaces at least a quarter as large as the largest one, with a
 * headroom between them. One that stands alone is a floor if more of the upright
 * surfaces lie above it than below. O(n log n). */
MissingSurfaces missingSurfaces(const PointView& points,
                                const std::vector<int>& indices,
                                unsigned threads,
                                const Priors& priors = {});

constexpr double foot = 0.3048; ///< metres
constexpr const char* if_in_feet =
    "if the foot is the unit of the scan, scale it by 0.3048 (--unit 0.3048 in "
    "pcl_sedr), else --unit 1 says that it is the metre";

/** @brief Returns a sentence if the unit of a scan seems to be the inch, else an empty
 * one. The scan must be 60 to 200 high, like one or two storeys in inches, and more
 * than 30 per storey found, unlike any tower. The outermost tenth of the points at each
 * end is ignored. Above 200, the check of the scan detects the unit. O(points).
 * @param storeys number of storeys found */
std::string inchProblem(const PointView& points, std::size_t storeys);

/** @brief Returns how unlikely a clear height is, nats: of a usual one 0; some are far
 * above it, but one hits one's head (see footProblem).
 * @param height metres */
double costOfHeight(double height, const Priors& priors);

/** @brief Evidence that the unit of a plan is the foot. */
struct UnitDoubt {
  double nats = 0;    ///< log-likelihood of the foot less that of the metre
  std::string reason; ///< a sentence; empty if there is no doubt
};

/** @brief Returns whether the unit of a plan may be the foot:
 * if its heights and areas of rooms, doors, walls and heights at which a scanner stood
 * are by 2 nats more likely in feet. Of each kind the logarithm lies about the middle
 * of the range that the priors give, which is two deviations wide; some are far above
 * it, but below deviations are half as wide: one hits one's head. O(rooms times
 * places).
 * @param links of the rooms, as high as their doors
 * @param places where the scanner stood, in the frame of the plan; may be empty */
UnitDoubt footProblem(const Floorplan& plan,
                      const std::vector<RoomLink>& links = {},
                      const std::vector<Eigen::Vector3f>& places = {},
                      const Priors& priors = {});

} // namespace pcl::sedr
