// SPDX-License-Identifier: BSD-3-Clause
#include "advice.h"

#include "results/distance_colour.h"
#include "scale.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

namespace {

using Advices = std::vector<Advice>;

constexpr double much_repaired = 0.25; // of a room's points
constexpr double hardly_seen = 0.2;    // of a wall
constexpr double much_hidden = 0.5;    // of a wall
constexpr double long_wall = 0.5;      // metres; shorter walls are not mentioned

std::string
percent(double share)
{
  return fixedText(100 * share, 0) + " %";
}

std::string
named(std::uint32_t room)
{
  return "Room " + std::to_string(room);
}

/** @brief Returns "wall 3 (2.4 m, 85 % hidden)" for each wall of a room that was hardly
 * seen. */
std::vector<std::string>
unseenWalls(const PlanRoom& room)
{
  std::vector<std::string> unseen;
  for (std::size_t k = 0; k < room.boundary.elements.size(); ++k) {
    const auto& wall = room.boundary.elements[k];
    if (wall.length() >= long_wall && wall.evidence.isKnown() &&
        wall.evidence.seen < hardly_seen && wall.evidence.hidden > much_hidden)
      unseen.push_back("wall " + std::to_string(k + 1) + " (" +
                       fixedText(wall.length(), 1) + " m, " +
                       percent(wall.evidence.hidden) + " hidden)");
  }
  return unseen;
}

void
addUnseenWalls(const Floorplan& plan, Advices& advices)
{
  constexpr std::size_t max_named = 6; // walls of a room
  std::vector<std::string> rooms;
  for (const auto& room : plan.rooms) {
    std::vector<std::string> unseen = unseenWalls(room);
    if (unseen.empty())
      continue;
    const std::size_t more = unseen.size() - std::min(unseen.size(), max_named);
    unseen.resize(unseen.size() - more);
    rooms.push_back("room " + std::to_string(room.id) + ": " +
                    boost::join(unseen, ", ") +
                    (more == 0 ? "" : " and " + std::to_string(more) + " more"));
  }
  if (!rooms.empty())
    advices.push_back(
        {"Walls of which hardly anything was seen: " + boost::join(rooms, "; ") + ".",
         "Their places follow their neighbours and what little was "
         "seen. If they matter, scan again from another place."});
}

void
addRepairs(const ReportData& data, Advices& advices)
{
  std::vector<std::string> rooms;
  for (const auto& room : data.rooms)
    if (room.repaired_share && *room.repaired_share >= much_repaired)
      rooms.push_back("room " + std::to_string(room.id) + " " +
                      percent(*room.repaired_share));
  if (!rooms.empty())
    advices.push_back(
        {"Much of the surface was not seen and is filled in: " +
             boost::join(rooms, ", ") +
             ". That is doors, windows, what furniture hides, or what was out of the "
             "scanner's sight.",
         "Compare the pictures of scan and model below. Where too much of a ceiling is "
         "missing, --plane-tolerance 0.1 takes in noisier planes."});
}

void
addOpenModels(const ReportData& data, Advices& advices)
{
  for (const auto& room : data.rooms) {
    if (room.mesh_closed == false)
      advices.push_back(
          {named(room.id) + ": its mesh is not closed" +
               (room.mesh_problem.empty() ? "" : ": " + room.mesh_problem) + ".",
           "Take the solid, solid.ply, or make the mesh of the plan by "
           "--mesh-from-plan."});
    if (room.solid_closed == false)
      advices.push_back(
          {named(room.id) + ": its solid is not closed" +
               (room.solid_problem.empty() ? "" : ": " + room.solid_problem) + ".",
           "Look at its walls in the plan: lines that cross or miss each other."});
  }
}

/** @brief Returns a parameter of the run, 0 if unknown. */
double
parameterOf(const ReportData& data, const std::string& name)
{
  for (const auto& [own, value] : data.parameters)
    if (own == name)
      return std::strtod(value.c_str(), nullptr);
  return 0;
}

/** @brief Returns a remedy for points far from their model: tolerances suited to the
 * noise, unless the run already used them. */
std::string
tolerancesFor(const ReportData& data)
{
  constexpr double wide = 0.1; // metres
  std::string options;
  for (const auto& [name, option] :
       {std::pair<std::string, std::string>{"plane_tolerance", "--plane-tolerance 0.1"},
        {"boundary_tolerance", "--boundary-tolerance 0.1"}})
    if (parameterOf(data, name) < wide)
      options += (options.empty() ? "" : " and ") + option;
  if (options.empty())
    return "That is its noise, which the tolerances of this run take in; a scan in "
           "other units needs --unit.";
  return "A scan so noisy needs " + options + "; one in other units --unit.";
}

void
addDistances(const ReportData& data, Advices& advices)
{
  if (!data.distances)
    return;
  constexpr double far_median = 0.02;  // metres
  constexpr double much_beyond = 0.15; // of the points
  const DistanceStatistics& d = *data.distances;
  const double beyond = 1 - d.within_5cm;
  if (d.median > far_median)
    advices.push_back({"Half of the structure's points lie more than " +
                           distanceText(d.median) + " off the model.",
                       tolerancesFor(data)});
  else if (beyond > much_beyond)
    advices.push_back(
        {percent(beyond) + " of the structure's points lie more than 5 cm off the "
                           "model.",
         "Often that is furniture at the walls: see where it is in the picture of "
         "distances. If whole walls are red there, a smaller --minimum-cells finds "
         "smaller details, and a smaller --grid-size finer ones."});
}

/** @brief Returns whether a warning of the run already mentions a repaired share. */
bool
isToldAlready(const std::string& warning)
{
  return warning.find("were filled in, not seen") != std::string::npos;
}

std::string
remedyOf(const std::string& warning)
{
  const auto tells = [&](const char* words) {
    return warning.find(words) != std::string::npos;
  };
  if (tells("too sparse"))
    return "A denser scan, or scans from more places, would show more. "
           "--fixed-grid keeps the small cells.";
  if (tells("left out") && tells("ceiling"))
    return "--pictures shows what each stage decided, and why.";
  return "";
}

template <typename Known>
bool
isKnownOfAll(const std::vector<RoomFacts>& rooms, Known known)
{
  return !rooms.empty() && std::all_of(rooms.begin(), rooms.end(), known);
}

} // namespace

std::vector<Advice>
adviceOn(const ReportData& data)
{
  Advices advices;
  addOpenModels(data, advices);
  addRepairs(data, advices);
  addUnseenWalls(data.plan, advices);
  addDistances(data, advices);
  const bool tells_repairs =
      std::any_of(data.rooms.begin(), data.rooms.end(), [](const RoomFacts& room) {
        return room.repaired_share.has_value();
      });
  for (const auto& warning : data.warnings)
    if (!tells_repairs || !isToldAlready(warning))
      advices.push_back({warning, remedyOf(warning)});
  return advices;
}

std::string
unknownOf(const ReportData& data)
{
  std::vector<std::string> unknown;
  if (!isKnownOfAll(data.rooms, [](const RoomFacts& room) {
        return room.mesh_closed.has_value() || room.solid_closed.has_value();
      }))
    unknown.emplace_back("whether all rooms are closed");
  if (!isKnownOfAll(data.rooms, [](const RoomFacts& room) {
        return room.repaired_share.has_value();
      }))
    unknown.emplace_back("how much of their surface was seen");
  if (!data.distances)
    unknown.emplace_back("how far the points lie from the model");
  return boost::join(unknown, ", ");
}

} // namespace pcl::sedr::tools
