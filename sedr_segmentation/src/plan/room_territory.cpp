// SPDX-License-Identifier: BSD-3-Clause
#include "room_territory.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel_for.h"
#include "sedr_filters/src/grids/cell_count.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Divides rooms into layers, lowest first; a room above a room of the layer
 * starts the next. A room next to several layers, such as a hall of two storeys, is in
 * each of them, so that its neighbours limit its growth. */
std::vector<std::vector<std::size_t>>
layersOf(std::size_t rooms, const std::vector<RoomHeights>& heights)
{
  std::vector<std::size_t> order(rooms);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (heights.empty())
    return {order};
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return heights[a].low < heights[b].low;
  });
  std::vector<std::vector<std::size_t>> layers;
  const auto fits = [&](const std::vector<std::size_t>& layer, std::size_t r) {
    return std::all_of(layer.begin(), layer.end(), [&](std::size_t member) {
      return shareHeights(heights[member], heights[r]);
    });
  };
  for (const std::size_t r : order) {
    if (layers.empty() || !fits(layers.back(), r))
      layers.emplace_back();
    layers.back().push_back(r);
  }
  for (auto& layer : layers) {
    for (const std::size_t r : order)
      if (std::find(layer.begin(), layer.end(), r) == layer.end() && fits(layer, r))
        layer.push_back(r);
    std::sort(layer.begin(), layer.end());
  }
  return layers;
}

/** @brief Returns the distance of a height from a height range, 0 inside. */
double
awayFrom(const RoomHeights& range, double z)
{
  return std::max({0.0, range.low - z, z - range.high});
}

} // namespace

RoomHeights
heightsFrom(double floor, std::vector<float> ceilings, const Priors& priors)
{
  if (ceilings.empty())
    return {floor, floor};
  const auto top = ceilings.begin() + static_cast<std::ptrdiff_t>(
                                          (1 - priors.share_unseen) *
                                          static_cast<double>(ceilings.size() - 1));
  std::nth_element(ceilings.begin(), top, ceilings.end());
  return {floor, *top};
}

std::vector<CellBox>
clusterBoxes(const std::vector<CellBox>& boxes, int margin)
{
  std::vector<CellBox> clusters;
  for (const CellBox& box : boxes) {
    if (box.count() == 0)
      continue;
    CellBox joined = grown(box, margin);
    for (std::size_t i = 0; i < clusters.size();) {
      if (overlapOf(joined, clusters[i]).count() == 0) {
        ++i;
        continue;
      }
      joined = around(joined, clusters[i]); // may overlap clusters tested before
      clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    }
    clusters.push_back(joined);
  }
  return clusters;
}

RoomTerritory::RoomTerritory(const CellGrid& grid,
                             const std::vector<CellSet>& scopes,
                             const std::vector<RoomHeights>& heights,
                             double reach,
                             const Priors& priors)
    : grid_(grid)
    , reach_(priors.max_wall / 2)
    , outside_(priors.surface_band)
    , deepest_(priors.patch)
{
  const int steps = cellsFor(reach, grid.size(), 3);
  for (const auto& layer : layersOf(scopes.size(), heights))
    if (!addLayer(scopes, layer, steps))
      return;
  heights_ = heights;
  if (layers_.size() > 1)
    scopes_ = scopes;
}

bool
RoomTerritory::addLayer(const std::vector<CellSet>& scopes,
                        const std::vector<std::size_t>& rooms,
                        int steps)
{
  std::vector<CellBox> boxes;
  for (const std::size_t r : rooms)
    boxes.push_back(boxOf(scopes[r]));
  Layer layer;
  for (const CellBox& box : clusterBoxes(boxes, steps + 1)) {
    problem_ = maskProblem(box);
    if (!problem_.empty())
      return false;
    Quarter quarter{CellMask(box), {}};
    quarter.room.assign(quarter.seen.values().size(), -1);
    for (const std::size_t r : rooms)
      for (std::size_t i = 0; i < scopes[r].size(); ++i) {
        if (!quarter.seen.isInside(scopes[r][i]))
          break; // a room lies completely in one quarter
        quarter.seen.set(scopes[r][i], 1);
        auto& room = quarter.room[quarter.seen.indexOf(scopes[r][i])];
        room = room < 0 ? static_cast<std::int32_t>(r) : room;
      }
    growLabels(inverted(CellMask(box)), steps, quarter.room);
    layer.push_back(std::move(quarter));
  }
  layers_.push_back(std::move(layer));
  return true;
}

std::int32_t
RoomTerritory::roomIn(const Layer& layer, Cell cell, const Eigen::Vector2d& p) const
{
  constexpr int near = 2; // cells: a thin partition
  const auto quarter = std::find_if(layer.begin(), layer.end(), [&](const Quarter& q) {
    return q.seen.isInside(cell);
  });
  if (quarter == layer.end())
    return -1;
  std::int32_t room = quarter->room[quarter->seen.indexOf(cell)];
  if (room < 0 || quarter->seen.at(cell))
    return room;
  // Cells are too coarse beside a thin partition.
  double least = std::numeric_limits<double>::infinity();
  for (int y = cell.y - near; y <= cell.y + near; ++y)
    for (int x = cell.x - near; x <= cell.x + near; ++x)
      if (quarter->seen.at({x, y})) {
        const double d = (grid_.centre({x, y}) - p).squaredNorm();
        if (d < least) {
          least = d;
          room = quarter->room[quarter->seen.indexOf({x, y})];
        }
      }
  return room;
}

std::int32_t
RoomTerritory::roomAt(const Eigen::Vector3f& p) const
{
  if (!std::isfinite(p.z()) || !grid_.holds(p.x(), p.y()))
    return -1;
  const Cell cell = grid_.at(p.x(), p.y());
  const Eigen::Vector2d at = p.head<2>().cast<double>();
  if (layers_.size() == 1) {
    const std::int32_t room = roomIn(layers_.front(), cell, at);
    const bool is_below =
        room >= 0 && !heights_.empty() &&
        p.z() < heights_[static_cast<std::size_t>(room)].low - deepest_;
    return is_below ? -1 : room;
  }
  std::int32_t best = -1;
  double least = reach_ + outside_;
  for (const Layer& layer : layers_) {
    const std::int32_t room = roomIn(layer, cell, at);
    if (room < 0)
      continue;
    const auto r = static_cast<std::size_t>(room);
    const double away = awayFrom(heights_[r], p.z());
    const double cost = away + (scopes_[r].contains(cell) ? 0 : outside_);
    if (away <= reach_ && cost < least) {
      least = cost;
      best = room;
    }
  }
  return best;
}

std::vector<std::int32_t>
RoomTerritory::roomsAt(const PointView& points, unsigned threads) const
{
  std::vector<std::int32_t> rooms(points.size());
  parallelFor(points.size(), points_a_block, threads,
              [&](std::size_t i) { rooms[i] = roomAt(points[i]); });
  return rooms;
}

} // namespace pcl::sedr
