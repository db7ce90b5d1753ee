// SPDX-License-Identifier: BSD-3-Clause
#include "surface_cells.h"
#include "../base/number_text.h"

#include <pcl/sedr_filters/impl/refinement.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

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

/** @brief Returns the bounding box of a loop's polygon. */
Eigen::AlignedBox2d
boxOf(const PlanLoop& loop, double tolerance)
{
  Eigen::AlignedBox2d box;
  for (const auto& corner : loop.polygon(tolerance))
    box.extend(corner);
  return box;
}

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
    cells += 2 * boxOf(loop, size / 10).sizes().prod() / (size * size);
  };
  if (!room.boundary.elements.empty())
    addSheets(room.boundary);
  for (const PlanNiche& niche : room.niches)
    addSheets(niche.boundary);
  return cells;
}

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

SurfaceCells::SurfaceCells(const PlanRoom& room, double size)
    : room_(room)
    , lookup_(room)
    , size_(size)
    , near_(std::max(0.25, size))
{
  for (const auto& surface : verticalSurfaces(room_))
    addStrip(surface);
  for (std::size_t i = 0; i < strips_.size(); ++i)
    near_.addAlong(*strips_[i].surface.element, size_, static_cast<std::uint32_t>(i));
  near_.finish();
  addSlabs();
}

void
SurfaceCells::addStrip(const VerticalSurface& surface)
{
  Strip strip{surface, surface.element->length(), {}, {}};
  const std::size_t columns = partsOf(strip.length, size_);
  for (std::size_t c = 0; c < columns; ++c) {
    const double s =
        strip.length * (static_cast<double>(c) + 0.5) / static_cast<double>(columns);
    const VerticalSpan span = surface.spanAt(s);
    strip.first.push_back(cells_.size());
    strip.spans.push_back(span);
    if (!(span.high - span.low > min_riser))
      continue;
    const std::size_t rows = partsOf(span.high - span.low, size_);
    const Eigen::Vector2d place = surface.element->pointAt(s);
    const Eigen::Vector3d normal = surface.normalAt(s);
    for (std::size_t r = 0; r < rows; ++r) {
      SurfaceCell cell;
      cell.centre.position << place, span.low + (span.high - span.low) *
                                                    (static_cast<double>(r) + 0.5) /
                                                    static_cast<double>(rows);
      cell.centre.normal = normal;
      cell.centre.label = surface.label;
      cell.centre.room = room_.id;
      cells_.push_back(cell);
    }
  }
  strip.first.push_back(cells_.size());
  starts_.push_back(cells_.size());
  strips_.push_back(std::move(strip));
}

template <typename PointAt>
void
SurfaceCells::addSheet(const PlanLoop& loop, PointAt pointAt)
{
  Sheet sheet;
  const Eigen::AlignedBox2d box = boxOf(loop, size_ / 10);
  if (!box.isEmpty()) {
    sheet.origin = box.min();
    const Eigen::Vector2d extent = box.sizes() / size_;
    sheet.width = static_cast<std::size_t>(extent.x()) + 1;
    sheet.height = static_cast<std::size_t>(extent.y()) + 1;
  }
  for (std::size_t i = 0; i < sheet.width * sheet.height; ++i) {
    const auto placeOf = [&](std::size_t part, std::size_t parts) -> Eigen::Vector2d {
      const auto middle = [parts](std::size_t cell, std::size_t k) {
        return static_cast<double>(cell) +
               (static_cast<double>(k) + 0.5) / static_cast<double>(parts);
      };
      return sheet.origin +
             size_ * Eigen::Vector2d(middle(i % sheet.width, part % parts),
                                     middle(i / sheet.width, part / parts));
    };
    SurfaceCell cell;
    const bool is_there = pointAt(placeOf(0, 1), cell.centre);
    const std::size_t parts = is_there ? partsOf(cell.centre.normal) : 1;
    sheet.parts.push_back(static_cast<std::uint8_t>(parts));
    sheet.first.push_back(sheet.cell.size());
    for (std::size_t part = 0; part < parts * parts; ++part) {
      const bool is_part =
          parts == 1 ? is_there : pointAt(placeOf(part, parts), cell.centre);
      sheet.cell.push_back(is_part ? cells_.size() : none);
      if (is_part)
        cells_.push_back(cell);
    }
  }
  starts_.push_back(cells_.size());
  sheets_.push_back(std::move(sheet));
}

void
SurfaceCells::addSlabs()
{
  for (const bool is_floor : {true, false})
    addSheet(room_.boundary, [&](const Eigen::Vector2d& place, SurfacePoint& point) {
      if (!lookup_.contains(place))
        return false;
      point = slabPointAt(lookup_, place, is_floor);
      return true;
    });
  for (const PlanNiche& niche : room_.niches)
    for (const bool is_bottom : {true, false})
      addSheet(niche.boundary, [&](const Eigen::Vector2d& place, SurfacePoint& point) {
        point = nichePointAt(room_, niche, place, is_bottom);
        return niche.boundary.contains(place) && !lookup_.isWithinBoundary(place);
      });
}

std::size_t
SurfaceCells::cellOf(const Sheet& sheet, const Eigen::Vector2d& place) const
{
  const Eigen::Vector2d exact = (place - sheet.origin) / size_;
  const Eigen::Vector2d at = exact.array().floor();
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < static_cast<double>(sheet.width) &&
        at.y() < static_cast<double>(sheet.height)))
    return none;
  const std::size_t i =
      static_cast<std::size_t>(at.y()) * sheet.width + static_cast<std::size_t>(at.x());
  const std::size_t parts = sheet.parts[i];
  const auto partOf = [parts](double share) {
    return std::min(parts - 1,
                    static_cast<std::size_t>(share * static_cast<double>(parts)));
  };
  return sheet.cell[sheet.first[i] + partOf(exact.y() - at.y()) * parts +
                    partOf(exact.x() - at.x())];
}

std::size_t
SurfaceCells::findLevel(const SurfacePoint& point) const
{
  const Eigen::Vector2d place = point.position.head<2>();
  const bool faces_up = point.normal.z() > 0;
  const int n = lookup_.nicheAt(place);
  if (n >= 0 && !lookup_.isWithinBoundary(place))
    return cellOf(sheets_[2 + 2 * static_cast<std::size_t>(n) + (faces_up ? 0 : 1)],
                  place);
  return cellOf(sheets_[faces_up ? 0 : 1], place);
}

std::size_t
SurfaceCells::findVertical(const SurfacePoint& point) const
{
  const Eigen::Vector2d place = point.position.head<2>();
  std::size_t best = none;
  double least = size_;
  for (const std::uint32_t i : near_.at(place)) {
    const Strip& strip = strips_[i];
    if (strip.surface.label != point.label)
      continue;
    const double s = strip.surface.element->project(place);
    const double d = (strip.surface.element->pointAt(s) - place).norm();
    if (d >= least)
      continue;
    const std::size_t columns = strip.spans.size();
    const auto c =
        std::min(columns - 1, static_cast<std::size_t>(s / strip.length *
                                                       static_cast<double>(columns)));
    const std::size_t rows = strip.first[c + 1] - strip.first[c];
    const VerticalSpan& span = strip.spans[c];
    const double t = (point.position.z() - span.low) / (span.high - span.low);
    if (rows == 0 || !(t >= 0 && t <= 1))
      continue;
    least = d;
    best = strip.first[c] +
           std::min(rows - 1, static_cast<std::size_t>(t * static_cast<double>(rows)));
  }
  return best;
}

bool
SurfaceCells::occupy(const SurfacePoint& point, std::size_t source)
{
  // Undersides and risers of details share a label: the normal distinguishes them.
  const bool is_slab = point.label == StructureLabel::Ceiling ||
                       point.label == StructureLabel::Floor ||
                       std::abs(point.normal.z()) > 0.5;
  const std::size_t index = is_slab ? findLevel(point) : findVertical(point);
  if (index == none)
    return false;
  SurfaceCell& cell = cells_[index];
  const double distance = (point.position - cell.centre.position).norm();
  if (cell.is_occupied && cell.distance <= distance)
    return true;
  cell.is_occupied = true;
  cell.source = source;
  cell.distance = distance;
  return true;
}

} // namespace pcl::sedr
