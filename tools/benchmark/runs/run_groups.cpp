// SPDX-License-Identifier: BSD-3-Clause
#include "run_groups.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pcl::sedr::benchmark {

namespace {

bool
isOfKind(Bar bar, BarKind kind)
{
  return bar == Bar::Done || isOfSolid(bar) == (kind == BarKind::Solid);
}

} // namespace

std::vector<RunRow>
latestRows(const std::vector<RunRow>& rows)
{
  std::vector<RunRow> latest;
  for (const RunRow& row : rows) {
    const auto same =
        std::find_if(latest.begin(), latest.end(),
                     [&row](const RunRow& other) { return other.isSameRun(row); });
    if (same == latest.end())
      latest.push_back(row);
    else
      *same = row;
  }
  return latest;
}

std::vector<RunGroup>
groupByScene(const std::vector<RunRow>& rows)
{
  std::vector<RunGroup> groups;
  for (const RunRow& row : rows) {
    const auto of_scene =
        std::find_if(groups.begin(), groups.end(), [&row](const RunGroup& group) {
          return group.front().scene == row.scene;
        });
    if (of_scene == groups.end())
      groups.push_back({row});
    else
      of_scene->push_back(row);
  }
  return groups;
}

std::vector<RunGroup>
groupRuns(const std::vector<RunRow>& rows)
{
  std::vector<RunGroup> groups;
  for (const RunGroup& of_scene : groupByScene(rows)) {
    std::map<double, RunGroup> by_noise;
    for (const RunRow& row : of_scene)
      by_noise[row.noise].push_back(row);
    for (const auto& group : by_noise)
      groups.push_back(group.second);
  }
  return groups;
}

std::vector<double>
figuresOf(const RunGroup& group, const std::function<double(const RunRow&)>& figure)
{
  std::vector<double> figures;
  for (const RunRow& row : group)
    if (!std::isnan(figure(row)))
      figures.push_back(figure(row));
  std::sort(figures.begin(), figures.end());
  return figures;
}

double
medianOf(const std::vector<double>& sorted)
{
  return sorted.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : sorted[(sorted.size() - 1) / 2];
}

std::size_t
missesOf(const RunGroup& group, Bar bar)
{
  const auto misses_bar = [bar](const RunRow& row) {
    const auto misses = missedBars(row);
    return std::any_of(misses.begin(), misses.end(),
                       [bar](const Miss& miss) { return miss.bar == bar; });
  };
  return static_cast<std::size_t>(
      std::count_if(group.begin(), group.end(), misses_bar));
}

std::string
missesOf(const RunGroup& group, BarKind kind)
{
  std::string text;
  for (const Bar bar : all_bars)
    if (const std::size_t count = isOfKind(bar, kind) ? missesOf(group, bar) : 0)
      text += (text.empty() ? "" : ", ") + nameOf(bar) + " " + std::to_string(count) +
              "/" + std::to_string(group.size());
  return text;
}

bool
missesAny(const RunRow& row, BarKind kind)
{
  const auto misses = missedBars(row);
  return std::any_of(misses.begin(), misses.end(),
                     [kind](const Miss& miss) { return isOfKind(miss.bar, kind); });
}

} // namespace pcl::sedr::benchmark
