// SPDX-License-Identifier: BSD-3-Clause
#include "facet_labels.h"

#include "../shapes/shape_fit.h"
#include "minimum_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief A rectangle of cells, none at first. */
using CellBox = Eigen::AlignedBox2i;

CellBox
wholeBox(const SheetGrid& grid)
{
  return {Eigen::Vector2i(0, 0), Eigen::Vector2i(grid.columns - 1, grid.rows - 1)};
}

/** @brief Calls `use(cell)` for the cells of a box, row by row. */
template <typename Use>
void
forAllIn(const SheetGrid& grid, const CellBox& box, Use use)
{
  for (int y = box.min().y(); y <= box.max().y(); ++y)
    for (int x = box.min().x(); x <= box.max().x(); ++x)
      use(grid.indexOf(x, y));
}

CellBox
grown(const SheetGrid& grid, CellBox box, int margin)
{
  box.min().array() -= margin;
  box.max().array() += margin;
  return box.intersection(wholeBox(grid));
}

/** @brief The borders between cells of the domain, and what they cost. */
class Borders {
public:
  Borders(const std::vector<FacetCosts>& facets, const FacetEvidence& evidence)
      : facets_(facets)
      , evidence_(evidence)
      , cells_(evidence.cells)
      , parameters_(evidence.parameters)
  {}

  /** @brief Calls `use(a, b)` for all neighbours in the domain of which one at least
   * lies in a box. */
  template <typename Use>
  void forAll(const CellBox& box, Use use) const
  {
    const SheetGrid& grid = cells_.grid();
    const auto useIfInside = [&](std::size_t a, int x, int y) {
      if (grid.holds(x, y) && cells_.isInside(grid.indexOf(x, y)))
        use(a, grid.indexOf(x, y));
    };
    for (int y = std::max(0, box.min().y() - 1); y <= box.max().y(); ++y)
      for (int x = std::max(0, box.min().x() - 1); x <= box.max().x(); ++x) {
        const std::size_t cell = grid.indexOf(x, y);
        if (!cells_.isInside(cell))
          continue;
        if (y >= box.min().y())
          useIfInside(cell, x + 1, y);
        if (x >= box.min().x())
          useIfInside(cell, x, y + 1);
      }
  }

  double
  costOf(std::size_t cell, std::size_t next, std::int32_t one, std::int32_t other) const
  {
    if (one == other)
      return 0;
    const auto& a = facets_[static_cast<std::size_t>(one)].height;
    const auto& b = facets_[static_cast<std::size_t>(other)].height;
    const double one_height = (static_cast<double>(a[cell]) + a[next]) / 2;
    const double other_height = (static_cast<double>(b[cell]) + b[next]) / 2;
    const auto& [low, high] = std::minmax(one_height, other_height);
    const double step = high - low;
    const bool is_beyond = (one_height > other_height) != parameters_.is_floor;
    return cells_.grid().size *
           (is_beyond ? evidence_.openShare(next, cell, low, high)
                      : evidence_.openShare(cell, next, low, high)) *
           (parameters_.crease +
            parameters_.step * std::min(1.0, step / parameters_.full_step));
  }

private:
  const std::vector<FacetCosts>& facets_;
  const FacetEvidence& evidence_;
  const CellPoints& cells_;
  const SheetParameters& parameters_;
};

} // namespace

namespace {

/** @brief What the points of a cell cost that are off a facet, if some are near it.
 * @param distanceAt of the k-th of all points from the facet */
template <typename DistanceAt>
float
costOfPoints(std::size_t cell, const FacetEvidence& evidence, DistanceAt distanceAt)
{
  const std::size_t begin = evidence.cells.first(cell);
  const std::size_t end = evidence.cells.first(cell + 1);
  const double outlier = evidence.parameters.outlier;
  double sum = 0;
  for (std::size_t k = begin; k < end; ++k) {
    const double share = distanceAt(k) / evidence.deviation;
    sum += std::min(share * share / 2, outlier);
  }
  return static_cast<float>(evidence.weight() * sum / static_cast<double>(end - begin));
}

/** @brief What a facet costs in a cell that shows none of it: a floor lies below what
 * was seen there, a ceiling above it. */
float
costOfUnseen(std::size_t cell, double height, const FacetEvidence& evidence)
{
  return evidence.isSeenBeyond(cell, height) ? evidence.outlier() : 0;
}

/** @brief The distance from the middle of a cell's points beyond which all of them are
 * outliers of a facet. */
double
farFrom(std::size_t cell, const FacetEvidence& evidence)
{
  // Distances are true to first order: beyond twice the radius all points are off.
  constexpr double surely = 2;
  return surely * evidence.cells.ball(cell).radius +
         evidence.deviation * std::sqrt(2 * evidence.parameters.outlier);
}

/** @brief Calls `use(cell, cost)` for the cells of the domain with points. */
template <typename Use>
void
forAllSeen(const PlanSlab& facet, const FacetEvidence& evidence, Use use)
{
  const CellPoints& cells = evidence.cells;
  const float outlier = evidence.outlier();
  std::size_t known =
      cells.rows().size(); // the row of points whose distances are known
  ShapeValues distances;
  const auto distanceAt = [&](std::size_t k) {
    if (k / row_size != known) {
      known = k / row_size;
      distancesOf(facet, cells.rows()[known], distances);
    }
    return distances[static_cast<Eigen::Index>(k % row_size)];
  };
  ShapeValues distance;
  auto next = cells.seen().begin();
  for (const PointRow& row : cells.middles()) {
    distancesOf(facet, row, distance);
    for (Eigen::Index i = 0; i < row.size(); ++i, ++next)
      use(*next, std::abs(distance[i]) > farFrom(*next, evidence)
                     ? outlier
                     : costOfPoints(*next, evidence, distanceAt));
  }
}

} // namespace

std::vector<CellCost>
cellsNear(const PlanSlab& facet, const FacetEvidence& evidence)
{
  std::vector<CellCost> near;
  const float outlier = evidence.outlier();
  forAllSeen(facet, evidence, [&](std::size_t cell, float cost) {
    if (cost < outlier)
      near.push_back({cell, cost});
  });
  return near;
}

float
costIn(std::size_t cell, const PlanSlab& facet, const FacetEvidence& evidence)
{
  const CellPoints& cells = evidence.cells;
  if (cells.isEmpty(cell))
    return costOfUnseen(cell, facet.heightAt(cells.grid().centre(cell)), evidence);
  if (std::abs(distanceOf(facet, cells.ball(cell).centre)) > farFrom(cell, evidence))
    return evidence.outlier();
  const Eigen::Vector3d* const points = cells.begin(cell);
  return costOfPoints(cell, evidence, [&](std::size_t k) {
    return distanceOf(facet, points[k - cells.first(cell)]);
  });
}

FacetCosts
costsOf(const PlanSlab& facet, const FacetEvidence& evidence)
{
  const CellPoints& cells = evidence.cells;
  const SheetGrid& grid = cells.grid();
  FacetCosts costs;
  costs.cost.assign(grid.count(), 0);
  costs.height.assign(grid.count(), 0);
  for (std::size_t cell = 0; cell < grid.count(); ++cell)
    if (cells.isInside(cell)) {
      costs.height[cell] = static_cast<float>(facet.heightAt(grid.centre(cell)));
      if (cells.isEmpty(cell))
        costs.cost[cell] = costOfUnseen(cell, costs.height[cell], evidence);
    }
  forAllSeen(facet, evidence, [&](std::size_t cell, float cost) {
    costs.cost[cell] = cost;
    // A wall's points are none of the facet's, but end where the ceiling is.
    if (evidence.risers && evidence.risers->isAtWall(cell) &&
        !evidence.isExplained(cost))
      costs.cost[cell] += costOfUnseen(cell, costs.height[cell], evidence);
  });
  return costs;
}

namespace {

/** @brief What the cells of a box cost, and the borders in and around it. */
double
energyWithin(const CellBox& box,
             const std::vector<FacetCosts>& facets,
             const Borders& borders,
             const CellPoints& cells,
             const std::vector<std::int32_t>& label)
{
  double energy = 0;
  forAllIn(cells.grid(), box, [&](std::size_t cell) {
    if (cells.isInside(cell))
      energy += facets[static_cast<std::size_t>(label[cell])].cost[cell];
  });
  borders.forAll(box, [&](std::size_t a, std::size_t b) {
    energy += borders.costOf(a, b, label[a], label[b]);
  });
  return energy;
}

} // namespace

double
energyOf(const std::vector<FacetCosts>& facets,
         const FacetEvidence& evidence,
         const std::vector<std::int32_t>& label)
{
  return energyWithin(wholeBox(evidence.cells.grid()), facets,
                      Borders(facets, evidence), evidence.cells, label);
}

namespace {

/** @brief About the cells that a facet has, or whose points it explains in part: where
 * it may spread. */
CellBox
reachOf(std::int32_t facet,
        const FacetCosts& costs,
        const FacetEvidence& evidence,
        const std::vector<std::int32_t>& label)
{
  constexpr double beyond = 1; // metres: over places without points
  const CellPoints& cells = evidence.cells;
  const SheetGrid& grid = cells.grid();
  CellBox box;
  for (std::size_t cell = 0; cell < label.size(); ++cell)
    if (cells.isInside(cell) &&
        (label[cell] == facet ||
         (!cells.isEmpty(cell) && costs.cost[cell] < evidence.outlier())))
      box.extend(Eigen::Vector2i(grid.columnOf(cell), grid.rowOf(cell)));
  if (box.isEmpty())
    return box;
  return grown(grid, box, static_cast<int>(std::ceil(beyond / grid.size)));
}

/** @brief The cells that one facet takes from others as it gains by them: of all such
 * choices within a box that which costs least. */
std::vector<std::size_t>
takenBy(std::int32_t own,
        const CellBox& box,
        const std::vector<FacetCosts>& facets,
        const Borders& borders,
        const CellPoints& cells,
        const std::vector<std::int32_t>& label)
{
  constexpr std::uint32_t fixed = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(label.size(), fixed); // of the cells of others
  std::vector<std::size_t> others;
  forAllIn(cells.grid(), box, [&](std::size_t cell) {
    if (!cells.isInside(cell) || label[cell] == own)
      return;
    number[cell] = static_cast<std::uint32_t>(others.size());
    others.push_back(cell);
  });
  BinaryEnergy expansion(others.size());
  const std::vector<float>& if_yes = facets[static_cast<std::size_t>(own)].cost;
  for (const std::size_t cell : others)
    expansion.addTerm(number[cell],
                      facets[static_cast<std::size_t>(label[cell])].cost[cell],
                      if_yes[cell]);
  borders.forAll(box, [&](std::size_t a, std::size_t b) {
    if (number[a] == fixed && number[b] == fixed)
      return;
    const double now = borders.costOf(a, b, label[a], label[b]);
    const double yes_no = borders.costOf(a, b, own, label[b]);
    const double no_yes = borders.costOf(a, b, label[a], own);
    if (number[b] == fixed)
      expansion.addTerm(number[a], now, yes_no);
    else if (number[a] == fixed)
      expansion.addTerm(number[b], now, no_yes);
    else // where risers are seen, two steps may cost less than one: a cut cannot tell
      expansion.addPair(number[a], number[b], std::min(now, no_yes + yes_no), no_yes,
                        yes_no, 0);
  });
  const std::vector<std::uint8_t> takes = expansion.minimise();
  std::vector<std::size_t> taken;
  for (const std::size_t cell : others)
    if (takes[number[cell]])
      taken.push_back(cell);
  return taken;
}

CellBox
boxAround(const SheetGrid& grid, const std::vector<std::size_t>& cells)
{
  CellBox box;
  for (const std::size_t cell : cells)
    box.extend(Eigen::Vector2i(grid.columnOf(cell), grid.rowOf(cell)));
  return box;
}

/** @brief Whether a cell in a box, or beside it, changed after an expansion. */
bool
hasChanged(const SheetGrid& grid,
           const CellBox& box,
           const std::vector<std::int32_t>& changed,
           std::int32_t last)
{
  bool has_changed = false;
  forAllIn(grid, grown(grid, box, 1), [&](std::size_t cell) {
    has_changed = has_changed || changed[cell] > last;
  });
  return has_changed;
}

} // namespace

void
labelCells(const std::vector<FacetCosts>& facets,
           const FacetEvidence& evidence,
           std::vector<std::int32_t>& label)
{
  constexpr int max_sweeps = 3;
  constexpr double worth = 1e-6;
  const Borders borders(facets, evidence);
  const auto count = static_cast<std::int32_t>(facets.size());
  // An expansion over cells that have not changed since the last one changes nothing.
  std::vector<std::int32_t> changed(label.size(), 0); // by which expansion
  std::vector<std::int32_t> tried(facets.size(), -1); // which was the facet's last
  for (std::int32_t k = 0; k < max_sweeps * count; ++k) {
    const auto own = static_cast<std::size_t>(k % count);
    const CellBox box = reachOf(k % count, facets[own], evidence, label);
    if (box.isEmpty() || !hasChanged(evidence.cells.grid(), box, changed, tried[own]))
      continue;
    tried[own] = k;
    const std::vector<std::size_t> taken =
        takenBy(k % count, box, facets, borders, evidence.cells, label);
    if (taken.empty())
      continue;
    std::vector<std::int32_t> next = label;
    for (const std::size_t cell : taken)
      next[cell] = k % count;
    const CellBox of_taken = boxAround(evidence.cells.grid(), taken);
    const auto energy = [&](const std::vector<std::int32_t>& of) {
      return energyWithin(of_taken, facets, borders, evidence.cells, of);
    };
    if (energy(next) >= energy(label) - worth)
      continue;
    for (const std::size_t cell : taken)
      changed[cell] = k + 1;
    tried[own] = k + 1;
    label = std::move(next);
  }
}

} // namespace pcl::sedr
