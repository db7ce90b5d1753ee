// SPDX-License-Identifier: BSD-3-Clause
#include "room_enclosure.h"
#include "room_groups.h"

#include <pcl/sedr_segmentation/room_segmentation.h>

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_segmentation/box_clusters.h>
#include <pcl/sedr_segmentation/cell_count.h>
#include <pcl/sedr_segmentation/hidden_ceiling.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <mutex>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

/** @brief How much more than the ceilings is looked at on each side, metres: walls that
 * something parts from them. */
constexpr double margin = 0.75;

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
    for (const CellSet& cells : connectedRegions(level.cells))
      if (static_cast<double>(cells.size()) * cell_area >=
          0.1 * parameters.minimum_area)
        boxes.push_back(boxOf(cells));
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
  return intersect(hull, CellMask(storey.levels[level].cells, scope.box()));
}

/** @brief The box in which a room of some pieces is looked at: nothing farther away
 * tells anything of it. */
CellBox
boxAround(const Storey& storey, const std::vector<const Piece*>& members)
{
  constexpr double far = 2; // metres
  CellBox box{{0, 0}, {-1, -1}};
  for (const Piece* piece : members)
    box = around(box, piece->cells.box());
  return overlapOf(grown(box, cellsFor(far, storey.grid.size())), storey.box);
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
  CellMask scope(boxAround(storey, members));
  CellMask ceiling = scope;
  for (const Piece* piece : members) {
    add(piece->cells, scope);
    if (piece->level == main.level) // parted by a beam
      add(piece->cells, ceiling);
  }
  const double area =
      static_cast<double>(scope.count()) * storey.grid.size() * storey.grid.size();
  if (area < storey.parameters.minimum_area)
    return false;
  const CellMask solid = solidOf(storey, scope);
  room.enclosure = enclosureOf(storey, solid, members, main.floor);
  if (hasWallsBelow(storey, solid, main) ||
      (room.enclosure < storey.parameters.minimum_enclosure &&
       !isFramed(storey, solid, main)))
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
    add(CellMask(rooms[r].scope, boxOf(rooms[r].scope)), taken);
  for (std::size_t r = first; r < rooms.size(); ++r) {
    RoomRegion& room = rooms[r];
    const int reach = cellsFor(margin, storey.grid.size());
    const CellMask seen(room.scope, grown(boxOf(room.scope), reach));
    const CellMask others = subtract(cropped(taken, seen.box()), seen);
    const CellMask hidden = hiddenCeiling(seen, others, storey.grid, storey.columns,
                                          storey.levels[room.ceiling_level].slab,
                                          storey.levels[room.floor_level].slab);
    room.hidden = hidden.toSet();
    room.scope = unite(room.scope, room.hidden);
    room.ceiling = unite(room.ceiling, room.hidden);
    add(hidden, taken);
  }
}

/** @brief The pieces of all ceilings that have a floor, and the passages between any.
 */
std::vector<Piece>
piecesWithFloors(const Storey& storey, CellMask& passages)
{
  std::vector<std::size_t> ceilings;
  for (std::size_t l = 0; l < storey.levels.size(); ++l)
    if (storey.levels[l].kind == LevelKind::Ceiling)
      ceilings.push_back(l);
  // Each looks at masks of the whole storey: of a large one, one after the other.
  constexpr std::uint64_t large = std::uint64_t{1} << 23; // cells
  const unsigned threads = storey.box.count() > large ? 1 : storey.parameters.threads;
  std::vector<std::vector<Piece>> found(ceilings.size());
  std::mutex mutex; // of the passages
  const auto look = [&](std::size_t c, std::size_t) {
    CellMask own(storey.box);
    for (Piece& piece : piecesOf(storey, ceilings[c], own))
      if (findFloor(storey, piece))
        found[c].push_back(std::move(piece));
    const std::lock_guard<std::mutex> lock(mutex);
    add(own, passages);
  };
  parallelBlocks(ceilings.size(), 1, threads, look);
  std::vector<Piece> pieces;
  for (auto& of_ceiling : found)
    std::move(of_ceiling.begin(), of_ceiling.end(), std::back_inserter(pieces));
  return pieces;
}

/** @brief Appends the rooms of one storey. */
void
roomsWithin(const Storey& storey, std::vector<RoomRegion>& rooms)
{
  const std::size_t first = rooms.size();
  CellMask passages(storey.box);
  const std::vector<Piece> pieces = piecesWithFloors(storey, passages);
  const std::vector<std::size_t> group = groupPieces(storey, pieces, passages);
  std::vector<std::vector<const Piece*>> members(pieces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p)
    members[group[p]].push_back(&pieces[p]);
  std::vector<RoomRegion> made(pieces.size());
  std::vector<std::uint8_t> is_room(pieces.size(), 0);
  parallelBlocks(
      pieces.size(), 1, storey.parameters.threads, [&](std::size_t g, std::size_t) {
        is_room[g] = !members[g].empty() && makeRoom(storey, members[g], made[g]);
      });
  for (std::size_t g = 0; g < pieces.size(); ++g)
    if (is_room[g])
      rooms.push_back(std::move(made[g]));
  addHiddenCeilings(storey, first, rooms);
}

/** @brief Whether a room is next to one of those that stay: no more than a wall is
 * between their ceilings. */
bool
isNextTo(const RoomRegion& room,
         const std::vector<RoomRegion>& rooms,
         const std::vector<std::uint8_t>& stays,
         double cell)
{
  constexpr double thickest_wall = 0.5; // metres
  const int reach = cellsFor(thickest_wall, cell);
  const CellBox box = grown(boxOf(room.scope), reach);
  const CellMask near = dilated(CellMask(room.scope, box), reach);
  for (std::size_t o = 0; o < rooms.size(); ++o)
    if (stays[o] &&
        std::any_of(rooms[o].scope.keys().begin(), rooms[o].scope.keys().end(),
                    [&](CellKey key) { return near.at(cellOf(key)) != 0; }))
      return true;
  return false;
}

/** @brief Drops what was seen of other rooms through doors. The ceiling of one that was
 * scanned from within goes up to the walls around it; through a door, one sees it from
 * some way behind that wall only, and nothing of the wall. What is next to one that
 * stays does so, too.
 * @param rooms largest first */
void
dropLobbies(const RoomParameters& parameters, std::vector<RoomRegion>& rooms)
{
  std::vector<std::uint8_t> stays(rooms.size(), 0);
  for (std::size_t r = 0; r < rooms.size(); ++r)
    stays[r] = r == 0 || rooms[r].enclosure >= parameters.minimum_apart_enclosure;
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (std::size_t r = 0; r < rooms.size(); ++r)
      if (!stays[r] && isNextTo(rooms[r], rooms, stays, parameters.cell_size))
        stays[r] = goes_on = true;
  }
  std::vector<RoomRegion> kept;
  for (std::size_t r = 0; r < rooms.size(); ++r)
    if (stays[r])
      kept.push_back(std::move(rooms[r]));
  rooms = std::move(kept);
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
    roomsWithin({levels, parameters, grid, box,
                 ColumnTable(grid, box, points, indices, parameters.threads)},
                rooms);
  }
  std::stable_sort(rooms.begin(), rooms.end(),
                   [](const RoomRegion& a, const RoomRegion& b) {
                     return a.scope.size() > b.scope.size();
                   });
  dropLobbies(parameters, rooms);
  return rooms;
}

} // namespace sedr
} // namespace pcl
