// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_surface/schedules.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief How arcs are written: exactly, or as chords within 0.25 mm for programs that
 * misread IfcArcIndex. */
enum class IfcArcs { Exact, Facets };

/** @brief Settings of writeIfc(). */
struct IfcSettings {
  std::string name = "building"; ///< of project and building
  std::string scan;              ///< see PlanDocument::scan; GUIDs depend on both
  std::string author;            ///< of the file, as is the next one
  std::string date;              ///< such as 2024-05-31; others are not written
  std::string crs;               ///< grid of the origin, such as EPSG:25832
  IfcArcs arcs = IfcArcs::Exact;
  double assumed_thickness = 0.2;      ///< if one face was seen, metres, 0.02 to 2
  double max_wall = Priors().max_wall; ///< maximum thickness of a wall, metres
};

/** @brief An IFC file and its contents. */
struct IfcModel {
  std::string text; ///< contents of the file
  std::size_t spaces = 0;
  std::size_t walls = 0;
  std::size_t paired_walls = 0; ///< walls with both faces seen
  std::size_t slabs = 0;
  std::size_t columns = 0;
  std::size_t openings = 0;
  std::size_t stairs = 0;            ///< those with flights
  Schedules schedules;               ///< of what was written, with the same numbers
  std::vector<PlanWarning> warnings; ///< what could not be written
};

/** @brief Writes a floor plan as IFC4 (ADD2 TC1), a STEP file in metres.
 *
 * @code
 * const pcl::sedr::IfcModel model = pcl::sedr::writeIfc(plan);
 * std::ofstream("model.ifc") << model.text;
 * @endcode
 *
 * The file holds site, building and the storeys of storeysOf(). A room is an IfcSpace
 * with quantities, part of its storey. It is a swept solid if floor and ceiling are
 * level and have no details, otherwise the triangles of extrudeRoom().
 *
 * Two faces of different rooms, at most 0.6 m apart, are an IfcWall of that thickness.
 * A wall with one face seen has the assumed thickness, which its Pset_SEDR states. The
 * x axis of a wall's placement runs along the wall. Floors and the uppermost ceilings
 * are IfcSlab, columns IfcColumn, platforms IfcSlab. Details below a ceiling are
 * IfcCovering, narrow ones IfcBeam. Openings are cut in their walls and deeper
 * than these; niches are recesses. Stairs are IfcStair with their flights. Spaces refer
 * to the walls and slabs around them (IfcRelSpaceBoundary1stLevel). A storey lies at
 * its usual floor. Walls, doors and windows have the numbers of the sheet as tags,
 * their property sets (Pset_WallCommon, ...), their quantities to a millimetre, and
 * doors and windows their types. Pset_SEDR holds residuals, shares and numbers of
 * points.
 *
 * The same plan gives the same bytes; the same project, scan and element have the same
 * GUID.
 *
 * @param plan fitted plan; without rooms the building is empty
 * @param origin origin of the coordinates, written as IfcMapConversion unless it is 0
 *
 * Cost: that of the solids, and elements squared for the walls. */
IfcModel writeIfc(const Floorplan& plan,
                  const IfcSettings& settings = {},
                  const Origin& origin = {});

} // namespace pcl::sedr
