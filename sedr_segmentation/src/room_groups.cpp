// SPDX-License-Identifier: BSD-3-Clause
#include "room_groups.h"

#include "room_frontiers.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

/** @brief Number of cell edges across which two pieces face each other. */
std::size_t
lengthOf(const Frontier& frontier)
{
  return frontier.wall + frontier.plain + frontier.passage.size() + frontier.hidden;
}

/** @brief Number of cell edges around a piece. */
std::size_t
perimeterOf(const CellMask& cells)
{
  std::size_t edges = 0;
  for (std::size_t i = 0; i < cells.values().size(); ++i) {
    if (!cells.values()[i])
      continue;
    const Cell c = cells.cellAt(i);
    for (const Cell d : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}})
      edges += cells.at({c.x + d.x, c.y + d.y}) ? 0 : 1;
  }
  return edges;
}

/** @brief The outline of a piece. */
struct Outline {
  std::size_t perimeter = 0; ///< cell edges
  CellBox box;
};

/** @brief Number of cell edges around a box. */
std::size_t
perimeterOf(const CellBox& box)
{
  return 2 * static_cast<std::size_t>(std::int64_t{box.high.x} - box.low.x + 1 +
                                      box.high.y - box.low.y + 1);
}

/** @brief Cell edges around each group of pieces, by its number, but for those between
 * its own pieces; no fewer than around its box: frontiers are longer than the edges on
 * either side of them, the more so the more strips a vault is cut into. */
std::vector<std::size_t>
perimetersOf(const std::vector<Outline>& outlines,
             const Frontiers& frontiers,
             const std::vector<std::size_t>& group)
{
  std::vector<std::size_t> all(group.size(), 0);
  std::vector<CellBox> boxes(group.size(), CellBox{{0, 0}, {-1, -1}});
  for (std::size_t p = 0; p < group.size(); ++p) {
    all[group[p]] += outlines[p].perimeter;
    boxes[group[p]] = around(boxes[group[p]], outlines[p].box);
  }
  for (const auto& [pair, frontier] : frontiers)
    if (group[pair.first] == group[pair.second])
      all[group[pair.first]] -=
          std::min(all[group[pair.first]], 2 * lengthOf(frontier));
  for (std::size_t g = 0; g < all.size(); ++g)
    if (all[g] > 0)
      all[g] = std::max(all[g], perimeterOf(boxes[g]));
  return all;
}

/** @brief The longest stretch of a frontier that may be a doorway, in cells; a gap of a
 * cell ends none. */
std::size_t
widestSpan(const std::vector<CellKey>& passage)
{
  const CellSet cells(passage);
  std::vector<CellKey> bridged;
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        bridged.push_back(keyOf({cells[i].x + dx, cells[i].y + dy}));
  const CellSet strips(std::move(bridged));
  const CellRegions regions = labelRegions(strips);
  std::vector<std::size_t> length(regions.sizes.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
    ++length[regions.label[strips.find(cells[i])]];
  return length.empty() ? 0 : *std::max_element(length.begin(), length.end());
}

/** @brief Whether the frontier is open: one room, not two. It must be a good part of
 * the outline of the smaller side, else it is a passage.
 * @param around cell edges around the smaller side */
bool
isOpen(const Frontier& frontier, std::size_t around, const RoomParameters& parameters)
{
  const std::size_t open = frontier.plain + frontier.passage.size();
  const std::size_t total = frontier.wall + open;
  // What furniture hides is as open as the rest.
  const double extent = static_cast<double>(open) *
                        (1 + static_cast<double>(frontier.hidden) /
                                 static_cast<double>(std::max<std::size_t>(1, total)));
  if (extent < parameters.minimum_open_share * static_cast<double>(around))
    return false;
  if (2 * frontier.plain >= total || 4 * open >= 3 * total)
    return true; // a door is a small part of what is wall else
  const double widest =
      static_cast<double>(widestSpan(frontier.passage)) * parameters.cell_size;
  return widest > parameters.widest_door && 2 * open > total;
}

/** @brief The frontiers between groups of pieces, by the groups' numbers. */
Frontiers
betweenGroups(const Frontiers& frontiers, const std::vector<std::size_t>& group)
{
  Frontiers merged;
  for (const auto& [pair, frontier] : frontiers) {
    const std::size_t a = group[pair.first];
    const std::size_t b = group[pair.second];
    if (a == b)
      continue;
    Frontier& sum = merged[{std::min(a, b), std::max(a, b)}];
    sum.wall += frontier.wall;
    sum.plain += frontier.plain;
    sum.hidden += frontier.hidden;
    sum.passage.insert(sum.passage.end(), frontier.passage.begin(),
                       frontier.passage.end());
  }
  return merged;
}

/** @brief Joins the groups that `areOne(frontier, around)` says are one, those that are
 * open along most of the smaller side first, until none is left: what is measured of a
 * group is that of all that has been joined to it. */
template <typename AreOne>
void
joinGroups(const std::vector<Outline>& outlines,
           const Frontiers& frontiers,
           AreOne areOne,
           std::vector<std::size_t>& group)
{
  for (bool has_changed = true; has_changed;) {
    const std::vector<std::size_t> edges = perimetersOf(outlines, frontiers, group);
    std::pair<std::size_t, std::size_t> joined;
    double most = 0;
    for (const auto& [pair, frontier] : betweenGroups(frontiers, group)) {
      const std::size_t smaller = std::min(edges[pair.first], edges[pair.second]);
      const double share =
          static_cast<double>(frontier.plain + frontier.passage.size()) /
          static_cast<double>(std::max<std::size_t>(1, smaller));
      if (share <= most || !areOne(frontier, smaller))
        continue;
      most = share;
      joined = pair;
    }
    has_changed = most > 0;
    if (has_changed)
      std::replace(group.begin(), group.end(), joined.second, joined.first);
  }
}

} // namespace

std::vector<std::size_t>
groupPieces(const Storey& storey,
            const std::vector<Piece>& pieces,
            const CellMask& passages)
{
  const Frontiers frontiers = frontiersOf(storey, pieces, passages);
  std::vector<std::size_t> group(pieces.size());
  std::vector<Outline> outlines;
  for (const auto& piece : pieces)
    outlines.push_back({perimeterOf(piece.cells), boxOf(piece.cells.toSet())});
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto isOpenAbove = [&](const Frontier& frontier, std::size_t around) {
    return 2 * frontier.plain >=
               frontier.wall + frontier.plain + frontier.passage.size() &&
           isOpen(frontier, around, storey.parameters);
  };
  const auto isOpenBelow = [&](const Frontier& frontier, std::size_t around) {
    return isOpen(frontier, around, storey.parameters);
  };
  joinGroups(outlines, frontiers, isOpenAbove, group);
  joinGroups(outlines, frontiers, isOpenBelow, group);
  return group;
}

} // namespace sedr
} // namespace pcl
