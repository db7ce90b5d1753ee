// SPDX-License-Identifier: BSD-3-Clause
#include "carried_report.h"

#include "model/plan_report.h"
#include "tool_error.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/editing/plan_edits.h"
#include "sedr_surface/src/sheet/text_places.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;

/** @brief A wall by the numbers of its room and its own, from 1. */
struct WallNumber {
  std::uint32_t room = 0;
  std::size_t wall = 0;
};

/** @brief Finds what an edit left as it was. */
class Untouched {
public:
  Untouched(const Floorplan& before, const Floorplan& plan)
      : before_(before)
      , plan_(plan)
  {}

  bool hasRoom(std::uint32_t id) const { return findRoom(plan_, id) != nullptr; }

  /** @brief Returns whether a room has the outline, floor and ceiling that it had. */
  bool isSameRoom(std::uint32_t id) const
  {
    const PlanRoom* const old = findRoom(before_, id);
    const PlanRoom* const now = findRoom(plan_, id);
    return old && now && isSame(old->boundary, now->boundary) &&
           planesOf(*old) == planesOf(*now);
  }

  /** @brief Returns which room a room is now, or is a part of; 0: none. */
  std::uint32_t roomNow(std::uint32_t id) const
  {
    return hasRoom(id) ? id : roomAround(findRoom(before_, id), plan_);
  }

  /** @brief Returns whether a new room is a part of a room before. */
  bool isSplit(std::uint32_t id) const
  {
    return std::any_of(
        plan_.rooms.begin(), plan_.rooms.end(), [&](const PlanRoom& room) {
          return !findRoom(before_, room.id) && roomAround(&room, before_) == id;
        });
  }

  /** @brief Returns which wall a wall is now; nothing if it was touched. */
  std::optional<WallNumber> find(const WallNumber& old) const
  {
    const PlanRoom* const room = findRoom(before_, old.room);
    if (!room || old.wall < 1 || old.wall > room->boundary.elements.size())
      return {};
    for (const PlanRoom& now : plan_.rooms)
      if (const auto k = elementLike(now, room->boundary.elements[old.wall - 1]))
        return WallNumber{now.id, *k + 1};
    return {};
  }

private:
  /** @brief Returns the room of a plan that holds the middle of a room, 0 for none. */
  static std::uint32_t roomAround(const PlanRoom* room, const Floorplan& plan)
  {
    if (room)
      for (const PlanRoom* const other : roomsAt(plan, heightsOf(*room)))
        if (other->contains(textSpotIn(room->boundary, room->columns).place))
          return other->id;
    return 0;
  }

  static std::vector<Eigen::Vector4d> planesOf(const PlanRoom& room)
  {
    std::vector<Eigen::Vector4d> planes{room.floor.plane, room.ceiling.plane};
    for (const auto* const details : {&room.floor_details, &room.details})
      for (const PlanDetail& detail : *details)
        planes.push_back(detail.slab.plane);
    return planes;
  }

  const Floorplan& before_;
  const Floorplan& plan_;
};

/** @brief Returns the maps of walls that are as they were. */
Json
mapsOf(const Json& maps, const Untouched& untouched)
{
  Json kept = Json::array();
  for (Json map : maps) {
    Json walls = Json::array();
    std::uint32_t room = 0;
    for (const Json& wall : map["walls"])
      if (const auto now =
              untouched.find({map.value("room", 0U), wall.get<std::size_t>()})) {
        walls.push_back(now->wall);
        room = now->room;
      }
    if (walls.size() != map["walls"].size())
      continue;
    map["room"] = room;
    map["walls"] = walls;
    kept.push_back(std::move(map));
  }
  return kept;
}

/** @brief Gives the doubt of a room to the room that this is now a part of.
 * @return whether it still is a doubt: not of a room that is gone, whether two rooms
 * are one that were merged, or whether one is two that was split */
bool
followRooms(const Untouched& untouched, PlanWarning& warning)
{
  const std::uint32_t old = warning.room;
  warning.room = untouched.roomNow(old);
  if (warning.kind == WarningKind::OneRoom && warning.values.size() > 2) {
    double& other = warning.values[2];
    if (!(other >= 0 && other <= std::numeric_limits<std::uint32_t>::max()))
      throw ToolError("report.json doubts whether room " + std::to_string(old) +
                      " and room " + numberText(other) +
                      " are one, and that is no number of a room");
    other = untouched.roomNow(static_cast<std::uint32_t>(other));
    return warning.room != 0 && other != 0 && other != warning.room;
  }
  return warning.room != 0 &&
         !(warning.kind == WarningKind::TwoRooms && untouched.isSplit(old));
}

} // namespace

std::vector<PlanWarning>
carriedWarnings(Json& report,
                const Floorplan& before,
                const Floorplan& plan,
                const std::vector<std::string>& edits)
{
  const std::set<WarningKind> of_files{
      WarningKind::Crossing, WarningKind::Contradiction, WarningKind::OpeningClosed,
      WarningKind::NoSolid,  WarningKind::NotInIfc,      WarningKind::IfcLoss,
      WarningKind::Edited}; // which are told anew
  const Untouched untouched(before, plan);
  Json& all = report["edits"];
  for (const std::string& edit : edits)
    all.push_back(edit);
  std::vector<PlanWarning> kept{
      warningOf(WarningKind::Edited,
                "the plan was edited by hand: " + all.back().get<std::string>() +
                    (all.size() > 1 ? ", the last of " + std::to_string(all.size()) +
                                          " edits that report.json tells"
                                    : "") +
                    "; mesh, points and distances are those of the scan")};
  for (PlanWarning& warning : warningsIn(report)) {
    if (of_files.count(warning.kind) > 0)
      continue;
    if (warning.wall > 0) {
      const auto now = untouched.find({warning.room, warning.wall});
      if (!now)
        continue;
      warning.room = now->room;
      warning.wall = now->wall;
    }
    else if (warning.room != 0) {
      const bool is_same = untouched.isSameRoom(warning.room);
      if (!followRooms(untouched, warning))
        continue;
      if (!is_same)
        warning.note = "before the plan was edited";
    }
    kept.push_back(std::move(warning));
  }
  return kept;
}

void
carryOver(Json& report,
          const Json& rooms,
          const Floorplan& before,
          const Floorplan& plan)
{
  const Untouched untouched(before, plan);
  for (Json& room : report["rooms"])
    for (const Json& old : rooms)
      if (old.value("id", 0U) == room["id"] && untouched.isSameRoom(room["id"]))
        for (const char* kept : {"unseen_outline", "mesh"})
          room[kept] = old.value(kept, Json());
  report["walls"] = mapsOf(report["walls"], untouched);
}

} // namespace pcl::sedr::tools
