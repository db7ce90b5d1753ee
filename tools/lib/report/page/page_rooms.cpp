// SPDX-License-Identifier: BSD-3-Clause
#include "html_text.h"
#include "page_sections.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <algorithm>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns a drawing without its file header, to be embedded in a page. */
std::string
inlineSvg(std::string svg)
{
  svg.erase(0, svg.find("<svg"));
  const std::string name_space = " xmlns=\"http://www.w3.org/2000/svg\"";
  const std::size_t place = svg.find(name_space);
  if (place != std::string::npos)
    svg.erase(place, name_space.size());
  return svg;
}

/** @brief Returns "closed", "open" or a dash. */
std::string
closedText(const std::optional<bool>& closed)
{
  return !closed ? "–" : *closed ? "closed" : "<strong>open</strong>";
}

bool
isIn(const PlanStorey& storey, std::uint32_t room)
{
  return std::binary_search(storey.rooms.begin(), storey.rooms.end(), room);
}

/** @brief The rooms of a storey, and their totals. */
struct StoreyRooms {
  std::vector<RoomFacts> rooms;
  double area = 0;
  double volume = 0;

  void add(const RoomFacts& room)
  {
    rooms.push_back(room);
    area += room.area;
    volume += room.volume;
  }
};

StoreyRooms
roomsOf(const ReportData& data, const PlanStorey& storey)
{
  StoreyRooms found;
  for (const RoomFacts& room : data.rooms)
    if (isIn(storey, room.id))
      found.add(room);
  return found;
}

std::string
roomTable(const std::vector<RoomFacts>& rooms)
{
  std::vector<std::vector<std::string>> rows;
  for (const auto& room : rooms)
    rows.push_back({std::to_string(room.id), numberText(room.area, 2),
                    numberText(room.perimeter, 2), numberText(room.height, 2),
                    numberText(room.volume, 2),
                    room.wall_area ? numberText(*room.wall_area, 2) : "–",
                    std::to_string(room.walls), std::to_string(room.columns),
                    std::to_string(room.details),
                    room.repaired_share ? percentText(*room.repaired_share) : "–",
                    closedText(room.mesh_closed), closedText(room.solid_closed)});
  return htmlTable({"room", "area, m²", "perimeter, m", "height, m", "volume, m³",
                    "wall surface, m²", "walls", "columns", "ceiling details",
                    "filled in", "mesh", "solid"},
                   rows);
}

std::string
heading(const PlanStorey& storey)
{
  return "<h3>" + escaped(storey.name) + "</h3>\n";
}

std::string
drawing(const ReportData& data, const PlanStorey* storey)
{
  DrawingSettings settings;
  settings.storey = storey;
  settings.tilts = data.tilts;
  settings.max_wall = data.max_wall;
  settings.paper = PaperSize::A4; // for larger letters on the page
  return "<div class=\"plan\">" + inlineSvg(floorplanToSvg(data.plan, settings)) +
         "</div>\n";
}

} // namespace

std::string
storeysPart(const ReportData& data)
{
  if (data.storeys.size() < 2)
    return "";
  std::vector<std::vector<std::string>> rows;
  for (const PlanStorey& storey : data.storeys) {
    const StoreyRooms found = roomsOf(data, storey);
    rows.push_back({escaped(storey.name), std::to_string(found.rooms.size()),
                    numberText(storey.floor, 2), numberText(storey.ceiling, 2),
                    numberText(found.area, 2), numberText(found.volume, 2)});
  }
  return htmlSection(
      "storeys", "Storeys",
      htmlTable({"storey", "rooms", "floor, m", "ceiling, m", "area, m²", "volume, m³"},
                rows, {true, false, false, false, false, false}) +
          "<p class=\"note\">Floor and ceiling: the lowest and the "
          "highest of its rooms, as heights of the scan.</p>\n");
}

std::string
planPart(const ReportData& data)
{
  if (data.plan.rooms.empty())
    return "";
  std::string drawings;
  if (data.storeys.size() < 2)
    drawings = drawing(data, nullptr);
  else
    for (const PlanStorey& storey : data.storeys)
      drawings += heading(storey) + drawing(data, &storey);
  const std::string doors = data.plan.doorways.empty()
                                ? "Doors and windows are closed."
                                : "Gaps: doorways that were found; windows are closed.";
  return htmlSection(
      "plan", "Plan",
      drawings +
          "<p class=\"note\">Lengths in metres; h is the height of a room. "
          "Thick: walls as its room sees them; dashed blue: edges of ceiling details, "
          "with their height over the floor. " +
          doors + "</p>\n");
}

std::string
roomsPart(const ReportData& data)
{
  if (data.rooms.empty())
    return "";
  std::string tables;
  if (data.storeys.size() < 2)
    tables = roomTable(data.rooms);
  else {
    std::vector<RoomFacts> others; // rooms missing from the plan
    for (const RoomFacts& room : data.rooms)
      if (std::none_of(data.storeys.begin(), data.storeys.end(),
                       [&](const PlanStorey& s) { return isIn(s, room.id); }))
        others.push_back(room);
    for (const PlanStorey& storey : data.storeys)
      tables += heading(storey) + roomTable(roomsOf(data, storey).rooms);
    if (!others.empty())
      tables += "<h3>not in the plan</h3>\n" + roomTable(others);
  }
  return htmlSection(
      "rooms", "Rooms",
      tables +
          "<p class=\"note\">Area: of the floor, without columns. Height: the mean. "
          "Wall surface: of the solid, without the faces of columns, doors and windows "
          "included. Filled in: share of the structure's points that no scan point "
          "stands for.</p>\n");
}

} // namespace pcl::sedr::tools
