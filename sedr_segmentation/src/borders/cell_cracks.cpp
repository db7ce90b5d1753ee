// SPDX-License-Identifier: BSD-3-Clause
#include "cell_cracks.h"

#include "../curves/contour.h"
#include "../surface/cell_points.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Cuts the contours of pieces into chains, each known to both its pieces. */
class CrackTracer {
public:
  CrackTracer(const SheetGrid& grid, CellCracks& cracks)
      : grid_(grid)
      , cracks_(cracks)
  {}

  void trace(std::int32_t own, const std::vector<std::size_t>& cells)
  {
    const auto cellOf = [&](std::size_t cell) {
      return Cell{grid_.columnOf(cell), grid_.rowOf(cell)};
    };
    CellBox box{cellOf(cells.front()), cellOf(cells.front())};
    for (const std::size_t cell : cells)
      box = around(box, {cellOf(cell), cellOf(cell)});
    CellMask mask(grown(box, 1));
    for (const std::size_t cell : cells)
      mask.set(cellOf(cell), 1);
    for (const Contour& contour : traceContours(mask, 1)) {
      std::vector<CrackVertex> v;
      for (const Eigen::Vector2d& p : contour)
        v.push_back({static_cast<int>(p.x()), static_cast<int>(p.y())});
      // From a node on, or from the same place as the piece beyond.
      const auto node = std::find_if(v.begin(), v.end(),
                                     [&](const CrackVertex& at) { return isNode(at); });
      std::rotate(v.begin(),
                  node != v.end() ? node : std::min_element(v.begin(), v.end()),
                  v.end());
      v.push_back(v.front());
      std::vector<ChainUse> loop;
      for (std::size_t first = 0; first + 1 < v.size();) {
        std::size_t last = first + 1;
        while (last + 1 < v.size() && !isNode(v[last]))
          ++last;
        loop.push_back(use(own, {v.begin() + static_cast<std::ptrdiff_t>(first),
                                 v.begin() + static_cast<std::ptrdiff_t>(last) + 1}));
        first = last;
      }
      cracks_.loops[static_cast<std::size_t>(own)].push_back(std::move(loop));
    }
  }

private:
  using Side = std::pair<CrackVertex, CrackVertex>;

  std::int32_t pieceAt(int x, int y) const
  {
    return grid_.holds(x, y) ? cracks_.piece[grid_.indexOf(x, y)] : -1;
  }

  /** @brief Whether other than two sides between pieces end at a corner. */
  bool isNode(const CrackVertex& v) const
  {
    const std::int32_t about[] = {pieceAt(v.x - 1, v.y - 1), pieceAt(v.x, v.y - 1),
                                  pieceAt(v.x, v.y), pieceAt(v.x - 1, v.y)};
    int sides = 0;
    for (int k = 0; k < 4; ++k)
      sides += about[k] != about[(k + 1) % 4] ? 1 : 0;
    return sides != 2;
  }

  /** @brief The chain along some corners with a piece on its left: that of the piece
   * beyond, or a new one. */
  ChainUse use(std::int32_t own, std::vector<CrackVertex> v)
  {
    const std::size_t n = v.size();
    const Side key =
        std::min(Side(std::minmax(v[0], v[1])), Side(std::minmax(v[n - 2], v[n - 1])));
    const auto [known, is_new] = chain_of_.emplace(key, cracks_.chains.size());
    if (!is_new)
      return {known->second, false};
    const CrackVertex way{v[1].x - v[0].x, v[1].y - v[0].y};
    // The cell on the right: that north-east of the corner, moved back or down.
    const std::int32_t right = pieceAt(v[0].x - (way.x < 0 || way.y < 0 ? 1 : 0),
                                       v[0].y - (way.x > 0 || way.y < 0 ? 1 : 0));
    cracks_.chains.push_back({std::move(v), own, right});
    return {known->second, true};
  }

  const SheetGrid& grid_;
  CellCracks& cracks_;
  std::map<Side, std::size_t> chain_of_; ///< by one of its sides at an end
};

} // namespace

CellCracks
cracksOf(const SheetGrid& grid, const std::vector<std::int32_t>& label)
{
  CellCracks cracks;
  cracks.piece.assign(grid.count(), -1);
  const std::vector<std::vector<std::size_t>> pieces = piecesOf(grid, label);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    for (const std::size_t cell : pieces[k])
      cracks.piece[cell] = static_cast<std::int32_t>(k);
    cracks.first_cell.push_back(pieces[k].front());
  }
  cracks.loops.resize(pieces.size());
  CrackTracer tracer(grid, cracks);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    tracer.trace(static_cast<std::int32_t>(k), pieces[k]);
  return cracks;
}

namespace {

constexpr int max_steps = 15;

Eigen::Vector2d
gradientOf(const PlanSlab& slab, const Eigen::Vector2d& p)
{
  if (slab.curve)
    return slab.curve->gradientAt(p);
  return -slab.plane.head<2>() / slab.plane[2];
}

} // namespace

std::pair<double, Eigen::Vector2d>
BorderPart::sideOf(const Eigen::Vector2d& p) const
{
  if (!meets())
    return {normal.dot(p - through), normal};
  const Eigen::Vector2d slope = gradientOf(*one, p) - gradientOf(*other, p);
  const double size = std::max(slope.norm(), 1e-6);
  return {(one->heightAt(p) - other->heightAt(p)) / size, slope / size};
}

std::optional<Eigen::Vector2d>
BorderPart::project(const Eigen::Vector2d& from, double farthest) const
{
  constexpr double exact = 1e-6;
  Eigen::Vector2d p = from;
  for (int step = 0; step < max_steps; ++step) {
    const auto [off, way] = sideOf(p);
    if (std::abs(off) < exact)
      return p;
    if (!(std::abs(off) < 2 * farthest))
      return std::nullopt;
    p -= off * way;
    if ((p - from).norm() > farthest)
      return std::nullopt;
  }
  return std::abs(sideOf(p).first) < border_tolerance
             ? std::optional<Eigen::Vector2d>(p)
             : std::nullopt;
}

std::optional<Eigen::Vector2d>
crossing(const BorderPart& a,
         const BorderPart& b,
         const Eigen::Vector2d& near,
         double farthest)
{
  constexpr double min_angle = 0.15; // sine
  Eigen::Vector2d p = near;
  for (int step = 0; step < max_steps; ++step) {
    const auto [off_a, way_a] = a.sideOf(p);
    const auto [off_b, way_b] = b.sideOf(p);
    Eigen::Matrix2d rows;
    rows << way_a.transpose(), way_b.transpose();
    if (std::abs(rows.determinant()) < min_angle)
      return std::nullopt;
    const Eigen::Vector2d move = rows.inverse() * Eigen::Vector2d(off_a, off_b);
    p -= move;
    if (!p.allFinite() || (p - near).norm() > farthest)
      return std::nullopt;
    if (move.norm() < 1e-7)
      return p;
  }
  return std::nullopt;
}

} // namespace pcl::sedr
