// SPDX-License-Identifier: BSD-3-Clause
#include "thinning_picture.h"

#include "map_cells.h"

#include "sedr_filters/src/grids/cell_mask.h"

#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace pcl::sedr::tools {

namespace {

/** @brief The shade of cells with a minimum number of points. */
struct Shade {
  std::uint32_t least;
  Colour colour;
  const char* meaning;
};

constexpr std::array<Shade, 7> shades{{{1, {198, 219, 239}, "1 point a cell"},
                                       {2, {158, 202, 225}, "2"},
                                       {4, {107, 174, 214}, "4"},
                                       {10, {49, 130, 189}, "10"},
                                       {50, {8, 81, 156}, "50"},
                                       {250, {8, 48, 107}, "250"},
                                       {1000, {3, 19, 43}, "1000 or more"}}};

/** @brief Returns the cells visible in a view. */
CellBox
boxOf(const Box& view, double cell_size)
{
  const auto cell = [&](double x) {
    return static_cast<std::int32_t>(std::floor(x / cell_size));
  };
  return {{cell(view.min().x()), cell(view.min().y())},
          {cell(view.max().x()), cell(view.max().y())}};
}

/** @brief Points, at once or piece by piece. */
struct PointPieces {
  std::size_t size;
  std::function<void(const std::function<void(const PointView&)>&)> forEach;
};

PointPieces
piecesOf(const PointView& points)
{
  return {points.size(), [&points](const auto& see) { see(points); }};
}

Panel
densityPanel(const std::string& title,
             const PointPieces& pieces,
             const CellGrid& grid,
             const CellBox& box)
{
  CellMask shade(box);
  std::vector<std::uint32_t> count(shade.values().size(), 0);
  pieces.forEach([&](const PointView& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3f p = points[i];
      if (!points.isFinite(i) || !grid.holds(p.x(), p.y()))
        continue;
      const Cell cell = grid.at(p.x(), p.y());
      if (shade.isInside(cell))
        ++count[shade.indexOf(cell)];
    }
  });
  Panel panel(title);
  for (std::size_t s = 0; s < shades.size(); ++s) {
    for (std::size_t i = 0; i < count.size(); ++i)
      shade.values()[i] =
          count[i] >= shades[s].least &&
                  (s + 1 == shades.size() || count[i] < shades[s + 1].least)
              ? 1
              : 0;
    panel.addCells(shade.toSet(), grid.size(), shades[s].colour);
  }
  return panel;
}

Picture
draw(const PointPieces& before, const PointView& after, double leaf)
{
  constexpr std::size_t min_piece = 400; // smaller pieces are scattered outside
  pcl::Indices all(after.size());
  std::iota(all.begin(), all.end(), 0);
  double size = leaf;
  CellSet cells(CellGrid(size), after, all);
  Box view = viewOf(cells, size, min_piece);
  // Buildings much larger than their voxels are drawn with larger cells.
  while (!maskProblem(boxOf(view, size)).empty() ||
         view.sizes().maxCoeff() / size > 4000) {
    size *= 2;
    cells = CellSet(CellGrid(size), after, all);
    view = viewOf(cells, size, min_piece);
  }
  const CellGrid grid(size);
  const CellBox box = boxOf(view, size);
  Panel scan =
      densityPanel("scan: " + counted(before.size, "point"), before, grid, box);
  Panel thinned = densityPanel("thinned: " + counted(after.size(), "point"),
                               piecesOf(after), grid, box);
  for (Panel* panel : {&scan, &thinned})
    panel->setView(view);
  Picture picture("Thinning: the mean of the points of each voxel, seen from above");
  picture.addMaps({scan, thinned});
  for (const auto& shade : shades)
    picture.addLegend(shade.meaning, shade.colour);
  return picture;
}

} // namespace

Picture
drawThinning(const PointView& before, const PointView& after, double leaf)
{
  return draw(piecesOf(before), after, leaf);
}

Picture
drawThinning(const RowSource& before, const PointView& after, double leaf)
{
  const auto for_each = [&](const std::function<void(const PointView&)>& see) {
    RowCoordinates coordinates(before.fields(), before.rowSize());
    before.forEachPiece([&](const RowSource::Piece& piece) {
      see(coordinates.of(piece.rows, piece.size));
      return true;
    });
  };
  return draw({before.size(), for_each}, after, leaf);
}

} // namespace pcl::sedr::tools
