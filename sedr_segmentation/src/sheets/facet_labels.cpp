// SPDX-License-Identifier: BSD-3-Clause
#include "facet_labels.h"

#include "minimum_cut.h"
#include "shape_fit.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief The borders between cells of the domain, and what they cost. */
class Borders {
public:
  Borders(const std::vector<FacetCosts>& facets, const FacetEvidence& evidence)
      : facets_(facets)
      , cells_(evidence.cells)
      , parameters_(evidence.parameters)
  {}

  /** @brief Calls `use(a, b)` for all neighbours in the domain. */
  template <typename Use>
  void forAll(Use use) const
  {
    const SheetGrid& grid = cells_.grid();
    for (int y = 0; y < grid.rows; ++y)
      for (int x = 0; x < grid.columns; ++x) {
        const std::size_t cell = grid.indexOf(x, y);
        if (!cells_.isInside(cell))
          continue;
        if (x + 1 < grid.columns && cells_.isInside(cell + 1))
          use(cell, cell + 1);
        if (y + 1 < grid.rows && cells_.isInside(grid.indexOf(x, y + 1)))
          use(cell, grid.indexOf(x, y + 1));
      }
  }

  double
  costOf(std::size_t cell, std::size_t next, std::int32_t one, std::int32_t other) const
  {
    if (one == other)
      return 0;
    const auto& a = facets_[static_cast<std::size_t>(one)].height;
    const auto& b = facets_[static_cast<std::size_t>(other)].height;
    const double step =
        std::abs(static_cast<double>(a[cell]) + a[next] - b[cell] - b[next]) / 2;
    return cells_.grid().size *
           (parameters_.crease +
            parameters_.step * std::min(1.0, step / parameters_.full_step));
  }

private:
  const std::vector<FacetCosts>& facets_;
  const CellPoints& cells_;
  const SheetParameters& parameters_;
};

} // namespace

FacetCosts
costsOf(const PlanSlab& facet, const FacetEvidence& evidence)
{
  const CellPoints& cells = evidence.cells;
  const SheetGrid& grid = cells.grid();
  const double weight = evidence.weight();
  const double outlier = evidence.parameters.outlier;
  FacetCosts costs;
  costs.cost.assign(grid.count(), 0);
  costs.height.assign(grid.count(), 0);
  for (std::size_t cell = 0; cell < grid.count(); ++cell) {
    if (!cells.isInside(cell))
      continue;
    costs.height[cell] = static_cast<float>(facet.heightAt(grid.centre(cell)));
    if (cells.isEmpty(cell))
      continue;
    double sum = 0;
    for (const Eigen::Vector3d* p = cells.begin(cell); p != cells.end(cell); ++p) {
      const double share = distanceOf(facet, *p) / evidence.deviation;
      sum += std::min(share * share / 2, outlier);
    }
    costs.cost[cell] = static_cast<float>(
        weight * sum / static_cast<double>(cells.end(cell) - cells.begin(cell)));
  }
  return costs;
}

double
energyOf(const std::vector<FacetCosts>& facets,
         const FacetEvidence& evidence,
         const std::vector<std::int32_t>& label)
{
  const CellPoints& cells = evidence.cells;
  double energy = 0;
  for (std::size_t cell = 0; cell < label.size(); ++cell)
    if (cells.isInside(cell))
      energy += facets[static_cast<std::size_t>(label[cell])].cost[cell];
  const Borders borders(facets, evidence);
  borders.forAll([&](std::size_t a, std::size_t b) {
    energy += borders.costOf(a, b, label[a], label[b]);
  });
  return energy;
}

void
labelCells(const std::vector<FacetCosts>& facets,
           const FacetEvidence& evidence,
           std::vector<std::int32_t>& label)
{
  const CellPoints& cells = evidence.cells;
  constexpr int most_sweeps = 4;
  constexpr double worth = 1e-6;
  const Borders borders(facets, evidence);
  double energy = energyOf(facets, evidence, label);
  const auto count = static_cast<std::int32_t>(facets.size());
  std::int32_t idle = 0; // expansions in a row that changed nothing
  for (std::int32_t k = 0; k < most_sweeps * count && idle < count; ++k) {
    const std::int32_t own = k % count;
    BinaryEnergy expansion(label.size());
    for (std::size_t cell = 0; cell < label.size(); ++cell)
      if (cells.isInside(cell))
        expansion.addTerm(cell,
                          facets[static_cast<std::size_t>(label[cell])].cost[cell],
                          facets[static_cast<std::size_t>(own)].cost[cell]);
    borders.forAll([&](std::size_t a, std::size_t b) {
      expansion.addPair(a, b, borders.costOf(a, b, label[a], label[b]),
                        borders.costOf(a, b, label[a], own),
                        borders.costOf(a, b, own, label[b]), 0);
    });
    const std::vector<std::uint8_t> takes = expansion.minimise();
    std::vector<std::int32_t> next = label;
    for (std::size_t cell = 0; cell < label.size(); ++cell)
      if (cells.isInside(cell) && takes[cell])
        next[cell] = own;
    const double there = energyOf(facets, evidence, next);
    ++idle;
    if (there >= energy - worth)
      continue;
    energy = there;
    label = std::move(next);
    idle = 0;
  }
}

} // namespace sedr
} // namespace pcl
