// SPDX-License-Identifier: BSD-3-Clause
#include "plan_file.h"

#include "bytes/input_file.h"
#include "bytes/whole_file.h"
#include "formats/scan_formats.h"
#include "run_tool.h"
#include "tool_error.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/editing/plan_edits.h"
#include "sedr_filters/src/json/floorplan_format.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_filters/src/plan/room_lookup.h"
#include <pcl/sedr_filters/plan_editor.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns how far a point is below the floor or above the ceiling of a room,
 * else 0. */
double
heightBeside(const RoomLookup& room, const Eigen::Vector3d& p)
{
  const Eigen::Vector2d place = p.head<2>();
  return std::max({0.0, room.floorAt(place) - p.z(), p.z() - room.ceilingAt(place)});
}

/** @brief Returns the number of the room that contains `p`, or else of the nearest. */
std::uint32_t
roomAt(const std::vector<RoomLookup>& rooms,
       const std::vector<Eigen::AlignedBox2d>& boxes,
       const Eigen::Vector3d& p)
{
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  const Eigen::Vector2d place = p.head<2>();
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    if (boxes[r].exteriorDistance(place) >= least)
      continue;
    const double beside =
        rooms[r].isWithinBoundary(place) ? 0 : rooms[r].room().boundary.distance(place);
    const double distance = std::hypot(beside, heightBeside(rooms[r], p));
    if (distance >= least)
      continue;
    least = distance;
    nearest = rooms[r].room().id;
  }
  return nearest;
}

/** @brief Returns what two rooms have in common, cubic metres, by samples in plan. */
double
commonVolume(const PlanRoom& a, const PlanRoom& b)
{
  constexpr double most_samples = 1e4;
  const Eigen::AlignedBox2d box =
      boundsOf(a.boundary).intersection(boundsOf(b.boundary));
  if (box.isEmpty() || commonArea(a, b) == 0)
    return 0;
  const RoomLookup one(a);
  const RoomLookup two(b);
  const double step = std::sqrt(box.volume() / most_samples);
  double volume = 0;
  for (double y = box.min().y() + step / 2; y < box.max().y(); y += step)
    for (double x = box.min().x() + step / 2; x < box.max().x(); x += step)
      if (const Eigen::Vector2d p(x, y); one.contains(p) && two.contains(p))
        volume += step * step *
                  std::max(std::min(one.ceilingAt(p), two.ceilingAt(p)) -
                               std::max(one.floorAt(p), two.floorAt(p)),
                           0.0);
  return volume;
}

/** @brief What of one kind contradicts itself in a plan. */
struct Contradictions {
  const char* claim;
  const char* unit;
  std::string where{}; ///< the largest
  std::size_t count = 0;
  double total = 0;
  double most = 0;

  void add(double size, const std::string& which)
  {
    constexpr double negligible = 0.1; // square or cubic metres
    if (size <= negligible)
      return;
    ++count;
    total += size;
    if (size > most) {
      most = size;
      where = which;
    }
  }

  void tell() const
  {
    const auto by = [this](double size) {
      return formatText(" by %.1f ", size) + unit;
    };
    if (count > 0)
      warn(claim + by(total) + " (places: " + std::to_string(count) + "), most " +
           where + by(most) + ": areas and volumes are wrong by as much");
  }
};

/** @brief Warns of outlines that cross themselves and of what is at one place: what is
 * made of such a plan is wrong there. */
void
warnOfContradictions(const Floorplan& plan)
{
  Contradictions rooms{"rooms overlap", "m3"};
  Contradictions columns{"columns overlap", "m2"};
  Contradictions outside{"columns reach out of their room", "m2"};
  std::size_t crossed = 0;
  std::string outline; // the first of these
  const auto areaWithin = [](const PlanLoop& boundary) {
    PlanRoom room;
    room.boundary = boundary;
    return room;
  };
  for (const PlanRoom& room : plan.rooms) {
    const std::string name = "room " + std::to_string(room.id);
    if (const std::string problem = outlineProblem(room.boundary);
        !problem.empty() && crossed++ == 0)
      outline = "that of " + name + " " + problem;
    for (const PlanRoom& other : plan.rooms)
      if (other.id > room.id)
        rooms.add(commonVolume(room, other),
                  name + " and room " + std::to_string(other.id));
    for (std::size_t i = 0; i < room.columns.size(); ++i) {
      const PlanRoom column = areaWithin(reversed(room.columns[i]));
      const std::string which = "column " + std::to_string(i + 1) + " of " + name;
      outside.add(column.area() - commonArea(column, areaWithin(room.boundary)), which);
      for (std::size_t j = i + 1; j < room.columns.size(); ++j)
        columns.add(commonArea(column, areaWithin(reversed(room.columns[j]))),
                    which + " and its column " + std::to_string(j + 1));
    }
  }
  if (crossed > 0)
    warn("outlines cannot be right (rooms: " + std::to_string(crossed) + "), " +
         outline + ": areas and volumes are wrong");
  for (const Contradictions& kind : {rooms, columns, outside})
    kind.tell();
}

} // namespace

std::string
textOfFile(const std::string& path)
{
  const InputFile file(path);
  std::string text(file.size(), '\0');
  file.read(0, text.size(), text.data());
  return text;
}

PlanDocument
loadPlan(const std::string& path)
{
  const InputFile file(path);
  if (looksLikePcd(file) || looksLikePly(file))
    throw ToolError("'" + path +
                    "' is a cloud or mesh; a floor plan is asked for, the "
                    "floorplan.json that pcl_sedr writes");
  std::string problem;
  PlanDocument document = documentFromJson(textOfFile(path), problem);
  if (!problem.empty())
    throw ToolError("'" + path + "': " + problem);
  if (document.plan.rooms.empty())
    throw ToolError("the floor plan '" + path + "' has no rooms", NothingFound);
  warnOfContradictions(document.plan);
  return document;
}

std::optional<Origin>
statedPlanOrigin(const std::string& path)
{
  const auto json = nlohmann::ordered_json::parse(textOfFile(path), nullptr, false);
  if (json.is_discarded())
    throw ToolError("'" + path + "' is no JSON, or only a part of one");
  Origin origin;
  if (!readOrigin(json, origin))
    throw ToolError("the origin in '" + path + "' is no list of three numbers");
  return json.contains("origin") ? std::optional<Origin>(origin) : std::nullopt;
}

void
giveRooms(const Floorplan& plan, ToolCloud& cloud)
{
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.label[i] != 0 && cloud.room[i] != 0)
      return;
  std::vector<RoomLookup> rooms;
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const PlanRoom& room : plan.rooms) {
    rooms.emplace_back(room);
    boxes.push_back(boundsOf(room.boundary));
  }
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = (*cloud.points)[i].getVector3fMap().cast<double>();
    if (cloud.label[i] != 0 && p.allFinite())
      cloud.room[i] = roomAt(rooms, boxes, p);
  }
}

void
setSurfacePoints(pcl::PCLPointCloud2& blob, const std::vector<SurfacePoint>& points)
{
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> labels;
  std::vector<std::uint32_t> rooms;
  for (const auto& point : points) {
    positions.push_back(point.position.cast<float>());
    labels.push_back(static_cast<std::uint32_t>(point.label));
    rooms.push_back(point.room);
  }
  setCoordinates(blob, 0, positions);
  int axis = 0;
  for (const char* name : {"normal_x", "normal_y", "normal_z"}) {
    std::vector<float> values;
    for (const auto& point : points)
      values.push_back(static_cast<float>(point.normal[axis]));
    setField(blob, name, values);
    ++axis;
  }
  setField(blob, "label", labels);
  setField(blob, "room", rooms);
}

} // namespace pcl::sedr::tools
