// SPDX-License-Identifier: BSD-3-Clause
#include "labelled_rooms.h"

#include "run_tool.h"
#include "tool_error.h"

#include "sedr_filters/src/json/floorplan_format.h"
#include "sedr_segmentation/src/scan/scan_check.h"
#include "sedr_segmentation/src/scan/scan_up.h"
#include <pcl/sedr_filters/impl/refinement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numeric>
#include <string>
#include <utility>

namespace pcl::sedr {

void
describe(PartFields& fields, RoomLink& link)
{
  fields.needed("rooms", link.rooms);
  fields.needed("start", link.start);
  fields.needed("end", link.end);
  fields.needed("bottom", link.bottom);
  fields.needed("top", link.top);
}

void
describe(PartFields& fields, RoomDoubt& doubt)
{
  fields.needed("rooms", doubt.rooms);
  fields.needed("at", doubt.at);
  fields.needed("area", doubt.area);
  fields.needed("chance", doubt.chance);
}

} // namespace pcl::sedr

namespace pcl::sedr::tools {

pcl::Indices
requireLabel(const ToolCloud& cloud, StructureLabel label)
{
  pcl::Indices found = cloud.withLabel(label);
  if (found.empty())
    throw ToolError("none of the " + std::to_string(cloud.size()) + " points of '" +
                        cloud.path + "' has label " +
                        std::to_string(static_cast<std::uint32_t>(label)) + ", " +
                        pcl::sedr::toString(label),
                    NothingFound);
  return found;
}

double
meanFloorHeight(const ToolCloud& cloud)
{
  const PointView points(*cloud.points);
  pcl::Indices finite;
  for (const auto i : requireLabel(cloud, StructureLabel::Floor))
    if (points.isFinite(static_cast<std::size_t>(i)))
      finite.push_back(i);
  if (finite.empty())
    throw ToolError("none of the points of '" + cloud.path +
                        "' with label 2, floor, is finite",
                    NothingFound);
  return meanHeight(points, finite);
}

bool
hasRooms(const ToolCloud& cloud, StructureLabel label)
{
  const pcl::Indices rows = cloud.withLabel(label);
  return std::any_of(rows.begin(), rows.end(), [&](int i) {
    return cloud.room[static_cast<std::size_t>(i)] != 0;
  });
}

void
setLabel(const pcl::Indices& rows,
         StructureLabel label,
         std::uint32_t room,
         ToolCloud& cloud)
{
  for (const int i : rows) {
    cloud.label[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(label);
    cloud.room[static_cast<std::size_t>(i)] = room;
  }
}

void
storeLabels(ToolCloud& cloud)
{
  setField(cloud.blob, "label", cloud.label);
  if (cloud.has_room)
    setField(cloud.blob, "room", cloud.room);
}

std::vector<PointOwner>
ownersOf(const ToolCloud& cloud)
{
  std::vector<PointOwner> owners;
  if (hasRooms(cloud))
    for (const std::uint32_t room : wholeField(cloud.blob, "owner"))
      owners.push_back({room, false});
  return owners;
}

std::vector<LabelledRoom>
labelledRooms(const ToolCloud& cloud, double grid_size)
{
  const bool has_rooms = hasRooms(cloud);
  PlanEvidence evidence;
  evidence.all.resize(cloud.size());
  std::iota(evidence.all.begin(), evidence.all.end(), 0);
  evidence.ceiling = cloud.withLabel(StructureLabel::Ceiling);
  evidence.floor = cloud.withLabel(StructureLabel::Floor);
  evidence.details = cloud.withLabel(StructureLabel::Detail);
  if (has_rooms)
    evidence.room = cloud.room;
  evidence.owners = ownersOf(cloud);
  const std::vector<std::uint32_t> numbers = roomNumbers(evidence);
  RoomFitParameters parameters;
  parameters.cell_size = grid_size;
  std::vector<RoomEvidence> shares =
      roomEvidence(PointView(*cloud.points), evidence, numbers, parameters);
  std::vector<LabelledRoom> rooms;
  for (std::size_t r = 0; r < shares.size(); ++r) {
    RoomEvidence& share = shares[r];
    for (const int i : share.around) // details without a number are of the room there
      if (const auto at = static_cast<std::size_t>(i);
          has_rooms && cloud.room[at] == 0 &&
          cloud.label[at] == static_cast<std::uint32_t>(StructureLabel::Detail))
        share.details.push_back(i);
    if (!share.ceiling.empty())
      rooms.push_back({std::move(share), has_rooms ? numbers[r] : 0});
  }
  if (rooms.empty())
    throw ToolError("none of the " + std::to_string(cloud.size()) + " points of '" +
                        cloud.path + "' has label 1, ceiling, and is finite",
                    NothingFound);
  return rooms;
}

PlanSlab
ceilingOf(const LabelledRoom& room,
          const ToolCloud& cloud,
          const RoomPlaneParameters& parameters)
{
  const PointView points(*cloud.points);
  return mainPlane(points, room.ceiling, ceilingLevel(points, room.ceiling),
                   parameters);
}

PlanSlab
floorOf(const LabelledRoom& room,
        const ToolCloud& cloud,
        const RoomPlaneParameters& parameters)
{
  const PointView points(*cloud.points);
  return mainPlane(points, room.floor, floorLevel(points, room.floor), parameters);
}

void
checkScan(const ToolCloud& cloud, bool trust_up)
{
  const PointView points(*cloud.points);
  pcl::Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  const std::string problem = scanProblem(points, &all);
  if (!problem.empty())
    throw ToolError("'" + cloud.path + "': " + problem, NothingFound);
  const UpDoubt doubt = trust_up ? UpDoubt() : doubtOfUp(points, all, {}, 0);
  const std::string sentence = "'" + cloud.path + "': " + doubt.reason;
  if (doubt.isInclined())
    throw ToolError(sentence, NothingFound);
  if (doubt.isDoubtful())
    warnOnce(sentence);
}

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "sedr-building";
constexpr int format_version = 6;

/** @brief Returns the gaps of a room: runs along x of equal ones. Each is x and y of
 * its first cell, its number of cells, the heights of floor and ceiling, to a tenth of
 * a millimetre, and 1 if the floor was seen, 2 more if the ceiling was. */
Json
gapsOf(const BuildingRoom& room)
{
  const auto heights = [](const RoomColumn& column) {
    return std::array<double, 2>{std::round(1e4 * column.floor) / 1e4,
                                 std::round(1e4 * column.ceiling) / 1e4};
  };
  const auto seen = [](const RoomColumn& column) {
    return (column.floor_seen ? 1 : 0) + (column.ceiling_seen ? 2 : 0);
  };
  Json runs = Json::array();
  for (auto first = room.columns.begin(), end = first; first != room.columns.end();
       first = end) {
    for (++end; end != room.columns.end() &&
                end->cell == Cell{first->cell.x + static_cast<int>(end - first),
                                  first->cell.y} &&
                heights(*end) == heights(*first) && seen(*end) == seen(*first);)
      ++end;
    const auto [floor, ceiling] = heights(*first);
    runs.push_back(
        {first->cell.x, first->cell.y, end - first, floor, ceiling, seen(*first)});
  }
  return runs;
}

} // namespace

std::string
buildingToJson(const Building& building)
{
  Json rooms = Json::array();
  for (const BuildingRoom& room : building.rooms)
    rooms.push_back({{"id", room.id},
                     {"floor", room.floor},
                     {"ceiling", room.ceiling},
                     {"gaps", gapsOf(room)}});
  return Json{{"format", format_name},
              {"version", format_version},
              {"unit", "m"},
              {"grid",
               {{"cell", building.grid.size()},
                {"origin", building.frame.origin},
                {"yaw", building.frame.yaw()}}},
              {"rooms", rooms},
              {"storeys", building.storeys},
              {"links", building.links},
              {"stairs", building.stairs},
              {"doubts", building.doubts}}
             .dump() +
         "\n";
}

Building
loadBuilding(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw ToolError("'" + path + "' cannot be read");
  try {
    const Json json = Json::parse(stream);
    if (json.value("format", "") != format_name)
      throw ToolError("its format is not " + std::string(format_name));
    const int version = json.value("version", 0);
    if (version != format_version)
      throw ToolError("its version is " + std::to_string(version) + ", version " +
                      std::to_string(format_version) + " is read");
    Building building;
    for (const Json& of_room : json.at("rooms")) {
      BuildingRoom& room = building.rooms.emplace_back();
      of_room.at("id").get_to(room.id);
      of_room.at("floor").get_to(room.floor);
      of_room.at("ceiling").get_to(room.ceiling);
    }
    json.at("storeys").get_to(building.storeys);
    json.at("links").get_to(building.links);
    json.at("stairs").get_to(building.stairs);
    json.at("doubts").get_to(building.doubts);
    return building;
  }
  catch (const std::exception& error) {
    const std::string reason = error.what();
    const std::size_t name = reason.find("] "); // of an exception of nlohmann
    throw ToolError("'" + path + "' is no building: " +
                    reason.substr(name == std::string::npos ? 0 : name + 2));
  }
}

} // namespace pcl::sedr::tools
