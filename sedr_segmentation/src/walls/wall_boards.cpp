// SPDX-License-Identifier: BSD-3-Clause
#include "wall_boards.h"

#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl {
namespace sedr {

namespace {

// Metres.
constexpr double top_band = 0.4; ///< below the ceiling, where no board hangs
constexpr double reach = 0.08;   ///< to both sides of the line: thinner than partitions
constexpr double least_length = 0.5;
constexpr double part = 0.2;           ///< along the wall, looked at as one
constexpr double corner = 0.1;         ///< whose points may be those of the next wall
constexpr double least_behind = 0.012; ///< of the wall, from the line
constexpr double least_depth = 0.02;   ///< of a board
constexpr double most_scatter = 0.012; ///< of the parts of a straight wall

constexpr std::size_t least_points = 3; ///< of a part
constexpr double least_share = 0.6;     ///< of the wall that was seen below the ceiling
constexpr double least_covered = 0.3;   ///< of that before which a board hangs

/** @brief A place near a wall: how far along it and before it. */
struct Beside {
  std::size_t index;
  std::size_t part;
  double before;
};

std::vector<Beside>
placesBeside(const PlanElement& wall, const std::vector<UprightPlace>& places)
{
  const double length = wall.length();
  const Eigen::Vector2d middle = wall.pointAt(length / 2);
  const double far = length / 2 + reach;
  std::vector<Beside> beside;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector2d& p = places[i].place;
    if ((p - middle).cwiseAbs().maxCoeff() > far)
      continue;
    const double s = wall.project(p);
    if (s < corner || s > length - corner)
      continue;
    const double before = (p - wall.pointAt(s)).dot(wall.normalAt(s));
    if (std::abs(before) <= reach)
      beside.push_back({i, static_cast<std::size_t>(s / part), before});
  }
  return beside;
}

double
middleOf(std::vector<double> values)
{
  return values.empty() ? 0 : middleValue(std::move(values));
}

/** @brief Whether the room goes on behind a wall: it is a face of a thin partition in
 * it, and what is behind it may be the other face. */
bool
isOfPartition(const PlanElement& wall, const PlanLoop& boundary)
{
  constexpr double thickest = 0.3;
  for (const double share : {0.25, 0.5, 0.75}) {
    const double s = share * wall.length();
    for (double d = reach; d < thickest; d += 0.05)
      if (boundary.contains(wall.pointAt(s) - d * wall.normalAt(s)))
        return true;
  }
  return false;
}

/** @brief How many more of the places below the ceiling stand `most` before a wall than
 * noise puts as far behind it: before a partition, half of them do, which are of its
 * other face. */
std::ptrdiff_t
surplusBefore(const std::vector<double>& above, double wall, double most)
{
  std::ptrdiff_t surplus = 0;
  for (const double d : above)
    surplus += (d > wall + most) - (d < wall - most);
  return surplus;
}

/** @brief Whether a board hangs before the wall that is behind a line.
 * @param[out] from how far before the line what is seen is the board's */
bool
hasBoard(const PlanElement& wall,
         const std::vector<UprightPlace>& places,
         const std::vector<Beside>& beside,
         double& from)
{
  const auto parts = static_cast<std::size_t>(wall.length() / part) + 1;
  std::vector<std::vector<double>> above(parts);
  std::vector<std::vector<double>> under(parts);
  for (const Beside& b : beside)
    (places[b.index].below < top_band ? above : under)[b.part].push_back(b.before);
  std::vector<double> walls;
  std::vector<double> boards;
  std::ptrdiff_t above_boards = 0;
  std::ptrdiff_t surplus = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    if (above[k].size() < least_points)
      continue;
    walls.push_back(middleOf(above[k]));
    if (under[k].size() < least_points)
      continue;
    const double before = middleOf(under[k]);
    const double depth = before - walls.back();
    if (depth <= least_depth)
      continue;
    boards.push_back(before);
    above_boards += static_cast<std::ptrdiff_t>(above[k].size());
    surplus += surplusBefore(above[k], walls.back(), depth / 2);
  }
  const auto count = [](const std::vector<double>& values) {
    return static_cast<double>(values.size());
  };
  if (count(walls) * part < least_share * wall.length() ||
      count(boards) < least_covered * count(walls) || 4 * surplus > above_boards)
    return false;
  const double behind = middleOf(walls);
  std::vector<double> off;
  off.reserve(walls.size());
  for (const double w : walls)
    off.push_back(std::abs(w - behind));
  if (behind > -least_behind || middleOf(off) > most_scatter)
    return false;
  from = (behind + middleOf(boards)) / 2;
  return true;
}

/** @brief The places on a board that hangs before a wall; none where there is none. */
std::vector<std::size_t>
boardBefore(const PlanElement& wall,
            const PlanLoop& boundary,
            const std::vector<UprightPlace>& places)
{
  if (wall.length() < least_length || isOfPartition(wall, boundary))
    return {};
  const std::vector<Beside> beside = placesBeside(wall, places);
  double from = 0;
  if (!hasBoard(wall, places, beside, from))
    return {};
  std::vector<std::size_t> board;
  for (const Beside& b : beside)
    if (b.before > from)
      board.push_back(b.index);
  return board;
}

} // namespace

bool
leaveOutBoards(const PlanLoop& boundary,
               std::vector<UprightPlace>& places,
               unsigned threads)
{
  const std::vector<PlanElement>& walls = boundary.elements;
  std::vector<std::vector<std::size_t>> boards(walls.size());
  parallelBlocks(walls.size(), 1, threads, [&](std::size_t w, std::size_t) {
    boards[w] = boardBefore(walls[w], boundary, places);
  });
  std::vector<std::uint8_t> is_board(places.size(), 0);
  for (const auto& board : boards)
    for (const std::size_t i : board)
      is_board[i] = 1;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!is_board[i])
      places[kept++] = places[i];
  const bool has_any = kept < places.size();
  places.resize(kept);
  return has_any;
}

} // namespace sedr
} // namespace pcl
