// SPDX-License-Identifier: BSD-3-Clause
#include "solid_builder.h"
#include "tilted_wall_solid.h"

#include "sedr_filters/src/plan/level_planes.h"

#include <pcl/sedr_filters/straightening.h>
#include <pcl/sedr_surface/room_solid.h>

#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double max_coordinate = 1e6; // metres, as in floorplanFromJson()

bool
isSound(const PlanElement& element)
{
  const auto isPlace = [](const Eigen::Vector2d& p) {
    return p.allFinite() && p.cwiseAbs().maxCoeff() <= max_coordinate;
  };
  return isPlace(element.start) && isPlace(element.end) && isPlace(element.centre) &&
         std::isfinite(element.radius) && std::isfinite(element.residual);
}

std::string
loopProblem(const PlanLoop& loop, const std::string& name)
{
  if (loop.elements.empty())
    return name + " has 0 elements";
  for (std::size_t i = 0; i < loop.elements.size(); ++i)
    if (!isSound(loop.elements[i]))
      return "element " + std::to_string(i + 1) + " of " + name +
             " is not finite or lies beyond 1000000 m";
  return {};
}

std::string
slabProblem(const PlanSlab& slab, const std::string& name)
{
  const Eigen::Vector4d& plane = slab.plane;
  const bool is_sound = plane.allFinite() &&
                        plane[2] >= min_upward * plane.head<3>().norm() &&
                        plane[2] > 0 && (!slab.curve || slab.curve->isFinite()) &&
                        std::abs(slab.heightAt({0, 0})) <= 4 * max_coordinate;
  return is_sound ? std::string()
                  : name + " is not finite, is tilted by more than 60 degrees or lies "
                           "beyond 1000000 m";
}

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

std::string
roomProblem(const PlanRoom& room)
{
  std::string problem = loopProblem(room.boundary, "its boundary");
  const auto check = [&problem](const std::string& next) {
    problem = problem.empty() ? next : problem;
  };
  const auto checkDetails = [&](const std::vector<PlanDetail>& details,
                                const std::string& kind) {
    for (std::size_t d = 0; d < details.size(); ++d) {
      const std::string name = kind + std::to_string(d + 1);
      check(slabProblem(details[d].slab, name));
      check(loopProblem(details[d].boundary, name));
      for (const PlanLoop& hole : details[d].holes)
        check(loopProblem(hole, "a hole of " + name));
    }
  };
  check(slabProblem(room.floor, "its floor"));
  check(slabProblem(room.ceiling, "its ceiling"));
  for (std::size_t c = 0; c < room.columns.size(); ++c)
    check(loopProblem(room.columns[c], "column " + std::to_string(c + 1)));
  checkDetails(room.details, "detail ");
  checkDetails(room.floor_details, "floor detail ");
  for (std::size_t n = 0; n < room.niches.size(); ++n) {
    const std::string name = "niche " + std::to_string(n + 1);
    check(slabProblem(room.niches[n].bottom, "the bottom of " + name));
    check(slabProblem(room.niches[n].top, "the top of " + name));
    check(loopProblem(room.niches[n].boundary, name));
  }
  return problem;
}

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
      report.warnings.push_back("its walls stand vertical in the solid: " + folded);
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
