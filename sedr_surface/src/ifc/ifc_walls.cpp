// SPDX-License-Identifier: BSD-3-Clause
#include "../walls/wall_band.h"
#include "ifc_bodies.h"
#include "ifc_parts.h"
#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace pcl::sedr::ifc {
namespace {

std::string
faceName(const Floorplan& plan, const WallFace& face)
{
  const std::string loop =
      face.loop > 0 ? "column_" + std::to_string(face.loop) + "_face_" : "wall_";
  return nameIn(plan.rooms[face.room], loop + std::to_string(face.element + 1));
}

void
writeBoundaries(IfcDocument& document, const WrittenWall& written)
{
  const PlanWall& wall = written.wall;
  writeBoundary(document, wall.face.room, written.name, written.ref,
                wall.other ? "INTERNAL" : "NOTDEFINED");
  if (wall.other)
    writeBoundary(document, wall.other->room, written.name + " back", written.ref);
}

/** @brief Returns the number of a face on the sheet: "3.12"; "3.c1.2" on an island. */
std::string
numberOf(const Floorplan& plan, const WallFace& face)
{
  return std::to_string(plan.rooms[face.room].id) + "." +
         (face.loop > 0 ? "c" + std::to_string(face.loop) + "." : "") +
         std::to_string(face.element + 1);
}

/** @brief Returns the share of both faces of a wall that was measured; -1 if that is
 * not known. */
double
measuredShare(const Floorplan& plan, const PlanWall& wall)
{
  WallShares shares;
  for (const auto& face : {std::optional<WallFace>(wall.face), wall.other})
    if (face && face->loop == 0)
      shares += wallShares(plan, plan.rooms[face->room], face->element);
  return shares.area > 0 ? shares.measured : -1;
}

/** @brief Returns the accuracy of both faces of a wall. */
SurfaceAccuracy
accuracyOf(const Floorplan& plan, const PlanWall& wall)
{
  const auto of = [&](const WallFace& face) {
    return isGuess(plan, face) ? SurfaceAccuracy() : elementOf(plan, face).accuracy;
  };
  return wall.other ? worse(of(wall.face), of(*wall.other)) : of(wall.face);
}

/** @brief Returns what its thickness is: reveals end at a pane or at the outer face. */
const char*
thicknessIs(const PlanWall& wall)
{
  if (wall.isAssumed())
    return "assumed";
  return wall.source == ThicknessSource::Faces ? "measured" : "at least";
}

WallRow
rowOf(const IfcDocument& document, const WrittenWall& written)
{
  const PlanWall& wall = written.wall;
  WallRow row{written.number,
              wall.other ? numberOf(document.plan, *wall.other) : "",
              document.storeys[written.storey].storey.name,
              written.is_external,
              wall.thickness,
              thicknessIs(wall),
              wall.stretch.length(),
              written.top() - written.bottom()};
  WallBody upright = written;
  upright.runs = {};
  std::vector<WallCut> through;
  std::copy_if(written.cuts.begin(), written.cuts.end(), std::back_inserter(through),
               [](const WallCut& cut) { return !cut.is_recess; });
  row.gross_area = row.length * (written.heights.mean() - written.heights.surplus);
  const double open =
      (upright.volume(document.plan, {}) - upright.volume(document.plan, through)) /
      wall.thickness;
  row.net_area = std::max(row.gross_area - open, 0.0);
  row.gross_volume = written.volume(document.plan, {});
  row.net_volume = written.volume(document.plan, written.cuts);
  row.measured = measuredShare(document.plan, wall);
  row.accuracy = accuracyOf(document.plan, wall);
  return row;
}

void
describe(IfcDocument& document, const WrittenWall& written, const WallRow& row)
{
  const PlanWall& wall = written.wall;
  const PlanElement& face = elementOf(document.plan, wall.face);
  document.addQuantities(written.ref, written.name, "Qto_WallBaseQuantities",
                         {{"LENGTH", "Length", row.length},
                          {"LENGTH", "Width", row.thickness},
                          {"LENGTH", "Height", row.height},
                          {"AREA", "GrossSideArea", row.gross_area},
                          {"AREA", "NetSideArea", row.net_area},
                          {"VOLUME", "GrossVolume", row.gross_volume},
                          {"VOLUME", "NetVolume", row.net_volume}});
  // "Outer wall at least 0.31", "Wall 0.20 assumed"
  const std::string claim = row.thickness_is;
  const std::string type = (row.is_external ? "Outer wall " : "Wall ") +
                           (claim == "at least" ? claim + " " : "") +
                           decimalText(row.thickness, 2) +
                           (wall.isAssumed() ? " " + claim : "");
  document.addToType("IFCWALLTYPE", type, written.ref, {symbol("NOTDEFINED")});
  document.addProperties(
      written.ref, written.name, "Pset_WallCommon",
      {{"Reference", typed("IFCIDENTIFIER", type)},
       {"IsExternal", typed("IFCBOOLEAN", logical(row.is_external))}});
  std::vector<Property> properties{
      {"ThicknessAssumed", typed("IFCBOOLEAN", logical(wall.isAssumed()))},
      {"ThicknessIs", typed("IFCLABEL", row.thickness_is)},
      {"Face", typed("IFCTEXT", faceName(document.plan, wall.face))},
      {"Residual", typed("IFCLENGTHMEASURE", face.residual)},
      {"Points", typed("IFCINTEGER", integer(face.inliers))}};
  appendAccuracy(row.accuracy, properties);
  double confidence = confidenceOf(face);
  if (wall.other) {
    properties.emplace_back("OtherFace",
                            typed("IFCTEXT", faceName(document.plan, *wall.other)));
    confidence =
        std::min(confidence, confidenceOf(elementOf(document.plan, *wall.other)));
  }
  if (confidence >= 0)
    properties.emplace_back("Confidence", shareProperty(confidence));
  if (row.measured >= 0)
    properties.emplace_back("MeasuredShare", shareProperty(row.measured));
  if (face.evidence.isKnown()) {
    properties.emplace_back(
        "Guess", typed("IFCBOOLEAN", logical(isGuess(document.plan, wall.face))));
    properties.emplace_back("SeenShare", shareProperty(face.evidence.seen));
    properties.emplace_back("HiddenShare", shareProperty(face.evidence.hidden));
    properties.emplace_back("OpeningShare", shareProperty(face.evidence.opening));
  }
  document.addProperties(written.ref, written.name, "Pset_SEDR", properties);
}

/** @brief Returns the body of a wall in its placement: swept if it is level, else
 * triangles. */
StepRef
bodyOf(IfcDocument& document, const WrittenWall& written)
{
  const PlanArea& profile = written.profile;
  TriangleMesh mesh;
  if (!written.heights.isLevel() || !written.runs.areAlike())
    mesh = written.mesh(document.plan);
  // A plan that cannot be triangulated is swept, too.
  return document.bodyOf(
      mesh.empty() ? document.shapes.extrusion(profile.boundary, profile.holes, 0,
                                               written.top() - written.bottom(),
                                               written.runs.near)
                   : document.shapes.faceSet(mesh),
      "wall");
}

/** @brief Returns whether most of a wall's face is within an area: behind it, too. */
bool
isWithin(const WallSite& site, const std::vector<PlanArea>& areas)
{
  constexpr int samples = 9;
  constexpr double behind = 0.005;
  const PlanWall& wall = site.wall;
  int within = 0;
  for (int i = 0; i < samples; ++i) {
    const auto [place, inward] =
        faceAt(elementOf(site.plan, wall.face),
               wall.stretch.from + wall.stretch.length() * (i + 0.5) / samples);
    const Eigen::Vector2d p = site.frame.toLocal(place - behind * inward);
    within += std::any_of(areas.begin(), areas.end(), [&](const PlanArea& area) {
      return area.boundary.contains(p);
    });
  }
  return within > samples / 2;
}

/** @brief Returns triangles in plan that the solid of a room takes of a wall: of a room
 * beside it the floors, those of niches are none, and none of one that is swept from
 * its plan; of one below what is open to the ceiling before its face. */
std::vector<PlanArea>
footprintOf(const IfcRoom& room,
            bool is_beside,
            const Floorplan& plan,
            const WallSite& site)
{
  if (is_beside && room.is_swept)
    return {};
  std::vector<std::string> floors{"floor"};
  for (std::size_t d = 1; d <= room.room.floor_details.size(); ++d)
    floors.push_back("floor_detail_" + std::to_string(d));
  std::vector<std::size_t> triangles(room.solid.triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0);
  std::vector<PlanArea> found;
  for (const std::size_t t : is_beside ? room.trianglesOf(floors) : triangles) {
    const auto isOpen = [&](int k) {
      const Eigen::Vector3d& p = room.solid.corner(t, k);
      return p.z() > openHeight(plan, site.wall.face, p.head<2>());
    };
    const double up = room.solid.scaledNormal(t).z();
    if (is_beside ? up >= 0 : up <= 0 || !isOpen(0) || !isOpen(1) || !isOpen(2))
      continue;
    std::vector<Eigen::Vector2d> corners;
    for (const int k : {0, 1, 2})
      corners.push_back(site.frame.toLocal(room.solid.corner(t, k).head<2>()));
    found.push_back({loopOf(corners)});
  }
  return found;
}

/** @brief Returns the plan of a wall in its frame, counter-clockwise: its band without
 * the rooms at its heights that reach behind its face, beside a niche or at a mitre,
 * and without their solids, which fill posts and slits that are narrower than the walls
 * around them are known. A wall that surrounds a room has a hole. Empty if nothing is
 * left: a face that no solid has is that of no wall. */
PlanArea
profileOf(const IfcDocument& document, const WallSite& site, double bottom)
{
  constexpr double rounding = 1e-5; // square metres
  const Floorplan& plan = document.plan;
  const PlanWall& wall = site.wall;
  std::vector<PlanArea> rooms;
  std::vector<PlanArea> bodies;
  for (const std::size_t r : site.near) {
    const IfcRoom& room = document.rooms[r];
    const bool is_beside = shareHeights(room.room, plan.rooms[wall.face.room]);
    if (const PlanArea area = site.areaOf(room.room);
        is_beside && commonArea(site.band, area) > rounding)
      rooms.push_back(area);
    if (is_beside || heightsOf(room.room).low <= bottom)
      for (const PlanArea& part : footprintOf(room, is_beside, plan, site))
        bodies.push_back(part);
  }
  const PlanArea profile =
      rooms.empty() ? site.band : largestPartOutside(site.band, rooms);
  const Eigen::AlignedBox2d box = boundsOf(profile.boundary);
  bodies.erase(std::remove_if(bodies.begin(), bodies.end(),
                              [&](const PlanArea& part) {
                                return !boundsOf(part.boundary).intersects(box);
                              }),
               bodies.end());
  if (isWithin(site, bodies))
    return {};
  // A solid has chords for arcs: what is between them is not taken.
  double taken = -no_area;
  if (elementOf(plan, wall.face).isArc())
    taken -= SolidParameters().chord_tolerance *
             (wall.stretch.length() +
              (wall.other ? elementOf(plan, *wall.other).length() : 0));
  for (const PlanArea& part : bodies)
    taken += commonArea(profile, part);
  return taken > 0 ? largestPartOutside(profile, bodies) : profile;
}

/** @brief Checks whether a face lies in another room, in part. */
bool
isInAnotherRoom(const Floorplan& plan, const WallFace& face)
{
  const PlanElement& element = elementOf(plan, face);
  const PlanRoom& own = plan.rooms[face.room];
  return std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& room) {
    const auto isInside = [&](double share) {
      constexpr double touching = 0.001; // metres
      const Eigen::Vector2d p = element.pointAt(share * element.length());
      return room.contains(p) && room.boundary.distance(p) > touching;
    };
    return room.id != own.id && shareHeights(room, own) &&
           (isInside(0.25) || isInside(0.5) || isInside(0.75));
  });
}

/** @brief Tells of each room which of its faces, longer than walls are thick, are of no
 * wall as they lie in other rooms. */
void
tellLostFaces(IfcDocument& document, const std::vector<PlanWall>& walls)
{
  const Floorplan& plan = document.plan;
  std::set<WallFace> known;
  for (const PlanWall& wall : walls) {
    known.insert(wall.face);
    if (wall.other)
      known.insert(*wall.other);
  }
  std::map<std::uint32_t, std::string> lost; // by room
  for (const WallFace& face : wallFaces(plan))
    if (known.count(face) == 0 &&
        elementOf(plan, face).length() > document.settings.max_wall &&
        isInAnotherRoom(plan, face)) {
      std::string& names = lost[plan.rooms[face.room].id];
      names += (names.empty() ? "" : ", ") + numberOf(plan, face);
    }
  for (const auto& [room, names] : lost)
    document.model.warnings.push_back(warningOf(
        WarningKind::IfcLoss,
        "no wall in the IFC for " + names + ": there the room overlaps another one", {},
        room));
}

} // namespace

std::vector<WrittenWall>
writeWalls(IfcDocument& document)
{
  const Floorplan& plan = document.plan;
  WallParameters parameters{document.settings.max_wall};
  parameters.assumed_thickness = document.settings.assumed_thickness;
  const std::vector<PlanWall> walls = findWalls(plan, parameters);
  tellLostFaces(document, walls);
  std::map<std::string, int> parts;
  std::vector<WrittenWall> written;
  for (const auto& [site, heights] : standingWalls(plan, walls)) {
    const PlanWall& wall = site.wall;
    if (heights.highest() - heights.bottom < min_wall_height)
      continue;
    WrittenWall added{{wall, site.frame, heights, runsOf(plan, wall),
                       profileOf(document, site, heights.bottom)},
                      faceName(plan, wall.face),
                      document.rooms[wall.face.room].storey};
    added.number = numberOf(plan, wall.face);
    const int part = ++parts[added.name];
    if (part > 1) {
      added.name += "_part_" + std::to_string(part);
      added.number += "-" + std::to_string(part);
    }
    added.is_external = isExternal(plan, wall);
    if (isWhollyOpen(plan, added))
      continue;
    const Eigen::Vector2d& origin = added.frame.origin;
    added.placement = document.shapes.placement(
        document.storeys[added.storey].placement,
        {origin.x(), origin.y(), heights.bottom - document.groundOf(added.storey)},
        added.frame.way);
    std::vector<StepRef> shapes{bodyOf(document, added)};
    if (!elementOf(plan, wall.face).isArc())
      shapes.push_back(
          document.shapes.line(document.axis_context, {0, -wall.thickness / 2},
                               {wall.stretch.length(), -wall.thickness / 2}));
    added.ref = document.addElement(
        "IFCWALL", added.name, added.storey, added.placement,
        document.shapes.product(shapes),
        {symbol(heights.isLevel() && added.runs.near == 0 && added.runs.far == 0
                    ? "STANDARD"
                    : "NOTDEFINED")},
        added.number);
    writeBoundaries(document, added);
    ++document.model.walls;
    document.model.paired_walls += wall.other ? 1 : 0;
    written.push_back(added);
  }
  return written;
}

void
describeWalls(IfcDocument& document, const std::vector<WrittenWall>& walls)
{
  for (const WrittenWall& wall : walls) {
    document.model.schedules.walls.push_back(rowOf(document, wall));
    describe(document, wall, document.model.schedules.walls.back());
  }
}

} // namespace pcl::sedr::ifc
