// SPDX-License-Identifier: BSD-3-Clause
#include "../walls/wall_band.h"
#include "ifc_bodies.h"
#include "ifc_parts.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr::ifc {
namespace {

/** @brief Returns what is between bottom and top of a niche that is not level, in the
 * frame of a wall, with z from its bottom. */
TriangleMesh
meshOf(const PlanNiche& niche, const PlanLoop& loop, const WallFrame& frame, double z)
{
  TriangleMesh foot = triangulated({loop}, {});
  const auto heightAt = [&](const PlanSlab& slab, const Eigen::Vector3d& p) {
    return slab.heightAt(frame.toPlan(p.head<2>())) - z;
  };
  for (Eigen::Vector3d& p : foot.vertices)
    p.z() = heightAt(niche.bottom, p);
  constexpr double min_height = 0.001;
  return prismOn(foot, [&](const Eigen::Vector3d& p) {
    return std::max(heightAt(niche.top, p), p.z() + min_height);
  });
}

/** @brief Returns whether a niche, such as a blind before a window makes one, lies in
 * a gap of its wall, up to the accuracy of both. */
bool
isInGap(const WrittenGap& gap, const PlanLoop& niche, double bottom, double top)
{
  constexpr double off = 0.05;
  Eigen::AlignedBox2d plan(gap.box.plan.min().array() - off,
                           gap.box.plan.max().array() + off);
  return plan.contains(boundsOf(inFrame(niche, gap.box.frame))) &&
         bottom > gap.box.bottom - off && top < gap.box.top + off;
}

/** @brief Adds recesses for niches, but for those within gaps of openings. */
void
writeNiches(IfcDocument& document,
            std::vector<WrittenWall>& walls,
            const std::vector<WrittenGap>& gaps)
{
  for (std::size_t r = 0; r < document.plan.rooms.size(); ++r) {
    const PlanRoom& room = document.plan.rooms[r];
    for (std::size_t n = 0; n < room.niches.size(); ++n) {
      const PlanNiche& niche = room.niches[n];
      const std::string own = "niche_" + std::to_string(n + 1);
      const std::string name = nameIn(room, own);
      const Eigen::Vector2d middle = boundsOf(niche.boundary).center();
      const double bottom = niche.bottom.heightAt(middle);
      const double height = niche.top.heightAt(middle) - bottom;
      const bool is_level = levelOf(niche.bottom, boundsOf(niche.boundary)) &&
                            levelOf(niche.top, boundsOf(niche.boundary));
      // A solid leaves out a niche without height or depth.
      const IfcRoom& written = document.rooms[r];
      const bool is_built =
          written.solid.empty() ||
          !written.trianglesOf({own + "_bottom", own + "_top"}).empty();
      std::size_t count = 0;
      for (WrittenWall& wall : walls) {
        const PlanLoop loop = inFrame(niche.boundary, wall.frame);
        if (!is_built || height <= 0 || bottom >= wall.top() ||
            bottom + height <= wall.bottom() ||
            commonArea(wall.profile, {loop}) <= no_area)
          continue;
        const double low = bottom - wall.bottom();
        if (std::any_of(gaps.begin(), gaps.end(), [&](const WrittenGap& gap) {
              return gap.wall == &wall && isInGap(gap, loop, low, low + height);
            })) {
          ++count;
          continue;
        }
        const std::string part = count == 0 ? "" : "_part_" + std::to_string(count + 1);
        writeOpening(document, wall, name + part,
                     is_level ? document.shapes.extrusion(loop, {}, low, height)
                              : document.shapes.faceSet(
                                    meshOf(niche, loop, wall.frame, wall.bottom())),
                     {loop, niche.bottom, niche.top, true});
        ++count;
      }
      if (count == 0)
        document.model.warnings.push_back(
            warningOf(WarningKind::IfcLoss, name + " is in no wall of the IFC"));
    }
  }
}

constexpr double overshoot = 0.1; ///< of an opening beyond both faces, metres
constexpr double beside = 0.15;   ///< of a wall, where an opening in it may lie, metres

/** @brief Returns the box of an opening across a wall: along a straight one, square to
 * its own chord through a curved one; false if it is not in this wall. */
bool
boxIn(const Floorplan& plan,
      const WrittenWall& written,
      const PlanOpening& opening,
      double reach,
      OpeningBox& box)
{
  constexpr double cosine = 0.86; // 30 degrees between opening and wall
  const PlanElement& element = elementOf(plan, written.wall.face);
  const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
  const Eigen::Vector2d way = (opening.end - opening.start).normalized();
  const auto [place, inward] = faceAt(element, element.project(middle));
  const double behind = -(middle - place).dot(inward);
  if (behind < -reach || behind > written.wall.thickness + reach ||
      std::abs(way.dot(inward)) > std::sqrt(1 - cosine * cosine))
    return false;
  constexpr double on_floor = 0.05; // a sill lower than that is none
  const double bottom = opening.bottom - written.bottom();
  box.bottom = bottom < on_floor ? 0 : bottom;
  box.top = opening.top - written.bottom();
  if (box.top - box.bottom < no_opening ||
      box.bottom >= written.top() - written.bottom())
    return false;
  const Eigen::Vector2d start = written.frame.toLocal(opening.start);
  const Eigen::Vector2d end = written.frame.toLocal(opening.end);
  if (element.isArc()) {
    const Eigen::Vector2d centre = written.frame.toLocal(element.centre);
    const Eigen::Vector2d chord = (end - start).normalized();
    box.frame = {centre, leftOf(chord).dot(start - centre) > 0 ? chord : -chord};
  }
  const double a = box.frame.toLocal(start).x();
  const double b = box.frame.toLocal(end).x();
  Eigen::AlignedBox2d across;
  if (element.isArc()) {
    const auto [inner, outer] =
        std::minmax({element.radius, farSideOf(plan, written.wall).radius});
    const double side = std::max(std::abs(a), std::abs(b));
    across.extend(
        Eigen::Vector2d(0, std::sqrt(std::max(inner * inner - side * side, 0.0))));
    across.extend(Eigen::Vector2d(0, outer));
  }
  else
    for (const Eigen::Vector2d& corner : written.wall.outline)
      across.extend(corner);
  const double taper = (written.runs.far - written.runs.near) * box.top;
  box.plan = Eigen::AlignedBox2d(
      Eigen::Vector2d(std::min(a, b),
                      across.min().y() + std::min(taper, 0.0) - overshoot),
      Eigen::Vector2d(std::max(a, b), across.max().y() + overshoot));
  return true;
}

/** @brief Adds an opening to all walls in which it lies, whatever rooms are told of it.
 * @return the gap in each */
std::vector<WrittenGap>
writeGaps(IfcDocument& document,
          std::vector<WrittenWall>& walls,
          const PlanOpening& opening,
          const std::string& name)
{
  constexpr double far = 0.5; // half of a wall thicker than those of two faces
  std::vector<WrittenGap> gaps;
  for (const double reach : {beside, far}) {
    for (WrittenWall& wall : walls) {
      OpeningBox box;
      if (!boxIn(document.plan, wall, opening, reach, box))
        continue;
      const PlanLoop plan = box.loop();
      if (commonArea(wall.profile, {plan}) <= no_opening * wall.wall.thickness)
        continue;
      const std::string part =
          gaps.empty() ? "" : "_part_" + std::to_string(gaps.size() + 1);
      const StepRef cut =
          writeOpening(document, wall, name + part,
                       document.shapes.extrusion(plan, {}, box.bottom,
                                                 box.top - box.bottom, wall.runs.near),
                       {plan, horizontalSlab(wall.bottom() + box.bottom),
                        horizontalSlab(wall.bottom() + box.top)});
      document.addQuantities(cut, name + part, "Qto_OpeningElementBaseQuantities",
                             {{"LENGTH", "Width", opening.width()},
                              {"LENGTH", "Height", opening.height()},
                              {"LENGTH", "Depth", wall.wall.thickness}});
      gaps.push_back({&wall, cut, box});
    }
    if (!gaps.empty())
      break;
  }
  return gaps;
}

const char*
operationOf(const PlanOpening& opening)
{
  const std::string leaf = leafOf(opening);
  return leaf == "double"  ? "DOUBLE_DOOR_SINGLE_SWING"
         : leaf == "left"  ? "SINGLE_SWING_LEFT"
         : leaf == "right" ? "SINGLE_SWING_RIGHT"
                           : "NOTDEFINED";
}

/** @brief Makes a door or window one of a type: one for each size, to a centimetre, and
 * hand.
 * @return the name of the type */
std::string
addToType(IfcDocument& document,
          const PlanOpening& opening,
          const std::string& kind,
          StepRef filling)
{
  const std::string leaf = leafOf(opening);
  const std::string name = kind + " " + decimalText(opening.width(), 2) + " x " +
                           decimalText(opening.height(), 2) +
                           (leaf.empty() ? "" : " " + leaf);
  if (kind == "Door")
    document.addToType("IFCDOORTYPE", name, filling,
                       {symbol("DOOR"), symbol(operationOf(opening)), none, none});
  else
    document.addToType("IFCWINDOWTYPE", name, filling,
                       {symbol("WINDOW"), symbol("NOTDEFINED"), none, none});
  return name;
}

void
describe(IfcDocument& document,
         const PlanOpening& opening,
         const WrittenWall& wall,
         StepRef filling)
{
  const std::string kind = opening.kind == OpeningKind::Door ? "Door" : "Window";
  const std::string mark = markOf(opening);
  const std::string type = addToType(document, opening, kind, filling);
  const double width = opening.width();
  const double height = opening.height();
  document.addQuantities(filling, mark, "Qto_" + kind + "BaseQuantities",
                         {{"LENGTH", "Width", width},
                          {"LENGTH", "Height", height},
                          {"LENGTH", "Perimeter", 2 * (width + height)},
                          {"AREA", "Area", width * height}});
  const bool is_external = wall.is_external && opening.leadsOutside();
  document.addProperties(filling, mark, "Pset_" + kind + "Common",
                         {{"Reference", typed("IFCIDENTIFIER", type)},
                          {"IsExternal", typed("IFCBOOLEAN", logical(is_external))}});
  std::vector<Property> properties{
      {"Confidence", shareProperty(opening.confidence)},
      {"SillHeight",
       typed("IFCLENGTHMEASURE", rounded(sillOf(document.plan, opening)))}};
  if (const std::string claim = widthIs(opening); !claim.empty())
    properties.emplace_back("WidthIs", typed("IFCLABEL", claim));
  if (opening.widthError() > 0)
    properties.emplace_back("WidthError",
                            typed("IFCLENGTHMEASURE", opening.widthError()));
  appendAccuracy(accuracyOf(opening), properties);
  document.addProperties(filling, mark, "Pset_SEDR", properties);
}

/** @brief Fills the gap of a door or window in the middle of its wall. By IFC, a door
 * opens towards the y axis of its placement, and its hinges are told looking that way.
 */
void
writeFilling(IfcDocument& document, const PlanOpening& opening, const WrittenGap& gap)
{
  constexpr double thickness = 0.05;
  const bool is_door = opening.kind == OpeningKind::Door;
  if (!is_door && opening.kind != OpeningKind::Window)
    return;
  const WrittenWall& wall = *gap.wall;
  const OpeningBox& box = gap.box;
  const std::vector<OpeningLeaf> leaves = leavesOf(opening);
  const auto across = [&](const Eigen::Vector2d& p) {
    return box.frame.toLocal(wall.frame.toLocal(p)).y();
  };
  const bool is_turned =
      !leaves.empty() && across(leaves[0].open) < across(leaves[0].hinge);
  const double sign = is_turned ? -1 : 1;
  const Eigen::Vector2d middle = box.frame.toPlan(box.plan.center());
  const Eigen::Vector2d half(box.plan.sizes().x() / 2, thickness / 2);
  const StepRef place = document.shapes.placement(
      wall.placement, {middle.x(), middle.y(), 0}, sign * box.frame.way);
  const IfcBody body =
      document.shapes.extrusion(loopAround({-half, half}), {}, box.bottom,
                                box.top - box.bottom, sign * wall.runs.near);
  const std::string mark = markOf(opening);
  const StepRef filling = document.addElement(
      is_door ? "IFCDOOR" : "IFCWINDOW", mark, wall.storey, place,
      document.shapeOf(body, "opening"),
      {rounded(opening.height()), rounded(opening.width()),
       symbol(is_door ? "DOOR" : "WINDOW"), symbol(operationOf(opening)), none},
      mark);
  document.relate("IFCRELFILLSELEMENT", mark + " in its opening", gap.opening, filling);
  describe(document, opening, wall, filling);
}

/** @brief Returns whether the opening is at the boundary of both of its rooms. */
bool
joinsRooms(const Floorplan& plan, const PlanOpening& opening)
{
  constexpr double near = 0.5;
  const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
  return std::count_if(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& room) {
           double distance = room.boundary.distance(middle);
           for (const PlanLoop& column : room.columns)
             distance = std::min(distance, column.distance(middle));
           return (room.id == opening.rooms[0] || room.id == opening.rooms[1]) &&
                  distance < near;
         }) == 2;
}

/** @brief Adds a virtual element between rooms that meet without a wall.
 * @return whether they do at the opening */
bool
writePassage(IfcDocument& document, const PlanOpening& opening, const std::string& name)
{
  if (!joinsRooms(document.plan, opening))
    return false;
  StepRef element;
  for (std::size_t r = 0; r < document.rooms.size(); ++r) {
    const PlanRoom& room = document.rooms[r].room;
    if (room.id != opening.rooms[0] && room.id != opening.rooms[1])
      continue;
    const std::size_t storey = document.rooms[r].storey;
    if (element.isNone())
      element = document.addElement("IFCVIRTUALELEMENT", name, storey,
                                    document.placeIn(storey), {}, {});
    writeBoundary(document, r, name, element, "INTERNAL", "VIRTUAL");
  }
  return true;
}

} // namespace

StepRef
writeOpening(IfcDocument& document,
             WrittenWall& wall,
             const std::string& name,
             const IfcBody& body,
             const WallCut& cut)
{
  const StepRef frame = document.shapes.axes(Eigen::Vector3d::Zero());
  const StepRef place = document.step.add("IFCLOCALPLACEMENT", {wall.placement, frame});
  const StepRef shape = document.shapeOf(body, "opening");
  const StepRef opening = document.step.add(
      "IFCOPENINGELEMENT", {document.guid(name), none, name, none, none, place, shape,
                            none, symbol(cut.is_recess ? "RECESS" : "OPENING")});
  wall.cuts.push_back(cut);
  document.relate("IFCRELVOIDSELEMENT", name + " in " + wall.name, wall.ref, opening);
  ++document.model.openings;
  return opening;
}

bool
isWhollyOpen(const Floorplan& plan, const WrittenWall& wall)
{
  const PlanLoop& profile = wall.profile.boundary;
  if (profile.elements.empty() || std::abs(profile.area()) < no_area)
    return true;
  return std::any_of(
      plan.openings.begin(), plan.openings.end(), [&](const PlanOpening& opening) {
        OpeningBox box;
        return boxIn(plan, wall, opening, beside, box) && box.bottom <= 0 &&
               box.top >= wall.top() - wall.bottom() - min_wall_height &&
               std::abs(
                   largestPartOutside(wall.profile, {{box.loop()}}).boundary.area()) <
                   no_area;
      });
}

void
writeOpenings(IfcDocument& document, std::vector<WrittenWall>& walls)
{
  const Floorplan& plan = document.plan;
  std::vector<WrittenGap> all;
  std::string outside; // numbers of openings in no wall
  double count = 0;    // of these
  for (const PlanOpening& opening : plan.openings) {
    const std::string name = "opening_" + markOf(opening);
    const std::vector<WrittenGap> gaps = writeGaps(document, walls, opening, name);
    all.insert(all.end(), gaps.begin(), gaps.end());
    if (!gaps.empty())
      writeFilling(document, opening, gaps.front());
    else if (!writePassage(document, opening, name)) {
      outside += (outside.empty() ? "" : ", ") + markOf(opening);
      ++count;
    }
  }
  document.model.schedules.openings = openingRows(plan);
  if (!outside.empty())
    document.model.warnings.push_back(
        warningOf(WarningKind::NotInIfc, outside,
                  {count, static_cast<double>(plan.openings.size())}));
  writeNiches(document, walls, all);
}

} // namespace pcl::sedr::ifc
