// SPDX-License-Identifier: BSD-3-Clause
#include "plan_walls.h"

#include "../plan/plan_geometry.h"

#include "../base/quantiles.h"
#include "../grids/place_table.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace pcl::sedr {
namespace {

constexpr double touching = 1e-6; ///< metres; ends within this distance coincide

/** @brief Finds the walls of a plan. */
class WallFinder {
public:
  WallFinder(const Floorplan& plan, const WallParameters& parameters)
      : plan_(plan)
      , parameters_(parameters)
      , rooms_near_(room_size)
  {
    for (std::size_t r = 0; r < plan.rooms.size(); ++r)
      rooms_near_.addIn(boundsOf(plan.rooms[r].boundary),
                        static_cast<std::uint32_t>(r));
    rooms_near_.finish();
    readReveals();
  }

  std::vector<PlanWall> find()
  {
    FacePairs pairs = pairFaces(plan_, parameters_);
    walls_ = std::move(pairs.walls);
    for (const PlanWall& free : pairs.free)
      if (!continueWall(free))
        addSingle(free);
    for (PlanWall& wall : walls_)
      if (!elementOf(plan_, wall.face).isArc())
        wall.outline = squareOutline(wall);
    cutMitres();
    return std::move(walls_);
  }

private:
  static constexpr double room_size = 4; // metres

  /** @brief Extends a wall of two faces over a short remainder of one of them. */
  bool continueWall(const PlanWall& free)
  {
    constexpr double longest = 0.7;
    const PlanElement& element = elementOf(plan_, free.face);
    if (free.stretch.length() > longest || element.isArc())
      return false;
    for (PlanWall& wall : walls_) {
      if (!wall.other || (!(wall.face == free.face) && !(*wall.other == free.face)))
        continue;
      const WallFrame frame{elementOf(plan_, wall.face).start,
                            frameOf(plan_, wall).way};
      double from = frame.toLocal(faceAt(element, free.stretch.from).first).x();
      double to = frame.toLocal(faceAt(element, free.stretch.to).first).x();
      if (from > to)
        std::swap(from, to);
      constexpr double beside = 0.02; // metres; faces may not be exactly parallel
      if (std::abs(from - wall.stretch.to) < beside)
        wall.stretch.to = to;
      else if (std::abs(to - wall.stretch.from) < beside)
        wall.stretch.from = from;
      else
        continue;
      return true;
    }
    return false;
  }

  /** @brief Finds the deepest reveal of each wall that leads outside, and the usual one
   * of each storey. */
  void readReveals()
  {
    std::map<std::uint32_t, std::vector<double>> of_storey;
    for (const PlanOpening& opening : plan_.openings)
      if (opening.leadsOutside() && opening.hasSeenReveals())
        for (const OpeningWall& wall : opening.walls) {
          double& deepest = reveals_[{wall.room, wall.element}];
          deepest = std::max(deepest, opening.depth);
        }
    if (reveals_.empty())
      return;
    storey_of_ = storeyOfRooms(plan_);
    for (const auto& [wall, depth] : reveals_)
      of_storey[storey_of_[wall.first]].push_back(depth);
    for (auto& [storey, depths] : of_storey)
      usual_reveal_[storey] = middleValue(depths);
  }

  /** @brief Returns a wall of one face, with the thickness that reveals show. */
  PlanWall withThickness(const PlanWall& free) const
  {
    PlanWall wall{free.face, std::nullopt, free.stretch, parameters_.assumed_thickness,
                  ThicknessSource::Assumed};
    const std::uint32_t room = plan_.rooms[free.face.room].id;
    const auto storey = storey_of_.find(room);
    const auto usual = storey == storey_of_.end() ? usual_reveal_.end()
                                                  : usual_reveal_.find(storey->second);
    if (usual == usual_reveal_.end())
      return wall;
    const auto own =
        free.face.loop == 0 ? reveals_.find({room, free.face.element}) : reveals_.end();
    const bool is_own = own != reveals_.end() && own->second >= usual->second;
    wall.thickness = is_own ? own->second : usual->second;
    wall.source = is_own ? ThicknessSource::Reveals : ThicknessSource::Storey;
    return wall;
  }

  /** @brief Adds a wall of one face, thinner if another room is near. */
  void addSingle(const PlanWall& free)
  {
    PlanWall wall = withThickness(free);
    const double thinnest = std::max(parameters_.min_thickness,
                                     parameters_.min_assumed_share * wall.thickness);
    while (wall.thickness >= thinnest && reachesRoom(free, wall.thickness)) {
      wall.thickness /= 2;
      wall.source = ThicknessSource::Assumed;
    }
    if (wall.thickness >= thinnest)
      walls_.push_back(wall);
  }

  bool reachesRoom(const PlanWall& free, double thickness) const
  {
    constexpr int samples = 9;
    const PlanRoom& own = plan_.rooms[free.face.room];
    for (int i = 0; i < samples; ++i) {
      const auto [place, inward] =
          faceAt(elementOf(plan_, free.face),
                 free.stretch.from + free.stretch.length() * (i + 0.5) / samples);
      const Eigen::Vector2d behind = place - thickness * inward;
      for (const std::uint32_t r : rooms_near_.at(behind))
        if (plan_.rooms[r].contains(behind) && shareHeights(plan_.rooms[r], own))
          return true;
    }
    return false;
  }

  std::array<Eigen::Vector2d, 4> squareOutline(const PlanWall& wall) const
  {
    const double length = wall.stretch.length();
    double at_start = -wall.thickness;
    double at_end = -wall.thickness;
    if (wall.other) { // parallel to the other face
      const PlanElement& other = elementOf(plan_, *wall.other);
      const WallFrame frame = frameOf(plan_, wall);
      const Eigen::Vector2d a = frame.toLocal(other.start);
      const Eigen::Vector2d b = frame.toLocal(other.end);
      const double slope = (b.y() - a.y()) / (b.x() - a.x());
      at_start = std::min(a.y() - slope * a.x(), -parameters_.min_thickness / 2);
      at_end = std::min(at_start + slope * length, -parameters_.min_thickness / 2);
    }
    return {{{0, 0}, {length, 0}, {length, at_end}, {0, at_start}}};
  }

  /** @brief Returns the straight wall of a face that reaches the end (start) of the
   * face's element; null if there is none. */
  PlanWall* wallAtCorner(const WallFace& face, bool is_end)
  {
    const PlanElement& element = elementOf(plan_, face);
    if (element.isArc())
      return nullptr;
    for (PlanWall& wall : walls_)
      if (wall.face == face &&
          (is_end ? element.length() - wall.stretch.to : wall.stretch.from) < touching)
        return &wall;
    return nullptr;
  }

  void cutMitres()
  {
    for (const WallFace& face : wallFaces(plan_)) {
      WallFace next = face;
      next.element = (face.element + 1) % wallLoop(plan_, face).elements.size();
      PlanWall* before = wallAtCorner(face, true);
      PlanWall* after = wallAtCorner(next, false);
      if (before && after && before != after)
        cutMitre(*before, *after);
    }
  }

  /** @brief Joins the far sides of two walls, unless they are nearly parallel or one is
   * too short. */
  void cutMitre(PlanWall& before, PlanWall& after)
  {
    const WallFrame f = frameOf(plan_, before);
    const WallFrame g = frameOf(plan_, after);
    const Eigen::Vector2d p = f.toPlan(before.outline[2]);
    const Eigen::Vector2d u = p - f.toPlan(before.outline[3]);
    const Eigen::Vector2d q = g.toPlan(after.outline[3]);
    const Eigen::Vector2d v = g.toPlan(after.outline[2]) - q;
    const double across = u.x() * v.y() - u.y() * v.x();
    constexpr double min_sine = 0.17; // 10 degrees
    if (std::abs(across) < min_sine * u.norm() * v.norm())
      return;
    const Eigen::Vector2d w = q - p;
    const Eigen::Vector2d corner = p + u * ((w.x() * v.y() - w.y() * v.x()) / across);
    const Eigen::Vector2d at_end = f.toLocal(corner);
    const Eigen::Vector2d at_start = g.toLocal(corner);
    const double most = 2 * std::max(before.thickness, after.thickness);
    if (std::abs(at_end.x() - before.outline[1].x()) > most ||
        std::abs(at_start.x()) > most ||
        at_end.x() < before.outline[3].x() + touching ||
        at_start.x() > after.outline[2].x() - touching)
      return;
    before.outline[2] = at_end;
    after.outline[3] = at_start;
  }

  const Floorplan& plan_;
  WallParameters parameters_;
  PlaceTable rooms_near_;
  std::map<std::pair<std::uint32_t, std::size_t>, double>
      reveals_; ///< deepest, by room and element
  std::map<std::uint32_t, std::uint32_t> storey_of_;
  std::map<std::uint32_t, double> usual_reveal_; ///< by storey
  std::vector<PlanWall> walls_;
};

} // namespace

bool
isIsland(const PlanRoom& room, const PlanLoop& column)
{
  constexpr double max_widths = 4; // that a column is deep
  constexpr double min_depths = 3; // that it is high
  const std::vector<Eigen::Vector2d> corners = column.polygon(0.01);
  if (corners.size() < 3)
    return false;
  Eigen::Vector2d sides = Eigen::Vector2d::Constant(1e9);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector2d way = corners[(k + 1) % corners.size()] - corners[k];
    if (way.norm() < touching)
      continue;
    const Eigen::Rotation2Dd turn(-std::atan2(way.y(), way.x()));
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& corner : corners)
      box.extend(turn * corner);
    if (box.volume() < sides.prod())
      sides = box.sizes();
  }
  const Eigen::Vector2d& foot = corners.front();
  const double height = room.ceilingAt(foot) - room.floorAt(foot);
  return sides.maxCoeff() > max_widths * sides.minCoeff() ||
         height < min_depths * sides.maxCoeff();
}

std::vector<PlanLoop>
wallLoops(const PlanRoom& room)
{
  std::vector<PlanLoop> loops{room.boundary};
  std::copy_if(room.columns.begin(), room.columns.end(), std::back_inserter(loops),
               [&](const PlanLoop& column) { return isIsland(room, column); });
  return loops;
}

const PlanLoop&
wallLoop(const Floorplan& plan, const WallFace& face)
{
  const PlanRoom& room = plan.rooms[face.room];
  return face.loop == 0 ? room.boundary : room.columns[face.loop - 1];
}

const PlanElement&
elementOf(const Floorplan& plan, const WallFace& face)
{
  return wallLoop(plan, face).elements[face.element];
}

bool
isGuess(const Floorplan& plan, const WallFace& face)
{
  return face.loop == 0 &&
         wallShares(plan, plan.rooms[face.room], face.element).isGuess();
}

std::vector<WallFace>
wallFaces(const Floorplan& plan)
{
  std::vector<WallFace> faces;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    for (std::size_t l = 0; l <= plan.rooms[r].columns.size(); ++l)
      if (l == 0 || isIsland(plan.rooms[r], plan.rooms[r].columns[l - 1]))
        for (std::size_t e = 0; e < wallLoop(plan, {r, 0, l}).elements.size(); ++e)
          faces.push_back({r, e, l});
  return faces;
}

std::pair<Eigen::Vector2d, Eigen::Vector2d>
faceAt(const PlanElement& element, double s)
{
  if (element.isArc())
    return {element.pointAt(s), element.normalAt(s)};
  const Eigen::Vector2d way = (element.end - element.start).normalized();
  return {element.start + s * way, {-way.y(), way.x()}};
}

WallFrame
frameOf(const Floorplan& plan, const PlanWall& wall)
{
  const PlanElement& element = elementOf(plan, wall.face);
  const Eigen::Vector2d origin = faceAt(element, wall.stretch.from).first;
  const Eigen::Vector2d chord = faceAt(element, wall.stretch.to).first - origin;
  return {origin, chord.norm() > touching ? Eigen::Vector2d(chord.normalized())
                                          : Eigen::Vector2d(1, 0)};
}

std::vector<PlanWall>
findWalls(const Floorplan& plan, const WallParameters& parameters)
{
  return WallFinder(plan, parameters).find();
}

} // namespace pcl::sedr
