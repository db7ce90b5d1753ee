// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/hidden_ceiling.h>
#include <pcl/sedr_segmentation/room_segmentation.h>

#include <pcl/sedr_filters/plane_fit.h>
#include <pcl/sedr_segmentation/box_clusters.h>
#include <pcl/sedr_segmentation/cell_count.h>
#include <pcl/sedr_segmentation/column_table.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace pcl {
namespace sedr {

namespace {

/** @brief How much more than the ceilings is looked at on each side, metres: walls that
 * something parts from them. */
constexpr double margin = 0.75;

/** @brief A connected piece of one ceiling. */
struct Piece {
  std::size_t level = 0;
  std::size_t floor = 0;
  CellMask cells;
  std::size_t size = 0;
};

/** @brief What all steps look at. */
struct Storey {
  const std::vector<Level>& levels;
  const RoomParameters& parameters;
  CellGrid grid;
  CellBox box;
  ColumnTable columns;

  double heightOf(std::size_t level, Cell cell) const
  {
    return levels[level].slab.heightAt(grid.centre(cell));
  }

  /** @brief Whether a wall goes up to `top` in this column. */
  bool isWallBelow(Cell cell, double top) const
  {
    return columns.share(cell, top - 0.6, top - 0.1, 5, 0) >= 0.6;
  }

  /** @brief Whether the column is a wall from the floor up to the ceiling: a cupboard
   * is not, nor is what stands below a beam. */
  bool isWall(Cell cell, double floor, double top) const
  {
    return columns.share(cell, top - 0.36, top - 0.08, 3, 1) >= 1 &&
           columns.share(cell, floor + 0.2, top - 0.15, 8, 0) >= 0.5 &&
           columns.share(cell, (floor + top) / 2, top - 0.15, 5, 0) >= 0.5;
  }

  /** @brief Whether a sill stands in the column: something upright from near the floor
   * up to 0.8 m. */
  bool isSill(Cell cell, double floor) const
  {
    return columns.share(cell, floor + 0.2, floor + 0.8, 4, 1) >= 0.75;
  }
};

/** @brief The pieces of one ceiling level. */
std::vector<Piece>
piecesOf(const Storey& storey, std::size_t level)
{
  const CellMask seen(storey.levels[level].cells, storey.box);
  // Closing bridges what was not hit; walls stay out.
  const double size = storey.grid.size();
  const int gap = cellsFor(0.1, size);
  CellMask closed = eroded(dilated(seen, gap), gap);
  for (std::size_t i = 0; i < closed.values().size(); ++i)
    if (closed.values()[i] && !seen.values()[i]) {
      const Cell cell = closed.cellAt(i);
      closed.values()[i] =
          storey.isWallBelow(cell, storey.heightOf(level, cell)) ? 0 : 1;
    }
  const double neck = 1.5 * cellsFor(0.05, size);
  const CellMask core = eroded(closed, neck);
  MaskRegions regions = labelRegions(core, true);
  growLabels(closed, static_cast<int>(2 * neck), regions.label);

  const double cell_area = size * size;
  std::vector<Piece> pieces;
  for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
    if (static_cast<double>(regions.sizes[r]) * cell_area <
        0.25 * storey.parameters.minimum_area)
      continue;
    Piece piece;
    piece.level = level;
    piece.cells = regionMask(closed, regions, static_cast<std::int32_t>(r));
    piece.size = piece.cells.count();
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/** @brief The lowest floor with enough of the piece; false where there is none. */
bool
findFloor(const Storey& storey, Piece& piece)
{
  double best = 0;
  for (std::size_t f = 0; f < storey.levels.size(); ++f) {
    if (storey.levels[f].kind != LevelKind::Floor)
      continue;
    std::size_t covered = 0;
    const CellSet& cells = storey.levels[f].cells;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (piece.cells.at(cells[i]) &&
          storey.heightOf(f, cells[i]) <
              storey.heightOf(piece.level, cells[i]) - storey.parameters.minimum_height)
        ++covered;
    const double share = static_cast<double>(covered) / static_cast<double>(piece.size);
    if (share > best && best < storey.parameters.minimum_floor_share) {
      best = share;
      piece.floor = f;
    }
  }
  return best >= storey.parameters.minimum_floor_share;
}

/** @brief How two pieces face each other, in cell edges. */
struct Frontier {
  std::size_t wall = 0;
  std::size_t plain = 0; ///< nothing below: a step, a soffit
  std::vector<CellKey>
      below_lintel;       ///< something above, nothing below: a beam or a doorway
  std::size_t hidden = 0; ///< something above, furniture below
};

/** @brief The cells from `cell` back to the piece that it was reached from. */
std::vector<Cell>
wayBack(std::size_t i, const CellMask& domain, const std::vector<std::size_t>& parent)
{
  std::vector<Cell> way;
  for (; i != CellSet::npos; i = parent[i])
    way.push_back(domain.cellAt(i));
  return way;
}

/** @brief Whether two pieces are at one height here. A beam parts one ceiling; what
 * hangs below both of two ceilings is the head of a passage. */
bool
isSameHeight(const Storey& storey, const Piece& a, const Piece& b, Cell cell)
{
  constexpr double most_step = 0.15;
  return std::abs(storey.heightOf(a.level, cell) - storey.heightOf(b.level, cell)) <=
         most_step;
}

void
judgeMeeting(const Storey& storey,
             const Piece& a,
             const Piece& b,
             const std::vector<Cell>& way,
             Frontier& frontier)
{
  const double top = std::min(storey.heightOf(a.level, way.front()),
                              storey.heightOf(b.level, way.front()));
  const double floor = std::max(storey.heightOf(a.floor, way.front()),
                                storey.heightOf(b.floor, way.front()));
  bool has_lintel = false;
  for (const Cell cell : way) {
    if (storey.isWall(cell, floor, top)) {
      ++frontier.wall;
      return;
    }
    has_lintel = has_lintel || storey.columns.hasWithin(cell, top - 0.5, top - 0.12);
  }
  // One walks below a beam: the floor goes on there, as it does not in a window. What
  // furniture hides of it says neither.
  const bool has_floor =
      storey.columns.share(way.front(), floor - 0.1, floor + 0.1, 1, 1) >= 1;
  if (!has_lintel)
    ++frontier.plain;
  else if (!has_floor) {
    const bool has_sill = std::any_of(
        way.begin(), way.end(), [&](Cell cell) { return storey.isSill(cell, floor); });
    ++(has_sill ? frontier.wall : frontier.hidden);
  }
  else if (isSameHeight(storey, a, b, way.front()))
    frontier.below_lintel.push_back(keyOf(way.front()));
}

/** @brief Where pieces face each other across at most 0.4 m each. */
std::map<std::pair<std::size_t, std::size_t>, Frontier>
frontiersOf(const Storey& storey, const std::vector<Piece>& pieces)
{
  const int steps = cellsFor(0.4, storey.grid.size());
  CellMask everywhere(storey.box);
  std::fill(everywhere.values().begin(), everywhere.values().end(), std::uint8_t{1});
  std::vector<std::int32_t> label(everywhere.values().size(), -1);
  for (std::size_t p = 0; p < pieces.size(); ++p)
    for (std::size_t i = 0; i < label.size(); ++i)
      if (pieces[p].cells.values()[i] && label[i] < 0)
        label[i] = static_cast<std::int32_t>(p);
  const std::vector<std::size_t> parent =
      growLabelsWithParents(everywhere, steps, label);

  std::map<std::pair<std::size_t, std::size_t>, Frontier> frontiers;
  for (std::size_t i = 0; i < label.size(); ++i) {
    const Cell cell = everywhere.cellAt(i);
    for (const Cell d : {Cell{1, 0}, Cell{0, 1}}) {
      const Cell to{cell.x + d.x, cell.y + d.y};
      if (label[i] < 0 || !everywhere.at(to))
        continue;
      const std::size_t j = everywhere.indexOf(to);
      if (label[j] < 0 || label[j] == label[i])
        continue;
      const auto a = static_cast<std::size_t>(std::min(label[i], label[j]));
      const auto b = static_cast<std::size_t>(std::max(label[i], label[j]));
      std::vector<Cell> way = wayBack(i, everywhere, parent);
      const std::vector<Cell> other = wayBack(j, everywhere, parent);
      way.insert(way.end(), other.begin(), other.end());
      judgeMeeting(storey, pieces[a], pieces[b], way, frontiers[{a, b}]);
    }
  }
  return frontiers;
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

/** @brief The longest stretch of a frontier below a lintel, in cells; a gap of a cell
 * ends none. */
std::size_t
widestSpan(const std::vector<CellKey>& below_lintel)
{
  const CellSet cells(below_lintel);
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
  const std::size_t open = frontier.plain + frontier.below_lintel.size();
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
      static_cast<double>(widestSpan(frontier.below_lintel)) * parameters.cell_size;
  return widest > parameters.widest_door && 2 * open > total;
}

using Frontiers = std::map<std::pair<std::size_t, std::size_t>, Frontier>;

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
    sum.below_lintel.insert(sum.below_lintel.end(), frontier.below_lintel.begin(),
                            frontier.below_lintel.end());
  }
  return merged;
}

/** @brief Cell edges around each group, by its number. */
std::vector<std::size_t>
perimetersOf(const std::vector<Piece>& pieces, const std::vector<std::size_t>& group)
{
  std::map<std::size_t, CellMask> cells;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const auto [it, is_new] = cells.emplace(group[p], pieces[p].cells);
    if (!is_new)
      it->second = unite(it->second, pieces[p].cells);
  }
  std::vector<std::size_t> perimeters(pieces.size(), 0);
  for (const auto& [number, mask] : cells)
    perimeters[number] = perimeterOf(mask);
  return perimeters;
}

/** @brief Joins the groups that `areOne(frontier, around)` says are one, until none is
 * left. */
template <typename AreOne>
void
joinGroups(const std::vector<Piece>& pieces,
           const Frontiers& frontiers,
           AreOne areOne,
           std::vector<std::size_t>& group)
{
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    const std::vector<std::size_t> perimeters = perimetersOf(pieces, group);
    for (const auto& [pair, frontier] : betweenGroups(frontiers, group)) {
      if (!areOne(frontier, std::min(perimeters[pair.first], perimeters[pair.second])))
        continue;
      const std::size_t kept = std::min(group[pair.first], group[pair.second]);
      const std::size_t gone = std::max(group[pair.first], group[pair.second]);
      std::replace(group.begin(), group.end(), gone, kept);
      has_changed = true;
    }
  }
}

/** @brief Group of every piece: first what meets without anything between, then what
 * meets below beams, for a beam may part each of two rows of coffers from the other by
 * bits, and a half of a ceiling alone makes a doorway look wide. */
std::vector<std::size_t>
groupPieces(const Storey& storey, const std::vector<Piece>& pieces)
{
  const Frontiers frontiers = frontiersOf(storey, pieces);
  std::vector<std::size_t> group(pieces.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto isOpenAbove = [&](const Frontier& frontier, std::size_t around) {
    return 2 * frontier.plain >=
               frontier.wall + frontier.plain + frontier.below_lintel.size() &&
           isOpen(frontier, around, storey.parameters);
  };
  const auto isOpenBelow = [&](const Frontier& frontier, std::size_t around) {
    return isOpen(frontier, around, storey.parameters);
  };
  joinGroups(pieces, frontiers, isOpenAbove, group);
  joinGroups(pieces, frontiers, isOpenBelow, group);
  return group;
}

/** @brief A room with what was not seen within it: gaps between its ceilings closed. */
CellMask
solidOf(const Storey& storey, const CellMask& scope)
{
  const double gap = cellsFor(0.4, storey.grid.size());
  const CellMask closed = eroded(dilated(scope, gap), gap);
  return unite(closed, enclosedCells(closed));
}

/** @brief What stands and lies around a room. */
struct Surroundings {
  CellMask walls; ///< columns that are occupied in the upper half of the room
  CellMask floor; ///< cells outside of the room where the floor goes on
};

Surroundings
surroundingsOf(const Storey& storey, const CellMask& solid, const Piece& main)
{
  Surroundings around{CellMask(solid.box()), CellMask(solid.box())};
  const int reach = cellsFor(0.7, storey.grid.size());
  const CellMask rim = subtract(dilated(solid, reach), eroded(solid, reach));
  for (std::size_t i = 0; i < rim.values().size(); ++i) {
    if (!rim.values()[i])
      continue;
    const Cell cell = rim.cellAt(i);
    const double top = storey.heightOf(main.level, cell);
    const double floor = storey.heightOf(main.floor, cell);
    around.walls.values()[i] =
        storey.columns.share(cell, (floor + top) / 2, top - 0.1, 8, 1) >= 0.6 ? 1 : 0;
    around.floor.values()[i] =
        !solid.values()[i] && storey.columns.hasWithin(cell, floor - 0.07, floor + 0.07)
            ? 1
            : 0;
  }
  return around;
}

/** @brief How much of a room's outline is closed rather than open: the share with a
 * wall within 0.6 m, for a cupboard may hide the ceiling that far, less the share
 * across which the floor goes on and no wall stands. What is seen through a door or a
 * window only has no walls towards it, and less of its ceiling is seen than of its
 * floor. */
double
enclosureOf(const Storey& storey, const CellMask& solid, const Piece& main)
{
  const double size = storey.grid.size();
  const Surroundings around = surroundingsOf(storey, solid, main);
  const CellMask outline = subtract(dilated(solid, 1), solid);
  const CellMask walled = dilated(around.walls, cellsFor(0.6, size));
  const CellMask open = subtract(dilated(around.floor, cellsFor(0.15, size)),
                                 dilated(around.walls, cellsFor(0.1, size)));
  const auto count = [&](const CellMask& mask) {
    return static_cast<double>(intersect(outline, mask).count());
  };
  return (count(walled) - count(open)) /
         static_cast<double>(std::max<std::size_t>(1, outline.count()));
}

/** @brief Whether something goes on below the floor along most of the outline: then it
 * is a table or a shelf. */
bool
hasWallsBelow(const Storey& storey, const CellMask& solid, const Piece& main)
{
  const CellMask outline = subtract(dilated(solid, 1), solid);
  std::size_t below = 0;
  for (std::size_t i = 0; i < outline.values().size(); ++i) {
    if (!outline.values()[i])
      continue;
    const Cell cell = outline.cellAt(i);
    const double floor = storey.heightOf(main.floor, cell);
    below += storey.columns.share(cell, floor - 0.4, floor - 0.15, 1, 2) > 0 ? 1 : 0;
  }
  return 5 * below > 3 * outline.count();
}

/** @brief Boxes around the ceilings that are large enough to be one, what is far apart
 * apart. */
std::vector<CellBox>
boxesOfCeilings(const std::vector<Level>& levels, const RoomParameters& parameters)
{
  std::vector<CellBox> boxes;
  const double cell_area = parameters.cell_size * parameters.cell_size;
  for (const auto& level : levels) {
    if (level.kind != LevelKind::Ceiling)
      continue;
    const CellRegions regions = labelRegions(level.cells);
    std::vector<std::vector<CellKey>> keys(regions.sizes.size());
    for (std::size_t i = 0; i < level.cells.size(); ++i)
      keys[regions.label[i]].push_back(level.cells.keys()[i]);
    for (auto& k : keys)
      if (static_cast<double>(k.size()) * cell_area >= 0.1 * parameters.minimum_area)
        boxes.push_back(boxOf(CellSet(std::move(k))));
  }
  return clusterBoxes(boxes, cellsFor(margin, parameters.cell_size));
}

/** @brief The cells of a ceiling between the pieces of a room, too narrow to be pieces
 * of their own: strips between a beam and a coffer. */
CellMask
stripsOf(const Storey& storey, std::size_t level, const CellMask& scope)
{
  const double gap = cellsFor(0.4, storey.grid.size());
  const CellMask hull = eroded(dilated(scope, gap), gap);
  return intersect(CellMask(storey.levels[level].cells, storey.box), hull);
}

/** @brief Makes a room of the pieces of one group, if it is one. */
bool
makeRoom(const Storey& storey,
         const std::vector<const Piece*>& members,
         RoomRegion& room)
{
  const Piece& main = **std::max_element(
      members.begin(), members.end(),
      [](const Piece* a, const Piece* b) { return a->size < b->size; });
  CellMask scope = main.cells;
  CellMask ceiling = main.cells;
  for (const Piece* piece : members) {
    scope = unite(scope, piece->cells);
    if (piece->level == main.level) // parted by a beam
      ceiling = unite(ceiling, piece->cells);
  }
  const double area =
      static_cast<double>(scope.count()) * storey.grid.size() * storey.grid.size();
  if (area < storey.parameters.minimum_area)
    return false;
  const CellMask solid = solidOf(storey, scope);
  if (enclosureOf(storey, solid, main) < storey.parameters.minimum_enclosure ||
      hasWallsBelow(storey, solid, main))
    return false;
  if (members.size() > 1) {
    const CellMask strips = stripsOf(storey, main.level, scope);
    ceiling = unite(ceiling, strips);
    scope = unite(scope, strips);
  }
  room.ceiling_level = main.level;
  room.floor_level = main.floor;
  room.ceiling = ceiling.toSet();
  room.scope = scope.toSet();
  return true;
}

/** @brief Adds to the rooms from `first` on what something hides of their ceilings. */
void
addHiddenCeilings(const Storey& storey,
                  std::size_t first,
                  std::vector<RoomRegion>& rooms)
{
  CellMask taken(storey.box);
  for (std::size_t r = first; r < rooms.size(); ++r)
    taken = unite(taken, CellMask(rooms[r].scope, storey.box));
  for (std::size_t r = first; r < rooms.size(); ++r) {
    RoomRegion& room = rooms[r];
    const int reach = cellsFor(margin, storey.grid.size());
    const CellMask seen(room.scope, grown(boxOf(room.scope), reach));
    const CellMask others =
        subtract(intersect(inverted(CellMask(seen.box())), taken), seen);
    const CellMask hidden = hiddenCeiling(seen, others, storey.grid, storey.columns,
                                          storey.levels[room.ceiling_level].slab,
                                          storey.levels[room.floor_level].slab);
    room.hidden = hidden.toSet();
    room.scope = unite(room.scope, room.hidden);
    room.ceiling = unite(room.ceiling, room.hidden);
    taken = unite(taken, hidden);
  }
}

/** @brief Appends the rooms of one storey. */
void
roomsWithin(const Storey& storey, std::vector<RoomRegion>& rooms)
{
  const std::size_t first = rooms.size();
  std::vector<Piece> pieces;
  for (std::size_t l = 0; l < storey.levels.size(); ++l)
    if (storey.levels[l].kind == LevelKind::Ceiling)
      for (auto& piece : piecesOf(storey, l))
        if (findFloor(storey, piece))
          pieces.push_back(std::move(piece));
  const std::vector<std::size_t> group = groupPieces(storey, pieces);
  for (std::size_t g = 0; g < pieces.size(); ++g) {
    std::vector<const Piece*> members;
    for (std::size_t p = 0; p < pieces.size(); ++p)
      if (group[p] == g)
        members.push_back(&pieces[p]);
    RoomRegion room;
    if (!members.empty() && makeRoom(storey, members, room))
      rooms.push_back(std::move(room));
  }
  addHiddenCeilings(storey, first, rooms);
}

} // namespace

std::vector<RoomRegion>
segmentRooms(const PointView& points,
             const std::vector<int>& indices,
             const std::vector<Level>& levels,
             const RoomParameters& parameters,
             std::string& problem)
{
  problem.clear();
  const CellGrid grid(parameters.cell_size);
  std::vector<RoomRegion> rooms;
  for (const CellBox& box : boxesOfCeilings(levels, parameters)) {
    problem = maskProblem(box);
    if (!problem.empty())
      return {};
    roomsWithin(
        {levels, parameters, grid, box, ColumnTable(grid, box, points, indices)},
        rooms);
  }
  std::stable_sort(rooms.begin(), rooms.end(),
                   [](const RoomRegion& a, const RoomRegion& b) {
                     return a.scope.size() > b.scope.size();
                   });
  return rooms;
}

} // namespace sedr
} // namespace pcl
