// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;

Json
solidOf(const std::vector<RoomSolidReport>& solids, std::uint32_t room)
{
  for (const auto& report : solids)
    if (report.room == room)
      return {{"closed_manifold", report.closed},
              {"triangles", report.triangles},
              {"area", report.area},
              {"floor_area", report.floor_area},
              {"ceiling_area", report.ceiling_area},
              {"wall_area", report.wall_area},
              {"riser_area", report.riser_area},
              {"volume", report.volume},
              {"problem", report.problem}};
  return nullptr;
}

/** @brief Returns how much of walls was measured; null if that is not known. */
Json
supportOf(const WallShares& walls)
{
  return walls.area > 0 ? Json{{"measured", walls.measured},
                               {"inferred", walls.inferred},
                               {"unseen", walls.unseen}}
                        : Json();
}

Json
roomsOf(const Floorplan& plan,
        const Schedules& schedules,
        const std::vector<RoomSolidReport>& solids)
{
  Json rooms = Json::array();
  const std::map<std::uint32_t, std::uint32_t> storeys = storeyOfRooms(plan);
  for (const RoomRow& row : schedules.rooms) {
    const PlanRoom& room = *findRoom(plan, row.id);
    rooms.push_back({{"id", room.id},
                     {"storey", storeys.at(room.id)},
                     {"area", row.area},
                     {"perimeter", row.perimeter},
                     {"height", row.height},
                     {"volume", row.volume},
                     {"walls", room.boundary.elements.size()},
                     {"columns", room.columns.size()},
                     {"details", room.details.size()},
                     {"support", supportOf(wallShares(plan, room))},
                     {"inferred_floor", room.floor.inferred},
                     {"inferred_ceiling", room.ceiling.inferred},
                     {"unseen_outline", 0},
                     {"solid", solidOf(solids, room.id)},
                     {"mesh", nullptr}});
  }
  return rooms;
}

Json
storeyFigures(const Floorplan& plan)
{
  Json storeys = Json::array();
  for (const PlanStorey& storey : storeysOf(plan)) {
    double area = 0;
    for (const PlanRoom& room : partOf(plan, storey).rooms)
      area += room.area();
    storeys.push_back({{"number", storey.number},
                       {"name", storey.name},
                       {"floor", storey.floor},
                       {"area", area},
                       {"rooms", storey.rooms}});
  }
  return storeys;
}

/** @brief Returns the sizes of doors, windows and passages. */
Json
openingsOf(const Floorplan& plan)
{
  Json openings = Json::array();
  for (const PlanOpening& opening : plan.openings)
    openings.push_back({{"number", markOf(opening)},
                        {"kind", nameOf(opening.kind)},
                        {"rooms", opening.rooms},
                        {"width", opening.width()},
                        {"height", opening.height()},
                        {"bottom", opening.bottom},
                        {"confidence", opening.confidence},
                        {"residual", opening.residual},
                        {"width_is", widthIs(opening)},
                        {"width_error", opening.widthError()}});
  return openings;
}

Json
schedulesOf(const Schedules& schedules)
{
  Json tables;
  for (const ScheduleTable& table : tablesOf(schedules))
    tables[table.name] = {{"columns", table.columns}, {"rows", table.rows}};
  return tables;
}

/** @brief Returns how many elements have each level of accuracy, by kind. */
Json
accuracyOf(const Schedules& schedules)
{
  Json kinds;
  const auto count = [&](const char* kind, const auto& rows, auto member) {
    for (const auto& row : rows)
      for (const auto& [what, level] :
           {std::pair("measured", measuredLevel(row.*member)),
            std::pair("represented", representedLevel(row.*member))}) {
        Json& number = kinds[kind][what][level];
        number = number.is_null() ? 1 : number.get<int>() + 1;
      }
  };
  count("walls", schedules.walls, &WallRow::accuracy);
  count("floors", schedules.rooms, &RoomRow::floor);
  count("ceilings", schedules.rooms, &RoomRow::ceiling);
  count("openings", schedules.openings, &OpeningRow::accuracy);
  return kinds;
}

/** @brief Returns probabilities of walls or openings, and the signs that tell them. */
Json
certaintyOf(const std::vector<Certainty>& elements,
            const std::vector<std::string>& signs)
{
  std::vector<std::string> columns{"element", "area"};
  for (const double step : certainty_steps)
    columns.push_back("within_" + decimalText(100 * step, 0) + "cm");
  columns.insert(columns.end(), signs.begin(), signs.end());
  Json rows = Json::array();
  for (const Certainty& element : elements) {
    Json row = Json::array({element.element, element.area});
    for (const double probability : element.within)
      row.push_back(probability);
    for (const double sign : element.signs)
      row.push_back(sign);
    rows.push_back(std::move(row));
  }
  return {{"columns", columns}, {"rows", rows}};
}

Json
placeOf(const Eigen::Vector2d& at)
{
  return at.allFinite() ? Json{at.x(), at.y()} : Json();
}

Json
warningsOf(const std::vector<PlanWarning>& list)
{
  Json warnings = Json::array();
  for (const PlanWarning& warning : list)
    warnings.push_back({{"kind", nameOf(warning.kind)},
                        {"room", warning.room},
                        {"wall", warning.wall},
                        {"at", placeOf(warning.at)},
                        {"values", warning.values},
                        {"reason", warning.reason},
                        {"note", warning.note},
                        {"text", sentenceOf(warning)}});
  return warnings;
}

Json
doubtsOf(const std::vector<PlanDoubt>& list)
{
  Json doubts = Json::array();
  for (const PlanDoubt& doubt : list) {
    std::vector<std::string> kinds;
    for (const WarningKind kind : doubt.kinds)
      kinds.push_back(nameOf(kind));
    doubts.push_back({{"subject", doubt.subject},
                      {"beside", doubt.beside},
                      {"room", doubt.room},
                      {"at", placeOf(doubt.at)},
                      {"stake", doubt.stake},
                      {"kinds", kinds},
                      {"text", doubt.text}});
  }
  return doubts;
}

Json
verdictOf(const PlanReview& review)
{
  constexpr std::array<const char*, 3> verdicts{"hand_over", "check", "scan_again"};
  return {{"verdict", verdicts[static_cast<std::size_t>(review.verdict)]},
          {"checks", review.checks},
          {"shown", std::min(leading_doubts, review.doubts.size())},
          {"within_1cm", review.within[0]},
          {"within_3cm", review.within[1]},
          {"within_5cm", review.within[2]},
          {"text", review.text}};
}

} // namespace

std::vector<PlanWarning>
warningsIn(const Json& report)
{
  std::vector<PlanWarning> warnings;
  for (const Json& told : report.value("warnings", Json::array())) {
    PlanWarning warning;
    const auto kind = warningKindOf(told.value("kind", ""));
    warning.kind = kind.value_or(WarningKind::Stage);
    warning.room = told.value("room", 0U);
    warning.wall = told.value("wall", std::size_t{0});
    warning.values = told.value("values", std::vector<double>());
    warning.reason = told.value("reason", told.value("text", ""));
    warning.note = told.value("note", "");
    if (const auto at = told.find("at"); at != told.end() && at->is_array())
      warning.at = Eigen::Vector2d(at->at(0).get<double>(), at->at(1).get<double>());
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

PlanReview
setPlan(Json& report,
        const Floorplan& plan,
        const Schedules& schedules,
        const std::vector<RoomSolidReport>& solids,
        const std::vector<PlanWarning>& warnings)
{
  report["storeys"] = storeyFigures(plan);
  report["support"] = supportOf(wallShares(plan));
  report["rooms"] = roomsOf(plan, schedules, solids);
  report["schedules"] = schedulesOf(schedules);
  report["accuracy"] = accuracyOf(schedules);
  report["openings"] = openingsOf(plan);
  PlanReview review = reviewOf(plan, warnings);
  report["certainty"] = {{"walls", certaintyOf(review.walls, wallSigns())},
                         {"openings", certaintyOf(review.openings, openingSigns())}};
  report["warnings"] = warningsOf(warnings);
  report["remarks"] = review.remarks;
  report["doubts"] = doubtsOf(review.doubts);
  report["verdict"] = verdictOf(review);
  return review;
}

namespace {

/** @brief Rounds real numbers to seven digits, the precision of floats, which would
 * have more digits as doubles. */
void
roundNumbers(Json& json)
{
  if (json.is_number_float()) {
    char text[32];
    std::snprintf(text, sizeof text, "%.7g", json.get<double>());
    json = std::strtod(text, nullptr);
  }
  else if (json.is_structured())
    for (auto& part : json)
      roundNumbers(part);
}

} // namespace

std::string
textOf(Json report, const Origin& origin)
{
  roundNumbers(report);
  const Eigen::Vector3d& place = origin.place;
  report["origin"] = {place.x(), place.y(), place.z()}; // with full precision
  // A path may contain any bytes; invalid UTF-8 becomes U+FFFD.
  return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace pcl::sedr::tools
