// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/room_layers.h>

#include <algorithm>

namespace pcl {
namespace sedr {

namespace {

constexpr int floor_slab = 0;
constexpr int ceiling_slab = 1;

std::string
numbered(const std::string& name, std::size_t index)
{
  return name + "_" + std::to_string(index + 1);
}

} // namespace

RoomLayers::RoomLayers(const PlanRoom& room)
{
  addSlab(room, room.floor, StructureLabel::Floor, "floor");
  addSlab(room, room.ceiling, StructureLabel::Ceiling, "ceiling");
  addLoop(room, room.boundary, StructureLabel::Wall, "wall");
  for (std::size_t c = 0; c < room.columns.size(); ++c)
    addLoop(room, room.columns[c], StructureLabel::Column,
            numbered("column", c) + "_face");
  for (std::size_t d = 0; d < room.details.size(); ++d) {
    const PlanDetail& detail = room.details[d];
    const std::string name = numbered("detail", d);
    details.push_back({static_cast<int>(slabs.size()), loops.size(), detail.holes.size()});
    addSlab(room, detail.slab, StructureLabel::Detail, name);
    addLoop(room, detail.boundary, StructureLabel::Detail, name + "_edge");
    for (std::size_t h = 0; h < detail.holes.size(); ++h)
      addLoop(room, detail.holes[h], StructureLabel::Detail,
              name + numbered("_hole", h) + "_edge");
  }
}

void
RoomLayers::addSlab(const PlanRoom& room,
                    const PlanSlab& slab,
                    StructureLabel label,
                    const std::string& name)
{
  slabs.push_back({slab, elements.size()});
  elements.push_back({room.id, label, numbered("room", room.id - 1) + "_" + name});
}

void
RoomLayers::addLoop(const PlanRoom& room,
                    const PlanLoop& loop,
                    StructureLabel label,
                    const std::string& name)
{
  loops.push_back({&loop, label, elements.size()});
  for (std::size_t i = 0; i < loop.elements.size(); ++i)
    elements.push_back({room.id, label,
                        numbered("room", room.id - 1) + "_" + numbered(name, i)});
}

PlanRegion
RoomLayers::regionOf(const std::vector<int>& winding) const
{
  PlanRegion region;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (winding[l] == 0)
      continue;
    if (loops[l].label == StructureLabel::Column)
      return {};
    if (loops[l].label == StructureLabel::Wall)
      region = {floor_slab, ceiling_slab};
  }
  if (!region.isRoom())
    return {};
  for (const Detail& detail : details) {
    const auto hole = winding.begin() + static_cast<std::ptrdiff_t>(detail.boundary) + 1;
    const bool is_in_hole =
        std::any_of(hole, hole + static_cast<std::ptrdiff_t>(detail.holes),
                    [](int turns) { return turns != 0; });
    if (winding[detail.boundary] != 0 && !is_in_hole)
      region.ceiling = detail.slab;
  }
  return region;
}

PlanRegion
RoomLayers::withoutDetail(PlanRegion region) const
{
  return region.isRoom() ? PlanRegion{floor_slab, ceiling_slab} : region;
}

} // namespace sedr
} // namespace pcl
