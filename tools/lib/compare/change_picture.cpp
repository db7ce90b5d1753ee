// SPDX-License-Identifier: BSD-3-Clause
#include "change_picture.h"

#include <map>

namespace pcl::sedr::tools {

namespace {

constexpr Colour
colourOf(ChangeKind kind)
{
  return kind == ChangeKind::Appeared   ? Colour{40, 160, 70}
         : kind == ChangeKind::Vanished ? Colour{210, 40, 40}
                                        : Colour{240, 150, 30};
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

/** @brief Adds the outlines of a change, with its name at the last one. */
void
addChange(const Change& change, Colour colour, Panel& panel)
{
  const Eigen::Vector2d above(0, 0.35); // metres, from the named outline
  Box last;
  for (const PlanLoop& outline : change.outlines) {
    panel.addLoop(outline, colour, colour, 3.5);
    last = Box();
    for (const PlanElement& element : outline.elements)
      last.extend(element.start).extend(element.end);
  }
  if (!last.isEmpty())
    panel.addLabel(last.center() + above, change.what + " " + toString(change.kind));
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
  std::map<ChangeKind, std::size_t> counts;
  for (const auto& change : changes) {
    ++counts[change.kind];
    addChange(change, colourOf(change.kind), panel);
  }
  const std::string count = std::to_string(changes.size());
  Picture picture(count + (changes.size() == 1 ? " change" : " changes"));
  picture.addMaps({panel});
  for (const auto kind :
       {ChangeKind::Appeared, ChangeKind::Vanished, ChangeKind::Moved})
    picture.addLegend(std::string(toString(kind)) + ": " + std::to_string(counts[kind]),
                      colourOf(kind));
  return picture;
}

} // namespace pcl::sedr::tools
