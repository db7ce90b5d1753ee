// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/table.h"

#include "benchmark/run_groups.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <set>

namespace pcl {
namespace sedr {
namespace benchmark {

namespace {

using Figure = std::function<double(const RunRow&)>;

enum class Worse { Higher, Lower };

std::string
formatted(const char* format, double value)
{
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string
marked(const std::string& cell, bool is_missed)
{
  return is_missed ? "**" + cell + "**" : cell;
}

/** @brief "0.21 (0.19)": the worst figure and the median, times `scale`. */
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

/** @brief A column of the table of runs. */
struct TableColumn {
  std::string title;
  std::function<std::string(const RunGroup&)> cell;
};

/** @brief A column of a figure, marked where the bar is missed. */
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

/** @brief "4/4", or "3-5/4" where the seeds differ. */
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

/** @brief "yes", or in how many runs the meshes are not closed or not one a room. */
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

/** @brief Recall and precision of a label, the worst of each. */
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
  columns.push_back({"missed", [](const RunGroup& group) { return missesOf(group); }});
  return columns;
}

std::string
tableRow(const std::vector<std::string>& cells)
{
  std::string line = "|";
  for (const std::string& cell : cells)
    line += " " + cell + " |";
  return line + "\n";
}

std::string
tableHead(const std::vector<std::string>& titles)
{
  return tableRow(titles) + tableRow(std::vector<std::string>(titles.size(), "---"));
}

std::string
runTable(const std::vector<RunRow>& rows, bool with_mesh)
{
  const auto columns = columnsOf(with_mesh);
  std::vector<std::string> titles;
  for (const TableColumn& column : columns)
    titles.push_back(column.title);
  std::string text = tableHead(titles);
  for (const RunGroup& group : groupRuns(rows)) {
    std::vector<std::string> cells;
    for (const TableColumn& column : columns)
      cells.push_back(column.cell(group));
    text += tableRow(cells);
  }
  return text;
}

std::string
summaryOf(const std::vector<RunRow>& rows)
{
  const auto good = std::count_if(rows.begin(), rows.end(), [](const RunRow& row) {
    return missedBars(row).empty();
  });
  const std::string missed = missesOf(rows);
  return "Scenes: " + std::to_string(groupByScene(rows).size()) +
         ". Runs: " + std::to_string(rows.size()) +
         ". Runs that reach every bar: " + std::to_string(good) + "." +
         (missed.empty() ? "" : " Missed: " + missed + ".") + "\n";
}

std::string
failuresOf(const std::vector<RunRow>& rows)
{
  std::string text;
  for (const RunRow& row : rows)
    if (!row.failure.empty())
      text += "- " + row.scene + ", noise " + formatted("%.4g", 100 * row.noise) +
              " cm, seed " + std::to_string(row.seed) + ": " + row.failure + "\n";
  return text.empty() ? "" : "\n## What failed\n\n" + text;
}

/** @brief The stages of all rows, in the order in which they first occur. */
std::vector<std::string>
stagesOf(const std::vector<RunRow>& rows)
{
  std::vector<std::string> names;
  for (const RunRow& row : rows)
    for (const auto& stage : row.stage_seconds)
      if (std::find(names.begin(), names.end(), stage.first) == names.end())
        names.push_back(stage.first);
  return names;
}

double
secondsOf(const RunRow& row, const std::string& stage)
{
  for (const auto& [name, seconds] : row.stage_seconds)
    if (name == stage)
      return seconds;
  return not_known;
}

std::string
stageTable(const std::vector<RunRow>& rows)
{
  const auto stages = stagesOf(rows);
  std::vector<std::string> titles{"scene", "points, M"};
  titles.insert(titles.end(), stages.begin(), stages.end());
  titles.emplace_back("all");
  std::string text = "\n## Seconds of each stage, median of all runs of a scene\n\n" +
                     tableHead(titles);
  for (const RunGroup& group : groupByScene(rows)) {
    const auto median = [&group](const Figure& figure, double scale) {
      const auto figures = figuresOf(group, figure);
      return figures.empty() ? "-" : formatted("%.2f", scale * medianOf(figures));
    };
    std::vector<std::string> cells{
        group.front().scene,
        median([](const RunRow& row) { return static_cast<double>(row.points); },
               1e-6)};
    for (const std::string& stage : stages)
      cells.push_back(
          median([&stage](const RunRow& row) { return secondsOf(row, stage); }, 1));
    cells.push_back(median([](const RunRow& row) { return row.seconds; }, 1));
    text += tableRow(cells);
  }
  return text;
}

constexpr const char* legend =
    "\nA row is a scene and a noise: of each figure the worst over all seeds and, "
    "where "
    "it reads differently, the\nmedian in brackets. Figures in bold miss their bar in "
    "at least one run. Shares and errors are in per cent.\nWhat the columns mean and "
    "where the bars lie: [the proving ground](proving_ground.md).\n\n";

} // namespace

std::string
tableOf(const std::vector<RunRow>& rows)
{
  const std::vector<RunRow> latest = latestRows(rows);
  std::string text = "<!-- SPDX-License-Identifier: BSD-3-Clause -->\n"
                     "# The proving ground: figures\n";
  for (const bool with_mesh : {true, false}) {
    std::vector<RunRow> kind;
    std::copy_if(latest.begin(), latest.end(), std::back_inserter(kind),
                 [with_mesh](const RunRow& row) { return row.with_mesh == with_mesh; });
    if (kind.empty())
      continue;
    text += with_mesh ? "\n## Models\n\n" : "\n## Structure alone, no mesh made\n\n";
    text += summaryOf(kind) + legend + runTable(kind, with_mesh) + failuresOf(kind) +
            stageTable(kind);
  }
  return text;
}

} // namespace benchmark
} // namespace sedr
} // namespace pcl
