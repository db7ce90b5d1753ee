// SPDX-License-Identifier: BSD-3-Clause
#include "seen_surfaces.h"

#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double told_share = 0.01; ///< of all surfaces of a room

} // namespace

SeenSurfaces::SeenSurfaces(const Floorplan& plan, const CellGrid& grid)
    : grid_(grid)
    , on_slab_(2 * plan.rooms.size())
    , beyond_(2 * plan.rooms.size())
    , above_(plan.rooms.size())
    , ceilings_(plan.rooms.size())
    , on_ceiling_(plan.rooms.size())
    , above_ceiling_(plan.rooms.size())
    , rooms_near_(0.5)
    , verticals_near_(0.5)
    , off_(plan.rooms.size())
{
  for (const PlanRoom& room : plan.rooms) {
    rooms_near_.addIn(boundsOf(outermostBoundary(room)),
                      static_cast<std::uint32_t>(rooms_.size()));
    for (const VerticalSurface& surface : verticalSurfaces(room)) {
      const PlanElement& line = *surface.element;
      verticals_near_.addAlong(line, relief + tiltReach(room),
                               static_cast<std::uint32_t>(verticals_.size()));
      verticals_.push_back({surface, std::max(off_wall, sigmas * line.residual), {}});
      for (double s = wall_tile / 2; s < line.length(); s += wall_tile)
        verticals_.back().spans.push_back(surface.spanAt(s));
      verticals_.back().seen.resize(verticals_.back().spans.size());
    }
    rooms_.emplace_back(room);
  }
  rooms_near_.finish();
  verticals_near_.finish();
}

bool
SeenSurfaces::isOnVertical(const Eigen::Vector3d& p)
{
  bool is_on = false;
  for (const std::uint32_t v : verticals_near_.at(p.head<2>())) {
    auto& [surface, tolerance, spans, seen] = verticals_[v];
    const double s = surface.project(p);
    const auto tile = static_cast<std::size_t>(s / wall_tile);
    if (s <= 0 || tile >= spans.size() || p.z() < spans[tile].low + off_wall ||
        p.z() > spans[tile].high + off_wall)
      continue;
    const double off =
        std::abs((p - surface.pointAt(s, p.z())).dot(surface.normalAt(s)));
    if (off <= tolerance && p.z() < spans[tile].high - off_wall)
      seen[tile] |= stepAt(p.z() - spans[tile].low - off_wall, off_wall);
    is_on = is_on || off <= tolerance;
  }
  return is_on;
}

int
SeenSurfaces::ownerOf(const Eigen::Vector3d& p) const
{
  const Eigen::Vector2d place = p.head<2>();
  for (const std::uint32_t r : rooms_near_.at(place)) {
    const RoomLookup& room = rooms_[r];
    if (room.nicheAt(place) >= 0 ||
        (room.holds(p) && p.z() > room.floorAt(place) - off_slab &&
         p.z() < room.ceilingAt(place) + off_slab))
      return static_cast<int>(r);
  }
  return -1;
}

void
SeenSurfaces::add(const Eigen::Vector3d& p)
{
  if (isOnVertical(p))
    return;
  const int owner = ownerOf(p);
  if (owner < 0) {
    addBeyond(p);
    return;
  }
  const auto r = static_cast<std::size_t>(owner);
  const std::array<double, 2> heights{rooms_[r].floorAt(p.head<2>()),
                                      rooms_[r].ceilingAt(p.head<2>())};
  for (const std::size_t k : {0, 1})
    if (std::abs(p.z() - heights[k]) < off_slab)
      on_slab_[2 * r + k].insert(keyOf(grid_.at(p.x(), p.y())));
  const double above = p.z() - heights[1];
  const CellKey tile = keyOf(tiles_.at(p.x(), p.y()));
  if (std::abs(above) < off_slab)
    ceilings_[r].insert(tile);
  if (std::abs(above) < off_wall)
    ++on_ceiling_[r][tile];
  if (above > std::max(off_wall / 2, sigmas * rooms_[r].room().ceiling.residual))
    above_ceiling_[r].insert(tile);
  addOff(p, r);
}

void
SeenSurfaces::addBeyond(const Eigen::Vector3d& p)
{
  const Eigen::Vector2d place = p.head<2>();
  for (const std::uint32_t r : rooms_near_.at(place)) {
    if (!rooms_[r].isWithinBoundary(place))
      continue;
    const double below = rooms_[r].floorAt(place) - p.z();
    const double above = p.z() - rooms_[r].ceilingAt(place);
    const double off = std::max(below, above);
    if (off <= off_slab || off >= reach)
      continue;
    beyond_[2 * r + (below > above ? 0 : 1)].try_emplace(keyOf(grid_.at(p.x(), p.y())),
                                                         static_cast<float>(p.z()));
    if (above > below) {
      Beyond& tile = above_[r][keyOf(tiles_.at(p.x(), p.y()))];
      tile.heights += p.z();
      ++tile.points;
    }
  }
}

void
SeenSurfaces::tellBeyond(std::size_t room, std::vector<PlanWarning>& warnings) const
{
  const PlanRoom& plan = rooms_[room].room();
  const double told = 0.25 * plan.area();
  const double floor = plan.floorAt(plan.boundary.elements.front().start);
  std::array<std::vector<CellValue>, 2> heights; // of what is below and above
  for (const std::size_t k : {0, 1})
    for (const auto& [key, height] : beyond_[2 * room + k])
      heights[k].emplace_back(key, height - floor);
  const Patches below(heights[0], grid_.size());
  const Patches above(heights[1], grid_.size());
  if (std::min(below.area, above.area) > told) {
    warnings.push_back(slabWarning(true, below, plan));
    warnings.push_back(slabWarning(false, above, plan));
    return;
  }
  // Of so many points a ceiling would have hidden some, and of one in a cell that is as
  // large as the scan is dense.
  constexpr std::size_t enough = 3;
  std::vector<CellValue> open; // tiles above, and no ceiling below them
  for (const auto& [key, seen] : above_[room]) {
    const Eigen::Vector2d at = tiles_.centre(cellOf(key));
    if (plan.boundary.distance(at) > grid_.size() && ceilings_[room].count(key) == 0 &&
        (seen.points >= enough ||
         !isOnSlab(room, keyOf(grid_.at(at.x(), at.y())), false)))
      open.emplace_back(key, seen.heights / static_cast<double>(seen.points) - floor);
  }
  const Patches pieces(open, wall_tile, 0); // however small, as between ribs
  const bool is_told =
      std::any_of(warnings.begin(), warnings.end(), [&](const PlanWarning& warning) {
        return warning.room == plan.id && warning.kind == WarningKind::CeilingOff;
      });
  if (!is_told && pieces.area >= told_share * surfacesOf(plan))
    warnings.push_back(slabWarning(false, pieces, plan));
}

void
SeenSurfaces::tellCeilingGaps(std::size_t room,
                              std::vector<PlanWarning>& warnings) const
{
  const PlanRoom& plan = rooms_[room].room();
  constexpr unsigned whole = 3; // points of a tile that is more than an edge
  std::vector<CellValue> gaps;  // tiles, 1 where a side leads up
  const auto isSeen = [&](const Cell& cell) {
    const auto found = on_ceiling_[room].find(keyOf(cell));
    return found != on_ceiling_[room].end() && found->second >= whole;
  };
  const auto hasSide = [&](const Cell& cell) {
    for (const int x : {-1, 0, 1})
      for (const int y : {-1, 0, 1})
        if (above_ceiling_[room].count(keyOf({cell.x + x, cell.y + y})) > 0)
          return true;
    return false;
  };
  const Eigen::AlignedBox2d box = boundsOf(plan.boundary);
  const Cell first = tiles_.at(box.min().x(), box.min().y());
  const Cell last = tiles_.at(box.max().x(), box.max().y());
  for (std::int32_t y = first.y; y <= last.y; ++y)
    for (std::int32_t x = first.x; x <= last.x; ++x)
      if (const Cell cell{x, y};
          !isSeen(cell) && rooms_[room].contains(tiles_.centre(cell)) &&
          plan.boundary.distance(tiles_.centre(cell)) > grid_.size())
        gaps.emplace_back(keyOf(cell), hasSide(cell) ? 1 : 0);
  const CellRegions regions = labelRegions(cellsOf(gaps));
  std::vector<double> sides(regions.sizes.size(), 0);
  for (std::size_t k = 0; k < gaps.size(); ++k)
    sides[regions.label[k]] += gaps[k].second;
  std::vector<CellValue> told;
  for (std::size_t k = 0; k < gaps.size(); ++k)
    if (const auto r = regions.label[k];
        2 * sides[r] >= static_cast<double>(regions.sizes[r]))
      told.push_back(gaps[k]);
  const Patches found(told, wall_tile);
  if (found.area >= told_share * surfacesOf(plan))
    warnings.push_back(
        {WarningKind::CeilingUnseen, {found.area}, plan.id, 0, {}, found.middle});
}

void
SeenSurfaces::addOff(const Eigen::Vector3d& p, std::size_t room)
{
  const RoomLookup& lookup = rooms_[room];
  const Cell cell = tiles_.at(p.x(), p.y());
  const auto [found, is_new] = off_[room].try_emplace(keyOf(cell));
  OffModel& off = found->second;
  if (is_new) {
    off.ceiling = infinite;
    for (const double x : {-1, 0, 1})
      for (const double y : {-1, 0, 1})
        off.ceiling =
            std::min(off.ceiling, lookup.ceilingAt(tiles_.centre(cell) +
                                                   wall_tile * Eigen::Vector2d(x, y)));
  }
  const double below = off.ceiling - p.z();
  if (below <= std::max(off_wall, sigmas * lookup.room().ceiling.residual))
    return;
  const HeightSteps step = stepAt(below, wall_tile);
  off.heights |= off.once & step; // one may lie between two surfaces
  off.once |= step;
}

void
SeenSurfaces::tellOff(std::size_t room, std::vector<PlanWarning>& warnings) const
{
  constexpr HeightSteps top = 3;     // what is seen there meets the ceiling
  constexpr HeightSteps band = 0x3f; // in which walls are looked for
  std::vector<CellValue> steps;
  for (const auto& [key, off] : off_[room])
    if ((off.heights & band).any())
      steps.emplace_back(
          key, ((off.heights & top).any() ? off.heights : off.heights & band).count());
  const CellRegions regions = labelRegions(cellsOf(steps));
  std::vector<double> meets(regions.sizes.size(), 0); // metres
  for (std::size_t k = 0; k < steps.size(); ++k)
    if ((off_[room].at(steps[k].first).heights & top).any())
      meets[regions.label[k]] += wall_tile;
  const PlanRoom& plan = rooms_[room].room();
  const auto isTold = [&](const Eigen::Vector2d& at) { // as before a wall
    return std::any_of(
        warnings.begin(), warnings.end(), [&](const PlanWarning& warning) {
          return warning.room == plan.id && warning.kind == WarningKind::WallOff &&
                 warning.values[1] > 0 && warning.wall > 0 &&
                 warning.wall <= plan.boundary.elements.size() &&
                 plan.boundary.elements[warning.wall - 1].distance(at) <
                     relief + wall_tile;
        });
  };
  std::vector<CellValue> told;
  for (std::size_t k = 0; k < steps.size(); ++k)
    if (meets[regions.label[k]] >= min_strip &&
        !isTold(tiles_.centre(cellOf(steps[k].first))))
      told.push_back(steps[k]);
  const CellGrid coarse(min_strip); // what is less than a cell apart is one thing
  const auto cellAt = [&](const CellValue& tile) {
    const Eigen::Vector2d at = tiles_.centre(cellOf(tile.first));
    return coarse.at(at.x(), at.y());
  };
  std::vector<CellKey> keys;
  for (const CellValue& tile : told)
    keys.push_back(keyOf(cellAt(tile)));
  const CellSet cells(keys);
  const CellRegions things = labelRegions(cells);
  std::vector<std::vector<CellValue>> tiles(things.sizes.size());
  for (const CellValue& tile : told)
    tiles[things.label[cells.find(cellAt(tile))]].push_back(tile);
  std::vector<PlanWarning> found; // one a thing; small ones count with the largest
  double area = 0;
  for (const std::vector<CellValue>& thing : tiles) {
    const Patches patch(thing, wall_tile, 0);
    const double own = patch.mean * patch.area; // of the steps
    area += own;
    found.push_back({WarningKind::Standing, {own}, plan.id, 0, {}, patch.middle});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.values[0] > b.values[0];
  });
  for (; found.size() > 1 && found.back().values[0] <= min_patch; found.pop_back())
    found.front().values[0] += found.back().values[0];
  if (area > min_patch && area >= told_share * surfacesOf(plan))
    warnings.insert(warnings.end(), found.begin(), found.end());
}

void
SeenSurfaces::tell(std::vector<PlanWarning>& warnings) const
{
  for (std::size_t r = 0; r < rooms_.size(); ++r) {
    tellOff(r, warnings);
    tellHalfWalls(r, warnings);
    tellHanging(r, warnings);
    tellBeyond(r, warnings);
    tellCeilingGaps(r, warnings);
  }
}

} // namespace pcl::sedr
