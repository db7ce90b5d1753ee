// SPDX-License-Identifier: BSD-3-Clause
#include "plan_walls.h"

#include "../plan/plan_geometry.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::sedr {
namespace {

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
class FacePairing {
public:
  FacePairing(const Floorplan& plan, const WallParameters& parameters)
      : plan_(plan)
      , parameters_(parameters)
  {
    const std::vector<WallFace> faces = wallFaces(plan);
    const double reach =
        std::max(parameters.max_thickness, parameters.max_depth_at_opening);
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
         (pair.thickness <= parameters_.max_depth_at_opening && isOpen(pair))))
      candidates_.push_back(pair);
  }

  /** @brief Returns whether an opening leads from one face of a pair to the other. */
  bool isOpen(const PlanWall& pair) const
  {
    const PlanElement& face = elementOf(plan_, pair.face);
    const std::uint32_t near = plan_.rooms[pair.face.room].id;
    const std::uint32_t far = plan_.rooms[pair.other->room].id;
    return std::any_of(
        plan_.openings.begin(), plan_.openings.end(), [&](const PlanOpening& opening) {
          const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
          const double s = face.project(middle);
          const auto [place, inward] = faceAt(face, s);
          const double behind = (place - middle).dot(inward);
          const bool joins_both =
              opening.rooms[0] == near
                  ? opening.rooms[1] == far
                  : opening.rooms[0] == far && opening.rooms[1] == near;
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
        if (parameters_.with_touching ||
            candidate.thickness >= parameters_.min_thickness) {
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

} // namespace

FacePairs
pairFaces(const Floorplan& plan, const WallParameters& parameters)
{
  const FacePairing pairs(plan, parameters);
  return {pairs.walls(), pairs.freeFaces()};
}

std::vector<std::vector<double>>
wallThicknesses(const Floorplan& plan, double max_wall)
{
  std::map<WallFace, PlanWall> longest;
  for (const PlanWall& wall : pairFaces(plan, {max_wall}).walls)
    for (const WallFace& face : {wall.face, *wall.other})
      if (wall.stretch.length() > longest[face].stretch.length())
        longest[face] = wall;
  std::vector<std::vector<double>> thicknesses;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    thicknesses.emplace_back();
    for (std::size_t e = 0; e < plan.rooms[r].boundary.elements.size(); ++e)
      thicknesses.back().push_back(longest[{r, e, 0}].thickness);
  }
  return thicknesses;
}

} // namespace pcl::sedr
