// SPDX-License-Identifier: BSD-3-Clause
#include "surrounded_points.h"

#include "quarter_turns.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

/** @brief Sectors are marked by the bits of a word. */
constexpr unsigned most_sectors = 64;

} // namespace

SurroundedPoints::SurroundedPoints(std::vector<Eigen::Vector3f> places,
                                   double cell_size,
                                   std::size_t neighbours,
                                   float angle)
    : places_(std::move(places))
    , grid_(cell_size)
    , neighbours_(neighbours)
    // Two sectors of equal growth turn by less than the angle, with a digit to spare.
    , sectors_(static_cast<unsigned>(std::min(1e6f, std::ceil(16.2f / angle))))
{
  std::vector<CellKey> keys;
  for (const auto& p : places_) {
    if (!grid_.holds(p.x(), p.y())) {
      sectors_ = most_sectors + 1;
      return;
    }
    keys.push_back(keyOf(grid_.at(p.x(), p.y())));
  }
  cells_ = CellSet(keys);
  first_.assign(cells_.size() + 1, 0);
  std::vector<std::size_t> cell_of;
  for (const CellKey key : keys) {
    cell_of.push_back(cells_.find(cellOf(key)));
    ++first_[cell_of.back() + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::size_t> next = first_;
  order_.resize(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i)
    order_[next[cell_of[i]]++] = static_cast<std::uint32_t>(i);
}

bool
SurroundedPoints::contains(std::size_t i) const
{
  if (sectors_ > most_sectors)
    return false;
  const std::uint64_t all = ~std::uint64_t{0} >> (most_sectors - sectors_);
  const auto reach = static_cast<float>(2 * grid_.size());
  const float scale = static_cast<float>(sectors_) / 4;
  const Eigen::Vector3f p = places_[i];
  const Cell middle = grid_.at(p.x(), p.y());
  std::uint64_t seen = 0;
  std::size_t count = 0;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      const std::size_t cell = cells_.find({middle.x + dx, middle.y + dy});
      if (cell == CellSet::npos)
        continue;
      count += first_[cell + 1] - first_[cell];
      for (std::size_t k = first_[cell]; k < first_[cell + 1] && seen != all; ++k) {
        const Eigen::Vector3f way = places_[order_[k]] - p;
        if (way.squaredNorm() > reach * reach || (way.x() == 0 && way.y() == 0))
          continue;
        const auto sector =
            static_cast<unsigned>(quarterTurns(way.x(), way.y()) * scale);
        seen |= std::uint64_t{1} << std::min(sector, sectors_ - 1);
      }
    }
  return seen == all && count <= neighbours_;
}

} // namespace sedr
} // namespace pcl
