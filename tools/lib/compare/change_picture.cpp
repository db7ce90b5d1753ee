// SPDX-License-Identifier: BSD-3-Clause
#include "change_picture.h"

#include "sedr_filters/src/plan/plan_segment.h"

#include <map>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the loops of a plan's elements by the names used in changes. */
std::map<std::string, PlanLoop>
loopsOf(const Floorplan& plan)
{
  std::map<std::string, PlanLoop> loops;
  for (const auto& room : plan.rooms) {
    const std::string name = "room_" + std::to_string(room.id);
    const auto add = [&](const char* kind, std::size_t k, const PlanLoop& loop) {
      loops[name + kind + std::to_string(k + 1)] = loop;
    };
    for (const auto& whole : {"", "_ceiling", "_floor"})
      loops[name + whole] = room.boundary;
    for (std::size_t k = 0; k < room.boundary.elements.size(); ++k)
      add("_wall_", k, {{room.boundary.elements[k]}});
    for (std::size_t k = 0; k < room.columns.size(); ++k)
      add("_column_", k, room.columns[k]);
    for (std::size_t k = 0; k < room.details.size(); ++k)
      add("_detail_", k, room.details[k].boundary);
    for (std::size_t k = 0; k < room.floor_details.size(); ++k)
      add("_floor_detail_", k, room.floor_details[k].boundary);
  }
  for (std::size_t k = 0; k < plan.openings.size(); ++k)
    loops["opening_" + std::to_string(k + 1)] = {
        {segment(plan.openings[k].start, plan.openings[k].end)}};
  return loops;
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

/** @brief Adds elements in a colour, with the change's name at the last one. */
void
addElements(const std::vector<std::string>& names,
            const std::map<std::string, PlanLoop>& loops,
            Colour colour,
            const std::string& label,
            Panel& panel)
{
  const Eigen::Vector2d above(0, 0.35); // metres, from the named element
  for (const auto& name : names) {
    const auto found = loops.find(name);
    if (found == loops.end() || found->second.elements.empty())
      continue;
    panel.addLoop(found->second, colour, colour, 3.5);
    Eigen::AlignedBox2d box;
    for (const PlanElement& element : found->second.elements)
      box.extend(element.start).extend(element.end);
    if (&name == &names.back())
      panel.addLabel(box.center() + above, label);
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
  const auto first = loopsOf(before);
  const auto second = loopsOf(after);
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
