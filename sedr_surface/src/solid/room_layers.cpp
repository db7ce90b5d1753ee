// SPDX-License-Identifier: BSD-3-Clause
#include "room_layers.h"

#include <algorithm>

namespace pcl::sedr {
namespace {

constexpr PlanRegion main_region{0, 1};

std::string
numbered(const std::string& name, std::size_t index)
{
  return name + "_" + std::to_string(index + 1);
}

StructureLabel
labelOf(LoopRole role)
{
  return role == LoopRole::Wall         ? StructureLabel::Wall
         : role == LoopRole::ColumnFace ? StructureLabel::Column
                                        : StructureLabel::Detail;
}

const char*
wordsFor(LoopRole role)
{
  constexpr const char* words[] = {"its outline", "a column", "a niche",
                                   "a part of its ceiling", "a part of its floor"};
  return words[static_cast<std::size_t>(role)];
}

} // namespace

RoomLayers::RoomLayers(const PlanRoom& room)
    : room_(room.id)
{
  addSlab(room.floor, room.boundary, StructureLabel::Floor, "its floor", "floor");
  addSlab(room.ceiling, room.boundary, StructureLabel::Ceiling, "its ceiling",
          "ceiling");
  slabs.back().is_facet = room.hasFacets();
  addLoop(room.boundary, LoopRole::Wall, "wall");
  for (std::size_t c = 0; c < room.columns.size(); ++c)
    addLoop(room.columns[c], LoopRole::ColumnFace, numbered("column", c) + "_face");
  addDetails(room.details, LoopRole::CeilingRiser, "detail");
  addDetails(room.floor_details, LoopRole::FloorRiser, "floor_detail");
  first_niche_slab_ = static_cast<int>(slabs.size());
  for (std::size_t n = 0; n < room.niches.size(); ++n) {
    const std::string name = numbered("niche", n);
    Part niche;
    niche.boundary = loops.size();
    niche.region.floor =
        addSlab(room.niches[n].bottom, room.niches[n].boundary, StructureLabel::Detail,
                wordsFor(LoopRole::NicheSide), name + "_bottom");
    niche.region.ceiling =
        addSlab(room.niches[n].top, room.niches[n].boundary, StructureLabel::Detail,
                wordsFor(LoopRole::NicheSide), name + "_top");
    addLoop(room.niches[n].boundary, LoopRole::NicheSide, name + "_side");
    niches_.push_back(niche);
  }
}

void
RoomLayers::addDetails(const std::vector<PlanDetail>& details,
                       LoopRole role,
                       const std::string& name)
{
  const bool is_floor = role == LoopRole::FloorRiser;
  for (std::size_t d = 0; d < details.size(); ++d) {
    Part part;
    part.boundary = loops.size();
    part.holes = details[d].holes.size();
    (is_floor ? part.region.floor : part.region.ceiling) =
        addSlab(details[d].slab, details[d].boundary,
                details[d].is_facet ? StructureLabel::Ceiling : StructureLabel::Detail,
                wordsFor(role), numbered(name, d));
    slabs.back().is_facet = details[d].is_facet;
    addLoop(details[d].boundary, role, numbered(name, d) + "_edge");
    for (std::size_t h = 0; h < details[d].holes.size(); ++h)
      addLoop(details[d].holes[h], role,
              numbered(name, d) + numbered("_hole", h) + "_edge");
    details_.push_back(part);
  }
}

void
RoomLayers::addElement(StructureLabel label,
                       LoopRole role,
                       const char* words,
                       const std::string& name)
{
  elements.push_back({room_, label, "room_" + std::to_string(room_) + "_" + name});
  roles_.push_back(role);
  words_.push_back(words);
}

int
RoomLayers::addSlab(const PlanSlab& slab,
                    const PlanLoop& loop,
                    StructureLabel label,
                    const char* words,
                    const std::string& name)
{
  slabs.push_back({slab, elements.size(), &loop});
  addElement(label, LoopRole::Wall, words, name);
  return static_cast<int>(slabs.size()) - 1;
}

void
RoomLayers::addLoop(const PlanLoop& loop, LoopRole role, const std::string& name)
{
  loops.push_back({&loop, role, elements.size()});
  for (std::size_t i = 0; i < loop.elements.size(); ++i)
    addElement(labelOf(role), role, wordsFor(role), numbered(name, i));
}

bool
RoomLayers::Part::contains(const std::vector<int>& winding) const
{
  const auto hole = winding.begin() + static_cast<std::ptrdiff_t>(boundary) + 1;
  return winding[boundary] != 0 &&
         std::all_of(hole, hole + static_cast<std::ptrdiff_t>(holes),
                     [](int turns) { return turns == 0; });
}

PlanRegion
RoomLayers::regionOf(const std::vector<int>& winding) const
{
  bool is_outside = winding[0] == 0;
  for (std::size_t l = 0; l < loops.size(); ++l)
    is_outside |= loops[l].role == LoopRole::ColumnFace && winding[l] != 0;
  if (is_outside) {
    const auto niche = std::find_if(niches_.begin(), niches_.end(),
                                    [&](const Part& n) { return n.contains(winding); });
    return niche == niches_.end() ? PlanRegion() : niche->region;
  }
  PlanRegion region = main_region;
  for (const Part& detail : details_) {
    if (!detail.contains(winding))
      continue;
    if (detail.region.floor != PlanRegion::nothing)
      region.floor = detail.region.floor;
    else
      region.ceiling = detail.region.ceiling;
  }
  return region;
}

std::vector<PlanRegion>
RoomLayers::plainRegions(const PlanRegion& region) const
{
  if (isNiche(region))
    return {{}};
  return {{main_region.floor, region.ceiling},
          {region.floor, main_region.ceiling},
          main_region,
          {}};
}

} // namespace pcl::sedr
