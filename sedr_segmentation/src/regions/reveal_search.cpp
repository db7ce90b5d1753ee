// SPDX-License-Identifier: BSD-3-Clause
#include "reveal_search.h"

namespace pcl::sedr {

CellMask
closed(const CellMask& mask, double radius)
{
  return eroded(dilated(mask, radius), radius);
}

RevealSearch::RevealSearch(const RoomCells& room,
                           const Surroundings& around,
                           const CellGrid& grid,
                           const RegionEnergy& energy)
    : grid_(grid)
    , energy_(energy)
    , air_(around.air)
    , seen_(closed(room.seen, 2))
    , closed_(dilated(around.opaque, 2))
    , next_(dilated(around.others, 2))
    , pillar_(dilated(room.pillar, 2))
    , above_(closed(room.riser, 2.5))
    , below_(closed(room.base, 2.5))
    , found_{CellMask(seen_.box()), CellMask(seen_.box()), CellMask(seen_.box())}
{}

void
RevealSearch::lookBehind(const WallLine& line)
{
  for (std::size_t b = 0; b < 2 * line.places.size(); ++b) {
    const AlongLine what = line.places[b / 2];
    if (what == AlongLine::Nothing)
      continue;
    const Eigen::Vector2d p = line.at((static_cast<double>(b) + 0.5) / 2);
    if (!seen_.isInside(grid_.at(p.x(), p.y())))
      continue;
    lookBehind(p, line.normal, what);
    lookBehind(p, -line.normal, what);
  }
}

bool
RevealSearch::is(const CellMask& mask, const Eigen::Vector2d& p) const
{
  return mask.at(grid_.at(p.x(), p.y())) != 0;
}

void
RevealSearch::mark(CellMask& mask, const Eigen::Vector2d& p)
{
  const Cell cell = grid_.at(p.x(), p.y());
  if (mask.isInside(cell))
    mask.set(cell, 1);
}

void
RevealSearch::lookBehind(const Eigen::Vector2d& p,
                         const Eigen::Vector2d& out,
                         AlongLine what)
{
  constexpr double before = 0.15; // metres: here air of the room was seen,
  constexpr double inside = 0.4;  // and here
  if (!is(seen_, p - before * out) || !is(seen_, p - inside * out))
    return;
  const double size = grid_.size();
  const double step = size / 2;
  const auto isAt = [&](const CellMask& wall) {
    return is(wall, p) || is(wall, p + size * out) || is(wall, p - size * out);
  };
  // The side of a soffit that ends at a wall is no lintel.
  const bool goes_on = what == AlongLine::Lower ||
                       (what == AlongLine::Gap && (isAt(below_) || isAt(above_)));
  const double farthest = energy_.max_doorway + 3 * size;
  double depth = 0;        // of the seen air behind the line
  bool has_lintel = false; // in it: there is the face of the wall
  while (depth < farthest && is(seen_, p + (depth + step) * out)) {
    depth += step;
    has_lintel = has_lintel || (depth > 2 * size && is(above_, p + depth * out));
  }
  const bool in_gap = what != AlongLine::Ended;
  const Eigen::Vector2d end = p + (depth + step) * out;
  const double thickest =
      goes_on && is(next_, end) ? energy_.max_doorway : energy_.max_wall;
  const double shallow = 1.5 * size;
  // Behind a leaf in a reveal no air of the room is seen, behind a column there is.
  bool is_column = false;
  if (is(pillar_, end))
    for (double d = depth + 3 * size; d < farthest && !is_column; d += step)
      is_column = is(seen_, p + d * out);
  const bool is_open = in_gap || (depth > shallow && !is(next_, end) &&
                                  !is(pillar_, end) && !has_lintel);
  const bool is_recess = depth > 0 && depth < thickest && !is_column;
  const bool is_reveal = is_recess && !is(closed_, end) && is_open;
  const bool is_shallow = is_recess && goes_on && depth > shallow;
  bool in_wall = in_gap;
  for (double d = step; d < farthest; d += step) {
    const Eigen::Vector2d q = p + d * out;
    if ((is_reveal || is_shallow) && d <= depth)
      mark(found_.reveal, q);
    in_wall = in_wall && d < thickest && !is(air_, q);
    if (in_wall)
      mark(found_.wall, q);
  }
  if (is_shallow)
    for (double d = -size; d < 2.5 * size; d += step)
      mark(found_.back, p + (depth + d) * out);
}

} // namespace pcl::sedr
