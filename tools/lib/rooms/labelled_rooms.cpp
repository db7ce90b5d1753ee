// SPDX-License-Identifier: BSD-3-Clause
#include "labelled_rooms.h"
#include "run_tool.h"
#include "sedr_segmentation/src/scan/scan_check.h"
#include "sedr_segmentation/src/scan/scan_up.h"
#include "tool_error.h"

#include <pcl/sedr_filters/impl/refinement.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

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

} // namespace pcl::sedr::tools
