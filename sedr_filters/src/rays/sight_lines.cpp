// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/sight_lines.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pcl {
namespace sedr {

namespace {

/** @brief Number of a part of [0, 1). */
std::size_t
partOf(double share, std::size_t parts)
{
  const double at = std::floor(share * static_cast<double>(parts));
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(parts - 1)));
}

/** @brief Height of a direction, 0 to 1 from straight down to straight up. */
double
heightOf(const Eigen::Vector3d& direction)
{
  return std::asin(std::clamp(direction.z(), -1.0, 1.0)) / M_PI + 0.5;
}

/** @brief Where in a turn around z a direction is, 0 to 1. */
double
turnOf(const Eigen::Vector3d& direction)
{
  return std::atan2(direction.y(), direction.x()) / (2 * M_PI) + 0.5;
}

/** @brief Calls `see(cell)` for all cells of directions, `rows` by twice as many, that
 * lead to within `radius` of a place. */
template <typename See>
void
forEachCellAround(const Eigen::Vector3d& place,
                  double radius,
                  std::size_t rows,
                  See see)
{
  const double distance = place.norm();
  const Eigen::Vector3d direction = place / distance;
  // As heights are counted; next to the scanner it is every direction.
  const double reach = distance > radius ? std::asin(radius / distance) / M_PI : 1;
  const double height = heightOf(direction);
  const double level =
      std::cos(M_PI * std::min(std::abs(height - 0.5) + reach, 0.5)); // the least
  const double width = level > 2 * reach ? reach / level : 0.5;       // of a turn
  const auto columns = static_cast<std::ptrdiff_t>(2 * rows);
  const auto columnAt = [&](double turn) {
    return static_cast<std::ptrdiff_t>(std::floor(turn * static_cast<double>(columns)));
  };
  const double turn = turnOf(direction);
  const std::ptrdiff_t first = columnAt(turn - width);
  const std::ptrdiff_t last = std::min(columnAt(turn + width), first + columns - 1);
  const std::size_t last_row = partOf(height + reach, rows);
  for (std::size_t row = partOf(height - reach, rows); row <= last_row; ++row)
    for (std::ptrdiff_t c = first; c <= last; ++c)
      see(row * 2 * rows + static_cast<std::size_t>((c % columns + columns) % columns));
}

auto
keyOf(const Eigen::Vector3f& p)
{
  return std::tuple(p.x(), p.y(), p.z());
}

} // namespace

std::size_t
SightLines::cellOf(const Station& station, const Eigen::Vector3d& direction)
{
  return partOf(heightOf(direction), station.rows) * 2 * station.rows +
         partOf(turnOf(direction), 2 * station.rows);
}

SightLines::SightLines(const std::vector<SightLine>& lines)
{
  constexpr double lines_a_cell = 4;
  constexpr double most_rows = 60; // of 3 degrees
  std::vector<SightLine> sorted;
  for (const SightLine& line : lines)
    if (line.from.allFinite() && line.to.allFinite() && line.from != line.to)
      sorted.push_back(line);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const SightLine& a, const SightLine& b) {
                     return keyOf(a.from) < keyOf(b.from);
                   });
  lines_.resize(sorted.size());
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end].from == sorted[begin].from)
      ++end;
    Station station;
    station.from = sorted[begin].from;
    const double rows =
        std::sqrt(static_cast<double>(end - begin) / (2 * lines_a_cell));
    station.rows = static_cast<std::size_t>(std::clamp(rows, 1.0, most_rows));
    std::vector<std::size_t> cell_of;
    for (std::size_t k = begin; k < end; ++k)
      cell_of.push_back(
          cellOf(station, (sorted[k].to - station.from).cast<double>().normalized()));
    station.first.assign(2 * station.rows * station.rows + 1, 0);
    for (const std::size_t cell : cell_of)
      ++station.first[cell + 1];
    station.first[0] = static_cast<std::uint32_t>(begin);
    std::partial_sum(station.first.begin(), station.first.end(), station.first.begin());
    std::vector<std::uint32_t> next = station.first;
    for (std::size_t k = begin; k < end; ++k)
      lines_[next[cell_of[k - begin]]++] = sorted[k];
    stations_.push_back(std::move(station));
  }
}

SightLines
SightLines::levelled(const Levelling& levelling) const
{
  std::vector<SightLine> lines = lines_;
  for (SightLine& line : lines)
    for (Eigen::Vector3f* const p : {&line.from, &line.to})
      *p = levelling.level(p->cast<double>()).cast<float>();
  return SightLines(lines);
}

SightLines::Crossings
SightLines::across(const Eigen::Vector3d& place,
                   const Eigen::Vector3d& normal,
                   double radius) const
{
  constexpr double clear = 0.15; // metres
  Crossings crossings;
  for (const Station& station : stations_) {
    const Eigen::Vector3d from = station.from.cast<double>();
    const Eigen::Vector3d whole = place - from;
    const double start = -whole.dot(normal); // how far in front of the surface
    const auto countIn = [&](std::size_t cell) {
      for (std::uint32_t k = station.first[cell]; k < station.first[cell + 1]; ++k) {
        const Eigen::Vector3d way = lines_[k].to.cast<double>() - from;
        const double end = start + way.dot(normal);
        if (std::abs(end) <= clear || (start > 0) != (start > end))
          continue; // ends at the surface, or leads away from it
        const double share = start / (start - end);
        if ((share * way - whole).squaredNorm() <= radius * radius)
          ++(share < 1 ? crossings.through : crossings.before);
      }
    };
    if (std::abs(start) > clear)
      forEachCellAround(whole, radius, station.rows, countIn);
  }
  return crossings;
}

} // namespace sedr
} // namespace pcl
