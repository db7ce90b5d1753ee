// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A row of the schedule of rooms; metres. */
struct RoomRow {
  std::uint32_t id = 0;
  std::string name;
  std::string storey;
  double area = 0;
  double area_2_0 = 0; ///< with at least 2.0 m of headroom
  double area_1_5 = 0; ///< with at least 1.5 m of headroom
  double perimeter = 0;
  double height = 0; ///< the usual one, see ClearHeight
  double lowest = 0; ///< of the solid's ceiling, but for its smallest parts
  double highest = 0;
  double volume = 0;
  double measured = -1;      ///< share of its walls; -1: not known
  SurfaceAccuracy floor{};   ///< of its main floor
  SurfaceAccuracy ceiling{}; ///< of its main ceiling
};

/** @brief A row of the schedule of doors, windows and passages; metres. */
struct OpeningRow {
  std::string mark; ///< see markOf()
  std::string kind;
  std::string storey;
  double width = 0;
  double height = 0;
  std::string width_is{};             ///< what was seen of the jambs, see widthIs()
  double width_error = 0;             ///< standard error; 0: not known
  double sill = 0;                    ///< above the floor, see sillOf()
  std::string leaf{};                 ///< "left", "right", "double"; see leafOf()
  std::uint32_t swing = 0;            ///< room that the leaf opens into
  std::array<std::uint32_t, 2> rooms; ///< 0: outside
  double confidence = 0;              ///< probability of the kind
  SurfaceAccuracy accuracy{};         ///< of its edges

  double head() const { return sill + height; }
};

/** @brief A row of the schedule of walls; metres. */
struct WallRow {
  std::string number; ///< that of its face on the sheet: "3.12"
  std::string other;  ///< of the face on its other side; "": not seen
  std::string storey;
  bool is_external = false;
  double thickness = 0;
  std::string thickness_is{}; ///< "measured", "at least" or "assumed"
  double length = 0;
  double height = 0;     ///< the maximum
  double gross_area = 0; ///< of one side
  double net_area = 0;   ///< without openings
  double gross_volume = 0;
  double net_volume = 0;      ///< without openings and niches
  double measured = -1;       ///< share of its faces; -1: not known
  SurfaceAccuracy accuracy{}; ///< of the worse face; none if one is a guess
};

/** @brief The schedules of a building. */
struct Schedules {
  std::vector<RoomRow> rooms;
  std::vector<OpeningRow> openings; ///< by kind and number
  std::vector<WallRow> walls;
};

/** @brief A schedule as texts, with a name such as "rooms"; names of columns end in the
 * unit: "area_m2". */
struct ScheduleTable {
  std::string name;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/** @brief Returns the level of accuracy (USIBD C220) of errors of which 95 % do not
 * exceed `error_95` metres: "LOA50" up to 1 mm, "LOA40" up to 5 mm, "LOA30" up to
 * 15 mm, "LOA20" up to 5 cm, else "LOA10"; "not measured" if it is 0. */
std::string levelOfAccuracy(double error_95);

/** @brief Returns the level of what was measured: two standard errors. */
std::string measuredLevel(const SurfaceAccuracy& accuracy);

/** @brief Returns the level at which the model represents the points. */
std::string representedLevel(const SurfaceAccuracy& accuracy);

/** @brief Returns the accuracy of the worst edge of an opening; none if nothing shows
 * any. */
SurfaceAccuracy accuracyOf(const PlanOpening& opening);

/** @brief Returns what the width of an opening is: "between reveals" that were seen, of
 * the wall or a lining; "between rims" of the wall's face; "leaf or frame"; "seen
 * part", if nothing shows a jamb; empty if it was edited. */
std::string widthIs(const PlanOpening& opening);

/** @brief Returns the rows of the openings, by kind and number.
 * @param plan with numbers, see numberOpenings() */
std::vector<OpeningRow> openingRows(const Floorplan& plan);

/** @brief Returns rooms, openings and walls as tables; lengths, areas and volumes with
 * three decimals. */
std::vector<ScheduleTable> tablesOf(const Schedules& schedules);

/** @brief Returns a table as CSV (RFC 4180) in UTF-8, with a line of names. */
std::string csvOf(const ScheduleTable& table);

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
 * Two faces of different rooms, at most Priors::max_wall apart, are an IfcWall of that
 * thickness. A wall with one face seen has the assumed thickness, which its Pset_SEDR
 * states. The x axis of a wall's placement runs along the wall. Floors and the
 * uppermost ceilings are IfcSlab, columns IfcColumn, platforms IfcSlab. Details below a
 * ceiling are IfcCovering, narrow ones IfcBeam. Openings are cut in their walls and
 * deeper than these; niches are recesses. Stairs are IfcStair with their flights.
 * Spaces refer to the walls and slabs around them (IfcRelSpaceBoundary1stLevel). A
 * storey lies at its usual floor. Walls, doors and windows have the numbers of the
 * sheet as tags, their property sets (Pset_WallCommon, ...), their quantities to a
 * millimetre, and doors and windows their types. Pset_SEDR holds residuals, shares and
 * numbers of points.
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
