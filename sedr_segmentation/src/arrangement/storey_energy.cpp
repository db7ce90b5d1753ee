// SPDX-License-Identifier: BSD-3-Clause
#include "storey_energy.h"

#include "../curves/contour.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

/** @brief Returns the cells of recesses behind lines of walls whose ceiling is lower
 * than that of the room before them. */
CellMask
revealsOf(const RoomCells& room, const RoomRegion& region, const CellGrid& grid)
{
  constexpr double deep = 0.6;   // metres
  constexpr float lower = 0.08F; // metres
  const int reach = static_cast<int>(std::lround(deep / grid.size()));
  CellMask reveals(room.seen.box());
  for (std::size_t i = 0; i < room.seen.values().size(); ++i) {
    const Cell cell = room.seen.cellAt(i);
    if (!room.seen.values()[i] || !region.beyond.at(cell))
      continue;
    float top = room.top[i];
    for (int d = -reach; d <= reach; ++d)
      for (const Cell by : {Cell{cell.x + d, cell.y}, Cell{cell.x, cell.y + d}})
        if (room.seen.at(by) && region.cells.at(by))
          top = std::max(top, room.top[room.seen.indexOf(by)]);
    reveals.values()[i] = room.low[i] < top - lower ? 1 : 0;
  }
  return reveals;
}

} // namespace

StoreyCosts::StoreyCosts(const StoreyEvidence& evidence,
                         const StoreyEnergy& energy,
                         const std::vector<StoreyLine>& lines,
                         const std::vector<PlanCells::Polygon>& polygons,
                         const std::vector<CellBorder>& borders)
    : energy_(energy)
    , labels_(evidence.storey.rooms.size() + 1)
    , reveals_(evidence.cells.size())
    , label_of_(evidence.cells.size(), 0)
    , of_cell_(polygons.size() * labels_, 0)
{
  for (std::size_t k = 1; k < labels_; ++k)
    label_of_[evidence.storey.rooms[k - 1]] = static_cast<int>(k);
  for (const std::size_t r : evidence.storey.rooms)
    reveals_[r] = revealsOf(evidence.cells[r], evidence.regions[r], evidence.grid);
  addAreas(evidence, polygons);
  for (const CellBorder& border : borders) {
    addFronts(evidence, lines[border.line], border);
    of_border_.push_back(costOf(lines[border.line], border));
  }
}

void
StoreyCosts::addAreas(const StoreyEvidence& evidence,
                      const std::vector<PlanCells::Polygon>& polygons)
{
  const CellGrid& grid = evidence.grid;
  for (std::size_t c = 0; c < polygons.size(); ++c) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : polygons[c])
      box.extend(p);
    const Cell low = grid.at(box.min().x(), box.min().y());
    const Cell high = grid.at(box.max().x(), box.max().y());
    std::vector<double> seen(labels_, 0);  // air of the room
    std::vector<double> taken(labels_, 0); // of its region, not seen
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        double area = -1;
        for (std::size_t k = 1; k < labels_; ++k) {
          const std::size_t r = evidence.storey.rooms[k - 1];
          const bool is_seen = evidence.cells[r].seen.at({x, y}) != 0;
          if (is_seen ? reveals_[r].at({x, y}) : !evidence.regions[r].cells.at({x, y}))
            continue;
          if (area < 0)
            area = sharedArea(grid.centre({x, y}), grid.size(), polygons[c]);
          (is_seen ? seen : taken)[k] += area;
        }
      }
    const double all = std::accumulate(seen.begin(), seen.end(), 0.0);
    double* const cost = &of_cell_[c * labels_];
    cost[0] = energy_.seen * all +
              energy_.taken * std::accumulate(taken.begin(), taken.end(), 0.0);
    for (std::size_t k = 1; k < labels_; ++k)
      cost[k] =
          energy_.seen * (all - seen[k]) +
          energy_.unseen * std::max(0.0, signedArea(polygons[c]) - all - taken[k]);
  }
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
      if (!(seen[i] > 0))
        continue;
      const auto isAir = [&, room = room](double d) {
        const Eigen::Vector2d q = p + d * left;
        const Cell cell = evidence.grid.at(q.x(), q.y());
        return evidence.cells[room].seen.at(cell) && !reveals_[room].at(cell);
      };
      const auto isBefore = [&](double side) { // clear of the wall's own cells
        return isAir(0.12 * side) && isAir(0.2 * side);
      };
      const bool on_left = isBefore(1);
      if (on_left == isBefore(-1))
        continue;
      const auto r = static_cast<std::size_t>(label_of_[room]);
      const double explained = static_cast<double>(seen[i]) * length;
      double* const front = &of_cell_[(on_left ? border.left : border.right) * labels_];
      for (std::size_t l = 0; l < labels_; ++l)
        front[l] += l == r ? 0 : energy_.front * explained;
      of_cell_[(on_left ? border.right : border.left) * labels_ + r] +=
          energy_.behind * explained;
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
    switch (line.between[static_cast<std::size_t>((s - line.from) / StoreyLine::bin)]) {
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
      const double missing = missingAt(p);
      const double explained =
          line.seenAt(p) > 0 ? static_cast<double>(seen[static_cast<std::size_t>(
                                   (line.along(p) - line.from) / StoreyLine::bin)])
                             : 0;
      own += length * (explained > 0 ? (1 - explained) * std::max(missing, energy_.off)
                                     : missing);
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
  if (!in_use)
    return known.open;
  double cost = known.other;
  for (const auto& [label, value] : known.of_room)
    if (label == left || label == right)
      cost = std::min(cost, value);
  return cost;
}

} // namespace pcl::sedr
