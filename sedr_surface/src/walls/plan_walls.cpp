// SPDX-License-Identifier: BSD-3-Clause
#include "plan_walls.h"

#include "sedr_filters/src/plan/plan_bounds.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/wall_shares.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace pcl::sedr {
namespace {

constexpr double touching = 1e-6; ///< metres; ends within this distance coincide

constexpr double shortest = 0.05;         ///< length of a wall, metres
constexpr double cosine_parallel = 0.996; ///< 5 degrees
constexpr double one_centre = 0.1; ///< distance of centres of concentric arcs, metres

/** @brief Computes the distance of a parallel face behind a straight one, and the
 * stretch of the latter in front of it. */
bool
straightBehind(const PlanElement& face,
               const PlanElement& other,
               Stretch& stretch,
               double& distance)
{
  const double length = face.length();
  const Eigen::Vector2d way = (face.end - face.start) / length;
  const Eigen::Vector2d other_way = (other.end - other.start) / other.length();
  if (way.dot(other_way) > -cosine_parallel)
    return false;
  const WallFrame frame{face.start, way};
  const Eigen::Vector2d a = frame.toLocal(other.end); // in the opposite direction
  const Eigen::Vector2d b = frame.toLocal(other.start);
  stretch = {std::max(0.0, a.x()), std::min(length, b.x())};
  if (stretch.length() < shortest)
    return false;
  distance = -(a.y() + (stretch.middle() - a.x()) * (b.y() - a.y()) / (b.x() - a.x()));
  return true;
}

/** @brief As above, for concentric arcs. */
bool
arcBehind(const PlanElement& face,
          const PlanElement& other,
          Stretch& stretch,
          double& distance)
{
  if ((face.centre - other.centre).norm() > one_centre ||
      face.counter_clockwise == other.counter_clockwise)
    return false;
  distance =
      face.counter_clockwise ? other.radius - face.radius : face.radius - other.radius;
  // The longest run of samples opposite the other arc.
  constexpr double step = 0.01;
  constexpr std::size_t most = 5000;
  const double length = face.length();
  const auto n =
      std::clamp<std::size_t>(static_cast<std::size_t>(length / step), 8, most);
  const double each = length / static_cast<double>(n);
  Stretch run;
  stretch = {};
  for (std::size_t i = 0; i < n; ++i) {
    const double from = each * static_cast<double>(i);
    if (!other.isBeside(face.pointAt(from + each / 2)))
      continue;
    if (run.length() > 0 && std::abs(run.to - from) < each / 2)
      run.to = from + each;
    else
      run = {from, from + each};
    if (run.length() > stretch.length())
      stretch = run;
  }
  return stretch.length() >= shortest;
}

/** @brief Removes a stretch from stretches; remainders shorter than a millimetre are
 * dropped. */
void
cutOut(std::vector<Stretch>& free, const Stretch& taken)
{
  constexpr double nothing = 0.001;
  std::vector<Stretch> rest;
  for (const Stretch& s : free) {
    const Stretch before{s.from, std::min(s.to, taken.from)};
    const Stretch after{std::max(s.from, taken.to), s.to};
    for (const Stretch& part : {before, after})
      if (part.length() > nothing)
        rest.push_back(part);
  }
  free = std::move(rest);
}

/** @brief Pairs the faces of a plan that are the two sides of one wall. */
class FacePairs {
public:
  FacePairs(const Floorplan& plan, const WallParameters& parameters)
      : plan_(plan)
      , parameters_(parameters)
  {
    const std::vector<WallFace> faces = wallFaces(plan);
    const double reach =
        std::max(parameters.max_thickness, parameters.max_depth_of_doorway);
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const PlanRoom& room : plan.rooms)
      boxes.push_back(boundsOf(room.boundary));
    for (const WallFace& face : faces)
      free_[face] = {{0, elementOf(plan, face).length()}};
    for (auto face = faces.begin(); face != faces.end(); ++face)
      for (auto other = face + 1; other != faces.end(); ++other)
        if (face->room == other->room ||
            (boxes[face->room].exteriorDistance(boxes[other->room]) <= reach &&
             shareHeights(plan.rooms[face->room], plan.rooms[other->room])))
          consider(*face, *other);
    pairNearestFirst();
  }

  /** @brief Returns the pairs with a wall between them. */
  const std::vector<PlanWall>& walls() const { return walls_; }

  /** @brief Returns the unpaired stretches, in the order of the faces. */
  std::vector<PlanWall> freeFaces() const
  {
    std::vector<PlanWall> faces;
    for (const auto& [face, stretches] : free_)
      for (const Stretch& stretch : stretches)
        if (stretch.length() >= shortest / 2)
          faces.push_back({face, std::nullopt, stretch});
    return faces;
  }

private:
  void consider(const WallFace& face, const WallFace& other)
  {
    const PlanElement& a = elementOf(plan_, face);
    const PlanElement& b = elementOf(plan_, other);
    if (a.isArc() != b.isArc() || a.length() < shortest || b.length() < shortest)
      return;
    PlanWall pair{face, other, {}, 0};
    const bool is_behind = a.isArc()
                               ? arcBehind(a, b, pair.stretch, pair.thickness)
                               : straightBehind(a, b, pair.stretch, pair.thickness);
    // Faces fitted independently may overlap by up to the minimum thickness.
    if (is_behind && pair.thickness > -parameters_.min_thickness &&
        (pair.thickness <= parameters_.max_thickness ||
         (pair.thickness <= parameters_.max_depth_of_doorway && isOpen(pair))))
      candidates_.push_back(pair);
  }

  /** @brief Returns whether a doorway leads from one face of a pair to the other. */
  bool isOpen(const PlanWall& pair) const
  {
    const PlanElement& face = elementOf(plan_, pair.face);
    const std::uint32_t near = plan_.rooms[pair.face.room].id;
    const std::uint32_t far = plan_.rooms[pair.other->room].id;
    return std::any_of(
        plan_.doorways.begin(), plan_.doorways.end(), [&](const PlanDoorway& doorway) {
          const Eigen::Vector2d middle = (doorway.start + doorway.end) / 2;
          const double s = face.project(middle);
          const auto [place, inward] = faceAt(face, s);
          const double behind = (place - middle).dot(inward);
          const bool joins_both =
              doorway.rooms[0] == near
                  ? doorway.rooms[1] == far
                  : doorway.rooms[0] == far && doorway.rooms[1] == near;
          return joins_both && s > pair.stretch.from && s < pair.stretch.to &&
                 behind >= 0 && behind <= pair.thickness;
        });
  }

  void pairNearestFirst()
  {
    std::stable_sort(
        candidates_.begin(), candidates_.end(),
        [](const PlanWall& a, const PlanWall& b) { return a.thickness < b.thickness; });
    for (const PlanWall& candidate : candidates_)
      take(candidate);
    std::stable_sort(
        walls_.begin(), walls_.end(),
        [](const PlanWall& a, const PlanWall& b) { return a.face < b.face; });
  }

  /** @brief Maps a stretch of a face to the other face. */
  Stretch mapped(const WallFace& from, const Stretch& stretch, const WallFace& to) const
  {
    const PlanElement& a = elementOf(plan_, from);
    const PlanElement& b = elementOf(plan_, to);
    const double p = b.project(faceAt(a, stretch.from).first);
    const double q = b.project(faceAt(a, stretch.to).first);
    return {std::min(p, q), std::max(p, q)};
  }

  /** @brief Pairs the free parts of a stretch of both faces. */
  void take(const PlanWall& candidate)
  {
    const std::vector<Stretch> free = free_[candidate.face];
    const std::vector<Stretch> free_behind = free_[*candidate.other];
    for (const Stretch& here : free)
      for (const Stretch& there : free_behind) {
        const Stretch behind = mapped(*candidate.other, there, candidate.face);
        Stretch common{std::max({here.from, behind.from, candidate.stretch.from}),
                       std::min({here.to, behind.to, candidate.stretch.to})};
        if (common.length() < shortest)
          continue;
        // Faces fitted independently do not end exactly at the same place.
        if (common.from - here.from < shortest)
          common.from = here.from;
        if (here.to - common.to < shortest)
          common.to = here.to;
        if (candidate.thickness >= parameters_.min_thickness) {
          walls_.push_back(candidate);
          walls_.back().stretch = common;
        }
        cutOut(free_[candidate.face], common);
        cutOut(free_[*candidate.other],
               mapped(candidate.face, common, *candidate.other));
      }
  }

  const Floorplan& plan_;
  WallParameters parameters_;
  std::map<WallFace, std::vector<Stretch>> free_; ///< stretches without a wall yet
  std::vector<PlanWall> candidates_;
  std::vector<PlanWall> walls_;
};

/** @brief Finds the walls of a plan. */
class WallFinder {
public:
  WallFinder(const Floorplan& plan, const WallParameters& parameters)
      : plan_(plan)
      , parameters_(parameters)
  {}

  std::vector<PlanWall> find()
  {
    FacePairs pairs(plan_, parameters_);
    walls_ = pairs.walls();
    for (const PlanWall& free : pairs.freeFaces())
      if (!continueWall(free))
        addAssumed(free);
    for (PlanWall& wall : walls_)
      if (!elementOf(plan_, wall.face).isArc())
        wall.outline = squareOutline(wall);
    cutMitres();
    return std::move(walls_);
  }

private:
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

  /** @brief Adds a wall of the assumed thickness, or thinner if another room is
   * near. */
  void addAssumed(const PlanWall& free)
  {
    double thickness = parameters_.assumed_thickness;
    const double thinnest =
        std::max(parameters_.min_thickness, parameters_.min_assumed_share * thickness);
    while (thickness >= thinnest && reachesRoom(free, thickness))
      thickness /= 2;
    if (thickness >= thinnest)
      walls_.push_back({free.face, std::nullopt, free.stretch, thickness});
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
      for (const PlanRoom& room : plan_.rooms)
        if (shareHeights(room, own) && room.contains(behind))
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
