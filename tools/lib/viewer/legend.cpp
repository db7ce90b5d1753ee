// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <pcl/sedr_surface/mesh_distance.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pcl::sedr::tools {

namespace {

/** @brief Formats a count with separated thousands: "1,234,567". */
std::string
countText(std::size_t count)
{
  std::string text = std::to_string(count);
  for (std::size_t place = text.size(); place > 3;)
    text.insert(place -= 3, ",");
  return text;
}

std::string
formatted(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/** @brief Returns what there is of a layer. */
std::string
contentOf(const ViewedResult& result, const std::string& layer)
{
  if (!result.has(layer))
    return "not there";
  if (layer == "plan")
    return countText(result.plan.rooms.size()) + " rooms";
  const auto cloud = result.clouds.find(layer);
  if (cloud == result.clouds.end())
    return countText(result.mesh(layer).triangles.size()) + " triangles";
  const auto& [size, whole] = std::pair(cloud->second.size(), cloud->second.whole_size);
  return countText(whole) + " points" +
         (size < whole ? ", " + countText(size) + " shown" : "");
}

} // namespace

void
Shapes::addLabels(std::vector<LegendLine>& lines) const
{
  const auto structure = result_.clouds.find("structure");
  if (structure == result_.clouds.end())
    return;
  const DisplayCloud& cloud = structure->second;
  const double share = static_cast<double>(cloud.whole_size) /
                       static_cast<double>(std::max<std::size_t>(1, cloud.size()));
  for (std::uint32_t label = 0; label < 6; ++label) {
    const auto count = std::count(cloud.labels.begin(), cloud.labels.end(), label);
    const auto whole =
        static_cast<std::size_t>(std::lround(share * static_cast<double>(count)));
    const auto meaning = static_cast<StructureLabel>(label);
    if (count > 0)
      lines.push_back(
          {toString(meaning) + ("  " + countText(whole)) +
               (cloud.size() < cloud.whole_size ? " points, about" : " points"),
           colourOf(meaning)});
  }
}

void
Shapes::addRooms(const ViewState& state, std::vector<LegendLine>& lines) const
{
  constexpr std::size_t max_rooms = 14; // with a line each
  std::size_t told = 0;
  for (const auto& room : result_.plan.rooms)
    if (shows(StructureLabel::Wall, room.id, Eigen::Vector3d::Zero(), state) &&
        told++ < max_rooms) {
      lines.push_back(
          {"room " + std::to_string(room.id) + formatted("  %.1f m2", room.area())});
      if (state.colour == "room")
        lines.back().colour = roomColour(room.id);
    }
  if (told > max_rooms)
    lines.push_back({"and " + std::to_string(told - max_rooms) + " more"});
}

void
Shapes::addDistances(const ViewState& state, std::vector<LegendLine>& lines) const
{
  if (result_.mesh("mesh").empty()) {
    lines.push_back({"no distances: there is no mesh.ply"});
    return;
  }
  lines.push_back({"distance from the mesh"});
  constexpr int steps = 5;
  for (int k = 0; k <= steps; ++k) {
    const double distance = state.range * k / steps;
    lines.push_back({distanceText(distance) + (k == steps ? " or more" : ""),
                     distanceColour(distance, state.range)});
  }
  for (const auto& [layer, cloud] : result_.clouds)
    if (state.layers.count(layer) > 0) {
      const DistanceStatistics figures = summarizeDistances(distances(layer));
      lines.push_back({layer + ": half within " + distanceText(figures.median) +
                       ", 95 % within " + distanceText(figures.p95)});
    }
}

std::vector<LegendLine>
Shapes::legend(const ViewState& state) const
{
  std::vector<LegendLine> lines;
  for (const std::string& layer : layer_names)
    if (state.layers.count(layer) > 0 || (state.two_views && layer == "scan"))
      lines.push_back({layer + ": " + contentOf(result_, layer)});
  if (state.colour == "distance")
    addDistances(state, lines);
  else if (state.colour == "label")
    addLabels(lines);
  addRooms(state, lines);
  if (state.storey != 0)
    lines.push_back({"storey " + std::to_string(state.storey) + " alone"});
  if (!state.ceilings)
    lines.push_back({"without ceilings"});
  if (std::isfinite(state.clip_height))
    lines.push_back({formatted("cut at %.2f m", state.clip_height)});
  return lines;
}

} // namespace pcl::sedr::tools
