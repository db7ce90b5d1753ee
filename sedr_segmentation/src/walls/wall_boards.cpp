// SPDX-License-Identifier: BSD-3-Clause
#include "wall_boards.h"

#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl::sedr {

namespace {

/** @brief How far to both sides of a line its wall is looked for: less than partitions
 * of stone are thick. */
double
reachOf(const Priors& priors)
{
  return 2 * priors.min_wall;
}

/** @brief The length of wall that is looked at as one. */
double
partOf(const Priors& priors)
{
  return 2 * priors.evidence_cell;
}

/** @brief A place near a wall: how far along it and before it. */
struct Beside {
  std::size_t index;
  std::size_t part;
  double before;
};

std::vector<Beside>
placesBeside(const PlanElement& wall,
             const std::vector<VerticalPlace>& places,
             const Priors& priors)
{
  const double reach = reachOf(priors);
  const double corner = priors.evidence_cell; // which may be of the next wall
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
      beside.push_back({i, static_cast<std::size_t>(s / partOf(priors)), before});
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
isOfPartition(const PlanElement& wall, const PlanLoop& boundary, const Priors& priors)
{
  const double reach = reachOf(priors);
  for (const double share : {0.25, 0.5, 0.75}) {
    const double s = share * wall.length();
    for (double d = reach; d < priors.max_wall / 2; d += priors.evidence_cell / 2)
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
         const std::vector<VerticalPlace>& places,
         const std::vector<Beside>& beside,
         const Priors& priors,
         double& from)
{
  const double part = partOf(priors);
  const auto min_points = static_cast<std::size_t>(priors.min_evidence);
  const auto parts = static_cast<std::size_t>(wall.length() / part) + 1;
  std::vector<std::vector<double>> above(parts);
  std::vector<std::vector<double>> under(parts);
  for (const Beside& b : beside)
    (places[b.index].below < priors.board_clearance ? above : under)[b.part].push_back(
        b.before);
  std::vector<double> walls;
  std::vector<double> boards;
  std::ptrdiff_t above_boards = 0;
  std::ptrdiff_t surplus = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    if (above[k].size() < min_points)
      continue;
    walls.push_back(middleOf(above[k]));
    if (under[k].size() < min_points)
      continue;
    const double before = middleOf(under[k]);
    const double depth = before - walls.back();
    if (depth <= priors.min_board_depth)
      continue;
    boards.push_back(before);
    above_boards += static_cast<std::ptrdiff_t>(above[k].size());
    surplus += surplusBefore(above[k], walls.back(), depth / 2);
  }
  const auto count = [](const std::vector<double>& values) {
    return static_cast<double>(values.size());
  };
  if (count(walls) * part < priors.share_clear * wall.length() ||
      count(boards) < priors.share_some * count(walls) || 4 * surplus > above_boards)
    return false;
  const double behind = middleOf(walls);
  std::vector<double> off;
  off.reserve(walls.size());
  for (const double w : walls)
    off.push_back(std::abs(w - behind));
  if (behind > -priors.wall_noise || middleOf(off) > priors.wall_noise)
    return false;
  from = (behind + middleOf(boards)) / 2;
  return true;
}

/** @brief The places on a board that hangs before a wall; none where there is none. */
std::vector<std::size_t>
boardBefore(const PlanElement& wall,
            const PlanLoop& boundary,
            const std::vector<VerticalPlace>& places,
            const Priors& priors)
{
  if (wall.length() < priors.min_wall_length || isOfPartition(wall, boundary, priors))
    return {};
  const std::vector<Beside> beside = placesBeside(wall, places, priors);
  double from = 0;
  if (!hasBoard(wall, places, beside, priors, from))
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
               std::vector<VerticalPlace>& places,
               unsigned threads,
               const Priors& priors)
{
  const std::vector<PlanElement>& walls = boundary.elements;
  std::vector<std::vector<std::size_t>> boards(walls.size());
  parallelBlocks(walls.size(), 1, threads, [&](std::size_t w, std::size_t) {
    boards[w] = boardBefore(walls[w], boundary, places, priors);
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

} // namespace pcl::sedr
