// SPDX-License-Identifier: BSD-3-Clause
#include "slice_picture.h"

#include "map_cells.h"
#include "scale.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr::tools {

namespace {

constexpr Colour accepted_colour = colours::detail;
constexpr Colour rejected_colour = colours::removed;

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

std::string
sliceNames(const SliceTrial& trial)
{
  std::string names;
  for (const double fraction : trial.fractions)
    names += (names.empty() ? "" : " and ") + fractionText(fraction);
  return names;
}

/** @brief Returns a trial by number, null if the room needed none. */
const SliceTrial*
findTrial(const RoomSlices& room, int number)
{
  for (const auto& trial : room.analysis.trials)
    if (trial.number == number)
      return &trial;
  return nullptr;
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
  for (const auto& room : rooms) {
    const SliceTrial* trial = findTrial(room, number);
    panel.addCells(room.analysis.ceiling, cell_size,
                   trial ? lightened(colours::ceiling, 0.35) : colours::faint);
    if (!trial)
      continue;
    slices = sliceNames(*trial);
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
  for (const auto& room : rooms) {
    const SliceDetails& analysis = room.analysis;
    panel.addCells(analysis.ceiling, cell_size, lightened(colours::ceiling, 0.35));
    panel.addCells(analysis.refused, cell_size, rejected_colour);
    panel.addCells(analysis.cells, cell_size, colours::detail);
    count += analysis.sizes.size();
  }
  panel.title = "found: " + (count > 0 ? counted(count, "detail") : "no detail");
  return panel;
}

/** @brief The section line of a room: through its details, along the axis that meets
 * more of the ceiling. */
struct SectionLine {
  int axis = 0;  ///< 0: along x at one y; 1: along y at one x
  double at = 0; ///< that y or x, metres
  bool isNear(const Eigen::Vector2d& p, double distance) const
  {
    return std::abs(p[1 - axis] - at) <= distance;
  }
};

SectionLine
sectionOf(const SliceDetails& analysis, double cell_size)
{
  const CellSet& through = analysis.cells.empty() ? analysis.ceiling : analysis.cells;
  const Eigen::Vector2d place = labelPlace(through, cell_size);
  const Cell middle = CellGrid(cell_size).at(place.x(), place.y());
  std::size_t along[2] = {0, 0};
  for (std::size_t i = 0; i < analysis.ceiling.size(); ++i) {
    along[0] += analysis.ceiling[i].y == middle.y ? 1 : 0;
    along[1] += analysis.ceiling[i].x == middle.x ? 1 : 0;
  }
  const int axis = along[0] >= along[1] ? 0 : 1;
  return {axis, place[1 - axis]};
}

/** @brief Returns the points of the room near the line, seen from the side. */
std::vector<Eigen::Vector2d>
inSection(const PointView& points, const pcl::Indices& indices, const SectionLine& line)
{
  constexpr double half_thickness = 0.1;
  std::vector<Eigen::Vector2d> places;
  for (const auto index : indices) {
    const Eigen::Vector3d p = points[static_cast<std::size_t>(index)].cast<double>();
    if (p.allFinite() && line.isNear(p.head<2>(), half_thickness))
      places.emplace_back(p[line.axis], p.z());
  }
  return places;
}

/** @brief Returns the view of the room from its ceiling down, with a small margin. */
Box
sectionView(const RoomSlices& room, const PointView& points, double cell_size, int axis)
{
  CellSet cells = room.analysis.ceiling;
  addTo(cells, room.analysis.cells);
  const Box plan = viewOf(cells, cell_size);
  std::vector<double> heights;
  for (const auto index : room.points)
    if (points.isFinite(static_cast<std::size_t>(index)) &&
        plan.contains(points[static_cast<std::size_t>(index)].head<2>().cast<double>()))
      heights.push_back(points[static_cast<std::size_t>(index)].z());
  Box view{{plan.low[axis] - 0.3, 0}, {plan.high[axis] + 0.3, 1}};
  if (heights.empty())
    return view;
  std::sort(heights.begin(), heights.end());
  view.low.y() = heights[heights.size() / 200] - 0.2;
  view.high.y() = heights[heights.size() - 1 - heights.size() / 2000] + 0.2;
  return view;
}

Panel
sectionPanel(const RoomSlices& room, const PointView& points, double cell_size)
{
  const SectionLine line = sectionOf(room.analysis, cell_size);
  const char* axes[] = {"x", "y"};
  Panel panel("vertical section" +
              (room.room > 0 ? " of room " + std::to_string(room.room) : "") + " at " +
              axes[1 - line.axis] + " = " + fixedText(line.at, 2) +
              " m, and the slices");
  panel.setAxis(std::string(axes[line.axis]) + ", m");
  const Box view = sectionView(room, points, cell_size, line.axis);
  panel.setView(view);
  panel.addPoints(inSection(points, room.points, line), colours::other, 2.5);
  panel.addPoints(inSection(points, room.ceiling, line), colours::ceiling, 3);
  panel.addPoints(
      inSection(points, {room.analysis.indices.begin(), room.analysis.indices.end()},
                line),
      colours::detail, 3);
  for (const auto& trial : room.analysis.trials)
    for (std::size_t k = 0; k < trial.heights.size(); ++k) {
      const double z = trial.heights[k];
      panel.addPath({{view.low.x(), z}, {view.high.x(), z}}, colours::wall, 2);
      panel.addLabel({view.high.x(), z + 0.04 * view.size().y()},
                     "trial " + std::to_string(trial.number) + ": " +
                         fractionText(trial.fractions[k]),
                     darkened(colours::wall, 0.3), Anchor::Right);
    }
  return panel;
}

/** @brief Returns the room with the largest details or, without details, the largest
 * room. */
const RoomSlices*
roomToCut(const std::vector<RoomSlices>& rooms)
{
  const RoomSlices* best = nullptr;
  for (const auto& room : rooms) {
    if (room.analysis.ceiling.empty())
      continue;
    const auto score = [](const RoomSlices& r) {
      return std::pair(r.analysis.cells.size(), r.analysis.ceiling.size());
    };
    if (!best || score(room) > score(*best))
      best = &room;
  }
  return best;
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
  for (const auto& room : rooms) {
    addTo(all, room.analysis.ceiling);
    addTo(all, room.analysis.cells);
    details += room.analysis.sizes.size();
    for (const auto& trial : room.analysis.trials)
      trials = std::max(trials, trial.number);
  }
  std::vector<Panel> maps;
  for (int number = 1; number <= trials; ++number)
    maps.push_back(trialPanel(rooms, number, cell_size));
  maps.push_back(detailPanel(rooms, cell_size));
  for (auto& map : maps)
    map.setView(viewOf(all, cell_size).grown(0.3));

  Picture picture("Grid-slices analysis of " + counted(rooms.size(), "room") + ": " +
                  (details > 0 ? counted(details, "detail") : "no details"));
  picture.addMaps(maps);
  if (const RoomSlices* room = roomToCut(rooms))
    picture.addRow({sectionPanel(*room, points, cell_size)});
  picture.addLegend("ceiling", lightened(colours::ceiling, 0.35));
  picture.addLegend("slice", colours::wall);
  picture.addLegend("zero-valued region taken, its cells; detail", accepted_colour);
  picture.addLegend("rejected or refused: too small, nothing above, a lamp, a head of "
                    "an opening",
                    rejected_colour);
  return picture;
}

} // namespace pcl::sedr::tools
