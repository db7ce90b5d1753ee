// SPDX-License-Identifier: BSD-3-Clause
#include "opening_search.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/plan/plan_surfaces.h"

#include <algorithm>
#include <map>

namespace pcl::sedr {
namespace {

/** @brief Numbers of seen, hidden, open and proved open cells of a surface. */
struct CellCounts : ElementEvidence {
  double proved = 0;
};

/** @brief Counts the cells of a map that lie on a surface, which its side may go
 * beyond.
 */
void
addCells(const WallSide& side,
         const WallMap& map,
         const VerticalSurface& surface,
         const std::vector<WallRectangle>& openings,
         CellCounts& counts)
{
  const double length = surface.element->length();
  const double margin = std::min(opening_numbers.on_face, length / 4);
  const double start =
      side.line.isArc() ? 0 : side.line.project(surface.element->start);
  for (std::size_t c = 0; c < map.columns(); ++c) {
    const double from = map.cell() * static_cast<double>(c);
    const double to = std::min(from + map.cell(), side.line.length());
    const double s = (from + to) / 2 - start;
    if (s < margin || s > length - margin)
      continue;
    const VerticalSpan span = surface.spanAt(s);
    for (std::size_t r = 0; r < map.rows(); ++r) {
      const double z = map.heightOf(r) + map.cell() / 2;
      const WallCell state = map.at(c, r);
      if (z < span.low + map.slabBand() || z > span.high - map.slabBand() ||
          state == WallCell::Beyond)
        continue;
      const bool is_open =
          std::any_of(openings.begin(), openings.end(), [&](const WallRectangle& at) {
            return s + start > at.from && s + start < at.to && z > at.bottom &&
                   z < at.top;
          });
      const bool is_seen =
          !is_open && (state == WallCell::Seen || map.offsetAt(c, r) == 0);
      if (is_open)
        ++counts.opening;
      else if (is_seen)
        ++counts.seen;
      else if (isHidden(state) || state == WallCell::Shaded)
        ++counts.hidden;
      else
        ++counts.opening;
      counts.proved += is_open || (!is_seen && state == WallCell::Through) ? 1 : 0;
    }
  }
}

/** @brief Returns the shares of counted cells. If the surface was not in view, all
 * cells that are in no opening and no ray passed through are hidden. */
ElementEvidence
sharesOf(const CellCounts& counts)
{
  constexpr double in_view = 0.05; // share that was seen of a surface in view
  const double all = counts.seen + counts.hidden + counts.opening;
  if (all == 0)
    return {};
  const double seen = counts.seen / all;
  if (seen >= in_view)
    return {seen, counts.hidden / all, counts.opening / all};
  const double open = counts.proved / all;
  return {seen, std::max(0.0, 1 - seen - open), open};
}

} // namespace

void
measureEvidence(const OpeningSearch& search, unsigned threads, Floorplan& plan)
{
  std::map<const PlanElement*, std::size_t> side_of;
  for (std::size_t k = 0; k < search.sides.size(); ++k)
    side_of[&search.sides[k].in(plan)] = k;
  std::vector<CellCounts> counts(search.sides.size());
  parallelFor(plan.rooms.size(), 1, threads, [&](std::size_t r) {
    for (const VerticalSurface& surface : verticalSurfaces(plan.rooms[r]))
      if (const auto side = side_of.find(surface.element); side != side_of.end())
        addCells(search.sides[side->second], search.maps[side->second], surface,
                 openingsOn(plan, search.sides[side->second]), counts[side->second]);
  });
  for (std::size_t k = 0; k < counts.size(); ++k)
    search.sides[k].in(plan).evidence = sharesOf(counts[k]);
}

} // namespace pcl::sedr
