// SPDX-License-Identifier: BSD-3-Clause
#include "opening_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {
namespace {

const double never = -std::numeric_limits<double>::infinity();

/** @brief Sums over the first rows of each column: rows + 1 values a column. */
std::vector<double>
rowSums(const std::vector<double>& values, std::size_t columns, std::size_t rows)
{
  std::vector<double> sums(columns * (rows + 1));
  for (std::size_t c = 0; c < columns; ++c)
    for (std::size_t r = 0; r < rows; ++r)
      sums[c * (rows + 1) + r + 1] = sums[c * (rows + 1) + r] + values[c * rows + r];
  return sums;
}

/** @brief A pair of rows, and the best opening between them that is not closed yet. */
struct Band {
  std::size_t first_row;
  std::size_t last_row;
  double prior;
  double gain = never; ///< of all up to here, with this opening
  std::size_t start = 0;
};

/** @brief What is best up to a column where wall stands. */
struct Closed {
  double gain = 0;
  std::size_t start = 0;                           ///< of the opening that ends here
  std::size_t band = static_cast<std::size_t>(-1); ///< of it; -1: the wall goes on
};

} // namespace

std::vector<CellRectangle>
bestRectangles(const CellGains& g)
{
  const std::size_t n = g.rows + 1;
  const auto inside = rowSums(g.inside, g.columns, g.rows);
  const auto left = rowSums(g.left, g.columns + 1, g.rows);
  const auto right = rowSums(g.right, g.columns + 1, g.rows);
  const auto over = [n](const std::vector<double>& sums, std::size_t column,
                        const Band& band) {
    return sums[column * n + band.last_row] - sums[column * n + band.first_row];
  };
  std::vector<Band> bands;
  for (std::size_t a = 0; a < g.rows; ++a)
    for (std::size_t b = a + g.min_rows; b <= g.rows; ++b)
      if (const double prior = g.prior(a, b); prior > never)
        bands.push_back({a, b, prior});
  std::vector<Closed> closed(g.columns + 1);
  for (std::size_t c = 0; c <= g.columns; ++c) {
    if (c > 0)
      closed[c].gain = closed[c - 1].gain;
    for (std::size_t k = 0; k < bands.size(); ++k) {
      Band& band = bands[k];
      if (band.gain > never && c - band.start >= g.min_columns) {
        const double gain = band.gain + over(right, c, band);
        if (gain > closed[c].gain)
          closed[c] = {gain, band.start, k};
      }
    }
    if (c == g.columns)
      break;
    for (Band& band : bands) {
      const double begun = closed[c].gain + band.prior + over(left, c, band);
      if (begun > band.gain) {
        band.gain = begun;
        band.start = c;
      }
      band.gain += over(inside, c, band) + g.lower[c * n + band.first_row] +
                   g.upper[c * n + band.last_row];
    }
  }
  std::vector<CellRectangle> best;
  for (std::size_t c = g.columns; c > 0;) {
    if (closed[c].gain == closed[c - 1].gain ||
        closed[c].band == static_cast<std::size_t>(-1)) {
      --c;
      continue;
    }
    const Band& band = bands[closed[c].band];
    const std::size_t start = closed[c].start;
    best.push_back({start, c, band.first_row, band.last_row});
    c = start;
  }
  std::reverse(best.begin(), best.end());
  return best;
}

namespace {

/** @brief Adds a rectangle, or those above each other that gain more than it: a bar of
 * wall between two openings costs a single one all that was seen of the bar. */
void
addParted(const CellGains& g,
          const CellRectangle& at,
          std::vector<CellRectangle>& found)
{
  const std::size_t n = g.rows + 1;
  std::vector<double> inside(n); // of the rows before each, from side to side
  std::vector<double> lower(n);
  std::vector<double> upper(n);
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t c = at.first_column; c < at.last_column; ++c) {
      lower[r] += g.lower[c * n + r];
      upper[r] += g.upper[c * n + r];
      inside[r] += r > 0 ? g.inside[c * g.rows + r - 1] : 0;
    }
    if (r > 0)
      inside[r] += inside[r - 1] + g.left[at.first_column * g.rows + r - 1] +
                   g.right[at.last_column * g.rows + r - 1];
  }
  const auto gainOf = [&](std::size_t a, std::size_t b) {
    return b >= a + g.min_rows
               ? g.prior(a, b) + inside[b] - inside[a] + lower[a] + upper[b]
               : never;
  };
  double most = gainOf(at.first_row, at.last_row);
  CellRectangle below = at;
  CellRectangle above = at;
  for (std::size_t a = at.first_row + 1; a < at.last_row; ++a)
    for (std::size_t b = a + 1; b < at.last_row; ++b)
      if (const double gain = gainOf(at.first_row, a) + gainOf(b, at.last_row);
          gain > most) {
        most = gain;
        below.last_row = a;
        above.first_row = below.next_row = b;
      }
  if (below.last_row == at.last_row) {
    found.push_back(at);
    return;
  }
  addParted(g, below, found);
  addParted(g, above, found);
}

} // namespace

std::vector<CellRectangle>
allRectangles(CellGains g)
{
  constexpr double taken = -1e6; // nats
  std::vector<CellRectangle> all;
  for (auto best = bestRectangles(g); !best.empty(); best = bestRectangles(g)) {
    const std::size_t first = all.size();
    for (const CellRectangle& r : best)
      addParted(g, r, all);
    for (std::size_t k = first; k < all.size(); ++k)
      for (std::size_t c = all[k].first_column; c < all[k].last_column; ++c)
        for (std::size_t r = all[k].first_row; r < all[k].last_row; ++r)
          g.inside[c * g.rows + r] = taken;
  }
  return all;
}

CellArch
bestArch(const CellGains& g, const CellRectangle& at, double cost)
{
  const std::size_t n = g.rows + 1;
  const auto inside = rowSums(g.inside, g.columns, g.rows);
  const auto left = rowSums(g.left, g.columns + 1, g.rows);
  const auto right = rowSums(g.right, g.columns + 1, g.rows);
  const double half = static_cast<double>(at.last_column - at.first_column) / 2;
  // What the head gains, and the jambs below it.
  const auto gainOf = [&](double top, double rise) {
    double gain = 0;
    for (std::size_t c = at.first_column; c < at.last_column; ++c) {
      const double x = (static_cast<double>(c - at.first_column) + 0.5) / half - 1;
      const auto row = static_cast<std::size_t>(
          std::round(top - rise * (1 - std::sqrt(std::max(0.0, 1 - x * x)))));
      gain += inside[c * n + row] - inside[c * n + at.first_row] + g.upper[c * n + row];
    }
    const auto spring = static_cast<std::size_t>(std::round(top - rise));
    return gain + left[at.first_column * n + spring] +
           right[at.last_column * n + spring];
  };
  CellArch best;
  const auto flat = static_cast<double>(at.last_row);
  double most = gainOf(flat, 0) + cost;
  const double highest =
      std::min(flat + half, static_cast<double>(std::min(g.rows, at.next_row)));
  for (double top = flat - 1; top <= highest; top += 0.5)
    for (double rise = 2; rise <= half; rise += 0.5) {
      if (top - rise < static_cast<double>(at.first_row + g.min_rows))
        break;
      if (const double gain = gainOf(top, rise); gain > most) {
        most = gain;
        best = {top, rise};
      }
    }
  return best;
}

} // namespace pcl::sedr
