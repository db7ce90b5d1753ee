// SPDX-License-Identifier: BSD-3-Clause
#include "rooms.h"

#include "loops.h"
#include "objects.h"
#include "openings.h"

#include <algorithm>
#include <iterator>

namespace pcl::sedr::sim {

namespace {

Slab
readSlab(const JsonView& view)
{
  return {view.number()};
}

CeilingDetail
readCeilingDetail(const JsonView& view)
{
  view.allowOnly({"loop", "height"});
  return {readLoop(view.at("loop")), readSlab(view.at("height"))};
}

/** @brief All of a room but its openings and furniture. */
Room
readShell(const JsonView& view)
{
  view.allowOnly({"name", "outline", "floor", "ceiling", "ceiling_details", "columns",
                  "openings", "furniture"});
  Room room;
  room.name = view.at("name").text();
  room.outline = readLoop(view.at("outline"));
  room.floor = readSlab(view.at("floor"));
  room.ceiling = readSlab(view.at("ceiling"));
  for (const JsonView& detail : view.itemsOf("ceiling_details"))
    room.details.push_back(readCeilingDetail(detail));
  for (const JsonView& column : view.itemsOf("columns"))
    room.columns.push_back(readLoop(column));
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
