// SPDX-License-Identifier: BSD-3-Clause
#include "frontier_points.h"

#include <pcl/sedr_filters/parallel.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

/** @brief Those around a point of a sheet: its neighbours in it, one a cell, cornerwise
 * too; the other face of a thin partition is farther away. */
constexpr double neighbourhood = 1.5; // cells

/** @brief The cells that these may lie in, to each side. */
constexpr int reach_cells = 2;

/** @brief The points of the cells along frontiers and around these, by height. */
class FrontierColumns {
public:
  FrontierColumns(const PointView& points,
                  const RoomTerritory& territory,
                  const std::vector<std::int32_t>& rooms)
      : reach_(static_cast<float>(neighbourhood * territory.grid().size()))
      , frontier_(territory.frontier())
  {
    std::vector<CellKey> keys;
    for (std::size_t f = 0; f < frontier_.size(); ++f)
      for (int dy = -reach_cells; dy <= reach_cells; ++dy)
        for (int dx = -reach_cells; dx <= reach_cells; ++dx)
          keys.push_back(keyOf({frontier_[f].x + dx, frontier_[f].y + dy}));
    cells_ = CellSet(std::move(keys));
    columns_.resize(cells_.size());
    for (std::size_t i = 0; i < rooms.size() && !cells_.empty(); ++i) {
      if (rooms[i] < 0)
        continue;
      const Eigen::Vector3f p = points[i];
      const std::size_t cell = cells_.find(territory.grid().at(p.x(), p.y()));
      if (cell != CellSet::npos)
        columns_[cell].push_back({p, rooms[i], i});
    }
    for (auto& column : columns_)
      std::sort(column.begin(), column.end(), [](const Member& a, const Member& b) {
        return a.place.z() != b.place.z() ? a.place.z() < b.place.z()
                                          : a.index < b.index;
      });
  }

  /** @brief Number of cells along frontiers. */
  std::size_t size() const { return frontier_.size(); }

  /** @brief Gives each point of a frontier's cell the room of most points around it,
   * its own of several as frequent. */
  void vote(std::size_t frontier, std::vector<std::int32_t>& rooms) const
  {
    constexpr std::size_t side = 2 * reach_cells + 1;
    std::array<std::pair<const std::vector<Member>*, std::size_t>, side * side> block;
    std::size_t columns = 0;
    forEachAround(cells_, frontier_[frontier], reach_cells, [&](std::size_t cell) {
      block[columns++] = {&columns_[cell], 0};
    });
    std::vector<std::pair<std::int32_t, std::size_t>> votes;
    for (const Member& own : columns_[cells_.find(frontier_[frontier])]) {
      votes.assign(1, {own.room, 0});
      for (std::size_t c = 0; c < columns; ++c) {
        auto& [column, next] = block[c];
        while (next < column->size() &&
               (*column)[next].place.z() < own.place.z() - reach_)
          ++next;
        for (std::size_t k = next; k < column->size(); ++k) {
          const Member& other = (*column)[k];
          if (other.place.z() > own.place.z() + reach_)
            break;
          if ((other.place - own.place).squaredNorm() <= reach_ * reach_)
            addTo(votes, other.room);
        }
      }
      rooms[own.index] = std::max_element(votes.begin(), votes.end(),
                                          [](const auto& a, const auto& b) {
                                            return a.second < b.second;
                                          })
                             ->first;
    }
  }

private:
  /** @brief A point and the room in whose territory it lies. */
  struct Member {
    Eigen::Vector3f place;
    std::int32_t room;
    std::size_t index;
  };

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
  std::vector<std::vector<Member>> columns_; ///< of the cells
};

} // namespace

std::vector<std::int32_t>
roomsOfPoints(const PointView& points, const RoomTerritory& territory, unsigned threads)
{
  constexpr std::size_t points_a_block = 16384;
  constexpr std::size_t cells_a_block = 64;
  std::vector<std::int32_t> rooms(points.size());
  parallelBlocks(rooms.size(), points_a_block, threads,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i)
                     rooms[i] = territory.roomAt(points[i]);
                 });
  const FrontierColumns columns(points, territory, rooms);
  parallelBlocks(columns.size(), cells_a_block, threads,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t f = begin; f < end; ++f)
                     columns.vote(f, rooms);
                 });
  return rooms;
}

} // namespace sedr
} // namespace pcl
