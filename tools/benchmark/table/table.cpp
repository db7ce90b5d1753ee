// SPDX-License-Identifier: BSD-3-Clause
#include "table.h"

#include "formatted.h"
#include "table_columns.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <string>

namespace pcl::sedr::benchmark {

namespace {

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
runTable(const std::vector<RunRow>& rows, const std::vector<TableColumn>& columns)
{
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

/** @brief Returns the seeds of all rows: "1, 2, 3". */
std::string
seedsOf(const std::vector<RunRow>& rows)
{
  std::set<std::uint64_t> seeds;
  for (const RunRow& row : rows)
    seeds.insert(row.seed);
  std::string text;
  for (const std::uint64_t seed : seeds)
    text += (text.empty() ? "" : ", ") + std::to_string(seed);
  return text;
}

std::string
summaryOf(const std::vector<RunRow>& rows, BarKind kind)
{
  const auto good = std::count_if(rows.begin(), rows.end(), [kind](const RunRow& row) {
    return !missesAny(row, kind);
  });
  const std::string missed = missesOf(rows, kind);
  return "Scenes: " + std::to_string(groupByScene(rows).size()) +
         ". Seeds: " + seedsOf(rows) + ". Runs: " + std::to_string(rows.size()) +
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

/** @brief Returns the stages of all rows in the order of first occurrence. */
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
    const auto median = [&group](const std::function<double(const RunRow&)>& figure,
                                 double scale) {
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
    text += summaryOf(kind, BarKind::Model) + legend +
            runTable(kind, columnsOf(with_mesh)) + failuresOf(kind) + stageTable(kind);
  }
  if (!latest.empty())
    text += "\n## Plans and solids\n\n" + summaryOf(latest, BarKind::Solid) + "\n" +
            runTable(latest, solidColumns());
  return text;
}

} // namespace pcl::sedr::benchmark
