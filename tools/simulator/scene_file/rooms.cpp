// SPDX-License-Identifier: BSD-3-Clause
#include "rooms.h"

#include "loops.h"
#include "objects.h"
#include "openings.h"

#include <algorithm>
#include <iterator>

namespace pcl::sedr::sim {

namespace {

constexpr double kSteepest = 45.0; ///< degrees

/** @brief A plane: its height, or its height, slope and direction.
 * @param origin where the height is measured unless the file says where
 */
Slab
readSlab(const JsonView& view, Vec2 origin)
{
  if (!view.isObject())
    return {view.number()};
  view.allowOnly({"height", "slope", "towards", "at"});
  const auto at = view.find("at");
  const double slope = view.at("slope").number(0.0, kSteepest) * pi / 180.0;
  const double towards = view.at("towards").number() * pi / 180.0;
  return {view.at("height").number(), rotated({std::tan(slope), 0.0}, towards),
          at ? at->point2() : origin};
}

/** @brief A part of the floor or ceiling, by its own plane or parallel to the whole.
 * @param offset key of the distance from @p whole
 * @param upwards 1 or -1: where that distance is counted
 */
SlabDetail
readSlabDetail(const JsonView& view, const Slab& whole, const char* offset, int upwards)
{
  view.allowOnly({"loop", "height", offset});
  const auto height = view.find("height");
  const auto distance = view.find(offset);
  if (height.has_value() == distance.has_value())
    view.fail(std::string("must have either \"height\" or \"") + offset + '"');
  SlabDetail detail{readLoop(view.at("loop")), whole};
  if (height)
    detail.slab = readSlab(*height, whole.origin);
  else
    detail.slab.height += upwards * distance->number();
  return detail;
}

Niche
readNiche(const JsonView& view, const Room& room)
{
  view.allowOnly({"wall", "from", "to", "sill", "head", "depth"});
  Niche niche;
  niche.wall = view.at("wall").count(0, room.outline.size() - 1);
  niche.from = view.at("from").number();
  niche.to = view.at("to").number();
  niche.sill = view.at("sill").number();
  niche.head = view.at("head").number();
  niche.depth = view.at("depth").size();
  return niche;
}

/** @brief All of a room but its openings and furniture. */
Room
readShell(const JsonView& view)
{
  view.allowOnly({"name", "outline", "floor", "ceiling", "floor_details",
                  "ceiling_details", "columns", "niches", "openings", "furniture"});
  Room room;
  room.name = view.at("name").text();
  room.outline = readLoop(view.at("outline"));
  if (!(areaOf(room.outline) > 0.0)) // walls, and what stands at them, would be lost
    view.at("outline").fail("does not run counter-clockwise");
  const Vec2 origin = room.outline.front().position;
  room.floor = readSlab(view.at("floor"), origin);
  room.ceiling = readSlab(view.at("ceiling"), origin);
  for (const JsonView& detail : view.itemsOf("floor_details"))
    room.floor_details.push_back(readSlabDetail(detail, room.floor, "rise", 1));
  for (const JsonView& detail : view.itemsOf("ceiling_details"))
    room.details.push_back(readSlabDetail(detail, room.ceiling, "drop", -1));
  for (const JsonView& column : view.itemsOf("columns"))
    room.columns.push_back(readLoop(column));
  for (const JsonView& niche : view.itemsOf("niches"))
    room.niches.push_back(readNiche(niche, room));
  return room;
}

void
append(std::vector<Object>& objects, std::vector<Object> more)
{
  std::move(more.begin(), more.end(), std::back_inserter(objects));
}

} // namespace

void
readRooms(const JsonView& list, Scene& scene)
{
  const auto views = list.items(1);
  for (const JsonView& view : views) {
    Room room = readShell(view);
    const bool is_known =
        std::any_of(scene.rooms.begin(), scene.rooms.end(),
                    [&room](const Room& other) { return other.name == room.name; });
    if (is_known)
      view.at("name").fail("is that of another room, too");
    scene.rooms.push_back(std::move(room));
  }
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (const JsonView& opening : views[i].itemsOf("openings"))
      readOpening(opening, i, scene);
    append(scene.furniture,
           readObjects(views[i].itemsOf("furniture"), &scene.rooms[i]));
  }
}

} // namespace pcl::sedr::sim
