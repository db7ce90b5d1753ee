// SPDX-License-Identifier: BSD-3-Clause
#include "seen_surfaces.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

bool
isAsLongAs(const PlanElement& wall, double width, const Priors& priors)
{
  constexpr double whole = 0.9;
  return width > priors.max_door_width && width >= whole * wall.length();
}

CellSet
cellsOf(const std::vector<CellValue>& values)
{
  std::vector<CellKey> keys;
  for (const auto& [key, value] : values)
    keys.push_back(key);
  return CellSet::fromSorted(std::move(keys));
}

Patches::Patches(const std::vector<CellValue>& values, double size, double least)
{
  const CellGrid grid(size);
  const CellSet cells = cellsOf(values);
  const CellRegions regions = labelRegions(cells);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto n = static_cast<double>(regions.sizes[regions.label[k]]);
    if (n * size * size < least)
      continue;
    ++count;
    low = std::min(low, values[k].second);
    high = std::max(high, values[k].second);
    mean += values[k].second;
    if (regions.label[k] == 0)
      middle += grid.centre(cells[k]) / n;
  }
  mean /= std::max<double>(1, static_cast<double>(count));
  area = static_cast<double>(count) * size * size;
}

PlanWarning
slabWarning(bool is_floor, const Patches& found, const PlanRoom& room)
{
  return {is_floor ? WarningKind::FloorOff : WarningKind::CeilingOff,
          {found.area, found.low, found.high},
          room.id,
          0,
          {},
          found.middle};
}

WallTiles::WallTiles(const VerticalSurface& surface)
    : surface_(surface)
    , edge_(std::max(off_edge, sigmas * surface.element->residual))
    , tolerance_(std::max(off_wall, edge_))
{
  double high = -infinite;
  low_ = infinite;
  for (double s = wall_tile / 2; s < surface.element->length(); s += wall_tile) {
    spans_.push_back(surface.spanAt(s));
    low_ = std::min(low_, spans_.back().low);
    high = std::max(high, spans_.back().high);
  }
  if (!(high > low_))
    return;
  rows_ = static_cast<std::size_t>((high - low_) / wall_tile) + 1;
  tiles_.resize(spans_.size() *
                (rows_ + static_cast<std::size_t>(reach / wall_tile) + 1));
}

double
WallTiles::middleOf(std::size_t row) const
{
  return low_ + (static_cast<double>(row) + 0.5) * wall_tile;
}

void
WallTiles::leaveOut(const PlanOpening& opening, const Priors& priors)
{
  constexpr double rim = 0.15; // metres
  if (isAsLongAs(*surface_.element, opening.width(), priors))
    return;
  const double a = surface_.element->project(opening.start);
  const double b = surface_.element->project(opening.end);
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    const double s = (static_cast<double>(i % spans_.size()) + 0.5) * wall_tile;
    const double z = middleOf(std::min(i / spans_.size(), rows_ - 1));
    tiles_[i].is_on |= s > std::min(a, b) - rim && s < std::max(a, b) + rim &&
                       z > opening.bottom - rim && z < opening.top + rim;
  }
}

double
WallTiles::offsetOf(const Eigen::Vector3d& p) const
{
  const double s = surface_.project(p);
  const auto column = static_cast<std::size_t>(s / wall_tile);
  if (rows_ == 0 || s <= 0 || column >= spans_.size() ||
      p.z() < spans_[column].low + off_wall || p.z() > spans_[column].high + off_wall)
    return infinite;
  return (p - surface_.pointAt(s, p.z())).dot(surface_.normalAt(s));
}

void
WallTiles::add(const Eigen::Vector3d& p, double offset)
{
  const auto column = static_cast<std::size_t>(surface_.project(p) / wall_tile);
  const bool is_at_ceiling = p.z() > spans_[column].high - off_wall;
  const bool is_behind = offset < -(is_at_ceiling ? edge_ : tolerance_);
  if (is_at_ceiling && !is_behind)
    return;
  const std::size_t row = is_at_ceiling
                              ? rows_ + static_cast<std::size_t>(-offset / wall_tile)
                              : static_cast<std::size_t>((p.z() - low_) / wall_tile);
  Tile& tile = tiles_[row * spans_.size() + column];
  if (is_behind)
    tile.behind = std::max(tile.behind, offset);
  else if (isOn(offset))
    tile.is_on = true;
  else
    tile.before = std::min(tile.before, offset);
}

Patches
WallTiles::passedUnder() const
{
  std::vector<CellValue> offsets;
  for (std::size_t column = 0; rows_ > 0 && column < spans_.size(); ++column)
    if (const Tile& ceiling = tiles_[rows_ * spans_.size() + column];
        !ceiling.is_on && ceiling.behind > -infinite)
      offsets.emplace_back(keyOf({static_cast<std::int32_t>(column), 0}),
                           100 * ceiling.behind);
  return {offsets, wall_tile, min_strip * wall_tile};
}

Patches
WallTiles::patches(bool is_behind) const
{
  std::vector<CellValue> offsets;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    const Tile& tile = tiles_[i];
    const double off = tile.before < infinite ? tile.before : tile.behind;
    if (tile.is_on || (off < 0) != is_behind || off < -reach || off > relief)
      continue;
    offsets.emplace_back(keyOf({static_cast<std::int32_t>(i % spans_.size()),
                                static_cast<std::int32_t>(i / spans_.size())}),
                         100 * off);
  }
  return {offsets, wall_tile};
}

} // namespace pcl::sedr
