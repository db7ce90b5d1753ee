// SPDX-License-Identifier: BSD-3-Clause
#include "slice_picture.h"

#include "map_cells.h"
#include "scale.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl::sedr::tools {
namespace {

constexpr Colour accepted_colour = colours::detail;
constexpr Colour rejected_colour = colours::removed;
constexpr Colour ceiling_colour = lightened(colours::ceiling, 0.35);

/** @brief Formats a fraction: "1/4", "3/8"; as decimal number if it is no such
 * fraction. */
std::string
fractionText(double fraction)
{
  for (const int parts : {2, 4, 8, 16}) {
    const double count = fraction * parts;
    if (std::abs(count - std::round(count)) < 1e-9)
      return fixedText(count, 0) + "/" + std::to_string(parts);
  }
  return fixedText(fraction, 3);
}

void
addRegions(const std::vector<CellSet>& regions,
           double cell_size,
           Colour colour,
           Panel& panel)
{
  constexpr std::size_t min_named = 10;
  for (const CellSet& region : regions) {
    panel.addCells(region, cell_size, colour);
    if (region.size() >= min_named)
      panel.addLabel(labelPlace(region, cell_size), std::to_string(region.size()));
  }
}

/** @brief Draws all rooms in one trial; rooms with details from earlier trials are
 * faint. */
Panel
trialPanel(const std::vector<RoomSlices>& rooms, int number, double cell_size)
{
  std::string slices;
  std::size_t accepted = 0;
  Panel panel("");
  for (const RoomSlices& room : rooms) {
    const auto& trials = room.analysis.trials;
    const auto trial =
        std::find_if(trials.begin(), trials.end(),
                     [&](const SliceTrial& t) { return t.number == number; });
    panel.addCells(room.analysis.ceiling, cell_size,
                   trial == trials.end() ? colours::faint : ceiling_colour);
    if (trial == trials.end())
      continue;
    slices.clear();
    for (const double fraction : trial->fractions)
      slices += (slices.empty() ? "" : " and ") + fractionText(fraction);
    accepted += trial->accepted.size();
    panel.addCells(trial->slice, cell_size, colours::wall);
    addRegions(trial->accepted, cell_size, accepted_colour, panel);
    addRegions(trial->rejected, cell_size, rejected_colour, panel);
  }
  panel.title = "trial " + std::to_string(number) + ", slice at " + slices + ": " +
                (accepted > 0 ? counted(accepted, "region") : "nothing");
  return panel;
}

Panel
detailPanel(const std::vector<RoomSlices>& rooms, double cell_size)
{
  std::size_t count = 0;
  Panel panel("");
  for (const RoomSlices& room : rooms) {
    panel.addCells(room.analysis.ceiling, cell_size, ceiling_colour);
    panel.addCells(room.analysis.refused, cell_size, rejected_colour);
    panel.addCells(room.analysis.cells, cell_size, colours::detail);
    count += room.analysis.sizes.size();
  }
  panel.title = "found: " + (count > 0 ? counted(count, "detail") : "no detail");
  return panel;
}

/** @brief The section line of a room: through its details, along the axis that meets
 * more of the ceiling. */
struct SectionLine {
  int axis = 0;  ///< 0: along x at one y; 1: along y at one x
  double at = 0; ///< that y or x, metres

  SectionLine(const SliceDetails& analysis, double cell_size)
  {
    const CellSet& through = analysis.cells.empty() ? analysis.ceiling : analysis.cells;
    const Eigen::Vector2d place = labelPlace(through, cell_size);
    const Cell middle = CellGrid(cell_size).at(place.x(), place.y());
    std::ptrdiff_t more_along_x = 0;
    for (std::size_t i = 0; i < analysis.ceiling.size(); ++i)
      more_along_x += (analysis.ceiling[i].y == middle.y ? 1 : 0) -
                      (analysis.ceiling[i].x == middle.x ? 1 : 0);
    axis = more_along_x >= 0 ? 0 : 1;
    at = place[1 - axis];
  }

  /** @brief Returns the points near the line, seen from the side. */
  Places section(const PointView& points, const pcl::Indices& indices) const
  {
    constexpr double half_thickness = 0.1;
    Places places;
    for (const auto index : indices) {
      const Eigen::Vector3d p = points[static_cast<std::size_t>(index)].cast<double>();
      if (p.allFinite() && std::abs(p[1 - axis] - at) <= half_thickness)
        places.emplace_back(p[axis], p.z());
    }
    return places;
  }
};

/** @brief Returns the view of a room's section, without the highest and lowest stray
 * points. */
Box
sectionView(const RoomSlices& room, const Places& section, double cell_size, int axis)
{
  CellSet cells = room.analysis.ceiling;
  addTo(cells, room.analysis.cells);
  const Box plan = viewOf(cells, cell_size);
  std::vector<double> heights;
  for (const Eigen::Vector2d& p : section)
    if (p.x() > plan.min()[axis] && p.x() < plan.max()[axis])
      heights.push_back(p.y());
  std::sort(heights.begin(), heights.end());
  const double low = heights.empty() ? 0.2 : heights[heights.size() / 200];
  const double high =
      heights.empty() ? 0.8 : heights[heights.size() - 1 - heights.size() / 2000];
  return {Eigen::Vector2d(plan.min()[axis] - 0.3, low - 0.2),
          Eigen::Vector2d(plan.max()[axis] + 0.3, high + 0.2)};
}

Panel
sectionPanel(const RoomSlices& room, const PointView& points, double cell_size)
{
  const char* axes[] = {"x", "y"};
  const SectionLine line(room.analysis, cell_size);
  Panel panel("vertical section" +
              (room.room > 0 ? " of room " + std::to_string(room.room) : "") + " at " +
              axes[1 - line.axis] + " = " + fixedText(line.at, 2) +
              " m, and the slices");
  panel.setAxis(std::string(axes[line.axis]) + ", m");
  const Places section = line.section(points, room.points);
  const Box view = sectionView(room, section, cell_size, line.axis);
  panel.setView(view);
  panel.addPoints(section, colours::other, 2.5);
  panel.addPoints(line.section(points, room.ceiling), colours::ceiling, 3);
  panel.addPoints(line.section(points, {room.analysis.indices.begin(),
                                        room.analysis.indices.end()}),
                  colours::detail, 3);
  for (const SliceTrial& trial : room.analysis.trials)
    for (std::size_t k = 0; k < trial.heights.size(); ++k) {
      const double z = trial.heights[k];
      panel.addPath({{view.min().x(), z}, {view.max().x(), z}}, colours::wall, 2);
      panel.addLabel({view.max().x(), z + 0.04 * view.sizes().y()},
                     "trial " + std::to_string(trial.number) + ": " +
                         fractionText(trial.fractions[k]),
                     darkened(colours::wall, 0.3), TextAnchor::End);
    }
  return panel;
}

} // namespace

Picture
drawSlices(const std::vector<RoomSlices>& rooms,
           const PointView& points,
           double cell_size)
{
  CellSet all;
  int trials = 0;
  std::size_t details = 0;
  const RoomSlices* cut = nullptr; // with the largest details, else the largest room
  for (const RoomSlices& room : rooms) {
    addTo(all, room.analysis.ceiling);
    addTo(all, room.analysis.cells);
    details += room.analysis.sizes.size();
    for (const SliceTrial& trial : room.analysis.trials)
      trials = std::max(trials, trial.number);
    const auto sizes = [](const RoomSlices& r) {
      return std::pair(r.analysis.cells.size(), r.analysis.ceiling.size());
    };
    if (!room.analysis.ceiling.empty() && (!cut || sizes(room) > sizes(*cut)))
      cut = &room;
  }
  std::vector<Panel> maps;
  for (int number = 1; number <= trials; ++number)
    maps.push_back(trialPanel(rooms, number, cell_size));
  maps.push_back(detailPanel(rooms, cell_size));
  for (Panel& map : maps)
    map.setView(grown(viewOf(all, cell_size), 0.3));

  Picture picture("Grid-slices analysis of " + counted(rooms.size(), "room") + ": " +
                  (details > 0 ? counted(details, "detail") : "no details"));
  picture.addMaps(maps);
  if (cut)
    picture.addRow({sectionPanel(*cut, points, cell_size)});
  picture.addLegend("ceiling", ceiling_colour);
  picture.addLegend("slice", colours::wall);
  picture.addLegend("zero-valued region taken, its cells; detail", accepted_colour);
  picture.addLegend("rejected or refused: too small, nothing above, a lamp, a head of "
                    "an opening",
                    rejected_colour);
  return picture;
}

} // namespace pcl::sedr::tools
