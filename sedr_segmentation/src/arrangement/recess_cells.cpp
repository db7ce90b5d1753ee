// SPDX-License-Identifier: BSD-3-Clause
#include "recess_cells.h"

#include <algorithm>

namespace pcl::sedr {

namespace {

CellMask
closed(const CellMask& mask, double radius)
{
  return eroded(dilated(mask, radius), radius);
}

/** @brief Looks behind lines for one room, by steps outwards. */
class RecessSearch {
public:
  RecessSearch(const Storey& storey,
               const std::vector<RoomCells>& cells,
               std::size_t room,
               const CellGrid& grid,
               double max_depth)
      : grid_(grid)
      , max_depth_(max_depth)
      , seen_(closed(cells[room].seen, 2))
      , opaque_(seen_.box())
      , glass_(seen_.box())
      , next_(seen_.box())
      , base_(seen_.box())
      , pillar_(dilated(cells[room].pillar, 2))
      , found_{CellMask(seen_.box()), CellMask(seen_.box())}
  {
    for (const std::size_t r : storey.rooms) {
      if (overlapOf(seen_.box(), cells[r].seen.box()).count() == 0)
        continue;
      addCells(subtract(cells[r].solid, cells[r].glass), opaque_);
      addCells(cells[r].glass, glass_);
      addCells(cells[r].base, base_);
      if (r != room)
        addCells(cells[r].besideRoom(cells[room], cells[r].seen), next_);
    }
    opaque_ = dilated(opaque_, 2);
    next_ = dilated(next_, 2);
    base_ = dilated(base_, 1);
  }

  void lookBehind(const StoreyLine& line)
  {
    const Eigen::AlignedBox2d box(grid_.centre(seen_.box().low),
                                  grid_.centre(seen_.box().high));
    if (line.is_end || !line.box().intersects(box))
      return;
    // A beam has no part below the ceiling, a wall has one beside its openings.
    constexpr double min_tall = 0.1; // share of a wall's surface
    const auto tall = std::count_if(line.tall.begin(), line.tall.end(),
                                    [](float share) { return share > 0; });
    const bool is_wall =
        StoreyLine::bin * static_cast<double>(tall) > min_tall * line.support();
    for (std::size_t i = 0; i < line.any.size(); ++i) {
      if (line.tall[i] > 0 || line.between[i] > StoreyLine::Between::Gap)
        continue;
      const Eigen::Vector2d p =
          line.at(line.from + (static_cast<double>(i) + 0.5) * StoreyLine::bin);
      const Eigen::Vector2d normal = leftOf(line.curve.tangentAt(p));
      const bool goes_on = line.between[i] == StoreyLine::Between::Partly;
      const bool is_beam = !is_wall && !is(base_, p);
      for (const Eigen::Vector2d& out : {normal, Eigen::Vector2d(-normal)})
        lookBehind(p, out, goes_on, line.part[i] > 0, is_beam);
    }
  }

  RecessCells found() && { return std::move(found_); }

private:
  bool is(const CellMask& mask, const Eigen::Vector2d& p) const
  {
    return mask.at(grid_.at(p.x(), p.y())) != 0;
  }

  void lookBehind(const Eigen::Vector2d& p,
                  const Eigen::Vector2d& out,
                  bool goes_on,
                  bool has_part,
                  bool is_beam)
  {
    constexpr double deepest_blind = 0.2;  // metres
    constexpr double deepest_reveal = 0.4; // to a leaf, a blind or a back
    if (!is(seen_, p - deepest_blind * out) || !is(seen_, p - deepest_reveal * out))
      return;
    const double size = grid_.size();
    const double step = size / 2;
    const double farthest = 1.5 * max_depth_ + 3 * size;
    double depth = 0; // of the seen air behind the line
    while (depth < farthest && is(seen_, p + (depth + step) * out) &&
           !is(glass_, p + depth * out))
      depth += step;
    const Eigen::Vector2d end = p + (depth + step) * out;
    const bool is_before_room = is(next_, end);
    if (!(depth > 0) || depth > (is_before_room ? 1.5 : 1) * max_depth_)
      return;
    // A beam hides the ceiling between itself and the wall.
    if (is_beam && !is_before_room)
      for (double d = depth + step; d < farthest && !is(glass_, p + d * out); d += step)
        if (is(opaque_, p + d * out))
          return;
    // Behind a leaf in a reveal no air of the room is seen, behind a column there is.
    if (is(pillar_, end))
      for (double d = depth + 3 * size; d < farthest; d += step)
        if (is(seen_, p + d * out))
          return;
    const bool has_back = is(opaque_, end) && !is_before_room;
    // A back farther behind than blinds are is a reveal's if sill or lintel are on the
    // line: what stands in an alcove is beside it.
    const bool is_reveal = depth <= deepest_blind || depth > deepest_reveal || has_part;
    if (has_back && (!goes_on || !is_reveal))
      return;
    CellMask& mask = has_back && depth > deepest_reveal ? found_.closed : found_.open;
    const Eigen::Vector2d along = 0.4 * StoreyLine::bin * leftOf(out);
    for (double d = step / 2; d <= depth; d += step)
      for (const double side : {-1, 0, 1}) {
        const Eigen::Vector2d q = p + d * out + side * along;
        if (const Cell cell = grid_.at(q.x(), q.y()); mask.isInside(cell))
          mask.set(cell, 1);
      }
  }

  const CellGrid& grid_;
  double max_depth_;
  CellMask seen_;
  CellMask opaque_; ///< near opaque surfaces
  CellMask glass_;
  CellMask next_;   ///< near the air of other rooms
  CellMask base_;   ///< near surfaces below the ceiling, such as sills
  CellMask pillar_; ///< near what may be columns
  RecessCells found_;
};

} // namespace

std::vector<RecessCells>
recessCells(const Storey& storey,
            const std::vector<RoomCells>& cells,
            const std::vector<StoreyLine>& lines,
            const CellGrid& grid,
            double max_depth)
{
  std::vector<RecessCells> found(cells.size());
  for (const std::size_t r : storey.rooms) {
    RecessSearch search(storey, cells, r, grid, max_depth);
    for (const StoreyLine& line : lines)
      search.lookBehind(line);
    found[r] = std::move(search).found();
  }
  return found;
}

} // namespace pcl::sedr
