// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_filters/wall_tilts.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How arcs are written: as such, or as chords within half a millimetre for
 * programs that misread IfcArcIndex. */
enum class IfcArcs { Exact, Facets };

/** @brief What writeIfc() is told beside the plan. */
struct IfcSettings {
  std::string name = "building"; ///< of project and building; GUIDs are made of it
  std::string crs;               ///< name of the grid of the origin, such as EPSG:25832
  IfcArcs arcs = IfcArcs::Exact;
  double assumed_thickness = 0.2; ///< of walls and slabs of which one face was seen,
                                  ///< metres, 0.02 to 2
  WallTilts
      tilts{}; ///< the walls that lean: spaces show them, walls stand at their feet
};

/** @brief A plan as IFC, and what is in it. */
struct IfcModel {
  std::string text; ///< the file
  std::size_t spaces = 0;
  std::size_t walls = 0;
  std::size_t paired_walls = 0; ///< those of which both faces were seen
  std::size_t slabs = 0;
  std::size_t columns = 0;
  std::size_t openings = 0;
  std::vector<std::string> warnings; ///< what could not be written, a sentence each
};

/** @brief A floor plan as IFC4 (ADD2 TC1), a STEP file in metres.
 *
 * @code
 * const pcl::sedr::IfcModel model = pcl::sedr::writeIfc(plan);
 * std::ofstream("model.ifc") << model.text;
 * @endcode
 *
 * Site, building and the storeys of storeysOf(). A room is an IfcSpace, part of its
 * storey, with quantities: swept where floor and ceiling are level and have no details,
 * else the triangles of extrudeRoom(). Two faces with a room each, at most 0.6 m apart,
 * are an IfcWall of that thickness; where one face was seen the wall has the assumed
 * thickness, which its Pset_SEDR says. Walls stand along the x of their own placement.
 * Floors and the uppermost ceilings are IfcSlab, columns IfcColumn, what hangs below a
 * ceiling IfcCovering or, where it is narrow, IfcBeam, platforms IfcSlab. Doorways are
 * openings in their walls, deeper than these, niches recesses. Spaces know the walls
 * and slabs around them (IfcRelSpaceBoundary1stLevel). Pset_SEDR holds what was seen:
 * residuals, shares, counts of points.
 *
 * The same plan gives the same bytes, and the same names the same GUIDs.
 *
 * @param plan as fitted; without rooms the building is empty
 * @param origin what places are counted from: an IfcMapConversion unless it is 0
 * Cost: that of the solids, and elements squared for the walls. */
IfcModel writeIfc(const Floorplan& plan,
                  const IfcSettings& settings = {},
                  const Origin& origin = {});

} // namespace sedr
} // namespace pcl
