// SPDX-License-Identifier: BSD-3-Clause
#include "wall_boards.h"

#include <pcl/sedr_filters/middle_value.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace pcl {
namespace sedr {

namespace {

// Metres.
/** @brief Below the ceiling, where no board hangs: in low rooms they end near it. */
constexpr std::array<double, 5> top_bands{0.4, 0.3, 0.2, 0.15, 0.1};
constexpr double reach = 0.08; ///< to both sides of the line: thinner than partitions
constexpr double least_length = 0.3;
constexpr double part = 0.2;           ///< along the wall, looked at as one
constexpr double corner = 0.1;         ///< whose points may be those of the next wall
constexpr double least_behind = 0.012; ///< of the wall, from the line
constexpr double least_width = 0.4;    ///< of all parts before which boards hang
constexpr double least_depth = 0.02;   ///< of a board
constexpr double low_band = 0.3;       ///< where a slot may be
constexpr double least_beside = 0.4;   ///< of the wall, beside what ends in a low band
constexpr double most_scatter = 0.012; ///< of the parts of a straight wall

constexpr std::size_t least_points = 3; ///< of a part
constexpr double least_share = 0.6;     ///< of the wall that was seen below the ceiling

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

/** @brief What is seen of a part of a wall. */
struct WallPart {
  std::vector<double> above; ///< what is before the line just below the ceiling
  std::vector<double> under;
  double wall = 0; ///< middle of what is above
  double board = 0;
  bool has_wall = false;
  bool has_board = false;
  bool goes_down = false; ///< what is under is the wall, too
};

std::vector<WallPart>
partsOf(const PlanElement& wall,
        const std::vector<UprightPlace>& places,
        const std::vector<Beside>& beside,
        double top_band)
{
  std::vector<WallPart> parts(static_cast<std::size_t>(wall.length() / part) + 1);
  for (const Beside& b : beside) {
    WallPart& own = parts[b.part];
    (places[b.index].below < top_band ? own.above : own.under).push_back(b.before);
  }
  for (WallPart& own : parts) {
    own.has_wall = own.above.size() >= least_points;
    own.wall = middleOf(own.above);
    own.board = middleOf(own.under);
    own.has_board = own.has_wall && own.under.size() >= least_points &&
                    own.board - own.wall > least_depth;
    own.goes_down = own.has_wall && own.under.size() >= least_points && !own.has_board;
  }
  return parts;
}

/** @brief A wall that a line is not quite along. */
struct LineBehind {
  double first = 0; ///< how far before the line it is at the first part, metres
  double slope = 0; ///< and how much farther at every next one

  double at(std::size_t k) const { return first + slope * static_cast<double>(k); }
};

/** @brief The line along which most parts of a wall are seen. */
LineBehind
lineBehind(const std::vector<WallPart>& parts)
{
  std::vector<double> slopes;
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (std::size_t i = 0; i < k; ++i)
      if (parts[i].has_wall && parts[k].has_wall)
        slopes.push_back((parts[k].wall - parts[i].wall) / static_cast<double>(k - i));
  LineBehind line;
  line.slope = middleOf(std::move(slopes));
  std::vector<double> first;
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (parts[k].has_wall)
      first.push_back(parts[k].wall - line.slope * static_cast<double>(k));
  line.first = middleOf(std::move(first));
  return line;
}

/** @brief What hangs before a wall. */
struct Board {
  LineBehind wall;
  double depth = 0;      ///< of its face, from the wall
  std::size_t parts = 0; ///< of the wall, before which it was seen
};

/** @brief The board before a wall, if what is seen just below the ceiling is straight
 * and behind the line.
 * @param is_beside_wall whether the wall must be seen beside it, too: else what a low
 * band shows may be a slot along the ceiling */
std::optional<Board>
boardBefore(const PlanElement& wall,
            const std::vector<WallPart>& parts,
            bool is_beside_wall)
{
  const auto lengthOf = [&](bool WallPart::*has) {
    return part * static_cast<double>(
                      std::count_if(parts.begin(), parts.end(),
                                    [&](const WallPart& own) { return own.*has; }));
  };
  if (lengthOf(&WallPart::has_wall) < least_share * wall.length() ||
      lengthOf(&WallPart::has_board) < least_width ||
      (is_beside_wall && lengthOf(&WallPart::goes_down) < least_beside))
    return {};
  std::ptrdiff_t above_boards = 0;
  std::ptrdiff_t surplus = 0;
  const LineBehind line = lineBehind(parts);
  std::vector<double> off;
  std::vector<double> behind;
  std::vector<double> depths;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const WallPart& own = parts[k];
    if (!own.has_wall)
      continue;
    off.push_back(std::abs(own.wall - line.at(k)));
    if (!own.has_board)
      continue;
    behind.push_back(line.at(k));
    depths.push_back(own.board - line.at(k));
    above_boards += static_cast<std::ptrdiff_t>(own.above.size());
    surplus += surplusBefore(own.above, own.wall, (own.board - own.wall) / 2);
  }
  if (4 * surplus > above_boards || middleOf(behind) > -least_behind ||
      middleOf(off) > most_scatter)
    return {};
  return Board{line, middleOf(depths), behind.size()};
}

/** @brief Whether an element is a wall from corner to corner, and not what stands
 * forward between short steps. */
bool
isWhole(const PlanLoop& boundary, std::size_t i)
{
  const std::size_t n = boundary.elements.size();
  return boundary.elements[(i + n - 1) % n].length() > least_length &&
         boundary.elements[(i + 1) % n].length() > least_length;
}

/** @brief The board that most of the wall shows, as high a band below the ceiling as
 * may be. */
std::optional<Board>
largestBoard(const PlanElement& wall,
             const std::vector<UprightPlace>& places,
             const std::vector<Beside>& beside,
             bool is_whole)
{
  std::optional<Board> largest;
  for (const double band : top_bands) {
    const std::optional<Board> board = boardBefore(
        wall, partsOf(wall, places, beside, band), is_whole && band < low_band);
    if (board && (!largest || board->parts > largest->parts))
      largest = board;
  }
  return largest;
}

} // namespace

bool
leaveOutBoards(const PlanLoop& boundary, std::vector<UprightPlace>& places)
{
  std::vector<std::uint8_t> is_board(places.size(), 0);
  bool has_any = false;
  for (std::size_t i = 0; i < boundary.elements.size(); ++i) {
    const PlanElement& wall = boundary.elements[i];
    if (wall.length() < least_length || isOfPartition(wall, boundary))
      continue;
    const std::vector<Beside> beside = placesBeside(wall, places);
    const std::optional<Board> board =
        largestBoard(wall, places, beside, isWhole(boundary, i));
    if (!board)
      continue;
    for (const Beside& b : beside) {
      places[b.index].is_strip = false;
      if (b.before > board->wall.at(b.part) + board->depth / 2)
        is_board[b.index] = 1;
    }
    has_any = true;
  }
  if (!has_any)
    return false;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!is_board[i])
      places[kept++] = places[i];
  places.resize(kept);
  return true;
}

} // namespace sedr
} // namespace pcl
