// SPDX-License-Identifier: BSD-3-Clause
#include "air_ends.h"
#include "end_pieces.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/quantiles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the gaps by column. */
std::vector<ColumnGap>
gapsAlong(const PointView& points,
          const std::vector<int>& indices,
          const Eigen::Matrix3d& axes)
{
  constexpr std::uint64_t least = 12; // cells
  constexpr std::uint64_t most = 120;
  std::vector<std::pair<std::uint64_t, float>> cells; // of each point, and its height
  cells.reserve(indices.size());
  for (const int i : indices) {
    const Eigen::Vector3d p = axes * points[static_cast<std::size_t>(i)].cast<double>();
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() >= farthest_place)
      continue;
    cells.emplace_back(columnKey(p), static_cast<float>(p.z()));
  }
  std::sort(cells.begin(), cells.end());
  std::vector<ColumnGap> gaps;
  std::uint64_t last = 0;
  float height_of_last = 0;
  for (std::size_t i = 0; i < cells.size();) {
    const std::uint64_t key = cells[i].first;
    double sum = 0;
    const std::size_t first = i;
    for (; i < cells.size() && cells[i].first == key; ++i)
      sum += cells[i].second;
    const auto height = static_cast<float>(sum / static_cast<double>(i - first));
    if (key >> air_columns::bits == last >> air_columns::bits && key - last > least &&
        key - last <= most + 1)
      gaps.push_back({key >> air_columns::bits, height_of_last, height});
    last = key;
    height_of_last = height;
  }
  return gaps;
}

/** @brief Returns each gap with the one beside it, along both axes, that it has most
 * air in common with. Columns without any are passed over: a sparse scan shows surfaces
 * in lines. */
GapBorders
bordersOf(const std::vector<ColumnGap>& gaps)
{
  constexpr std::uint64_t reach = 4; // cells
  GapBorders borders;
  for (const std::uint64_t step :
       {std::uint64_t{1}, std::uint64_t{1} << air_columns::bits})
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      float most = 0;
      std::size_t best = i;
      for (std::uint64_t k = 1; k <= reach && most == 0; ++k) {
        const std::uint64_t column = gaps[i].column + k * step;
        for (auto gap = std::lower_bound(gaps.begin(), gaps.end(), column, isBefore);
             gap != gaps.end() && gap->column == column; ++gap) {
          const float common =
              std::min(gaps[i].high, gap->high) - std::max(gaps[i].low, gap->low);
          if (common > most) {
            most = common;
            best = static_cast<std::size_t>(gap - gaps.begin());
          }
        }
      }
      if (best != i)
        borders.emplace_back(i, best);
    }
  return borders;
}

/** @brief Returns the entropy of what is counted by levels, times its number, nats. */
double
entropyOf(const std::map<double, double>& counts)
{
  double sum = 0;
  double logs = 0;
  for (const auto& [level, count] : counts) {
    sum += count;
    logs += count * std::log(count);
  }
  return sum > 0 ? sum * std::log(sum) - logs : 0;
}

/** @brief Returns the entropy of heights in steps of a cell, from where they fit best;
 * the first gaps of all columns, the second ones, ... by themselves, as storeys are. */
double
entropyOfHeights(const std::vector<ColumnGap>& gaps, float ColumnGap::*end)
{
  double least = std::numeric_limits<double>::infinity();
  for (const double start : {0.0, 0.5}) {
    std::vector<std::map<double, double>> levels; // by number of the gap in its column
    std::size_t number = 0;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      number = i > 0 && gaps[i].column == gaps[i - 1].column ? number + 1 : 0;
      levels.resize(std::max(levels.size(), number + 1));
      levels[number][std::floor(gaps[i].*end / air_columns::size + start)] += 1;
    }
    double sum = 0;
    for (const auto& of_storey : levels)
      sum += entropyOf(of_storey);
    least = std::min(least, sum / static_cast<double>(gaps.size()));
  }
  return least;
}

/** @brief Returns the share of steps within large pieces, off their rims. */
double
reliefOf(const std::vector<ColumnGap>& gaps,
         const GapBorders& borders,
         const EndPieces& pieces,
         float ColumnGap::*end)
{
  constexpr float least_step = 0.03F; // metres
  std::vector<int> beside(gaps.size(), 0);
  const auto isWithin = [&](const GapBorders::value_type& border) {
    return pieces.of[border.first] == pieces.of[border.second] &&
           pieces.isLarge(pieces.of[border.first]);
  };
  for (const auto& border : borders)
    if (isWithin(border)) {
      ++beside[border.first];
      ++beside[border.second];
    }
  double all = 0;
  double steps = 0;
  for (const auto& border : borders) {
    const auto [a, b] = border;
    if (!isWithin(border) || beside[a] < 4 || beside[b] < 4)
      continue;
    all += 1;
    steps += std::abs(gaps[a].*end - gaps[b].*end) >= least_step ? 1 : 0;
  }
  return steps / std::max(all, 1.0);
}

/** @brief Returns the log-odds that scanners stand on an end of the air, as on a floor,
 * and not anywhere in a room's width, nats: by their distances from the median height
 * of the end about them, where a scanner sees it. At most 9 to 1 against it: they may
 * stand on shelves. */
double
oddsOfStations(const std::vector<ColumnGap>& gaps,
               const std::vector<Eigen::Vector3d>& stations,
               float ColumnGap::*end)
{
  constexpr double usual =
      1.6; // metres, give or take a quarter; a room is 3 times as wide
  double odds = 0;
  for (const Eigen::Vector3d& station : stations) {
    std::vector<double> heights;
    for (double x = -usual; x < usual; x += air_columns::size) {
      const auto columnAt = [&](double y) {
        return columnKey(station.head<2>() + Eigen::Vector2d(x, y));
      };
      for (auto gap =
               std::lower_bound(gaps.begin(), gaps.end(), columnAt(-usual), isBefore);
           gap != gaps.end() && gap->column <= columnAt(usual); ++gap)
        if (gap->low < station.z() && station.z() < gap->high)
          heights.push_back(std::abs(station.z() - (*gap).*end));
    }
    if (heights.empty())
      continue;
    const double off = 4 * (middleValue(heights) / usual - 1);
    odds += std::log(3 * 4 / std::sqrt(2 * M_PI)) - off * off / 2;
  }
  return std::max(odds, -std::log(9));
}

EndSurface
surfaceOf(const std::vector<ColumnGap>& gaps,
          const GapBorders& borders,
          const std::vector<Eigen::Vector3d>& stations,
          float ColumnGap::*end,
          const Priors& priors)
{
  const EndPieces pieces = piecesOf(gaps, borders, end, priors);
  EndSurface surface;
  const ThingCounts counts = thingsOf(gaps, pieces, end, priors);
  surface.things = counts.things;
  surface.bars = counts.bars;
  for (const std::uint32_t piece : pieces.of)
    surface.large += pieces.isLarge(piece) ? 1.0 / static_cast<double>(gaps.size()) : 0;
  surface.relief = reliefOf(gaps, borders, pieces, end);
  surface.levels = entropyOfHeights(gaps, end);
  surface.stations = oddsOfStations(gaps, stations, end);
  return surface;
}

} // namespace

AirAlongAxis
airAlong(const PointView& points,
         const std::vector<int>& indices,
         const Eigen::Matrix3d& axes,
         std::vector<Eigen::Vector3d> stations,
         const Priors& priors)
{
  for (Eigen::Vector3d& station : stations)
    station = axes * station;
  const std::vector<ColumnGap> gaps = gapsAlong(points, indices, axes);
  AirAlongAxis air;
  if (gaps.empty())
    return air;
  std::vector<double> heights;
  for (const ColumnGap& gap : gaps)
    heights.push_back(gap.high - gap.low);
  const GapBorders borders = bordersOf(gaps);
  air.area = air_columns::size * air_columns::size * static_cast<double>(gaps.size());
  air.height = middleValue(heights);
  air.low = surfaceOf(gaps, borders, stations, &ColumnGap::low, priors);
  air.high = surfaceOf(gaps, borders, stations, &ColumnGap::high, priors);
  return air;
}

} // namespace pcl::sedr
