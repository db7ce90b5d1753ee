// SPDX-License-Identifier: BSD-3-Clause
#include "frontier_points.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Radius of the neighbourhood of a point: adjacent points of its wall face,
 * also diagonally. The other face of a thin partition is farther away. */
constexpr double neighbourhood = 1.5; // cells

/** @brief Number of frontier cells per block of a thread; each has many points. */
constexpr std::size_t frontiers_a_block = 64;

/** @brief Half size of the neighbourhood in cells. */
constexpr auto reach_cells = static_cast<int>(neighbourhood + 0.5);

/** @brief The points of the cells at and around frontiers, sorted by height. */
class FrontierColumns {
public:
  FrontierColumns(const PointView& points,
                  const RoomTerritory& territory,
                  const std::vector<std::int32_t>& rooms,
                  unsigned threads)
      : reach_(static_cast<float>(neighbourhood * territory.grid().size()))
      , frontier_(territory.frontier())
  {
    std::vector<CellKey> keys;
    for (std::size_t f = 0; f < frontier_.size(); ++f)
      for (int dy = -reach_cells; dy <= reach_cells; ++dy)
        for (int dx = -reach_cells; dx <= reach_cells; ++dx)
          keys.push_back(keyOf({frontier_[f].x + dx, frontier_[f].y + dy}));
    cells_ = CellSet(std::move(keys));
    sortIntoColumns(points, rooms, cellsOf(points, territory.grid(), rooms, threads));
    sortColumns(threads);
  }

  /** @brief Returns the number of frontier cells. */
  std::size_t size() const { return frontier_.size(); }

  /** @brief Assigns to each point of a frontier cell the most frequent room around it,
   * its own on a tie. */
  void vote(std::size_t frontier, std::vector<std::int32_t>& rooms) const
  {
    constexpr std::size_t side = 2 * reach_cells + 1;
    struct Window {
      const Member* next; ///< first point within the height window
      const Member* end;
    };
    std::array<Window, side * side> block{};
    std::size_t columns = 0;
    forEachAround(cells_, frontier_[frontier], reach_cells, [&](std::size_t cell) {
      if (first_[cell] < first_[cell + 1])
        block[columns++] = {begin(cell), begin(cell + 1)};
    });
    std::vector<std::pair<std::int32_t, std::size_t>> votes;
    const std::size_t middle = cells_.find(frontier_[frontier]);
    for (const Member* m = begin(middle); m != begin(middle + 1); ++m) {
      const Member& own = *m;
      const float low = own.place.z() - reach_;
      const float high = own.place.z() + reach_;
      votes.assign(1, {own.room, 0});
      for (std::size_t c = 0; c < columns; ++c) {
        auto& [next, end] = block[c];
        while (next != end && next->place.z() < low)
          ++next;
        for (const Member* other = next; other != end && other->place.z() <= high;
             ++other)
          if ((other->place - own.place).squaredNorm() <= reach_ * reach_)
            addTo(votes, other->room);
      }
      rooms[own.index] = std::max_element(votes.begin(), votes.end(),
                                          [](const auto& a, const auto& b) {
                                            return a.second < b.second;
                                          })
                             ->first;
    }
  }

private:
  /** @brief A point and the room of its territory. */
  struct Member {
    Eigen::Vector3f place;
    std::int32_t room;
    std::size_t index;
  };

  /** @brief Returns the cell of each point of a room, npos for other points. */
  std::vector<std::size_t> cellsOf(const PointView& points,
                                   const CellGrid& grid,
                                   const std::vector<std::int32_t>& rooms,
                                   unsigned threads) const
  {
    std::vector<std::size_t> cells(cells_.empty() ? 0 : rooms.size(), CellSet::npos);
    parallelFor(cells.size(), points_a_block, threads, [&](std::size_t i) {
      if (rooms[i] >= 0)
        cells[i] = cells_.find(grid.at(points[i].x(), points[i].y()));
    });
    return cells;
  }

  void sortIntoColumns(const PointView& points,
                       const std::vector<std::int32_t>& rooms,
                       const std::vector<std::size_t>& cells)
  {
    first_.assign(cells_.size() + 1, 0);
    for (const std::size_t cell : cells)
      if (cell != CellSet::npos)
        ++first_[cell + 1];
    for (std::size_t c = 1; c < first_.size(); ++c)
      first_[c] += first_[c - 1];
    members_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end());
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (cells[i] != CellSet::npos)
        members_[next[cells[i]]++] = {points[i], rooms[i], i};
  }

  void sortColumns(unsigned threads)
  {
    const auto isLower = [](const Member& a, const Member& b) {
      return a.place.z() != b.place.z() ? a.place.z() < b.place.z() : a.index < b.index;
    };
    parallelFor(cells_.size(), frontiers_a_block, threads, [&](std::size_t c) {
      Member* const low = members_.data() + first_[c];
      Member* const high = members_.data() + first_[c + 1];
      if (!std::is_sorted(low, high, isLower)) // the usual case
        std::sort(low, high, isLower);
    });
  }

  const Member* begin(std::size_t cell) const { return members_.data() + first_[cell]; }

  static void addTo(std::vector<std::pair<std::int32_t, std::size_t>>& votes,
                    std::int32_t room)
  {
    for (auto& vote : votes)
      if (vote.first == room) {
        ++vote.second;
        return;
      }
    votes.emplace_back(room, 1);
  }

  float reach_;
  CellSet frontier_;
  CellSet cells_;
  std::vector<std::size_t> first_; ///< first member of each cell, and the end
  std::vector<Member> members_;
};

} // namespace

std::vector<std::int32_t>
roomsOfPoints(const PointView& points, const RoomTerritory& territory, unsigned threads)
{
  std::vector<std::int32_t> rooms(points.size());
  parallelFor(rooms.size(), points_a_block, threads,
              [&](std::size_t i) { rooms[i] = territory.roomAt(points[i]); });
  const FrontierColumns columns(points, territory, rooms, threads);
  parallelFor(columns.size(), frontiers_a_block, threads,
              [&](std::size_t f) { columns.vote(f, rooms); });
  return rooms;
}

} // namespace pcl::sedr
