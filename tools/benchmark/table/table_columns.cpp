// SPDX-License-Identifier: BSD-3-Clause
#include "table_columns.h"

#include "formatted.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace pcl::sedr::benchmark {

namespace {

using Figure = std::function<double(const RunRow&)>;

enum class Worse { Higher, Lower };

std::string
marked(const std::string& cell, bool is_missed)
{
  return is_missed ? "**" + cell + "**" : cell;
}

/** @brief Returns the worst figure and the median, times `scale`: "0.21 (0.19)". */
std::string
spread(const RunGroup& group,
       const Figure& figure,
       Worse worse,
       const char* format,
       double scale)
{
  const auto figures = figuresOf(group, figure);
  if (figures.empty())
    return "-";
  const double extreme = worse == Worse::Higher ? figures.back() : figures.front();
  const std::string worst = formatted(format, scale * extreme);
  const std::string median = formatted(format, scale * medianOf(figures));
  return worst == median ? worst : worst + " (" + median + ")";
}

/** @brief Returns the column of a figure; cells that miss the bar are marked. */
TableColumn
figureColumn(const std::string& title,
             const Figure& figure,
             Worse worse,
             const char* format,
             double scale,
             std::optional<Bar> bar = std::nullopt)
{
  return {title, [=](const RunGroup& group) {
            return marked(spread(group, figure, worse, format, scale),
                          bar && missesOf(group, *bar) > 0);
          }};
}

TableColumn
shareColumn(const std::string& title,
            const Figure& figure,
            Worse worse,
            std::optional<Bar> bar = std::nullopt)
{
  return figureColumn(title, figure, worse, "%.2f", 100, bar);
}

/** @brief Returns found and true rooms: "4/4", or "3-5/4" if the seeds differ. */
std::string
roomsCell(const RunGroup& group)
{
  const auto found = figuresOf(group, [](const RunRow& row) {
    return static_cast<double>(row.rooms.rooms_found);
  });
  std::string text = formatted("%.0f", found.front());
  if (found.front() != found.back())
    text += "-" + formatted("%.0f", found.back());
  text += "/" + std::to_string(group.front().rooms.rooms_true);
  return marked(text,
                missesOf(group, Bar::Rooms) > 0 || missesOf(group, Bar::Done) > 0);
}

/** @brief Returns "yes", or the number of runs with open meshes or extra components. */
std::string
closedCell(const RunGroup& group)
{
  const std::size_t open = missesOf(group, Bar::Closed);
  const std::size_t split = missesOf(group, Bar::Components);
  const std::size_t failed = missesOf(group, Bar::Done);
  if (failed == group.size())
    return "-";
  std::string text = open == 0 ? "yes" : "no " + std::to_string(open);
  if (split > 0)
    text += ", parts " + std::to_string(split);
  return marked(text, open + split > 0);
}

/** @brief Returns "yes", or the number of runs with open or crossing solids. */
std::string
solidClosedCell(const RunGroup& group)
{
  const std::size_t open = missesOf(group, Bar::SolidClosed);
  const std::size_t crossing = missesOf(group, Bar::SolidCrossing);
  if (missesOf(group, Bar::Done) == group.size())
    return "-";
  std::string text = open == 0 ? "yes" : "no " + std::to_string(open);
  if (crossing > 0)
    text += ", crossing " + std::to_string(crossing);
  return marked(text, open + crossing > 0);
}

/** @brief Returns found and true corners: "4/4", or "4-5/4" if the seeds differ. */
std::string
cornersCell(const RunGroup& group)
{
  std::vector<std::size_t> found;
  std::size_t real = 0;
  for (const RunRow& row : group)
    if (row.plan.corners_found) {
      found.push_back(*row.plan.corners_found);
      real = row.plan.corners_true.value_or(0);
    }
  if (found.empty())
    return "-";
  const auto [least, most] = std::minmax_element(found.begin(), found.end());
  std::string text = std::to_string(*least);
  if (*least != *most)
    text += "-" + std::to_string(*most);
  return marked(text + "/" + std::to_string(real), missesOf(group, Bar::Corners) > 0);
}

double
extrusionSeconds(const RunRow& row)
{
  for (const auto& [name, seconds] : row.stage_seconds)
    if (name == "FloorplanExtrusion")
      return seconds;
  return not_known;
}

/** @brief Returns a column with the worst recall and the worst precision of a label. */
TableColumn
labelColumn(std::size_t k)
{
  return {
      toString(scored_labels[k]), [k](const RunGroup& group) {
        const auto recall =
            figuresOf(group, [k](const RunRow& row) { return row.labels[k].recall; });
        const auto precision = figuresOf(
            group, [k](const RunRow& row) { return row.labels[k].precision; });
        if (recall.empty())
          return std::string("-");
        return formatted("%.1f", 100 * recall.front()) + " / " +
               (precision.empty() ? "-" : formatted("%.1f", 100 * precision.front()));
      }};
}

std::vector<TableColumn>
modelColumns()
{
  const auto mesh = [](double ModelFigures::*figure) {
    return [figure](const RunRow& row) { return row.mesh.*figure; };
  };
  return {
      {"closed", closedCell},
      figureColumn("mean, cm", mesh(&ModelFigures::truth_to_mesh_mean), Worse::Higher,
                   "%.3f", 100, Bar::Mean),
      figureColumn("max, cm", mesh(&ModelFigures::truth_to_mesh_max), Worse::Higher,
                   "%.1f", 100),
      shareColumn("≤ 1 cm", mesh(&ModelFigures::truth_within_1cm), Worse::Lower,
                  Bar::Within1cm),
      shareColumn("≤ 5 cm", mesh(&ModelFigures::truth_within_5cm), Worse::Lower,
                  Bar::Within5cm),
      figureColumn("model mean, cm", mesh(&ModelFigures::mesh_to_truth_mean),
                   Worse::Higher, "%.3f", 100),
      figureColumn("model max, cm", mesh(&ModelFigures::mesh_to_truth_max),
                   Worse::Higher, "%.1f", 100),
      shareColumn("model > 5 cm", mesh(&ModelFigures::mesh_beyond_5cm), Worse::Higher,
                  Bar::ModelBeyond5cm),
      shareColumn("details ≤ 5 cm", mesh(&ModelFigures::detail_within_5cm),
                  Worse::Lower, Bar::DetailZone),
  };
}

std::vector<TableColumn>
structureColumns()
{
  const auto points = [](double StructureFigures::*figure) {
    return [figure](const RunRow& row) { return row.structure.*figure; };
  };
  return {
      figureColumn("mean, cm", points(&StructureFigures::points_to_truth_mean),
                   Worse::Higher, "%.3f", 100),
      figureColumn("max, cm", points(&StructureFigures::points_to_truth_max),
                   Worse::Higher, "%.1f", 100),
      shareColumn("points > 5 cm", points(&StructureFigures::points_beyond_5cm),
                  Worse::Higher, Bar::PointsBeyond5cm),
      shareColumn("covered", points(&StructureFigures::truth_covered), Worse::Lower,
                  Bar::Covered),
  };
}

} // namespace

std::vector<TableColumn>
columnsOf(bool with_mesh)
{
  const auto rooms = [](double RoomFigures::*figure) {
    return [figure](const RunRow& row) { return row.rooms.*figure; };
  };
  std::vector<TableColumn> columns{
      {"scene", [](const RunGroup& group) { return group.front().scene; }},
      {"noise, cm",
       [](const RunGroup& group) {
         return formatted("%.4g", 100 * group.front().noise);
       }},
      {"rooms", roomsCell},
  };
  const auto figures = with_mesh ? modelColumns() : structureColumns();
  columns.insert(columns.end(), figures.begin(), figures.end());
  columns.push_back(
      shareColumn("area", rooms(&RoomFigures::area_error), Worse::Higher));
  columns.push_back(
      shareColumn("height", rooms(&RoomFigures::height_error), Worse::Higher));
  columns.push_back(shareColumn(
      "volume",
      rooms(with_mesh ? &RoomFigures::mesh_volume_error : &RoomFigures::volume_error),
      Worse::Higher));
  for (std::size_t k = 0; k < scored_labels.size(); ++k)
    columns.push_back(labelColumn(k));
  columns.push_back(figureColumn(
      "s", [](const RunRow& row) { return row.seconds; }, Worse::Higher, "%.1f", 1));
  columns.push_back({"missed", [](const RunGroup& group) {
                       return missesOf(group, BarKind::Model);
                     }});
  return columns;
}

std::vector<TableColumn>
solidColumns()
{
  const auto rooms = [](double RoomFigures::*figure) {
    return [figure](const RunRow& row) { return row.rooms.*figure; };
  };
  const auto plan = [](double PlanFigures::*figure) {
    return [figure](const RunRow& row) { return row.plan.*figure; };
  };
  const auto solid = [](double SolidFigures::*figure) {
    return [figure](const RunRow& row) { return row.solid.*figure; };
  };
  return {
      {"scene", [](const RunGroup& group) { return group.front().scene; }},
      {"noise, cm",
       [](const RunGroup& group) {
         return formatted("%.4g", 100 * group.front().noise);
       }},
      {"closed", solidClosedCell},
      figureColumn("mean, cm", solid(&SolidFigures::truth_to_solid_mean), Worse::Higher,
                   "%.4f", 100, Bar::SolidMean),
      figureColumn("max, cm", solid(&SolidFigures::truth_to_solid_max), Worse::Higher,
                   "%.3f", 100, Bar::SolidMax),
      figureColumn("solid to truth max, cm", solid(&SolidFigures::solid_to_truth_max),
                   Worse::Higher, "%.3f", 100),
      shareColumn("area", rooms(&RoomFigures::area_error), Worse::Higher,
                  Bar::PlanArea),
      shareColumn("perimeter", plan(&PlanFigures::perimeter_error), Worse::Higher),
      shareColumn("volume", solid(&SolidFigures::volume_error), Worse::Higher,
                  Bar::SolidVolume),
      shareColumn("wall surface", solid(&SolidFigures::wall_area_error), Worse::Higher,
                  Bar::WallArea),
      shareColumn("radius", plan(&PlanFigures::radius_error), Worse::Higher,
                  Bar::Radius),
      {"corners", cornersCell},
      figureColumn("corner off, cm", plan(&PlanFigures::corner_distance_max),
                   Worse::Higher, "%.3f", 100),
      figureColumn(
          "triangles",
          [](const RunRow& row) {
            return row.solid.triangles ? static_cast<double>(*row.solid.triangles)
                                       : not_known;
          },
          Worse::Higher, "%.0f", 1, Bar::SolidTriangles),
      figureColumn("ms", extrusionSeconds, Worse::Higher, "%.0f", 1000),
      {"missed", [](const RunGroup& group) { return missesOf(group, BarKind::Solid); }},
  };
}

} // namespace pcl::sedr::benchmark
