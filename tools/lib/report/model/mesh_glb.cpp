// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_glb.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/solid_io.h>

#include <map>
#include <set>

namespace pcl {
namespace sedr {
namespace tools {

std::string
meshToGlb(TriangleMesh mesh, const Floorplan& plan)
{
  mesh.flip();
  std::vector<SolidElement> elements;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> number_of;
  std::set<std::uint32_t> rooms;
  mesh.elements.clear();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t room = mesh.rooms.empty() ? 0 : mesh.rooms[t];
    const std::uint32_t label = mesh.labels.empty() ? 0 : mesh.labels[t];
    const auto next = static_cast<std::uint32_t>(elements.size() + 1);
    const auto [entry, is_new] = number_of.emplace(std::make_pair(room, label), next);
    mesh.elements.push_back(entry->second);
    if (!is_new)
      continue;
    rooms.insert(room);
    SolidElement element;
    element.label = static_cast<StructureLabel>(label);
    element.room = room;
    element.name = "room_" + std::to_string(room) + "_" + toString(element.label);
    elements.push_back(element);
  }
  std::vector<PlanStorey> storeys = storeysOf(plan);
  for (const PlanStorey& storey : storeys)
    for (const std::uint32_t room : storey.rooms)
      rooms.erase(room);
  if (!rooms.empty()) {
    storeys.emplace_back();
    storeys.back().number = 0;
    storeys.back().name = "no storey";
    storeys.back().rooms.assign(rooms.begin(), rooms.end());
  }
  return solidToGlb(mesh, elements, storeys);
}

} // namespace tools
} // namespace sedr
} // namespace pcl
