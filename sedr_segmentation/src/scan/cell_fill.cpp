// SPDX-License-Identifier: BSD-3-Clause
#include "cell_fill.h"

#include "sedr_filters/src/base/quantiles.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::sedr {

namespace {

constexpr std::int32_t square_size = 20;
constexpr std::size_t min_of_square = 10;

/** @brief Minimum median fill; below it the scan is sparse in too many places. */
constexpr double fill_enough = 0.98;

/** @brief Numbers of cells between two occupied ones. */
struct Between {
  std::size_t all = 0;
  std::size_t occupied = 0;
};

CellKey
squareOf(Cell cell)
{
  const auto down = [](std::int32_t v) {
    return (v >= 0 ? v : v - square_size + 1) / square_size;
  };
  return keyOf({down(cell.x), down(cell.y)});
}

/** @brief Counts the cells between two occupied ones in direction `way`. */
void
countBetween(const CellSet& cells, Cell way, std::map<CellKey, Between>& squares)
{
  auto last = squares.end(); // the next cell in a row is mostly in the same square
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell middle{cells[i].x + way.x, cells[i].y + way.y};
    if (!cells.contains({middle.x + way.x, middle.y + way.y}))
      continue;
    const CellKey square = squareOf(middle);
    if (last == squares.end() || last->first != square)
      last = squares.try_emplace(square).first;
    ++last->second.all;
    last->second.occupied += cells.contains(middle) ? 1 : 0;
  }
}

/** @brief Returns the fill of each square, weighted by its occupied cells. */
std::vector<Weighted>
sharesOf(const std::vector<CellSet>& ceilings)
{
  std::vector<Weighted> shares;
  for (const CellSet& cells : ceilings) {
    std::map<CellKey, Between> squares;
    countBetween(cells, {1, 0}, squares);
    countBetween(cells, {0, 1}, squares);
    for (const auto& [key, square] : squares)
      if (square.all >= min_of_square) {
        const auto occupied = static_cast<double>(square.occupied);
        shares.push_back({occupied / static_cast<double>(square.all), occupied});
      }
  }
  return shares;
}

} // namespace

double
cellSizeFor(const std::vector<CellSet>& ceilings, double size, const Priors& priors)
{
  const std::vector<Weighted> shares = sharesOf(ceilings);
  if (shares.empty() || weightedQuantile(shares, 0.5) >= fill_enough)
    return size;
  const double fill = std::max(weightedQuantile(shares, 0.1), 0.01);
  const double enlargement =
      std::sqrt(std::log(1 - priors.cell_fill) / std::log(1 - fill));
  const double wanted = size * std::clamp(enlargement, 1.0, priors.max_enlargement);
  const double up = 1 / std::max(1.0, std::floor(1 / wanted));
  const bool is_too_large = up > size * priors.max_enlargement;
  return std::max(size, is_too_large ? 1 / std::ceil(1 / wanted) : up);
}

} // namespace pcl::sedr
