// SPDX-License-Identifier: BSD-3-Clause
#include "refinement_picture.h"

#include "map_cells.h"
#include "plan_layers.h"
#include "scale.h"

#include <algorithm>
#include <map>

namespace pcl::sedr::tools {

namespace {

double
wayOf(const MovedPoint& point)
{
  return (point.after - point.before).norm();
}

/** @brief Returns a box of a given size, metres, with the largest total movement of
 * points. */
Box
busiestPlace(const RefinedWalls& walls, const Eigen::Vector2d& size)
{
  const CellGrid grid(size.y() / 2);
  std::map<CellKey, double> ways;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  for (const auto& point : walls.moved)
    ways[keyOf(grid.at(point.after.x(), point.after.y()))] += wayOf(point);
  double most = -1;
  for (const auto& [key, way] : ways)
    if (way > most) {
      most = way;
      place = grid.centre(cellOf(key));
    }
  return {Eigen::Vector2d(place - size / 2), Eigen::Vector2d(place + size / 2)};
}

Panel
wallPanel(const std::string& title,
          const RefinedWalls& walls,
          const Floorplan& plan,
          bool is_after,
          double pixels)
{
  Panel panel(title);
  if (is_after) // the plan shows where no point went
    addPlan(plan, 1, panel);
  else
    panel.addPoints(walls.removed, colours::removed, pixels);
  for (const auto label :
       {StructureLabel::Wall, StructureLabel::Column, StructureLabel::Detail}) {
    std::vector<Eigen::Vector2d> places;
    for (const auto& point : walls.moved)
      if (point.label == label)
        places.push_back(is_after ? point.after : point.before);
    panel.addPoints(std::move(places), colourOf(label), pixels);
  }
  if (!is_after)
    addPlan(plan, 1, panel);
  return panel;
}

/** @brief Draws a histogram of movements. */
Panel
wayPanel(const RefinedWalls& walls)
{
  constexpr double bin = 0.5; // centimetres
  std::vector<double> share;
  double mean = 0;
  const auto count = static_cast<double>(std::max<std::size_t>(1, walls.moved.size()));
  for (const auto& point : walls.moved) {
    const auto b = static_cast<std::size_t>(100 * wayOf(point) / bin);
    share.resize(std::max(share.size(), b + 1), 0);
    share[b] += 100 / count;
    mean += wayOf(point) / count;
  }
  Panel panel("they moved " + fixedText(100 * mean, 1) + " cm on average");
  panel.setAxis("way, cm");
  std::vector<Box> bars;
  for (std::size_t b = 0; b < share.size(); ++b)
    bars.emplace_back(Eigen::Vector2d(bin * static_cast<double>(b), 0),
                      Eigen::Vector2d(bin * (static_cast<double>(b) + 0.9), share[b]));
  panel.addBoxes(std::move(bars), colours::wall);
  const double highest =
      share.empty() ? 1 : *std::max_element(share.begin(), share.end());
  panel.setView(
      {Eigen::Vector2d(0, 0),
       Eigen::Vector2d(bin * static_cast<double>(share.size() + 1), 1.05 * highest)});
  return panel;
}

} // namespace

RefinedWalls&
RefinedWalls::operator+=(const RefinedWalls& other)
{
  moved.insert(moved.end(), other.moved.begin(), other.moved.end());
  removed.insert(removed.end(), other.removed.begin(), other.removed.end());
  return *this;
}

Picture
drawRefinement(const RefinedWalls& walls, const Floorplan& plan)
{
  constexpr double margin = 0.3;
  const Eigen::Vector2d close_up(1.2, 0.9);
  const auto pair = [&](const std::string& where, const Box& view, double pixels) {
    std::vector<Panel> panels{wallPanel("found" + where, walls, plan, false, pixels),
                              wallPanel("refined" + where, walls, plan, true, pixels)};
    for (auto& panel : panels)
      panel.setView(view);
    return panels;
  };
  Picture picture("Refinement of " + counted(walls.moved.size(), "wall point") + ", " +
                  std::to_string(walls.removed.size()) + " left out");
  picture.addMaps(pair("", viewOf(plan, margin), 2.5));
  std::vector<Panel> below = pair(", close up", busiestPlace(walls, close_up), 4);
  below.push_back(wayPanel(walls));
  picture.addRow(std::move(below));
  picture.addLegend("wall point, from above", colours::wall);
  picture.addLegend("of a column", colours::column);
  picture.addLegend("of a riser of a detail", colours::detail);
  picture.addLegend("too far from its wall: left out", colours::removed);
  picture.addLegend("plan", colours::ink);
  return picture;
}

} // namespace pcl::sedr::tools
