// SPDX-License-Identifier: BSD-3-Clause
#include "../mesh/mesh_repair.h"
#include "opening_reveals.h"
#include "sedr_filters/src/base/number_text.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/impl/floorplan_extrusion.hpp>

#include <optional>
#include <set>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Adds a warning for each pair of rooms that overlap. Rooms without a wall
 * between them, as of one that was split, lie back to back. */
void
warnOfCrossings(const TriangleMesh& mesh, std::vector<PlanWarning>& warnings)
{
  std::set<std::pair<std::uint32_t, std::uint32_t>> crossing;
  const auto areBackToBack = [&](std::uint32_t t, std::uint32_t u) {
    return mesh.rooms[t] != mesh.rooms[u] &&
           mesh.scaledNormal(t).normalized().dot(mesh.scaledNormal(u).normalized()) <
               -1 + 1e-9;
  };
  for (const auto& [t, u] : findSelfIntersections(mesh))
    if (!areBackToBack(t, u))
      crossing.insert({mesh.rooms[t], mesh.rooms[u]});
  for (const auto& [room, other] : crossing)
    warnings.push_back({WarningKind::Crossing, {static_cast<double>(other)}, room});
}

} // namespace

std::string
extrudePlan(const Floorplan* plan, const SolidParameters& parameters, PlanSolids solids)
{
  if (!plan)
    return "no floor plan is set";
  if (plan->rooms.empty())
    return "the floor plan has 0 rooms";
  const double tolerance = parameters.chord_tolerance;
  if (!(tolerance >= 1e-6 && tolerance <= 1))
    return "the chord tolerance must lie from 1e-06 to 1 m, it is " +
           numberText(tolerance) + " m";
  std::string problem;
  std::optional<RevealedPlan> cut;
  if (parameters.cut_openings)
    cut.emplace(*plan);
  for (const PlanRoom& room : cut ? cut->rooms : plan->rooms) {
    TriangleMesh solid;
    const RoomSolidReport report =
        extrudeRoom(room, parameters, solid, solids.elements);
    const std::string name = "room " + std::to_string(room.id) + ": ";
    solids.mesh.append(solid);
    if (!report.problem.empty())
      problem += (problem.empty() ? "" : "; ") + name + report.problem;
    for (PlanWarning warning : report.warnings) {
      warning.room = room.id;
      if (cut)
        warning.reason = cut->named(warning.reason);
      solids.warnings.push_back(warning);
    }
    solids.reports.push_back(report);
  }
  if (cut) {
    for (SolidElement& element : solids.elements)
      element.name = cut->named(element.name);
    joinReveals(*cut, solids.elements, solids.mesh, solids.warnings);
  }
  warnOfCrossings(solids.mesh, solids.warnings);
  return problem;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(FloorplanExtrusion, SEDR_POINT_TYPES)
