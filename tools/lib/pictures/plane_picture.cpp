// SPDX-License-Identifier: BSD-3-Clause
#include "plane_picture.h"

#include "map_cells.h"
#include "scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::sedr::tools {

namespace {

using Planes = std::vector<pcl::HorizontalPlane>;

Colour
colourOfLevel(LevelKind kind)
{
  return kind == LevelKind::Ceiling ? colours::ceiling
         : kind == LevelKind::Floor ? colours::floor
                                    : colours::other;
}

std::string
nameOf(const pcl::HorizontalPlane& plane)
{
  const char* kind = plane.kind == LevelKind::Ceiling ? "ceiling"
                     : plane.kind == LevelKind::Floor ? "floor"
                                                      : "neither";
  return fixedText(plane.height, 2) + " m: " + kind + ", " + fixedText(plane.area, 1) +
         " m²";
}

/** @brief Returns the planes, largest first. */
std::vector<const pcl::HorizontalPlane*>
bySize(const Planes& planes)
{
  std::vector<const pcl::HorizontalPlane*> sorted;
  for (const auto& plane : planes)
    sorted.push_back(&plane);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto* a, const auto* b) { return a->area > b->area; });
  return sorted;
}

/** @brief Returns the range of heights to show: around the ceilings and floors, or
 * around all planes if there are none. */
std::pair<double, double>
heightsOf(const Planes& planes)
{
  constexpr double margin = 0.5;
  const bool has_rooms =
      std::any_of(planes.begin(), planes.end(),
                  [](const auto& plane) { return plane.kind != LevelKind::Other; });
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const auto& plane : planes)
    if (!has_rooms || plane.kind != LevelKind::Other) {
      low = std::min(low, plane.height - margin);
      high = std::max(high, plane.height + margin);
    }
  return planes.empty() ? std::pair(0.0, 1.0) : std::pair(low, high);
}

/** @brief Draws a histogram of cells by height, coloured where a plane was found.
 * Heights far above and below all planes are cut off. */
Panel
histogramPanel(const Planes& planes, const HeightHistogram& histogram)
{
  Panel panel("what is seen at each height");
  panel.setAxis("cells of the plan, walls left out");
  std::size_t most = 1;
  for (const auto& bin : histogram.bins)
    most = std::max(most, bin.cells);
  const auto colourAt = [&](double height) {
    Colour colour = lightened(colours::other, 0.4);
    double least = 2 * histogram.bin_height;
    for (const auto& plane : planes)
      if (std::abs(plane.height - height) < least) {
        least = std::abs(plane.height - height);
        colour = colourOfLevel(plane.kind);
      }
    return colour;
  };
  for (const auto& bin : histogram.bins)
    panel.addBoxes({Box(Eigen::Vector2d(0, bin.low),
                        Eigen::Vector2d(static_cast<double>(bin.cells),
                                        bin.low + histogram.bin_height))},
                   colourAt(bin.low + histogram.bin_height / 2));
  const auto [low, high] = heightsOf(planes);
  for (const auto* plane : bySize(planes)) // above the bar
    panel.addLabel({static_cast<double>(most), plane->height + 0.03 * (high - low)},
                   nameOf(*plane), darkened(colourOfLevel(plane->kind), 0.3),
                   TextAnchor::End);
  panel.setView({Eigen::Vector2d(0, low),
                 Eigen::Vector2d(1.05 * static_cast<double>(most), high)});
  return panel;
}

} // namespace

Picture
drawPlanes(const Planes& planes,
           const HeightHistogram& histogram,
           const PointView& points,
           double cell_size)
{
  constexpr std::size_t min_piece = 100; // smaller pieces are scattered outside
  const CellGrid grid(cell_size);
  Panel above("ceilings");
  Panel below("floors, and what is neither");
  CellSet all;
  std::size_t count[2] = {0, 0};
  for (const auto* plane : bySize(planes)) {
    const CellSet cells(grid, points, plane->inliers.indices);
    if (cells.empty())
      continue;
    const bool is_ceiling = plane->kind == LevelKind::Ceiling;
    Colour colour = colourOfLevel(plane->kind);
    if (is_ceiling)
      colour = ceilingShade(count[0]++);
    else if (plane->kind == LevelKind::Floor)
      colour = lightened(colour, 0.35 * static_cast<double>(count[1]++ % 3));
    Panel& panel = is_ceiling ? above : below;
    panel.addCells(cells, cell_size, colour);
    panel.addLabel(labelPlace(cells, cell_size), fixedText(plane->height, 2) + " m");
    addTo(all, cells);
  }
  Picture picture("Horizontal planes: " + counted(count[0], "ceiling") + ", " +
                  counted(count[1], "floor") + ", " +
                  std::to_string(planes.size() - count[0] - count[1]) + " neither");
  for (Panel* panel : {&above, &below})
    panel->setView(viewOf(all, cell_size, min_piece));
  if (histogram.bins.empty()) // planes of rooms, which were not found by height
    picture.addMaps({above, below});
  else
    picture.addRow({histogramPanel(planes, histogram), above, below});
  picture.addLegend("ceiling", colours::ceiling);
  picture.addLegend("floor", colours::floor);
  picture.addLegend("neither", colours::other);
  return picture;
}

} // namespace pcl::sedr::tools
