// SPDX-License-Identifier: BSD-3-Clause
#include "facet_choice.h"

#include "sheet_relief.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

constexpr ShapeKind kinds[] = {ShapeKind::Plane, ShapeKind::Cylinder, ShapeKind::Sphere,
                               ShapeKind::EllipticCylinder, ShapeKind::Ellipsoid};

/** @brief Chooses among proposals, round by round. */
class Chooser {
public:
  Chooser(const CellPoints& cells,
          const std::vector<double>& directions,
          double deviation,
          const SheetParameters& parameters)
      : cells_(cells)
      , directions_(directions)
      , deviation_(deviation)
      , parameters_(parameters)
  {
    const double weight = std::pow(cells.grid().size / parameters.patch, 2);
    for (std::size_t cell = 0; cell < cells.grid().count(); ++cell)
      if (cells.isInside(cell) && !cells.isEmpty(cell))
        patches_ += weight;
    outlier_ = static_cast<float>(weight * parameters.outlier);
    const double strays = parameters.unevenness;
    noise_ = std::sqrt(std::max(0.0, deviation * deviation - strays * strays));
  }

  FacetChoice run(std::vector<FacetProposal> proposals)
  {
    constexpr int most_rounds = 4;
    FacetChoice best;
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < most_rounds; ++round) {
      FacetChoice choice = chosen(proposals);
      if (choice.facets.empty())
        break;
      labelCells(choice.costs, cells_, parameters_, choice.label);
      refit(choice);
      const double total = totalOf(choice);
      if (total >= least - 1e-3)
        break;
      least = total;
      best = choice;
      proposals = choice.facets;
      for (FacetProposal& other : others(choice))
        proposals.push_back(std::move(other));
    }
    return best;
  }

  /** @brief What a facet's parameters cost (Schwarz 1978). */
  double penaltyOf(int parameters) const
  {
    return 0.5 * parameters * std::log(std::max(2.0, patches_));
  }

  double totalOf(const FacetChoice& choice) const
  {
    double total = energyOf(choice.costs, cells_, parameters_, choice.label);
    for (const FacetProposal& facet : choice.facets)
      total += penaltyOf(parametersOf(facet.kind));
    return total;
  }

  /** @brief What a cell with points costs that no facet explains. */
  float outlier() const { return outlier_; }

private:
  /** @brief One proposal after the other, always that which lowers the costs most. */
  FacetChoice chosen(const std::vector<FacetProposal>& proposals) const
  {
    const std::size_t count = cells_.grid().count();
    std::vector<FacetCosts> costs;
    for (const FacetProposal& facet : proposals)
      costs.push_back(costsOf(facet.slab, cells_, deviation_, parameters_));
    std::vector<float> lowest(count, 0);
    for (std::size_t cell = 0; cell < count; ++cell)
      if (cells_.isInside(cell) && !cells_.isEmpty(cell))
        lowest[cell] = outlier_;
    FacetChoice choice;
    choice.label.assign(count, 0);
    std::vector<bool> is_chosen(proposals.size(), false);
    for (;;) {
      std::size_t best = proposals.size();
      double most = 0;
      for (std::size_t k = 0; k < proposals.size(); ++k) {
        if (is_chosen[k])
          continue;
        double gain = -penaltyOf(parametersOf(proposals[k].kind));
        for (std::size_t cell = 0; cell < count; ++cell)
          gain += std::max(0.0F, lowest[cell] - costs[k].cost[cell]);
        if (gain <= most)
          continue;
        most = gain;
        best = k;
      }
      if (best == proposals.size())
        return choice;
      is_chosen[best] = true;
      for (std::size_t cell = 0; cell < count; ++cell)
        if (costs[best].cost[cell] < lowest[cell]) {
          lowest[cell] = costs[best].cost[cell];
          choice.label[cell] = static_cast<std::int32_t>(choice.facets.size());
        }
      choice.facets.push_back(proposals[best]);
      choice.costs.push_back(costs[best]);
    }
  }

  std::vector<std::vector<std::size_t>> cellsOf(const FacetChoice& choice) const
  {
    std::vector<std::vector<std::size_t>> own(choice.facets.size());
    for (std::size_t cell = 0; cell < choice.label.size(); ++cell)
      if (cells_.isInside(cell) && !cells_.isEmpty(cell))
        own[static_cast<std::size_t>(choice.label[cell])].push_back(cell);
    return own;
  }

  double costOver(const FacetProposal& facet,
                  const std::vector<std::size_t>& cells) const
  {
    const FacetCosts costs = costsOf(facet.slab, cells_, deviation_, parameters_);
    double sum = penaltyOf(parametersOf(facet.kind));
    for (const std::size_t cell : cells)
      sum += costs.cost[cell];
    return sum;
  }

  /** @brief Of all shapes through some cells the one that costs least. */
  FacetProposal bestShape(const FacetProposal& known,
                          const std::vector<std::size_t>& own) const
  {
    FacetProposal best = known;
    double least = costOver(known, own);
    if (own.size() < 10)
      return best;
    const auto consider = [&](FacetProposal facet) {
      if (!isBuilt(facet, parameters_))
        return;
      const double cost = costOver(facet, own);
      if (cost >= least)
        return;
      least = cost;
      best = std::move(facet);
    };
    FacetProposal refined = known;
    refineShape(known.kind, cells_.pointsOf(own, 5000), deviation_, refined.slab);
    consider(refined);
    for (const ShapeKind kind : kinds) {
      // What is left is noise, at least: another shape must earn its parameters.
      const double cost_of_kind = penaltyOf(parametersOf(kind)) + noiseOver(own);
      if (cost_of_kind < least)
        consider(fitFacet(kind, cells_, own, directions_, deviation_));
    }
    return best;
  }

  /** @brief What the noise of the points alone costs over some cells. */
  double noiseOver(const std::vector<std::size_t>& cells) const
  {
    const double weight = outlier_ / parameters_.outlier;
    const double share = noise_ / deviation_;
    return 0.5 * share * share * weight * static_cast<double>(cells.size());
  }

  /** @brief Fits every facet to its cells, and drops those without any. */
  void refit(FacetChoice& choice) const
  {
    const auto own = cellsOf(choice);
    std::vector<std::int32_t> number(choice.facets.size(), 0);
    FacetChoice kept;
    for (std::size_t k = 0; k < choice.facets.size(); ++k) {
      if (own[k].empty())
        continue;
      number[k] = static_cast<std::int32_t>(kept.facets.size());
      kept.facets.push_back(bestShape(choice.facets[k], own[k]));
      kept.costs.push_back(
          costsOf(kept.facets.back().slab, cells_, deviation_, parameters_));
    }
    for (const std::int32_t label : choice.label)
      kept.label.push_back(number[static_cast<std::size_t>(label)]);
    choice = std::move(kept);
  }

  /** @brief Neighbouring facets as one. */
  std::vector<FacetProposal> others(const FacetChoice& choice) const
  {
    const SheetGrid& grid = cells_.grid();
    std::map<std::pair<std::int32_t, std::int32_t>, int> borders;
    for (std::size_t cell = 0; cell + 1 < choice.label.size(); ++cell)
      for (const std::size_t next :
           {cell + 1, cell + static_cast<std::size_t>(grid.columns)})
        if (next < choice.label.size() && cells_.isInside(cell) &&
            cells_.isInside(next) && choice.label[cell] != choice.label[next])
          ++borders[std::minmax(choice.label[cell], choice.label[next])];
    const auto own = cellsOf(choice);
    std::vector<FacetProposal> found;
    for (const auto& [pair, length] : borders) {
      const auto a = static_cast<std::size_t>(pair.first);
      const auto b = static_cast<std::size_t>(pair.second);
      std::vector<std::size_t> both = own[a];
      both.insert(both.end(), own[b].begin(), own[b].end());
      std::sort(both.begin(), both.end());
      if (both.size() < 10)
        continue;
      for (const ShapeKind kind : kinds) {
        constexpr std::size_t few_points = 300; // most pairs are no one shape
        constexpr double least_share = 0.8;
        FacetProposal facet =
            fitFacet(kind, cells_, both, directions_, deviation_, few_points);
        if (!isBuilt(facet, parameters_) ||
            shareExplained(facet, cells_, both, 2 * deviation_) <= least_share)
          continue;
        facet = fitFacet(kind, cells_, both, directions_, deviation_);
        if (isBuilt(facet, parameters_))
          found.push_back(std::move(facet));
      }
    }
    return found;
  }

  const CellPoints& cells_;
  const std::vector<double>& directions_;
  double deviation_;
  const SheetParameters& parameters_;
  double patches_ = 0; ///< with points
  float outlier_ = 0;
  double noise_ = 0; ///< of the points, metres
};

} // namespace

FacetChoice
chooseFacets(const CellPoints& cells,
             std::vector<FacetProposal> proposals,
             const std::vector<double>& directions,
             double deviation,
             const SheetParameters& parameters)
{
  Chooser chooser(cells, directions, deviation, parameters);
  FacetChoice choice = chooser.run(std::move(proposals));
  addReliefs(cells, deviation, parameters, chooser.outlier(), choice);
  return choice;
}

} // namespace sedr
} // namespace pcl
