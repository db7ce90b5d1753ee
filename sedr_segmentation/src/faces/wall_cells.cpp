// SPDX-License-Identifier: BSD-3-Clause
#include "wall_cells.h"

#include "sedr_filters/src/base/quantiles.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <functional>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief What was seen in a cell between the floor and the ceiling, in bins of height.
 */
struct CellColumn {
  std::uint8_t below_top = 0; ///< filled bins, down from the highest ceiling near it
  std::uint8_t below_low = 0; ///< likewise from the lowest
  std::uint64_t above_floor =
      0;                 ///< filled bins, up from the floor; the last is all above
  bool is_wall = false;  ///< wall growing has reached it
  bool is_short = false; ///< too little height for a bin of a low lintel
  /** Homogeneous sum of the places of its surface in plan. */
  Eigen::Vector3d places = Eigen::Vector3d::Zero();
};

/** @brief A point that may be a wall's. */
struct WallPlace {
  std::size_t cell;
  Eigen::Vector2d at;
  bool is_wall; ///< wall growing has reached it
  bool is_top;  ///< it lies below the highest ceiling near it
};

/** @brief The search for the surfaces of a room that reach up to its ceiling. */
class WallSearch {
public:
  WallSearch(const CellGrid& grid,
             const RoomCellsParameters& parameters,
             const CeilingEnds& ends,
             RoomCells& cells)
      : grid_(grid)
      , p_(parameters)
      , ends_(ends)
      , cells_(cells)
      , columns_(cells.seen.values().size())
      , highest_(columns_.size(), -no_height)
  {
    measureCeiling();
  }

  /** @brief Counts points by their cell and height.
   * @param of_wall whether wall growing has reached them
   * @param of_ceiling whether they pass for the ceiling's: above what hides a wall up
   * to near the ceiling its points do
   * @param place see forEachIn() */
  template <typename Place>
  void count(const PointView& points,
             const std::vector<int>& indices,
             bool of_wall,
             bool of_ceiling,
             Place place)
  {
    forEachIn(
        cells_.seen, grid_, points, indices,
        [&](std::size_t at, const Eigen::Vector3f& q) {
          if (isOnLowLintel(at, q.z()))
            columns_[at].places += q.head<2>().homogeneous().cast<double>();
          if (!of_ceiling || (q.z() <= cells_.top[at] - p_.rim && !maySlope(at)))
            countOne(at, q, of_wall);
        },
        place);
  }

  /** @brief Sets what is known of the walls. */
  void run()
  {
    spread(cells_.seen, 1, std::greater<>(), highest_);
    labelCells();
    for (std::size_t at = 0; at < columns_.size(); ++at)
      if (!cells_.riser.values()[at] || isTall(at))
        columns_[at].places.setZero();
    takePlaces();
    takeHeights();
    takeLintels();
    for (const auto& [cell, at] : below_sill_)
      if (cells_.base.values()[cell] && !cells_.solid.values()[cell])
        cells_.part_points.push_back(at);
  }

private:
  void measureCeiling()
  {
    const std::size_t count = columns_.size();
    std::vector<float> below_top(count, 0);
    std::vector<float> is_seen(count, 0);
    std::vector<float> is_at_top(count, 0);
    std::vector<double> depths; // of the ceiling about each cell
    for (std::size_t at = 0; at < count; ++at)
      if (ends_.low[at] <= ends_.high[at]) {
        below_top[at] = cells_.top[at] - ends_.high[at];
        is_seen[at] = 1;
        is_at_top[at] = ends_.high[at] > cells_.top[at] - p_.rim / 3 ? 1 : 0;
        depths.push_back(cells_.top[at] - cells_.low[at]);
      }
    const int reach = static_cast<int>(std::lround(p_.local / grid_.size()));
    depth_ = boxSums(cells_.seen, reach, below_top);
    seen_near_ = boxSums(cells_.seen, reach, is_seen);
    at_top_ = boxSums(cells_.seen, reach, is_at_top);
    beside_ = ends_.high;
    spread(cells_.seen, 1, std::greater<>(), beside_);
    uneven_ = depths.empty() ? 0 : middleValue(std::move(depths));
  }

  /** @brief Checks whether the ceiling of a cell may be a slope's. */
  bool maySlope(std::size_t at) const
  {
    return depth_[at] > seen_near_[at] * p_.rim / 2 &&
           ends_.high[at] - ends_.low[at] < 2 * p_.bin;
  }

  /** @brief Checks whether a low lintel may be at a height. It goes down from where a
   * level ceiling ends and a lower one begins: of the ceiling around it a third is at
   * its top, of one that slopes a row of cells. */
  bool isOnLowLintel(std::size_t at, double z) const
  {
    const double top = cells_.top[at] - uneven_;
    return beside_[at] > top - p_.rim / 3 && at_top_[at] > seen_near_[at] / 3 &&
           cells_.low[at] < top - std::max(p_.below, grid_.size()) &&
           z < top - p_.rim / 3 &&
           z > std::max<double>(cells_.low[at], top - 2 * p_.bin) + p_.rim / 3;
  }

  /** @brief Checks whether a height is in the band below a ceiling where walls are
   * looked for. */
  bool isInBand(float z, float ceiling) const
  {
    const double lowest =
        std::max(ceiling - p_.band, cells_.floor + (ceiling - cells_.floor) / 2);
    return z > lowest && z < ceiling - p_.rim;
  }

  std::uint8_t binBelow(float ceiling, float z) const
  {
    return static_cast<std::uint8_t>(
        1U << std::min(7, static_cast<int>((ceiling - z) / p_.bin)));
  }

  void countOne(std::size_t at, const Eigen::Vector3f& q, bool of_wall)
  {
    const Eigen::Vector2d place = q.head<2>().cast<double>();
    CellColumn& column = columns_[at];
    if (q.z() < cells_.top[at] + p_.rim)
      highest_[at] = std::max(highest_[at], q.z());
    if (const double above = q.z() - cells_.floor; above > p_.rim) {
      const float height = static_cast<float>(above) /
                           (cells_.top[at] - static_cast<float>(cells_.floor));
      if (q.z() < cells_.top[at] - p_.rim)
        heights_.emplace_back(at, Eigen::Vector3f(q.x(), q.y(), height));
      column.above_floor |= std::uint64_t{1}
                            << static_cast<int>(std::min(63.0, above / p_.bin));
      if (above < p_.sill)
        below_sill_.emplace_back(at, place);
    }
    const bool is_below_low = isInBand(q.z(), cells_.low[at]);
    const bool is_below_top = isInBand(q.z(), cells_.top[at]);
    if (is_below_low)
      column.below_low |= binBelow(cells_.low[at], q.z());
    if (is_below_top)
      column.below_top |= binBelow(cells_.top[at], q.z());
    if (is_below_low || is_below_top) {
      column.is_wall = column.is_wall || of_wall;
      places_.push_back({at, place, of_wall, is_below_top});
    }
  }

  /** @brief Checks whether the surface of a cell ends below its ceiling. */
  bool endsBelow(std::size_t at) const
  {
    return below_ceiling_.values()[at] && highest_[at] < cells_.low[at] - p_.below;
  }

  void labelCells()
  {
    cells_.solid = CellMask(cells_.seen.box());
    cells_.glass = cells_.riser = cells_.pillar = cells_.base = cells_.solid;
    below_ceiling_ = eroded(dilated(cells_.seen, 1), 3);
    const std::uint64_t up_to_sill =
        (std::uint64_t{1} << static_cast<unsigned>(p_.sill / p_.bin)) - 1;
    for (std::size_t at = 0; at < columns_.size(); ++at) {
      CellColumn& column = columns_[at];
      const int needed = column.is_wall ? p_.filled_of_wall : p_.filled;
      const int below_top = __builtin_popcount(column.below_top);
      const int below_low = __builtin_popcount(column.below_low);
      const bool goes_on = below_low > 1; // one may be a stray
      column.is_short = cells_.top[at] - cells_.low[at] < p_.filled_of_wall * p_.bin;
      cells_.solid.values()[at] = below_top >= needed && goes_on && !endsBelow(at);
      cells_.riser.values()[at] =
          !goes_on &&
          (below_top >= needed || (column.is_short && column.places.z() > 0));
      cells_.pillar.values()[at] =
          below_top < needed && below_low >= needed && !endsBelow(at);
      const bool is_tall =
          __builtin_popcountll(column.above_floor & ~up_to_sill) >= p_.filled;
      cells_.base.values()[at] =
          __builtin_popcountll(column.above_floor & up_to_sill) >= p_.filled_of_wall &&
          !(is_tall && highest_[at] < cells_.low[at] - p_.below);
    }
  }

  bool isTall(std::size_t at) const
  {
    return cells_.solid.values()[at] ||
           (cells_.riser.values()[at] && !columns_[at].is_short);
  }

  /** @brief Returns the share of the height from floor to ceiling at which something
   * was seen in or beside a cell. */
  float shareAt(std::size_t at) const
  {
    std::uint64_t filled = 0;
    const Cell cell = cells_.seen.cellAt(at);
    for (std::int32_t dy = -1; dy <= 1; ++dy)
      for (std::int32_t dx = -1; dx <= 1; ++dx)
        if (const Cell beside{cell.x + dx, cell.y + dy}; cells_.seen.isInside(beside))
          filled |= columns_[cells_.seen.indexOf(beside)].above_floor;
    const double height =
        cells_.top[at] - std::max<double>(cells_.bottom[at], cells_.floor) - 2 * p_.rim;
    const double all = std::max(1.0, height / p_.bin);
    const double above = filled >> 63U != 0 ? std::max(0.0, all - 64) : 0; // one bin
    return static_cast<float>(
        std::min(1.0, (__builtin_popcountll(filled) + above) / all));
  }

  /** @brief Checks whether the surface of a cell may be a wall's: a level one, such as
   * the soffit of a window, fills one bin. */
  bool fillsBins(std::size_t at) const
  {
    return __builtin_popcount(columns_[at].below_top) > 1;
  }

  /** @brief Takes the points of what reaches up to the ceiling. */
  void takePlaces()
  {
    CellMask tall(cells_.seen.box());
    for (std::size_t at = 0; at < columns_.size(); ++at)
      tall.values()[at] = isTall(at);
    const CellMask near_tall = dilated(tall, 1);
    const CellMask beside_tall = dilated(tall, 3); // of what is wall for certain
    const CellMask near_pillar = dilated(cells_.pillar, 1);
    for (const WallPlace& place : places_) {
      if (endsBelow(place.cell))
        continue;
      const CellMask& near = !place.is_top                            ? near_pillar
                             : place.is_wall && fillsBins(place.cell) ? beside_tall
                                                                      : near_tall;
      if (near.values()[place.cell]) {
        cells_.wall_points.push_back(place.at);
        cells_.wall_shares.push_back(shareAt(place.cell));
      }
      if (place.is_top && isTall(place.cell))
        columns_[place.cell].places += place.at.homogeneous();
    }
  }

  /** @brief Takes the heights of points in and beside cells of surfaces. */
  void takeHeights()
  {
    const CellMask surfaces =
        dilated(unite(unite(cells_.solid, cells_.riser), cells_.pillar), 2);
    for (const auto& [cell, point] : heights_)
      if (surfaces.values()[cell])
        cells_.height_points.push_back(point);
  }

  /** @brief Takes one point of each cell of a lintel; cells without any are none. */
  void takeLintels()
  {
    const CellMask near_base = dilated(cells_.base, 1);
    for (std::size_t at = 0; at < columns_.size(); ++at) {
      const CellColumn& column = columns_[at];
      if (!(column.places.z() > 0))
        cells_.riser.values()[at] = 0;
      if (!cells_.riser.values()[at])
        continue;
      const Eigen::Vector2d place = column.places.hnormalized();
      cells_.part_points.push_back(place);
      // As good as a wall above a parapet; elsewhere it may be noise of the ceiling.
      if (column.is_short && near_base.values()[at]) {
        cells_.wall_points.insert(cells_.wall_points.end(), p_.filled, place);
        cells_.wall_shares.insert(cells_.wall_shares.end(), p_.filled, shareAt(at));
      }
    }
  }

  const CellGrid& grid_;
  const RoomCellsParameters& p_;
  const CeilingEnds& ends_;
  RoomCells& cells_;
  std::vector<CellColumn> columns_;
  std::vector<float> highest_; ///< that was seen in or beside each cell
  std::vector<float>
      depth_; ///< sum within `local` of how far ceilings lie below the top
  std::vector<float> seen_near_; ///< cells within `local` with ceiling,
  std::vector<float> at_top_;    ///< those of them at its top
  std::vector<float> beside_;    ///< the highest ceiling in or beside a cell
  double uneven_ = 0;            ///< usual depth of the ceiling about a cell
  CellMask below_ceiling_;
  std::vector<WallPlace> places_;
  std::vector<std::pair<std::size_t, Eigen::Vector2d>> below_sill_; ///< points, by cell
  std::vector<std::pair<std::size_t, Eigen::Vector3f>> heights_;    ///< likewise
};

} // namespace

void
gatherWalls(const PointView& points,
            const RoomPoints& room,
            const WallSlopes& slopes,
            const CellGrid& grid,
            const RoomCellsParameters& parameters,
            const CeilingEnds& ends,
            RoomCells& cells)
{
  const auto atTop = [&](const Eigen::Vector3f& q) -> Eigen::Vector3f {
    const Eigen::Vector2f place =
        placeInPlan(q.cast<double>(), slopes, grid, cells).cast<float>();
    return {place.x(), place.y(), q.z()};
  };
  WallSearch search(grid, parameters, ends, cells);
  search.count(points, room.walls, true, false, atTop);
  search.count(points, room.others, false, false, atTop);
  search.count(points, room.ceiling, true, true, asScanned);
  search.run();
}

} // namespace pcl::sedr
