// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_ifc.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief A column of a schedule. */
template <typename Row>
struct Column {
  std::string name;
  std::function<std::string(const Row&)> text;
};

std::string
measure(double value)
{
  return decimalText(value, 3);
}

/** @brief Returns a share in percent, nothing if it is not known. */
std::string
percent(double share)
{
  return share < 0 ? "" : decimalText(100 * share, 0);
}

std::string
roomText(std::uint32_t room)
{
  return room == 0 ? "outside" : std::to_string(room);
}

template <typename Row>
ScheduleTable
tableOf(const char* name,
        const std::vector<Column<Row>>& columns,
        const std::vector<Row>& rows)
{
  ScheduleTable table{name, {}, {}};
  for (const Column<Row>& column : columns)
    table.columns.push_back(column.name);
  for (const Row& row : rows) {
    table.rows.emplace_back();
    for (const Column<Row>& column : columns)
      table.rows.back().push_back(column.text(row));
  }
  return table;
}

/** @brief Returns the columns, and those of an accuracy.
 * @param of "floor_", to tell several of a row apart */
template <typename Row>
std::vector<Column<Row>>
withAccuracy(std::vector<Column<Row>> columns,
             SurfaceAccuracy Row::*member,
             const std::string& of = "")
{
  const auto add = [&](const char* name, auto text) {
    columns.push_back({of + name, [=](const Row& row) { return text(row.*member); }});
  };
  const auto millimetres = [](const SurfaceAccuracy& accuracy, double value) {
    return accuracy.isKnown() ? decimalText(1000 * value, 1) : "";
  };
  add("standard_error_mm", [=](const SurfaceAccuracy& accuracy) {
    return millimetres(accuracy, accuracy.standard_error);
  });
  add("measured_accuracy", measuredLevel);
  add("deviation_95_mm", [=](const SurfaceAccuracy& accuracy) {
    return millimetres(accuracy, accuracy.deviation_95);
  });
  add("represented_accuracy", representedLevel);
  return columns;
}

const std::vector<Column<RoomRow>> room_columns{
    {"room", [](const RoomRow& r) { return std::to_string(r.id); }},
    {"name", [](const RoomRow& r) { return r.name; }},
    {"storey", [](const RoomRow& r) { return r.storey; }},
    {"area_m2", [](const RoomRow& r) { return measure(r.area); }},
    {"area_above_2.0m_m2", [](const RoomRow& r) { return measure(r.area_2_0); }},
    {"area_above_1.5m_m2", [](const RoomRow& r) { return measure(r.area_1_5); }},
    {"perimeter_m", [](const RoomRow& r) { return measure(r.perimeter); }},
    {"height_m", [](const RoomRow& r) { return measure(r.height); }},
    {"lowest_m", [](const RoomRow& r) { return measure(r.lowest); }},
    {"highest_m", [](const RoomRow& r) { return measure(r.highest); }},
    {"volume_m3", [](const RoomRow& r) { return measure(r.volume); }},
    {"walls_measured_percent", [](const RoomRow& r) { return percent(r.measured); }}};

const std::vector<Column<OpeningRow>> opening_columns{
    {"number", [](const OpeningRow& o) { return o.mark; }},
    {"kind", [](const OpeningRow& o) { return o.kind; }},
    {"storey", [](const OpeningRow& o) { return o.storey; }},
    {"width_m", [](const OpeningRow& o) { return measure(o.width); }},
    {"width_is", [](const OpeningRow& o) { return o.width_is; }},
    {"width_error_mm",
     [](const OpeningRow& o) {
       return o.width_error > 0 ? decimalText(1000 * o.width_error, 1) : "";
     }},
    {"height_m", [](const OpeningRow& o) { return measure(o.height); }},
    {"sill_m", [](const OpeningRow& o) { return measure(o.sill); }},
    {"head_m", [](const OpeningRow& o) { return measure(o.head()); }},
    {"leaf", [](const OpeningRow& o) { return o.leaf; }},
    {"opens_into",
     [](const OpeningRow& o) { return o.leaf.empty() ? "" : roomText(o.swing); }},
    {"from_room", [](const OpeningRow& o) { return roomText(o.rooms[0]); }},
    {"to_room", [](const OpeningRow& o) { return roomText(o.rooms[1]); }},
    {"kind_probability_percent",
     [](const OpeningRow& o) { return percent(o.confidence); }}};

const std::vector<Column<WallRow>> wall_columns{
    {"number", [](const WallRow& w) { return w.number; }},
    {"other_face", [](const WallRow& w) { return w.other; }},
    {"storey", [](const WallRow& w) { return w.storey; }},
    {"external",
     [](const WallRow& w) { return std::string(w.is_external ? "yes" : "no"); }},
    {"thickness_m", [](const WallRow& w) { return measure(w.thickness); }},
    {"thickness_is", [](const WallRow& w) { return w.thickness_is; }},
    {"length_m", [](const WallRow& w) { return measure(w.length); }},
    {"height_m", [](const WallRow& w) { return measure(w.height); }},
    {"gross_area_m2", [](const WallRow& w) { return measure(w.gross_area); }},
    {"net_area_m2", [](const WallRow& w) { return measure(w.net_area); }},
    {"measured_percent", [](const WallRow& w) { return percent(w.measured); }}};

/** @brief Quotes a field that has a comma, a quote or the end of a line. A text that
 * spreadsheets would take as a formula gets an apostrophe before it. */
std::string
fieldOf(std::string text)
{
  if (const std::string number = text.substr(text[0] == '-' ? 1 : 0);
      text.find_first_of("=+-@\t\r") == 0 &&
      number.find_first_not_of("0123456789.") != std::string::npos)
    text.insert(0, "'");
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  boost::replace_all(text, "\"", "\"\"");
  return "\"" + text + "\"";
}

std::string
lineOf(const std::vector<std::string>& texts)
{
  std::vector<std::string> fields;
  for (const std::string& text : texts)
    fields.push_back(fieldOf(text));
  return boost::join(fields, ",") + "\r\n";
}

} // namespace

std::string
levelOfAccuracy(double error_95)
{
  if (!(error_95 > 0))
    return "not measured";
  int level = 50;
  for (const double finest : {0.001, 0.005, 0.015, 0.05})
    level -= error_95 > finest ? 10 : 0;
  return "LOA" + std::to_string(level);
}

std::string
measuredLevel(const SurfaceAccuracy& accuracy)
{
  return levelOfAccuracy(2 * accuracy.standard_error);
}

std::string
representedLevel(const SurfaceAccuracy& accuracy)
{
  return levelOfAccuracy(accuracy.isKnown() ? accuracy.deviation_95 : 0);
}

SurfaceAccuracy
accuracyOf(const PlanOpening& opening)
{
  double worst = opening.residual;
  for (const OpeningEdge& edge : opening.edges)
    worst = std::max(worst, edge.error);
  return opening.deviation_95 > 0 ? SurfaceAccuracy{worst, opening.deviation_95}
                                  : SurfaceAccuracy{};
}

std::string
widthIs(const PlanOpening& opening)
{
  constexpr std::array<const char*, 4> words{"seen part", "leaf or frame",
                                             "between rims", "between reveals"};
  return opening.widthError() > 0 ? words[static_cast<std::size_t>(opening.jambsSeen())]
                                  : "";
}

std::vector<OpeningRow>
openingRows(const Floorplan& plan)
{
  std::vector<OpeningRow> rows;
  const std::vector<PlanStorey> storeys = storeysOf(plan);
  std::vector<const PlanOpening*> openings;
  for (const PlanOpening& opening : plan.openings)
    openings.push_back(&opening);
  const auto rank = [](const PlanOpening* o) {
    return std::tuple(o->kind == OpeningKind::Unknown, o->kind, o->number);
  };
  std::sort(
      openings.begin(), openings.end(),
      [&](const PlanOpening* a, const PlanOpening* b) { return rank(a) < rank(b); });
  for (const PlanOpening* opening : openings) {
    const std::uint32_t room = opening->rooms[opening->rooms[0] == 0 ? 1 : 0];
    const auto storey =
        std::find_if(storeys.begin(), storeys.end(), [room](const PlanStorey& s) {
          return std::count(s.rooms.begin(), s.rooms.end(), room) > 0;
        });
    rows.push_back({markOf(*opening), nameOf(opening->kind),
                    storey == storeys.end() ? "" : storey->name, opening->width(),
                    opening->height(), widthIs(*opening), opening->widthError(),
                    sillOf(plan, *opening), leafOf(*opening), opening->swing,
                    opening->rooms, opening->confidence, accuracyOf(*opening)});
  }
  return rows;
}

std::vector<ScheduleTable>
tablesOf(const Schedules& schedules)
{
  return {tableOf("rooms",
                  withAccuracy(withAccuracy(room_columns, &RoomRow::floor, "floor_"),
                               &RoomRow::ceiling, "ceiling_"),
                  schedules.rooms),
          tableOf("openings", withAccuracy(opening_columns, &OpeningRow::accuracy),
                  schedules.openings),
          tableOf("walls", withAccuracy(wall_columns, &WallRow::accuracy),
                  schedules.walls)};
}

std::string
csvOf(const ScheduleTable& table)
{
  std::string csv = lineOf(table.columns);
  for (const std::vector<std::string>& row : table.rows)
    csv += lineOf(row);
  return csv;
}

} // namespace pcl::sedr
