// SPDX-License-Identifier: BSD-3-Clause
#include "change_picture.h"

#include "change_mesh.h"

#include <map>

namespace pcl::sedr::tools {

namespace {

constexpr double chord = 0.005; // metres, between an arc and its chords

using Path = std::vector<Eigen::Vector2d>;

Path
closedPath(const PlanLoop& loop)
{
  Path path = loop.polygon(chord);
  if (!path.empty())
    path.push_back(path.front());
  return path;
}

/** @brief Returns the paths of a plan's elements by the names used in changes. */
std::map<std::string, Path>
pathsOf(const Floorplan& plan)
{
  std::map<std::string, Path> paths;
  for (const auto& room : plan.rooms) {
    const std::string name = "room_" + std::to_string(room.id);
    for (const auto& whole : {"", "_ceiling", "_floor"})
      paths[name + whole] = closedPath(room.boundary);
    for (std::size_t k = 0; k < room.boundary.elements.size(); ++k) {
      const PlanElement& wall = room.boundary.elements[k];
      Path path = PlanLoop{{wall}}.polygon(chord);
      path.push_back(wall.end);
      paths[name + "_wall_" + std::to_string(k + 1)] = path;
    }
    for (std::size_t k = 0; k < room.columns.size(); ++k)
      paths[name + "_column_" + std::to_string(k + 1)] = closedPath(room.columns[k]);
    for (std::size_t k = 0; k < room.details.size(); ++k)
      paths[name + "_detail_" + std::to_string(k + 1)] =
          closedPath(room.details[k].boundary);
    for (std::size_t k = 0; k < room.floor_details.size(); ++k)
      paths[name + "_floor_detail_" + std::to_string(k + 1)] =
          closedPath(room.floor_details[k].boundary);
  }
  return paths;
}

void
addOutlines(const Floorplan& plan, Colour colour, double pixels, Panel& panel)
{
  for (const auto& room : plan.rooms) {
    panel.addLoop(room.boundary, colour, colour, pixels);
    for (const auto& column : room.columns)
      panel.addLoop(column, colour, colour, pixels);
    for (const auto* details : {&room.details, &room.floor_details})
      for (const auto& detail : *details)
        panel.addLoop(detail.boundary, colour, colour, pixels / 2);
  }
}

Eigen::Vector2d
middleOf(const Path& path)
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& p : path)
    sum += p;
  return sum / static_cast<double>(path.size());
}

/** @brief Adds elements in a colour, with the change's name at the last one. */
void
addElements(const std::vector<std::string>& names,
            const std::map<std::string, Path>& paths,
            Colour colour,
            const std::string& label,
            Panel& panel)
{
  constexpr double pixels = 3.5;
  const Eigen::Vector2d above(0, 0.35); // metres, from the named element
  for (const auto& name : names) {
    const auto found = paths.find(name);
    if (found == paths.end() || found->second.empty())
      continue;
    panel.addPath(found->second, colour, pixels);
    if (&name == &names.back())
      panel.addLabel(middleOf(found->second) + above, label);
  }
}

} // namespace

Picture
drawChanges(const Floorplan& before,
            const Floorplan& after,
            const std::vector<Change>& changes)
{
  Panel panel("plan, the first one faint");
  addOutlines(before, colours::faint, 1.5, panel);
  addOutlines(after, colours::ink, 1.5, panel);
  const auto first = pathsOf(before);
  const auto second = pathsOf(after);
  std::map<ChangeKind, std::size_t> counts;
  for (const auto& change : changes) {
    ++counts[change.kind];
    const std::string label = change.what + " " + toString(change.kind);
    if (change.kind == ChangeKind::Vanished)
      addElements(change.before, first, change_colours::vanished, label, panel);
    else
      addElements(change.after, second,
                  change.kind == ChangeKind::Moved ? change_colours::moved
                                                   : change_colours::appeared,
                  label, panel);
  }
  const std::string count = std::to_string(changes.size());
  Picture picture(count + (changes.size() == 1 ? " change" : " changes"));
  picture.addMaps({panel});
  for (const auto& [kind, colour] :
       {std::pair{ChangeKind::Appeared, change_colours::appeared},
        {ChangeKind::Vanished, change_colours::vanished},
        {ChangeKind::Moved, change_colours::moved}})
    picture.addLegend(std::string(toString(kind)) + ": " + std::to_string(counts[kind]),
                      colour);
  return picture;
}

} // namespace pcl::sedr::tools
