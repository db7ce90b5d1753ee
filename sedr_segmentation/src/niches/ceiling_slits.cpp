// SPDX-License-Identifier: BSD-3-Clause
#include "slit_faces.h"

#include "ceiling_slits.h"

#include "../curves/plan_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double parallel = 0.98;  ///< minimum cosine: 11 degrees
constexpr double same_wall = 0.06; ///< maximum offset of collinear walls, metres

/** @brief Maximum number of sides of furniture at a wall. */
constexpr std::size_t max_sides = 5;

/** @brief Sides of an outline, or a column, that may belong to furniture. */
struct Suspect {
  PlanRoom* room = nullptr;
  std::vector<PlanElement> sides;
  bool is_column = false;
  std::vector<SlitFace> faces;
};

Eigen::Vector2d
wayOf(const PlanElement& e)
{
  return (e.end - e.start).normalized();
}

Eigen::Vector2d
leftOf(const Eigen::Vector2d& way)
{
  return {-way.y(), way.x()};
}

const PlanElement&
elementAt(const PlanLoop& loop, std::size_t i)
{
  return loop.elements[i % loop.elements.size()];
}

/** @brief Returns whether the `count` sides from `first` outline furniture at a wall.
 * They start perpendicular to the wall before them and return to that wall, or to the
 * one around its corner. */
bool
standsBefore(const PlanLoop& loop,
             std::size_t first,
             std::size_t count,
             const Priors& priors)
{
  const std::size_t n = loop.elements.size();
  if (n < count + 2)
    return false;
  for (std::size_t k = 0; k < count + 2; ++k)
    if (elementAt(loop, first + n - 1 + k).isArc())
      return false;
  const PlanElement& before = elementAt(loop, first + n - 1);
  const PlanElement& after = elementAt(loop, first + count);
  const Eigen::Vector2d along = wayOf(before);
  const Eigen::Vector2d inwards = leftOf(along);
  const Eigen::Vector2d last = wayOf(elementAt(loop, first + count - 1));
  if (wayOf(elementAt(loop, first)).dot(inwards) < parallel)
    return false;
  Eigen::Array2d high = Eigen::Array2d::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector2d to = elementAt(loop, first + k).end - before.end;
    high = high.max(Eigen::Array2d(along.dot(to), inwards.dot(to)));
  }
  if (high.minCoeff() < priors.min_furniture_depth ||
      high.maxCoeff() > priors.max_furniture_length)
    return false;
  if (wayOf(after).dot(along) > parallel)
    return high.y() <= priors.max_furniture_depth && last.dot(inwards) < -parallel &&
           std::abs(inwards.dot(after.start - before.end)) < same_wall;
  return high.minCoeff() <= priors.max_furniture_depth && last.dot(along) > parallel &&
         wayOf(after).dot(inwards) > parallel;
}

Suspect
suspectOf(PlanRoom& room,
          std::vector<PlanElement> sides,
          bool is_column,
          const Priors& priors)
{
  Suspect suspect{&room, std::move(sides), is_column, {}};
  for (const PlanElement& side : suspect.sides)
    suspect.faces.emplace_back(room, side, priors);
  return suspect;
}

std::vector<Suspect>
suspectsOf(Floorplan& plan, const Priors& priors)
{
  std::vector<Suspect> suspects;
  for (PlanRoom& room : plan.rooms) {
    for (std::size_t i = 0; i < room.boundary.elements.size(); ++i)
      for (std::size_t count = max_sides; count >= 2; --count) { // longest first
        if (!standsBefore(room.boundary, i, count, priors))
          continue;
        std::vector<PlanElement> sides;
        for (std::size_t k = 0; k < count; ++k)
          sides.push_back(elementAt(room.boundary, i + k));
        suspects.push_back(suspectOf(room, std::move(sides), false, priors));
      }
    for (const PlanLoop& column : room.columns)
      if (!column.elements.empty())
        suspects.push_back(suspectOf(room, column.elements, true, priors));
  }
  return suspects;
}

/** @brief Returns whether a slit was seen above at least half of the sides, and no side
 * reaches the ceiling. */
bool
isBelowSlit(const Suspect& suspect)
{
  double slit = 0;
  double length = 0;
  for (const SlitFace& face : suspect.faces) {
    const SlitFace::Top top = face.top();
    if (top == SlitFace::Top::Ceiling)
      return false;
    length += face.length();
    slit += top == SlitFace::Top::Slit ? face.length() : 0;
  }
  return slit >= length / 2;
}

bool
isSame(const PlanElement& a, const PlanElement& b)
{
  return a.start == b.start && a.end == b.end;
}

/** @brief Removes `count` sides from `first` of an outline: joins the walls on both
 * sides, or intersects them in a corner. */
bool
leadPast(PlanLoop& loop, std::size_t first, std::size_t count)
{
  std::vector<PlanElement> rest;
  const std::size_t n = loop.elements.size();
  for (std::size_t k = count; k < n; ++k)
    rest.push_back(elementAt(loop, first + k));
  PlanElement& after = rest.front();
  PlanElement& before = rest.back();
  if (wayOf(before).dot(wayOf(after)) < parallel) {
    const auto corners = intersections(carrierOf(before), carrierOf(after));
    if (corners.empty())
      return false;
    before.end = after.start = corners.front();
  }
  else {
    after.start = before.start;
    after.inliers += before.inliers;
    rest.pop_back();
  }
  loop.elements = std::move(rest);
  return true;
}

bool
takeOut(const Suspect& suspect, const Priors& priors)
{
  const PlanElement& side = suspect.sides.front();
  if (suspect.is_column) {
    auto& columns = suspect.room->columns;
    columns.erase(std::find_if(columns.begin(), columns.end(), [&](const PlanLoop& c) {
      return isSame(c.elements.front(), side);
    }));
    return true;
  }
  PlanLoop& loop = suspect.room->boundary;
  const std::size_t count = suspect.sides.size();
  for (std::size_t i = 0; i < loop.elements.size(); ++i)
    if (isSame(loop.elements[i], side) && standsBefore(loop, i, count, priors))
      return leadPast(loop, i, count);
  return false; // already removed with an adjacent one
}

} // namespace

std::size_t
leaveOutBelowSlits(Floorplan& plan,
                   const PointView& raw,
                   const std::vector<int>& indices,
                   unsigned threads,
                   const Priors& priors)
{
  std::vector<Suspect> suspects = suspectsOf(plan, priors);
  std::vector<SlitFace*> faces;
  for (Suspect& suspect : suspects)
    for (SlitFace& face : suspect.faces)
      faces.push_back(&face);
  if (faces.empty())
    return 0;
  countAtFaces(faces, raw, indices, threads);
  std::size_t taken_out = 0;
  for (const Suspect& suspect : suspects)
    if (isBelowSlit(suspect) && takeOut(suspect, priors))
      ++taken_out;
  return taken_out;
}

} // namespace pcl::sedr
