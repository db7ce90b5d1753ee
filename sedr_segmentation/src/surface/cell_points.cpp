// SPDX-License-Identifier: BSD-3-Clause
#include "cell_points.h"

#include "../shapes/shape_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

std::vector<std::vector<std::size_t>>
piecesOf(const SheetGrid& grid, const std::vector<std::uint8_t>& is_in)
{
  auto pieces = piecesOf(grid, std::vector<std::int32_t>(is_in.begin(), is_in.end()));
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                              [&](const auto& piece) { return !is_in[piece.front()]; }),
               pieces.end());
  return pieces;
}

std::vector<std::vector<std::size_t>>
piecesOf(const SheetGrid& grid, const std::vector<std::int32_t>& label)
{
  std::vector<std::uint8_t> is_known(grid.count(), 0);
  std::vector<std::vector<std::size_t>> pieces;
  for (std::size_t first = 0; first < grid.count(); ++first) {
    if (is_known[first])
      continue;
    std::vector<std::size_t> piece{first};
    is_known[first] = 1;
    for (std::size_t k = 0; k < piece.size(); ++k)
      grid.forAllSides(piece[k], [&](std::size_t next) {
        if (label[next] != label[first] || is_known[next])
          return;
        is_known[next] = 1;
        piece.push_back(next);
      });
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

void
fillNearest(const SheetGrid& grid, std::vector<std::int32_t>& label)
{
  std::vector<std::size_t> front;
  for (std::size_t cell = 0; cell < label.size(); ++cell)
    if (label[cell] >= 0)
      front.push_back(cell);
  for (std::size_t k = 0; k < front.size(); ++k)
    grid.forAllSides(front[k], [&](std::size_t beside) {
      if (label[beside] >= 0)
        return;
      label[beside] = label[front[k]];
      front.push_back(beside);
    });
}

RiserBins::RiserBins(const SheetGrid& grid,
                     const std::vector<std::uint8_t>& domain,
                     const std::vector<Eigen::Vector3d>& points,
                     double low,
                     double high)
    : bottom_(low)
{
  constexpr double bins = 64;
  bin_ = std::max(bin_, (high - low) / (bins - 1));
  own_.assign(grid.count(), 0);
  for (const Eigen::Vector3d& p : points)
    if (const std::size_t cell = grid.at(p.head<2>());
        cell < own_.size() && p.z() >= low && p.z() <= high)
      own_[cell] |= std::uint64_t{1} << static_cast<int>((p.z() - bottom_) / bin_);
  is_at_wall_.assign(grid.count(), 0);
  for (std::size_t cell = 0; cell < own_.size(); ++cell)
    grid.forAllWithin(cell, to_wall, [&](std::size_t next) {
      is_at_wall_[cell] = is_at_wall_[cell] | !domain[next];
    });
  seen_.assign(grid.count(), 0);
  for (std::size_t cell = 0; cell < own_.size(); ++cell) {
    const auto add = [&](std::size_t near) {
      if (!domain[cell] || !is_at_wall_[near])
        seen_[cell] |= own_[near];
    };
    add(cell);
    grid.forAllSides(cell, add);
  }
}

double
RiserBins::share(std::size_t cell, std::size_t next, double low, double high) const
{
  if (high - low < min_step)
    return 0;
  const double middle = std::floor(((low + high) / 2 - bottom_) / bin_);
  const double first = std::min(middle, std::ceil((low + margin - bottom_) / bin_));
  const double last =
      std::max(middle, std::floor((high - margin - bottom_) / bin_) - 1);
  const auto from = static_cast<int>(std::clamp(first, 0.0, 63.0));
  const auto count = static_cast<int>(std::clamp(last, 0.0, 63.0)) - from + 1;
  const std::uint64_t between = (~std::uint64_t{0} >> (64 - count)) << from;
  return static_cast<double>(
             __builtin_popcountll((seen_[cell] | seen_[next]) & between)) /
         count;
}

bool
RiserBins::isSeen(std::size_t cell, double low, double high) const
{
  const auto from =
      static_cast<int>(std::clamp(std::ceil((low - bottom_) / bin_), 0.0, 64.0));
  const auto to =
      static_cast<int>(std::clamp(std::floor((high - bottom_) / bin_), 0.0, 64.0));
  return from < to &&
         (own_[cell] & (~std::uint64_t{0} >> (64 - to + from)) << from) != 0;
}

CellPoints::CellPoints(const SheetGrid& grid,
                       const std::vector<std::uint8_t>& domain,
                       const std::vector<Eigen::Vector3d>& points,
                       std::size_t most)
    : grid_(grid)
    , domain_(domain)
    , first_(grid.count() + 1, 0)
{
  const auto cellOf = [&](const Eigen::Vector3d& p) {
    const std::size_t cell = grid.at(p.head<2>());
    return cell < grid.count() && domain[cell] && std::isfinite(p.z()) ? cell
                                                                       : grid.count();
  };
  std::vector<std::size_t> count(grid.count(), 0);
  for (const Eigen::Vector3d& p : points)
    if (const std::size_t cell = cellOf(p); cell < grid.count())
      ++count[cell];
  for (std::size_t cell = 0; cell < grid.count(); ++cell)
    first_[cell + 1] = first_[cell] + std::min(count[cell], most);
  points_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  std::vector<std::size_t> passed(grid.count(), 0);
  for (const Eigen::Vector3d& p : points)
    if (const std::size_t cell = cellOf(p);
        cell < grid.count() && isChosen(passed[cell]++, count[cell], most)) {
      points_[next[cell]++] = p;
      lowest_ = std::min(lowest_, p.z());
      highest_ = std::max(highest_, p.z());
    }
  balls_.resize(grid.count());
  for (std::size_t cell = 0; cell < grid.count(); ++cell) {
    if (isEmpty(cell))
      continue;
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d* p = begin(cell); p != end(cell); ++p)
      box.extend(*p);
    balls_[cell] = {box.center(), box.diagonal().norm() / 2};
  }
  rows_ = rowsOf(points_);
  std::vector<Eigen::Vector3d> middles;
  for (std::size_t cell = 0; cell < grid.count(); ++cell)
    if (!isEmpty(cell)) {
      seen_.push_back(cell);
      middles.push_back(balls_[cell].centre);
    }
  middles_ = rowsOf(middles);
}

std::vector<Eigen::Vector3d>
CellPoints::pointsOf(const std::vector<std::size_t>& cells, std::size_t most) const
{
  std::size_t count = 0;
  for (const std::size_t cell : cells)
    count += first_[cell + 1] - first_[cell];
  const std::size_t step = std::max<std::size_t>(1, (count + most - 1) / most);
  std::vector<Eigen::Vector3d> chosen;
  chosen.reserve(count / step + 1);
  std::size_t before = 0; // points in the cells before this one
  std::size_t next = 0;   // number of the next point to choose, over all cells
  for (const std::size_t cell : cells) {
    const std::size_t size = first_[cell + 1] - first_[cell];
    for (; next < before + size; next += step)
      chosen.push_back(points_[first_[cell] + next - before]);
    before += size;
  }
  return chosen;
}

std::vector<std::size_t>
CellPoints::window(std::size_t cell, int reach) const
{
  std::vector<std::size_t> cells;
  grid_.forAllWithin(cell, reach, [&](std::size_t near) {
    if (!isEmpty(near))
      cells.push_back(near);
  });
  return cells;
}

double
CellPoints::noise() const
{
  constexpr double least = 1e-4;
  constexpr std::size_t max_patches = 2000;
  constexpr std::size_t min_points = 10;
  const std::size_t step = grid_.count() / max_patches + 1;
  std::vector<double> deviations;
  for (std::size_t cell = 0; cell < grid_.count(); cell += step) {
    if (isEmpty(cell))
      continue;
    const auto near = pointsOf(window(cell, 1), 500);
    if (near.size() < min_points)
      continue;
    const PlanSlab plane = fitPlane(near);
    double sum = 0;
    for (const Eigen::Vector3d& p : near)
      sum += std::pow(distanceOf(plane, p), 2);
    deviations.push_back(std::sqrt(sum / static_cast<double>(near.size() - 3)));
  }
  if (deviations.empty())
    return least;
  // Many patches may lie on creases, steps and lamps.
  const auto typical =
      deviations.begin() + static_cast<std::ptrdiff_t>(deviations.size() / 3);
  std::nth_element(deviations.begin(), typical, deviations.end());
  return std::max(least, *typical);
}

} // namespace pcl::sedr
