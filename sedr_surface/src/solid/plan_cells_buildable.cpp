// SPDX-License-Identifier: BSD-3-Clause
#include "plan_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Pieces of a room with a smaller area are removed, square metres. */
constexpr double crumb = 0.01;

template <typename... Values>
std::string
textOf(const char* format, Values... values)
{
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

} // namespace

double
PlanCells::heightOf(int slab, std::uint32_t vertex) const
{
  return layers_.slabs[static_cast<std::size_t>(slab)].slab.heightAt(
      grid_.toPlan(arrangement_.vertices[vertex]));
}

double
PlanCells::clearance(const Part& part) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t t : part.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      least = std::min(least, heightOf(part.region.ceiling, corner(t, i)) -
                                  heightOf(part.region.floor, corner(t, i)));
  return least;
}

bool
PlanCells::touchesBeside(const Part& part) const
{
  for (const std::uint32_t t : part.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const PlanRegion other = across(t, i);
      const auto meet = [&](int slab, int other_slab) {
        const auto isNear = [&](std::uint32_t v) {
          return std::abs(heightOf(slab, v) - heightOf(other_slab, v)) < minClearance();
        };
        return isNear(corner(t, i)) && isNear(corner(t, i + 1));
      };
      if (other.isRoom() &&
          (meet(part.region.floor, other.ceiling) ||
           (layers_.isNiche(part.region) && meet(part.region.ceiling, other.floor))))
        return true;
    }
  return false;
}

bool
PlanCells::isOpen(const Part& part) const
{
  for (const std::uint32_t t : part.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const PlanRegion other = across(t, i);
      // An earlier niche is open itself, or is left out before the next round.
      if (!other.isRoom() ||
          (layers_.isNiche(other) && other.floor >= part.region.floor))
        continue;
      const auto overlapAt = [&](std::uint32_t v) {
        return std::min(heightOf(part.region.ceiling, v), heightOf(other.ceiling, v)) -
               std::max(heightOf(part.region.floor, v), heightOf(other.floor, v));
      };
      if (overlapAt(corner(t, i)) > minClearance() &&
          overlapAt(corner(t, i + 1)) > minClearance())
        return true;
    }
  return false;
}

std::string
PlanCells::problemOf(const Part& part) const
{
  if (!part.region.isRoom())
    return {};
  const double height = clearance(part);
  if (height < minClearance())
    return textOf("comes down to %.3f m above what is below it", height);
  if (layers_.isNiche(part.region) && !isOpen(part))
    return "is not open to the room";
  if (part.region != layers_.plainRegions(part.region).front() && touchesBeside(part))
    return "is where the ceiling beside it is";
  return {};
}

void
PlanCells::dropUnbuildable(std::vector<PlanWarning>& warnings)
{
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (Part& part : regions()) {
      const std::string problem = problemOf(part);
      if (problem.empty())
        continue;
      const PlanRegion region = part.region;
      for (const PlanRegion& plain : layers_.plainRegions(region)) {
        part.region = plain;
        if (plain != region && problemOf(part).empty())
          break;
      }
      const bool is_floor = part.region.isRoom() && part.region.floor != region.floor;
      const int slab = is_floor ? region.floor : region.ceiling;
      const std::size_t element = layers_.slabs[static_cast<std::size_t>(slab)].element;
      warnings.push_back({WarningKind::Contradiction,
                          {part.area},
                          0,
                          0,
                          layers_.elements[element].name + " " + problem +
                              textOf(": %.2f m2 are left out", part.area)});
      assign(part, part.region);
      is_changed = true;
      break;
    }
  }
}

void
PlanCells::checkPieces(std::vector<PlanWarning>& warnings)
{
  std::vector<Part> pieces = roomPieces();
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Part& a, const Part& b) { return a.area > b.area; });
  while (pieces.size() > 1 && pieces.back().area < crumb) {
    assign(pieces.back(), PlanRegion());
    pieces.pop_back();
  }
  if (pieces.size() > 1)
    warnings.push_back({WarningKind::Contradiction,
                        {pieces[1].area},
                        0,
                        0,
                        textOf("its plan falls into %zu pieces, the largest of %.2f m2 "
                               "and %.2f m2",
                               pieces.size(), pieces[0].area, pieces[1].area)});
}

} // namespace pcl::sedr
