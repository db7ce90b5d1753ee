// SPDX-License-Identifier: BSD-3-Clause
#include "solid_builder.h"
#include "tilted_wall_solid.h"

#include "sedr_filters/src/plan/plan_check.h"

#include <pcl/sedr_filters/straightening.h>
#include <pcl/sedr_surface/room_solid.h>

#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Sums the areas of triangles by label and orientation. */
void
measure(const TriangleMesh& solid, RoomSolidReport& report)
{
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    const Eigen::Vector3d normal = solid.scaledNormal(t);
    const double area = normal.norm() / 2;
    const auto label = static_cast<StructureLabel>(solid.labels[t]);
    report.area += area;
    if (label == StructureLabel::Wall || label == StructureLabel::Column)
      report.wall_area += area;
    else if (label == StructureLabel::Detail && std::abs(normal.z()) < area) // vertical
      report.riser_area += area;
    else
      (normal.z() < 0 ? report.floor_area : report.ceiling_area) += area;
  }
  report.triangles = solid.triangles.size();
  report.volume = solid.signedVolume();
  report.topology = checkTopology(solid);
  report.closed = report.topology.isClosedManifold();
  if (!report.closed)
    report.problem = "its solid is not closed: " + report.topology.problem();
}

} // namespace

RoomSolidReport
extrudeRoom(const PlanRoom& room,
            const SolidParameters& parameters,
            TriangleMesh& solid,
            std::vector<SolidElement>& elements,
            const WallTilts& tilts)
{
  solid = TriangleMesh();
  RoomSolidReport report;
  report.room = room.id;
  report.problem = roomProblem(room);
  if (!report.problem.empty())
    return report;
  const bool is_tilted = isTilted(room, tilts);
  const PlanRoom straight =
      is_tilted ? straightened(Floorplan{{room}}, tilts).rooms.front() : PlanRoom();
  const RoomLayers layers(is_tilted ? straight : room);
  PlanSubdivision subdivision;
  report.problem = subdivideRoom(layers, parameters, subdivision, report.warnings);
  if (report.problem.empty())
    report.problem = SolidBuilder(layers, subdivision).build(solid);
  if (report.problem.empty() && is_tilted) {
    const std::string folded =
        tiltWalls(layers, wallRuns(room, tilts), headOf(room, tilts), solid);
    if (!folded.empty()) {
      report = extrudeRoom(room, parameters, solid, elements);
      report.warnings.push_back({WarningKind::Contradiction,
                                 {},
                                 0,
                                 0,
                                 "its walls stand vertical in the solid: " + folded});
      return report;
    }
  }
  if (!report.problem.empty()) {
    solid = TriangleMesh();
    return report;
  }
  const auto first = static_cast<std::uint32_t>(elements.size()) + 1;
  for (auto& element : solid.elements)
    element += first;
  solid.rooms.assign(solid.triangles.size(), room.id);
  elements.insert(elements.end(), layers.elements.begin(), layers.elements.end());
  measure(solid, report);
  return report;
}

} // namespace pcl::sedr
