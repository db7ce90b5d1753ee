// SPDX-License-Identifier: BSD-3-Clause
#include "edited_report.h"

#include "sedr_filters/src/editing/room_references.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;

/** @brief A wall by the numbers of its room and its own, from 1. */
struct WallNumber {
  std::uint32_t room = 0;
  std::size_t wall = 0;

  std::string text() const { return std::to_string(room) + "." + std::to_string(wall); }
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

/** @brief Returns the doubts that hold for the new plan. */
Json
doubtsOf(const Json& warnings, const Untouched& untouched)
{
  const std::set<std::string> of_files{"crossing", "contradiction", "opening_closed",
                                       "no_solid", "not_in_ifc",    "ifc_loss",
                                       "edited"}; // which are told anew
  Json kept = Json::array();
  for (Json warning : warnings) {
    const auto room = warning.value("room", 0U);
    const WallNumber wall{room, warning.value("wall", std::size_t{0})};
    if (of_files.count(warning.value("kind", "")) > 0 ||
        (room != 0 && !untouched.hasRoom(room) && wall.wall == 0))
      continue;
    std::string text = warning.value("text", "");
    if (wall.wall > 0) {
      const auto now = untouched.find(wall);
      if (!now)
        continue;
      warning["room"] = now->room;
      warning["wall"] = now->wall;
      boost::replace_first(text, wall.text() + ":", now->text() + ":");
    }
    else if (room != 0 && !untouched.isSameRoom(room))
      text += " (before the plan was edited)";
    warning["text"] = text;
    kept.push_back(std::move(warning));
  }
  return kept;
}

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

} // namespace

void
carryOver(Json& report,
          const Json& rooms,
          const Floorplan& before,
          const Floorplan& plan,
          const std::vector<std::string>& edits)
{
  const Untouched untouched(before, plan);
  for (Json& room : report["rooms"])
    for (const Json& old : rooms)
      if (old.value("id", 0U) == room["id"] && untouched.isSameRoom(room["id"]))
        for (const char* kept : {"unseen_outline", "mesh"})
          room[kept] = old.value(kept, Json());
  report["walls"] = mapsOf(report["walls"], untouched);
  Json& all = report["edits"];
  for (const std::string& edit : edits)
    all.push_back(edit);
  Json warnings = doubtsOf(report["warnings"], untouched);
  Json edited;
  edited["kind"] = "edited";
  edited["room"] = 0;
  edited["wall"] = 0;
  edited["at"] = nullptr;
  edited["values"] = Json::array({all.size()});
  edited["text"] = "the plan was edited by hand: " + all.back().get<std::string>() +
                   (all.size() > 1 ? ", the last of " + std::to_string(all.size()) +
                                         " edits that report.json tells"
                                   : "") +
                   "; mesh, points and distances are those of the scan";
  warnings.insert(warnings.begin(), edited);
  report["warnings"] = warnings;
}

} // namespace pcl::sedr::tools
