// SPDX-License-Identifier: BSD-3-Clause
#include "../base/number_text.h"
#include "../base/parallel.h"
#include "../plan/plan_geometry.h"
#include "../plan/plan_surfaces.h"
#include "../plan/room_lookup.h"
#include "../rays/cube_points.h"

#include "../walls/plan_walls.h"
#include <pcl/sedr_filters/impl/refinement.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace pcl::sedr {
namespace {

/** @brief A cell of a room's surfaces and the point that represents it. */
struct SurfaceCell {
  SurfacePoint centre;
  bool is_occupied = false; ///< whether a scanned point lies in it
  std::size_t source = 0;   ///< index of the scanned point nearest to the centre
  double distance = 0;      ///< distance of that point from the centre, metres
};

/** @brief Returns the number of equal parts of about `size`, at least one. */
std::size_t
partsOf(double length, double size)
{
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(length / size)));
}

/** @brief Returns the number of parts in x and y of a grid cell on a surface with this
 * normal. Parts keep points on a slope as close as in plan. */
std::size_t
partsOf(const Eigen::Vector3d& normal)
{
  constexpr double most = 8;
  constexpr double gentle = 0.9; // cosine of the slope, 26 degrees
  const double upward = std::abs(normal.z());
  return upward > gentle
             ? 1
             : static_cast<std::size_t>(std::ceil(std::min(1 / upward, most)));
}

/** @brief Lower risers are not steps but two fits of the same height, metres. */
constexpr double min_riser = 0.01;

/** @brief Estimates the number of cells of a room; in plan, of the box around it. */
double
estimatedCells(const PlanRoom& room, double size)
{
  double cells = 0;
  for (const VerticalSurface& surface : verticalSurfaces(room)) {
    const double length = surface.element->length();
    const VerticalSpan span = surface.spanAt(length / 2);
    cells += (length / size + 1) * (std::max(0.0, span.high - span.low) / size + 1);
  }
  const auto addSheets = [&](const PlanLoop& loop) {
    cells += 2 * boundsOf(loop).sizes().prod() / (size * size);
  };
  if (!room.boundary.elements.empty())
    addSheets(room.boundary);
  for (const PlanNiche& niche : room.niches)
    addSheets(niche.boundary);
  return cells;
}

/** @brief The surfaces of a room, divided into cells of nearly equal size. Vertical
 * surfaces are divided into equal parts along their elements and in height; floors,
 * ceilings, and bottoms and tops of niches by grids in plan. The cells cover the whole
 * room, so empty cells are its holes (paper, section 2.4). */
class SurfaceCells {
public:
  /** @param room must not move while this object exists
   * @param size edge of a cell, metres, > 0; surfaceCellsProblem() of the plan must be
   * empty */
  SurfaceCells(const PlanRoom& room, double size)
      : room_(room)
      , lookup_(room)
      , size_(size)
      , cubes_(size)
  {
    for (const auto& surface : verticalSurfaces(room_))
      addStrip(surface);
    addSlabs();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const std::uint32_t cube = cubes_.add(cubes_.at(placeOf(cells_[i].centre)));
      in_cube_.resize(cubes_.size());
      in_cube_[cube].push_back(i);
    }
  }

  /** @brief Assigns point `source` of the scan, already on the structure, to its cell
   * if the room has such a surface: the nearest. */
  void occupy(const SurfacePoint& point, std::size_t source)
  {
    constexpr double alike = 0.5; // cosine; undersides and risers share a label
    constexpr double weight = 4;  // off its plane a point is on another surface
    const Eigen::Vector3d place = placeOf(point);
    double nearest = size_;
    SurfaceCell* found = nullptr;
    cubes_.anyAround(cubes_.at(place), [&](std::uint32_t cube) {
      for (const std::size_t i : in_cube_[cube]) {
        const SurfacePoint& centre = cells_[i].centre;
        const Eigen::Vector3d off = place - placeOf(centre);
        double distance = off.norm();
        if (!isLevel(point)) {
          if (centre.label != point.label || centre.normal.dot(point.normal) < alike)
            continue;
          distance += weight * std::abs(off.dot(centre.normal));
        }
        if (distance >= nearest)
          continue;
        nearest = distance;
        found = &cells_[i];
      }
      return false;
    });
    if (!found)
      return;
    const double distance = (point.position - found->centre.position).norm();
    if (found->is_occupied && found->distance <= distance)
      return;
    found->is_occupied = true;
    found->source = source;
    found->distance = distance;
  }

  /** @brief Returns all cells: vertical surfaces, then floor, ceiling and niches. */
  const std::vector<SurfaceCell>& cells() const { return cells_; }

private:
  static bool isLevel(const SurfacePoint& point)
  {
    return point.label == StructureLabel::Ceiling ||
           point.label == StructureLabel::Floor || std::abs(point.normal.z()) > 0.5;
  }

  /** @brief Returns where to look for the cell of a point: of floors and ceilings, in
   * plan, apart from each other. */
  static Eigen::Vector3d placeOf(const SurfacePoint& point)
  {
    constexpr double apart = 1e4; // metres
    Eigen::Vector3d place = point.position;
    if (isLevel(point))
      place.z() = point.normal.z() > 0 ? -apart : apart;
    return place;
  }

  void addStrip(const VerticalSurface& surface)
  {
    const double length = surface.element->length();
    const std::size_t columns = partsOf(length, size_);
    for (std::size_t c = 0; c < columns; ++c) {
      const double s =
          length * (static_cast<double>(c) + 0.5) / static_cast<double>(columns);
      const VerticalSpan span = surface.spanAt(s);
      const double height = span.high - span.low;
      const std::size_t rows = height > min_riser ? partsOf(height, size_) : 0;
      SurfaceCell cell{{{}, surface.normalAt(s), surface.label, room_.id}};
      for (std::size_t r = 0; r < rows; ++r) {
        cell.centre.position =
            surface.pointAt(s, span.low + height * (static_cast<double>(r) + 0.5) /
                                              static_cast<double>(rows));
        cells_.push_back(cell);
      }
    }
  }

  /** @brief Appends the cells of a floor, ceiling or niche inside `loop`: a grid in
   * plan, finer where steep. `pointAt(place, point)` gives the surface point at a
   * place, or returns false if there is none. */
  template <typename PointAt>
  void addSheet(const PlanLoop& loop, PointAt pointAt)
  {
    const Eigen::AlignedBox2d box = boundsOf(loop);
    if (box.isEmpty())
      return;
    const Eigen::Vector2d extent = box.sizes() / size_;
    const auto width = static_cast<std::size_t>(extent.x()) + 1;
    const auto height = static_cast<std::size_t>(extent.y()) + 1;
    for (std::size_t i = 0; i < width * height; ++i) {
      const auto placeOf = [&](std::size_t part, std::size_t parts) -> Eigen::Vector2d {
        const auto middle = [parts](std::size_t cell, std::size_t k) {
          return static_cast<double>(cell) +
                 (static_cast<double>(k) + 0.5) / static_cast<double>(parts);
        };
        return box.min() + size_ * Eigen::Vector2d(middle(i % width, part % parts),
                                                   middle(i / width, part / parts));
      };
      SurfaceCell cell;
      const bool is_there = pointAt(placeOf(0, 1), cell.centre);
      const std::size_t parts = is_there ? partsOf(cell.centre.normal) : 1;
      for (std::size_t part = 0; part < parts * parts; ++part)
        if (parts == 1 ? is_there : pointAt(placeOf(part, parts), cell.centre))
          cells_.push_back(cell);
    }
  }

  void addSlabs()
  {
    for (const bool is_floor : {true, false})
      addSheet(outermostBoundary(room_),
               [&](const Eigen::Vector2d& place, SurfacePoint& point) {
                 point = slabPointAt(lookup_, place, is_floor);
                 return lookup_.holds(point.position);
               });
    for (const PlanNiche& niche : room_.niches)
      for (const bool is_bottom : {true, false})
        addSheet(
            niche.boundary, [&](const Eigen::Vector2d& place, SurfacePoint& point) {
              point = nichePointAt(room_, niche, place, is_bottom);
              return niche.boundary.contains(place) && !lookup_.isWithinBoundary(place);
            });
  }

  const PlanRoom& room_;
  RoomLookup lookup_;
  double size_;
  std::vector<SurfaceCell> cells_;
  CubeTable cubes_; ///< that hold centres of cells
  std::vector<std::vector<std::size_t>> in_cube_;
};

} // namespace

std::string
surfaceCellsProblem(const Floorplan& plan, double size)
{
  double cells = 0;
  for (const auto& room : plan.rooms)
    cells += estimatedCells(room, size);
  if (cells <= max_surface_cells)
    return {};
  const std::string count =
      std::isfinite(cells) ? "about " + numberText(cells) : "countless";
  return "the surfaces of the floor plan would have " + count + " cells of " +
         numberText(size) + " m, at most " + numberText(max_surface_cells) +
         " can be held: take larger cells";
}

Refinement
refineToPlan(const PointView& points,
             const std::vector<int>& indices,
             const std::vector<std::uint32_t>& labels,
             const std::vector<std::uint32_t>& rooms,
             const Floorplan& plan,
             double farthest,
             unsigned threads)
{
  std::map<std::uint32_t, RoomSurfaces> surfaces;
  for (const auto& room : plan.rooms)
    surfaces.try_emplace(room.id, room, farthest);

  std::vector<SurfacePoint> snapped(indices.size());
  std::vector<std::uint8_t> is_structure(indices.size(), 0);
  parallelFor(indices.size(), 4096, threads, [&](std::size_t k) {
    const auto i = static_cast<std::size_t>(indices[k]);
    const auto room = surfaces.find(rooms[i]);
    if (room == surfaces.end() || !points.isFinite(i))
      return;
    is_structure[k] =
        room->second.snap(points[i].cast<double>(),
                          static_cast<StructureLabel>(labels[i]), snapped[k])
            ? 1
            : 0;
  });

  Refinement result;
  for (std::size_t k = 0; k < indices.size(); ++k)
    if (is_structure[k]) {
      result.sources.push_back(indices[k]);
      result.points.push_back(snapped[k]);
    }
  return result;
}

OpeningSpaces::OpeningSpaces(const Floorplan& plan)
{
  for (const PlanOpening& opening : plan.openings) {
    spaces_.push_back({opening});
    for (const OpeningWall& of : opening.walls) {
      const PlanRoom* const room = findRoom(plan, of.room);
      if (!room || of.element >= room->boundary.elements.size())
        continue;
      const PlanElement& wall = room->boundary.elements[of.element];
      const double s = wall.project((opening.start + opening.end) / 2);
      spaces_.back().foot = room->floor.heightAt(wall.pointAt(s));
      spaces_.back().run = std::tan(wall.tilt) * wall.normalAt(s);
      break;
    }
  }
}

bool
OpeningSpaces::contains(const Eigen::Vector3d& place, double margin) const
{
  constexpr double beside = 0.1; // the bulge of a curved wall, metres
  return std::any_of(spaces_.begin(), spaces_.end(), [&](const Space& space) {
    const PlanOpening& o = space.opening;
    if (place.z() <= o.bottom - margin || place.z() >= o.top + margin)
      return false;
    const double half = o.width() / 2;
    const Eigen::Vector2d way = (o.end - o.start) / (2 * half);
    const Eigen::Vector2d off =
        place.head<2>() - (place.z() - space.foot) * space.run - (o.start + o.end) / 2;
    const double along = off.dot(way) / (half + margin); // -1 to 1
    return std::abs(along) < 1 &&
           std::abs(way.x() * off.y() - way.y() * off.x()) <= o.depth / 2 + beside &&
           place.z() < o.top + margin - o.rise * (1 - std::sqrt(1 - along * along));
  });
}

std::vector<RepairedPoint>
repairHoles(const std::vector<SurfacePoint>& refined,
            const Floorplan& plan,
            double cell_size)
{
  std::map<std::uint32_t, std::vector<std::size_t>> points_of;
  for (std::size_t i = 0; i < refined.size(); ++i)
    points_of[refined[i].room].push_back(i);
  std::vector<RepairedPoint> repaired;
  for (const auto& room : plan.rooms) {
    SurfaceCells cells(room, cell_size);
    for (const std::size_t i : points_of[room.id])
      cells.occupy(refined[i], i);
    repaired.reserve(repaired.size() + cells.cells().size());
    for (const auto& cell : cells.cells()) {
      if (cell.is_occupied)
        repaired.push_back({refined[cell.source], static_cast<int>(cell.source)});
      else
        repaired.push_back({cell.centre, -1});
    }
  }
  return repaired;
}

} // namespace pcl::sedr
