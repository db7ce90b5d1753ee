// SPDX-License-Identifier: BSD-3-Clause
#include "seen_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double whole = 0.9; ///< share of a wall

/** @brief Checks whether something takes up a wall from end to end and is no door. */
bool
isAsLongAs(const PlanElement& wall, double width, const Priors& priors)
{
  return width > priors.max_door_width && width >= whole * wall.length();
}

} // namespace

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

double
surfacesOf(const PlanRoom& room)
{
  const Eigen::Vector2d at = room.boundary.elements.front().start;
  const double height = room.ceiling.heightAt(at) - room.floor.heightAt(at);
  return 2 * room.area() + room.perimeter() * height;
}

namespace {

/** @brief Patches of a wall in which something was seen off it. */
struct OffWall {
  const WallSide* side;
  Patches found;
  double area;       ///< square metres; where a ceiling passes it, up to the floor
  double passed = 0; ///< metres over which a ceiling passes it
};

/** @brief What the map of a side shows off the plan's surface. */
class OffSurface {
public:
  OffSurface(const Floorplan& plan,
             const WallSide& side,
             const WallMap& map,
             const SeenSurfaces& rooms,
             const Priors& priors)
      : side_(side)
      , wall_(side.in(plan))
      , openings_(openingsOn(plan, side))
      , map_(map)
      , rooms_(rooms)
      , from_(side.line.isArc() ? 0 : side.line.project(wall_.start))
      , to_(from_ + wall_.length())
  {
    // What is as long as its wall, or as high and shows nothing beyond its back, may be
    // the wall itself, seen behind cupboards or in a recess.
    const auto isRecess = [&](const WallRectangle& o) {
      return o.to - o.from > priors.max_door_width &&
             o.top - o.bottom >= whole * (side.ceiling - side.floor) &&
             backOf(map, o).beyond <= Priors::share_unseen;
    };
    openings_.erase(std::remove_if(openings_.begin(), openings_.end(),
                                   [&](const WallRectangle& o) {
                                     return isRecess(o) ||
                                            isAsLongAs(wall_, o.to - o.from, priors);
                                   }),
                    openings_.end());
  }

  OffWall patches(bool is_behind) const
  {
    std::vector<CellValue> offsets;
    for (std::size_t r = 0; r < map_.rows(); ++r)
      for (std::size_t c = 0; c < map_.columns(); ++c)
        if (const double off = map_.offsetAt(c, r);
            off != 0 && (off < 0) == is_behind && off >= -reach && off <= relief)
          add(c, r, map_.heightOf(r) + map_.cell() / 2, off, offsets);
    const Patches found(offsets, map_.cell());
    return {&side_, found, found.area};
  }

  /** @brief Returns the columns behind which the ceiling goes on into no room, half a
   * metre of them or more: no wall can be there. */
  OffWall passedUnder() const
  {
    std::vector<CellValue> ways;
    for (std::size_t c = 0; c < map_.columns(); ++c)
      if (const double way = map_.ceiling().behind(c); way > 0)
        add(c, 0, side_.ceiling - off_wall, -way, ways);
    const Patches found(ways, map_.cell(), min_strip * map_.cell());
    const double length = found.area / map_.cell();
    return {&side_, found, length * (side_.ceiling - side_.floor), length};
  }

  /** @brief Returns the columns before which a lower part of the ceiling ends, and how
   * far: what is behind it nobody saw. */
  OffWall passedBy() const
  {
    const PlanRoom& room = rooms_.lookup(side_.room).room();
    std::vector<CellValue> gaps;
    double area = 0; // of what is not in the model if that is no soffit but a beam
    for (std::size_t c = 0; c < map_.columns(); ++c) {
      const double s = map_.cell() * (static_cast<double>(c) + 0.5);
      const Eigen::Vector2d at =
          side_.line.pointAt(s) + off_wall * side_.line.normalAt(s);
      const int part = room.detailAt(at);
      if (s < from_ + off_wall || s > to_ - off_wall || part < 0 ||
          room.details[static_cast<std::size_t>(part)].is_facet)
        continue;
      double gap = map_.ceiling().before(c);
      if (!std::isfinite(gap)) // nothing of the part was seen there
        for (gap = off_wall; gap < OpeningSizes().before &&
                             room.detailAt(at + gap * side_.line.normalAt(s)) == part;)
          gap += off_wall;
      if (gap < off_wall)
        continue;
      const double drop = room.ceiling.heightAt(at) - room.ceilingAt(at);
      if (drop < off_wall)
        continue;
      gaps.emplace_back(keyOf({static_cast<std::int32_t>(c), 0}), gap);
      area += map_.cell() * (gap + drop);
    }
    Patches found(gaps, map_.cell(), 0);
    found.area *= found.mean / map_.cell(); // not of cells, but of gaps
    return {&side_, found, area};
  }

private:
  /** @brief Adds a cell unless it is beside a corner, in an opening or its reveals, or
   * what is behind it is in a room. */
  void add(std::size_t c,
           std::size_t r,
           double z,
           double off,
           std::vector<CellValue>& offsets) const
  {
    const double s = map_.cell() * (static_cast<double>(c) + 0.5);
    if (s < from_ + off_wall || s > to_ - off_wall || isInOpening(s, z))
      return;
    const double height = z - side_.foot;
    const double before = off + height * std::tan(side_.line.tilt) -
                          (off < 0 ? off_wall : 0); // beyond the noise of a face
    Eigen::Vector3d place;
    place << side_.line.pointAt(s) + before * side_.line.normalAt(s), z;
    if (off > 0 || rooms_.ownerOf(place) < 0)
      offsets.emplace_back(
          keyOf({static_cast<std::int32_t>(c), static_cast<std::int32_t>(r)}),
          100 * off);
  }

  bool isInOpening(double s, double z) const
  {
    constexpr double rim = 0.15; // metres
    return std::any_of(openings_.begin(), openings_.end(), [&](const WallRectangle& o) {
      return s > o.from - rim && s < o.to + rim && z > o.bottom - rim &&
             z < o.top + rim;
    });
  }

  const WallSide& side_;
  const PlanElement& wall_;
  std::vector<WallRectangle> openings_;
  const WallMap& map_;
  const SeenSurfaces& rooms_;
  double from_; ///< of the wall, along its side
  double to_;
};

} // namespace

void
tellOffWalls(const Floorplan& plan,
             const OpeningSearch& maps,
             const SeenSurfaces& rooms,
             const Priors& priors,
             std::vector<PlanWarning>& warnings)
{
  // Of all surfaces of a room: what is close before walls may be furniture.
  constexpr double told_behind = 0.01;
  constexpr double told_before = 0.02;
  std::vector<std::array<double, 2>> areas(plan.rooms.size()); // before, behind
  std::vector<std::vector<OffWall>> parts(plan.rooms.size());
  std::vector<OffWall> off;
  for (std::size_t k = 0; k < maps.sides.size(); ++k) {
    const WallSide& side = maps.sides[k];
    const OffSurface surface(plan, side, maps.maps[k], rooms, priors);
    if (OffWall part = surface.passedBy(); part.area > 0)
      parts[side.room].push_back(std::move(part));
    for (const bool is_behind : {true, false}) {
      OffWall found = surface.patches(is_behind);
      if (OffWall under = surface.passedUnder(); is_behind && under.area > found.area)
        found = std::move(under);
      if (found.found.count == 0)
        continue;
      areas[side.room][is_behind ? 1 : 0] += found.area;
      off.push_back(std::move(found));
    }
  }
  for (const auto& [side, found, area, passed] : off) {
    const PlanRoom& room = plan.rooms[side->room];
    std::vector<double> values{area, found.mean};
    if (passed > 0)
      values.push_back(passed);
    const bool is_behind = found.mean < 0;
    if (areas[side->room][is_behind ? 1 : 0] >=
        (is_behind ? told_behind : told_before) * surfacesOf(room))
      warnings.push_back({WarningKind::WallOff,
                          std::move(values),
                          room.id,
                          side->isWall() ? side->element + 1 : 0,
                          {},
                          side->line.pointAt(found.middle.x())});
  }
  for (std::size_t r = 0; r < parts.size(); ++r) {
    PlanWarning told{WarningKind::PartUnseen, {0}, plan.rooms[r].id};
    double behind = 0;
    double largest = 0;
    for (const auto& [side, found, area, passed] : parts[r]) {
      told.values[0] += found.area;
      behind += area;
      if (found.area > largest)
        told.at = side->line.pointAt(found.middle.x());
      largest = std::max(largest, found.area);
    }
    if (behind > 0 && behind >= told_behind * surfacesOf(plan.rooms[r]))
      warnings.push_back(told);
  }
  for (const PlanRoom& room : plan.rooms)
    for (const PlanNiche& niche : room.niches) {
      const PlanElement& mouth = niche.boundary.elements.back();
      const Eigen::Vector2d at = (mouth.start + mouth.end) / 2;
      const std::size_t w = room.boundary.nearest(at);
      if (isAsLongAs(room.boundary.elements[w], mouth.length(), priors))
        warnings.push_back(
            {WarningKind::WallOff,
             {mouth.length() * (niche.top.heightAt(at) - niche.bottom.heightAt(at)),
              -100 * niche.boundary.elements.front().length()},
             room.id,
             w + 1,
             {},
             at});
    }
}

} // namespace pcl::sedr
