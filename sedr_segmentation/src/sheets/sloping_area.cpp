// SPDX-License-Identifier: BSD-3-Clause
#include "cell_pieces.h"
#include "cell_points.h"
#include "shape_fit.h"

#include "sheet_fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief What the points about a cell say of its surface. */
struct Window {
  double slope = 0;
  double height = 0;    ///< mean, metres
  double deviation = 0; ///< of the points from a smooth surface, metres
};

/** @brief Fits a plane to some points, and where that slopes a surface that bends. */
Window
windowOf(const std::vector<Eigen::Vector3d>& points)
{
  using Row = Eigen::Matrix<double, 6, 1>;
  const Eigen::Vector3d mean = meanOf(points);
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Row right = Row::Zero();
  double square = 0;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d p = point - mean;
    Row row;
    row << p.x(), p.y(), 1, p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
    normal.noalias() += row * row.transpose();
    right += p.z() * row;
    square += p.z() * p.z();
  }
  const Eigen::Vector2d rise =
      normal.topLeftCorner<2, 2>().ldlt().solve(right.head<2>());
  const double left = square - normal.ldlt().solve(right).dot(right);
  const double freedom = static_cast<double>(points.size()) - 6;
  return {rise.norm(), mean.z(),
          std::sqrt(std::max(0.0, left) / freedom / (1 + rise.squaredNorm()))};
}

/** @brief The windows of 3 x 3 cells about each one that slope; others are left as they
 * are. */
std::vector<Window>
slopingWindows(const CellPoints& cells)
{
  constexpr std::size_t min_points = 10;
  constexpr std::size_t max_points = 60;
  const SheetGrid& grid = cells.grid();
  std::vector<Window> windows(grid.count());
  for (std::size_t cell = 0; cell < grid.count(); ++cell) {
    const auto points = cells.pointsOf(cells.window(cell, 1), max_points);
    if (points.size() < min_points)
      continue;
    const Window window = windowOf(points);
    if (window.slope > std::tan(SheetParameters().level))
      windows[cell] = window;
  }
  return windows;
}

/** @brief The noise of the points of what slopes. That of level ceilings is less: their
 * voxels are full, those of a slope are cut by it and some hold a point or two. */
double
noiseOf(const std::vector<Window>& windows)
{
  std::vector<double> deviations;
  for (const Window& window : windows)
    if (window.slope > 0)
      deviations.push_back(window.deviation);
  return typicalDeviation(std::move(deviations));
}

/** @brief The cells of squares of 2 x reach + 1 that are all in a set. */
std::vector<std::uint8_t>
opened(const SheetGrid& grid, const std::vector<std::uint8_t>& is_in, int reach)
{
  std::vector<std::uint8_t> result(grid.count(), 0);
  const auto around = [&](int x, int y, auto use) {
    for (int row = y - reach; row <= y + reach; ++row)
      for (int column = x - reach; column <= x + reach; ++column)
        use(grid.indexOf(column, row));
  };
  for (int y = reach; y + reach < grid.rows; ++y)
    for (int x = reach; x + reach < grid.columns; ++x) {
      bool is_whole = true;
      around(x, y, [&](std::size_t cell) { is_whole = is_whole && is_in[cell] != 0; });
      if (is_whole)
        around(x, y, [&](std::size_t cell) { result[cell] = 1; });
    }
  return result;
}

} // namespace

double
slopingArea(const std::vector<Eigen::Vector3d>& points)
{
  constexpr double finest = 0.1; // metres
  constexpr double filled = 3;   // points in a cell
  constexpr double max_cells = 1e6;
  constexpr double smooth = 1.5; // deviations
  constexpr double step = 6;     // strays: lower ones look like smooth slopes
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : points)
    box.extend(p.head<2>());
  if (box.isEmpty())
    return 0;
  SheetParameters parameters;
  parameters.cell_size = std::max(
      finest, std::sqrt(filled * box.volume() / static_cast<double>(points.size())));
  parameters.max_cells = static_cast<std::size_t>(max_cells);
  const SheetGrid grid = sheetGrid(box, parameters);
  const std::vector<std::uint8_t> all(grid.count(), 1);
  const CellPoints cells(grid, all, points);
  const std::vector<Window> windows = slopingWindows(cells);
  const double noise = std::min(noiseOf(windows), parameters.largest_noise);
  const double strays = std::hypot(smooth * noise, parameters.unevenness);
  std::vector<std::uint8_t> slopes(grid.count(), 0);
  for (std::size_t cell = 0; cell < grid.count(); ++cell)
    slopes[cell] = windows[cell].slope > 0 && windows[cell].deviation < strays ? 1 : 0;
  std::size_t largest = 0;
  for (const auto& piece : piecesOf(grid, opened(grid, slopes, 1))) {
    const auto [low, high] =
        std::minmax_element(piece.begin(), piece.end(), [&](auto a, auto b) {
          return windows[a].height < windows[b].height;
        });
    if (windows[*high].height - windows[*low].height > step * strays)
      largest = std::max(largest, piece.size());
  }
  return static_cast<double>(largest) * grid.size * grid.size;
}

} // namespace pcl::sedr
