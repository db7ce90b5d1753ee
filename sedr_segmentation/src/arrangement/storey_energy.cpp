// SPDX-License-Identifier: BSD-3-Clause
#include "storey_energy.h"

#include "../curves/contour.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns the area that a square and a convex polygon share. */
double
sharedArea(const Eigen::Vector2d& middle,
           double size,
           const PlanCells::Polygon& polygon)
{
  const double h = size / 2;
  PlanCells::Polygon part{
      middle + Eigen::Vector2d(-h, -h), middle + Eigen::Vector2d(h, -h),
      middle + Eigen::Vector2d(h, h), middle + Eigen::Vector2d(-h, h)};
  for (std::size_t i = 0; i < polygon.size() && part.size() > 2; ++i) {
    const Eigen::Vector2d inward =
        leftOf(polygon[(i + 1) % polygon.size()] - polygon[i]);
    PlanCells::Polygon rest;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Eigen::Vector2d& p = part[k];
      const Eigen::Vector2d& q = part[(k + 1) % part.size()];
      const double from = inward.dot(p - polygon[i]);
      const double to = inward.dot(q - polygon[i]);
      if (from >= 0)
        rest.push_back(p);
      if ((from >= 0) != (to >= 0))
        rest.push_back(p + (q - p) * (from / (from - to)));
    }
    part = std::move(rest);
  }
  return part.size() > 2 ? signedArea(part) : 0;
}

} // namespace

double
StoreyCosts::CellCost::ofRoom(int label) const
{
  double cost = none + unseen;
  for (const auto& [of, more] : of_room)
    cost += of == label ? more : 0;
  return cost;
}

double&
StoreyCosts::CellCost::moreOf(int label)
{
  for (auto& [of, more] : of_room)
    if (of == label)
      return more;
  return of_room.emplace_back(label, 0).second;
}

StoreyCosts::StoreyCosts(const StoreyEvidence& evidence,
                         const StoreyEnergy& energy,
                         const StoreyLines& lines,
                         const PlanCells& arrangement,
                         const std::vector<CellBorder>& borders)
    : energy_(energy)
    , certainty_(lines.certainty)
    , recesses_(recessCells(evidence.storey,
                            evidence.cells,
                            lines.lines,
                            evidence.grid,
                            evidence.max_wall))
    , label_of_(evidence.cells.size(), 0)
    , of_cell_(arrangement.polygons().size())
    , near_(evidence.storey.rooms.size() + 1)
{
  for (std::size_t k = 1; k < labels(); ++k)
    label_of_[evidence.storey.rooms[k - 1]] = static_cast<int>(k);
  addAreas(evidence, arrangement);
  for (const CellBorder& border : borders) {
    const StoreyLine& line = lines.lines[border.line];
    addFronts(evidence, line, border);
    of_border_.push_back(costOf(line, border));
  }
}

void
StoreyCosts::addAreas(const StoreyEvidence& evidence, const PlanCells& arrangement)
{
  constexpr double unbounded = 1e6; // nats: no border is at the edge
  const CellGrid& grid = evidence.grid;
  for (std::size_t c = 0; c < cells(); ++c) {
    const PlanCells::Polygon& polygon = arrangement.polygons()[c];
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : polygon)
      box.extend(p);
    const CellBox cells_of{grid.at(box.min().x(), box.min().y()),
                           grid.at(box.max().x(), box.max().y())};
    CellCost& cost = of_cell_[c];
    std::vector<std::size_t> before; // rooms
    double air = 0;                  // of any room, also in recesses
    near_[0].push_back(c);
    for (std::size_t k = 1; k < labels(); ++k) {
      const std::size_t r = evidence.storey.rooms[k - 1];
      const CellMask& seen = evidence.cells[r].seen;
      const CellBox part = overlapOf(seen.box(), cells_of);
      if (part.count() == 0)
        continue;
      near_[k].push_back(c);
      double other = 0; // what it costs if the cell is not the room's
      for (int y = part.low.y; y <= part.high.y; ++y)
        for (int x = part.low.x; x <= part.high.x; ++x) {
          if (!seen.at({x, y}))
            continue;
          const double area = sharedArea(grid.centre({x, y}), grid.size(), polygon);
          if (std::none_of(before.begin(), before.end(), [&](std::size_t b) {
                return evidence.cells[b].seen.at({x, y}) != 0;
              }))
            air += area;
          if (!recesses_[r].open.at({x, y}))
            other +=
                area * (recesses_[r].closed.at({x, y}) ? energy_.niche : energy_.seen);
        }
      before.push_back(r);
      if (other > 0) {
        cost.none += other;
        cost.moreOf(static_cast<int>(k)) -= other;
      }
    }
    cost.unseen = energy_.unseen * std::max(0.0, signedArea(polygon) - air) +
                  (arrangement.isAtEdge(c) ? unbounded : 0);
  }
}

/** @brief Returns on which side of a place on a surface the room is that saw it: 1 to
 * the left, -1 to the right, 0 if that is unclear. A place before which no ceiling was
 * seen, such as a blind in a window, has no room on that side. */
int
StoreyCosts::sideOfAir(const StoreyEvidence& evidence,
                       std::uint32_t room,
                       const Eigen::Vector2d& p,
                       const Eigen::Vector2d& left) const
{
  // Metres: in the recess of a pane, before what stands there, and clear of the wall.
  const double next_cell = std::max(0.06, 1.2 * evidence.grid.size());
  const double near[] = {next_cell, std::max(0.12, next_cell),
                         std::max(0.2, next_cell)};
  enum class Air { None, Recess, Niche, Room };
  const auto airAt = [&](double d) {
    const Eigen::Vector2d q = p + d * left;
    const Cell cell = evidence.grid.at(q.x(), q.y());
    const RecessCells& recess = recesses_[room];
    return !evidence.cells[room].seen.at(cell) ? Air::None
           : recess.open.at(cell)              ? Air::Recess
           : recess.closed.at(cell)            ? Air::Niche
                                               : Air::Room;
  };
  const auto beside = [&](int side) {
    const Air air = std::min(airAt(near[1] * side), airAt(near[2] * side));
    const Air next = airAt(near[0] * side);
    return next <= Air::Recess ? std::min(air, next) : air;
  };
  const Air to_left = beside(1);
  const Air to_right = beside(-1);
  if (std::max(to_left, to_right) != Air::Room ||
      std::min(to_left, to_right) > Air::Recess)
    return 0;
  return to_left == Air::Room ? 1 : -1;
}

/** @brief Adds what it costs that the cell before a surface is not of the room that saw
 * it, or the cell behind it is. */
void
StoreyCosts::addFronts(const StoreyEvidence& evidence,
                       const StoreyLine& line,
                       const CellBorder& border)
{
  const auto pieces =
      static_cast<std::size_t>(std::ceil(border.length() / StoreyLine::bin));
  const Eigen::Vector2d way = border.end - border.start;
  const Eigen::Vector2d left = leftOf(way.normalized());
  const double length = border.length() / static_cast<double>(pieces);
  for (std::size_t k = 0; k < pieces; ++k) {
    const Eigen::Vector2d p = border.start + way * ((static_cast<double>(k) + 0.5) /
                                                    static_cast<double>(pieces));
    if (!(line.seenAt(p) > 0))
      continue;
    const auto i =
        static_cast<std::size_t>((line.along(p) - line.from) / StoreyLine::bin);
    for (const auto& [room, seen] : line.seen) {
      if (!(seen[i] > 0) || !(line.tall[i] > 0))
        continue;
      const int side = sideOfAir(evidence, room, p, left);
      if (side == 0)
        continue;
      const bool on_left = side > 0;
      const double cost =
          certainty_ * static_cast<double>(seen[i] * line.height[i]) * length;
      CellCost& front = of_cell_[on_left ? border.left : border.right];
      front.none += cost;
      front.moreOf(label_of_[room]) -= cost;
      of_cell_[on_left ? border.right : border.left].moreOf(label_of_[room]) += cost;
    }
  }
}

StoreyCosts::BorderCost
StoreyCosts::costOf(const StoreyLine& line, const CellBorder& border) const
{
  const auto pieces =
      static_cast<std::size_t>(std::ceil(border.length() / StoreyLine::bin));
  const double length = border.length() / static_cast<double>(pieces);
  const auto missingAt = [&](const Eigen::Vector2d& p) {
    const double s = line.along(p);
    if (s < line.from || s >= line.to)
      return energy_.open;
    const auto i = static_cast<std::size_t>((s - line.from) / StoreyLine::bin);
    if (line.tall[i] > 0) // the face of another room: no place for a wall
      return energy_.open + energy_.ended;
    switch (line.between[i]) {
    case StoreyLine::Between::Partly:
      return energy_.partly;
    case StoreyLine::Between::Gap:
      return energy_.gap;
    case StoreyLine::Between::Beyond:
      return energy_.ended;
    default:
      return energy_.open;
    }
  };
  std::vector<Eigen::Vector2d> places;
  BorderCost cost;
  cost.open = (energy_.open + energy_.wall) * border.length();
  cost.other = energy_.wall * border.length();
  for (std::size_t k = 0; k < pieces; ++k) {
    const double t = (static_cast<double>(k) + 0.5) / static_cast<double>(pieces);
    places.push_back(border.start + t * (border.end - border.start));
    cost.other += missingAt(places.back()) * length;
  }
  for (const auto& [room, seen] : line.seen) {
    double own = energy_.wall * border.length();
    for (const Eigen::Vector2d& p : places) {
      double explained = 0;
      if (line.seenAt(p) > 0) {
        const auto i =
            static_cast<std::size_t>((line.along(p) - line.from) / StoreyLine::bin);
        explained = line.tall[i] > 0 ? static_cast<double>(seen[i]) : 0;
      }
      own += length * (explained > 0 ? (1 - explained) * energy_.off : missingAt(p));
    }
    if (own < cost.other - 1e-9)
      cost.of_room.emplace_back(label_of_[room], own);
  }
  return cost;
}

double
StoreyCosts::ofBorder(std::size_t border, int left, int right, bool in_use) const
{
  const BorderCost& known = of_border_[border];
  double cost = 0; // of each room's face
  for (const int label : {left, right}) {
    if (label == 0)
      continue;
    const auto own =
        std::find_if(known.of_room.begin(), known.of_room.end(),
                     [&](const auto& of_room) { return of_room.first == label; });
    cost += !in_use                      ? known.open
            : own == known.of_room.end() ? known.other
                                         : own->second;
  }
  return cost;
}

} // namespace pcl::sedr
