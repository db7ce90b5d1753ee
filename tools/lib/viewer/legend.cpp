// SPDX-License-Identifier: BSD-3-Clause
#include "legend.h"

#include "canvas.h"
#include "map_cells.h"
#include "results/distance_colour.h"
#include "scale.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace pcl::sedr::tools {

namespace {

using Lines = std::vector<LegendLine>;

constexpr std::array<StructureLabel, 6> label_order{
    StructureLabel::Ceiling, StructureLabel::Floor,  StructureLabel::Wall,
    StructureLabel::Detail,  StructureLabel::Column, StructureLabel::Other};

constexpr std::size_t max_rooms = 14; // with a line each

/** @brief Returns a line on the content of a layer. */
std::string
sizeOf(const ViewedResult& result, Layer layer)
{
  if (const auto* cloud = result.cloudOf(layer)) {
    const std::string shown =
        cloud->isPart() ? ", " + countText(cloud->size()) + " shown" : "";
    return countText(cloud->whole_size) + " points" + shown;
  }
  if (const auto* mesh = result.meshOf(layer))
    return countText(mesh->triangles.size()) + " triangles";
  return counted(result.plan.rooms.size(), "room");
}

void
addLabels(const ViewedResult& result, const ViewState& state, Lines& lines)
{
  if (result.structure.labels.empty())
    return;
  if (!state.isShownRight(Layer::Structure))
    lines.push_back({"structure, not shown:"});
  std::map<StructureLabel, std::size_t> points;
  for (const auto label : result.structure.labels)
    ++points[static_cast<StructureLabel>(label)];
  for (const auto label : label_order) {
    if (points[label] == 0)
      continue;
    const double share = result.structure.size() == 0
                             ? 1
                             : static_cast<double>(result.structure.whole_size) /
                                   static_cast<double>(result.structure.size());
    const auto count =
        static_cast<std::size_t>(static_cast<double>(points[label]) * share + 0.5);
    lines.push_back({std::string(toString(label)) + "  " + countText(count) +
                         (result.structure.isPart() ? " points, about" : " points"),
                     colourOf(label), state.colouring != Colouring::Room});
  }
}

void
addRooms(const ViewedResult& result,
         const Painter& painter,
         const ViewState& state,
         Lines& lines)
{
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  const auto isShown = [&](std::uint32_t room) {
    return painter.storeys().holds(state.storey, room, nowhere);
  };
  std::map<std::uint32_t, std::string> rooms;
  for (const auto room : result.structure.rooms)
    if (room != 0 && isShown(room))
      rooms[room] = "";
  for (const auto& room : result.plan.rooms)
    if (isShown(room.id))
      rooms[room.id] = "  " + fixedText(room.area(), 1) + " m2";
  std::size_t told = 0;
  for (const auto& [room, area] : rooms) {
    if (told++ == max_rooms) {
      lines.push_back({"and " + std::to_string(rooms.size() - max_rooms) + " more"});
      return;
    }
    lines.push_back({"room " + std::to_string(room) + area, roomColour(room),
                     state.colouring == Colouring::Room});
  }
}

void
addDistances(const ViewedResult& result,
             const Painter& painter,
             const ViewState& state,
             Lines& lines)
{
  if (result.mesh.empty()) {
    lines.push_back({"no distances: there is no mesh.ply"});
    return;
  }
  lines.push_back({"distance from the mesh"});
  constexpr int steps = 5;
  for (int k = 0; k <= steps; ++k) {
    const double distance = painter.range() * k / steps;
    lines.push_back({distanceText(distance) + (k == steps ? " or more" : ""),
                     distanceColour(distance, painter.range()), true});
  }
  for (const auto layer : all_layers) {
    if (!state.layers.has(layer) || painter.distances(layer).empty())
      continue;
    const auto figures = summarizeDistances(painter.distances(layer));
    lines.push_back({std::string(toString(layer)) + ":"});
    lines.push_back({"half within " + distanceText(figures.median)});
    lines.push_back({"95 % within " + distanceText(figures.p95)});
  }
}

/** @brief Converts a name to characters that the legend supports. */
std::string
asciiOf(std::string name)
{
  for (char& c : name)
    c = c >= ' ' && c <= '~' ? c : '?';
  return name;
}

// Pixels.
constexpr int line_height = 19;
constexpr int margin = 8;
constexpr int patch = 12;
constexpr int patch_space = 20;

Text
textOf(const LegendLine& line)
{
  Text text;
  text.line = line.text;
  text.x = margin + (line.is_sample ? patch_space : 0);
  return text;
}

} // namespace

std::string
countText(std::size_t count)
{
  std::string text = std::to_string(count);
  for (std::size_t place = text.size(); place > 3;) {
    place -= 3;
    text.insert(place, ",");
  }
  return text;
}

std::vector<LegendLine>
legendOf(const ViewedResult& result, const Painter& painter, const ViewState& state)
{
  Lines lines;
  for (const auto layer : all_layers)
    if (state.isShownLeft(layer) || state.isShownRight(layer))
      lines.push_back({std::string(toString(layer)) + ": " +
                       (result.has(layer) ? sizeOf(result, layer) : "not there")});
  if (state.colouring == Colouring::Distance)
    addDistances(result, painter, state, lines);
  else
    addLabels(result, state, lines);
  addRooms(result, painter, state, lines);
  if (const PlanStorey* storey = painter.storeys().find(state.storey))
    lines.push_back({"shown alone: " + asciiOf(storey->name)});
  if (!state.ceiling)
    lines.push_back({"without ceilings"});
  if (state.isClipped())
    lines.push_back({"cut at " + fixedText(state.clip_height, 2) + " m"});
  return lines;
}

Image
drawLegend(const std::vector<LegendLine>& lines)
{
  if (lines.empty())
    return {};
  int width = 0;
  for (const auto& line : lines) {
    const Text text = textOf(line);
    width = std::max(width, static_cast<int>(text.x) + widthOf(text) + margin);
  }
  Canvas canvas(width, static_cast<int>(lines.size()) * line_height + 2 * margin);
  double y = margin + line_height / 2.0;
  for (const auto& line : lines) {
    if (line.is_sample)
      canvas.fillBox({{margin, y - patch / 2.0}, {margin + patch, y + patch / 2.0}},
                     line.colour);
    Text text = textOf(line);
    text.y = y;
    canvas.addText(text);
    y += line_height;
  }
  return canvas.image();
}

} // namespace pcl::sedr::tools
