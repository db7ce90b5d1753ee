// SPDX-License-Identifier: BSD-3-Clause
#include "plan_drawing.h"

#include "../formats/decimal_text.h"
#include "../overhead/height_lines.h"
#include "../sheet/plan_frame.h"
#include "../solid/plan_facets.h"
#include "../walls/plan_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Headrooms drawn below a roof, metres. Area rules such as the former DIN 277
 * count half of what is lower than the first. Building codes require the second over
 * half of a habitable room. */
constexpr double headrooms[] = {1.5, 2.3};

bool
liesOn(const PlanElement& element, const PlanRoom& room)
{
  const double on_wall = snapTolerance(element, 0);
  const auto isOn = [&](double share) {
    const Eigen::Vector2d p = element.pointAt(share * element.length());
    return room.boundary.distance(p) <= on_wall ||
           std::any_of(room.columns.begin(), room.columns.end(),
                       [&](const PlanLoop& c) { return c.distance(p) <= on_wall; });
  };
  return isOn(0) && isOn(0.25) && isOn(0.5) && isOn(0.75) && isOn(1);
}

/** @brief Returns where, between two distances along an element, it enters or leaves a
 * room. */
double
crossingOf(const PlanElement& element, const PlanRoom& room, double from, double to)
{
  const bool is_inside = room.contains(element.pointAt(from));
  for (int i = 0; i < 40; ++i) {
    const double middle = (from + to) / 2;
    (room.contains(element.pointAt(middle)) == is_inside ? from : to) = middle;
  }
  return (from + to) / 2;
}

/** @brief Returns the pieces of a detail's edge within the room; a fitted detail may
 * reach beyond the walls. Pieces shorter than 2 cm are omitted. */
std::vector<PlanElement>
piecesInside(const PlanElement& element, const PlanRoom& room)
{
  constexpr double step = 0.02;
  constexpr std::size_t most = 10000;
  const double length = element.length();
  const auto steps =
      std::min(most, static_cast<std::size_t>(std::ceil(length / step)) + 1);
  const auto at = [&](std::size_t i) {
    return length * static_cast<double>(i) / static_cast<double>(steps);
  };
  // Sampled at the middle of each step, as the ends may lie on a wall.
  const auto middleOf = [&](std::size_t i) { return (at(i) + at(i + 1)) / 2; };
  std::vector<PlanElement> pieces;
  double from = 0;
  bool is_inside = room.contains(element.pointAt(middleOf(0)));
  const auto close = [&](double to) {
    if (is_inside && (to - from >= step || to - from == length))
      pieces.push_back(from == 0 && to == length ? element : element.part(from, to));
    from = to;
  };
  for (std::size_t i = 1; i < steps; ++i) {
    const bool is_next_inside = room.contains(element.pointAt(middleOf(i)));
    if (is_next_inside == is_inside)
      continue;
    close(crossingOf(element, room, middleOf(i - 1), middleOf(i)));
    is_inside = is_next_inside;
  }
  close(length);
  return pieces;
}

/** @brief A loop and what is in the way of a text in it. */
class TextSpace {
public:
  TextSpace(const PlanLoop& loop, const std::vector<PlanLoop>& obstacles)
      : loop_(loop)
      , obstacles_(obstacles)
  {
    const auto add = [&](const PlanLoop& edges) {
      for (const PlanElement& edge : edges.elements)
        edges_.push_back(&edge);
    };
    add(loop);
    std::for_each(obstacles.begin(), obstacles.end(), add);
  }

  /** @brief Returns the distance from all edges; negative outside the loop or in an
   * obstacle. Where `isTooNear(distance)` of an edge holds, so of any lower number, it
   * returns the distance of that edge. */
  template <typename IsTooNear>
  double clearanceAt(const Eigen::Vector2d& p, IsTooNear isTooNear)
  {
    double clearance = std::numeric_limits<double>::infinity();
    for (const PlanElement*& edge : edges_) {
      clearance = std::min(clearance, edge->distance(p));
      if (!isTooNear(clearance))
        continue;
      std::swap(edge, edges_.front()); // is near the next place, too
      return clearance;
    }
    const bool is_free =
        loop_.contains(p) &&
        std::none_of(obstacles_.begin(), obstacles_.end(),
                     [&](const PlanLoop& obstacle) { return obstacle.contains(p); });
    return is_free ? clearance : -clearance;
  }

private:
  const PlanLoop& loop_;
  const std::vector<PlanLoop>& obstacles_;
  std::vector<const PlanElement*> edges_;
};

/** @brief Adds the lines of the headrooms below a ceiling. The longest piece of each
 * carries its height. */
void
addHeadroom(const PlanRoom& room,
            const CeilingLines& ceiling,
            std::vector<DrawnElement>& drawn)
{
  for (const double height : headrooms) {
    std::vector<PlanElement> lines;
    for (const PlanElement& line : heightLines(room, ceiling, height))
      for (const PlanElement& piece : piecesInside(line, room))
        lines.push_back(piece);
    if (lines.empty())
      continue;
    const auto longest = std::max_element(
        lines.begin(), lines.end(), [](const PlanElement& a, const PlanElement& b) {
          return a.length() < b.length();
        });
    for (const PlanElement& line : lines)
      drawn.push_back({line, DrawnLayer::Headroom, room.id,
                       &line == &*longest ? "h " + decimalText(height, 2) : ""});
  }
}

/** @brief Adds the heads of tilted walls, each with its tilt. */
void
addHeads(const PlanRoom& room, const WallTilts& tilts, std::vector<DrawnElement>& drawn)
{
  for (const WallTilt& tilt : tilts) {
    if (tilt.room != room.id || tilt.tilt == 0 ||
        tilt.wall >= room.boundary.elements.size())
      continue;
    const PlanLoop head = boundaryAt(room, tilts, headOf(room, {tilt}));
    drawn.push_back({head.elements[tilt.wall], DrawnLayer::Detail, room.id,
                     "tilt " + decimalText(std::abs(tilt.tilt) * 180 / M_PI, 1) + "°"});
  }
}

} // namespace

std::vector<CeilingLines>
ceilingsOf(const Floorplan& plan, double finest)
{
  std::vector<CeilingLines> lines;
  for (const PlanRoom& room : plan.rooms)
    lines.push_back(ceilingLines(room, finest));
  return lines;
}

std::vector<DrawnElement>
drawnElements(const Floorplan& plan,
              const std::vector<CeilingLines>& ceilings,
              const WallTilts& tilts)
{
  std::vector<DrawnElement> all;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    const PlanRoom& room = plan.rooms[r];
    std::vector<DrawnElement> drawn;
    const auto add = [&](const PlanLoop& loop, DrawnLayer layer, bool is_on_top) {
      for (const PlanElement& element : loop.elements)
        if (element.length() > 0 && !(is_on_top && liesOn(element, room)))
          drawn.push_back({element, layer, room.id});
    };
    const auto addInside = [&](const PlanLoop& loop, const auto& addPiece) {
      for (const PlanElement& element : loop.elements)
        if (element.length() > 0 && !liesOn(element, room))
          for (const PlanElement& piece : piecesInside(element, room))
            addPiece(piece);
    };
    const auto addAll = [&](const PlanDetail& detail, const auto& addPiece) {
      addInside(detail.boundary, addPiece);
      for (const PlanLoop& hole : detail.holes)
        addInside(hole, addPiece);
    };
    add(room.boundary, DrawnLayer::Wall, false);
    for (const PlanLoop& column : room.columns)
      add(column, isIsland(room, column) ? DrawnLayer::Wall : DrawnLayer::Column,
          false);
    for (const PlanDetail& detail : room.details)
      if (!detail.is_facet)
        addAll(detail, [&](const PlanElement& piece) {
          drawn.push_back({piece, DrawnLayer::Detail, room.id});
        });
    for (const CeilingLine& line : ceilings[r].lines)
      for (const PlanElement& piece : piecesInside(line.element, room))
        drawn.push_back({piece, line.is_crease ? DrawnLayer::Ridge : DrawnLayer::Detail,
                         room.id, line.text});
    for (const PlanDetail& detail : room.floor_details)
      addAll(detail, [&](const PlanElement& piece) {
        drawn.push_back({piece, DrawnLayer::FloorDetail, room.id});
      });
    for (const PlanNiche& niche : room.niches)
      add(niche.boundary, DrawnLayer::Niche, true);
    addHeadroom(room, ceilings[r], drawn);
    addHeads(room, tilts, drawn);
    all.insert(all.end(), drawn.begin(), drawn.end());
  }
  return all;
}

TextSpot
textSpotIn(const PlanLoop& loop, const std::vector<PlanLoop>& obstacles)
{
  // A lattice over the loop, then finer ones around the best place.
  constexpr int steps = 24;
  constexpr double pull = 0.05; // towards the middle, among equally good places
  Eigen::AlignedBox2d box = boundsOf(loop);
  const Eigen::Vector2d middle = box.center();
  TextSpot best{middle, 0};
  double best_score = -std::numeric_limits<double>::infinity();
  TextSpace space(loop, obstacles);
  for (int round = 0; round < 3 && !box.isEmpty(); ++round) {
    const Eigen::Vector2d step = box.sizes() / steps;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) {
        const Eigen::Vector2d p = box.min() + step.cwiseProduct(Eigen::Vector2d(i, j));
        const double off = pull * (p - middle).norm();
        const double clearance = space.clearanceAt(
            p, [&](double distance) { return distance - off <= best_score; });
        const double score = clearance - off;
        if (score <= best_score)
          continue;
        best_score = score;
        best = {p, clearance};
      }
    box = Eigen::AlignedBox2d(best.place - step, best.place + step);
  }
  best.radius = std::max(best.radius, 0.0);
  return best;
}

std::string
sizeText(const PlanElement& element)
{
  return element.isArc() ? "R " + decimalText(element.radius, 2)
                         : decimalText(element.length(), 2);
}

std::string
columnText(const PlanLoop& column)
{
  const std::vector<PlanElement>& e = column.elements;
  constexpr double same = 0.02;
  const bool is_round =
      !e.empty() && std::all_of(e.begin(), e.end(), [&](const PlanElement& part) {
        return part.isArc() && std::abs(part.radius - e.front().radius) < same;
      });
  if (is_round)
    return "Ø " + decimalText(2 * e.front().radius, 2);
  const bool is_quad =
      e.size() == 4 && std::none_of(e.begin(), e.end(), [](const PlanElement& part) {
        return part.isArc();
      });
  return is_quad ? decimalText(e[0].length(), 2) + " x " + decimalText(e[1].length(), 2)
                 : "";
}

std::vector<std::string>
roomTexts(const PlanRoom& room,
          const CeilingLines& ceiling,
          const Eigen::Vector2d& place,
          const std::string& square)
{
  const double height = room.ceiling.heightAt(place) - room.floor.heightAt(place);
  std::string heights = decimalText(height, 2);
  if (room.hasFacets()) {
    const auto [eaves, ridge] = heightRange(room, ceiling);
    heights = decimalText(eaves, 2) + " - " + decimalText(ridge, 2);
  }
  return {"Room " + std::to_string(room.id), decimalText(room.area(), 2) + " " + square,
          "h " + heights + " m"};
}

} // namespace pcl::sedr
