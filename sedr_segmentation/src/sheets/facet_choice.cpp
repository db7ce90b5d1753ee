// SPDX-License-Identifier: BSD-3-Clause
#include "facet_choice.h"

#include "sheet_fit.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr ShapeKind all_kinds[] = {ShapeKind::Level,
                                   ShapeKind::Plane,
                                   ShapeKind::Cylinder,
                                   ShapeKind::Sphere,
                                   ShapeKind::EllipticCylinder,
                                   ShapeKind::Ellipsoid};
constexpr int plane_kinds = 2; ///< the first ones

constexpr std::size_t min_cells = 10; ///< that another shape is tried for
constexpr double settled = 1e-4;      ///< share of its cost: a last fit follows

/** @brief Chooses among proposals, round by round. */
class Chooser {
public:
  explicit Chooser(const FacetEvidence& evidence)
      : evidence_(evidence)
      , cells_(evidence.cells)
      , kinds_(std::begin(all_kinds),
               evidence.parameters.is_floor ? std::begin(all_kinds) + plane_kinds
                                            : std::end(all_kinds))
  {
    for (std::size_t cell = 0; cell < cells_.grid().count(); ++cell)
      if (isSeen(cell))
        patches_ += evidence.weight();
  }

  FacetChoice run(std::vector<FacetProposal> proposals)
  {
    constexpr int max_rounds = 4;
    FacetChoice best;
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < max_rounds; ++round) {
      if (round > 0) {
        proposals = best.facets;
        for (FacetProposal& other : others(best))
          proposals.push_back(std::move(other));
      }
      FacetChoice choice = chosen(proposals, best.costs);
      if (choice.facets.empty())
        break;
      labelCells(choice.costs, evidence_, choice.label);
      refit(choice);
      const double total = totalOf(choice);
      if (total >= least - 1e-3)
        break;
      least = total;
      best = std::move(choice);
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
    double total = energyOf(choice.costs, evidence_, choice.label);
    for (const FacetProposal& facet : choice.facets)
      total += penaltyOf(parametersOf(facet.kind));
    return total;
  }

private:
  bool isSeen(std::size_t cell) const
  {
    return cells_.isInside(cell) && !cells_.isEmpty(cell);
  }

  /** @brief Calls `body(k)` for the numbers below n, on all threads. */
  template <typename Body>
  void forEach(std::size_t n, Body body) const
  {
    parallelBlocks(n, 1, evidence_.parameters.threads,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t k = begin; k < end; ++k)
                       body(k);
                   });
  }

  /** @brief The cells in which a facet costs less than what no facet explains. */
  std::vector<CellCost> cellsNear(const FacetCosts& facet) const
  {
    std::vector<CellCost> near;
    for (const std::size_t cell : cells_.seen())
      if (facet.cost[cell] < evidence_.outlier())
        near.push_back({cell, facet.cost[cell]});
    return near;
  }

  /** @brief One proposal after the other, always that which lowers the costs most.
   * @param known costs of the first proposals */
  FacetChoice chosen(const std::vector<FacetProposal>& proposals,
                     const std::vector<FacetCosts>& known) const
  {
    const std::size_t count = cells_.grid().count();
    std::vector<std::vector<CellCost>> near(proposals.size());
    forEach(proposals.size(), [&](std::size_t k) {
      near[k] = k < known.size() ? cellsNear(known[k])
                                 : sedr::cellsNear(proposals[k].slab, evidence_);
    });
    std::vector<float> lowest(count, 0);
    for (std::size_t cell = 0; cell < count; ++cell)
      if (isSeen(cell))
        lowest[cell] = evidence_.outlier();
    const auto gainOf = [&](std::size_t k) {
      double gain = -penaltyOf(parametersOf(proposals[k].kind));
      for (const auto& [cell, cost] : near[k])
        gain += std::max(0.0F, lowest[cell] - cost);
      return gain;
    };
    // What a proposal gains falls with every one that is taken: gains of before are
    // bounds.
    std::vector<double> gains(proposals.size());
    forEach(proposals.size(), [&](std::size_t k) { gains[k] = gainOf(k); });
    FacetChoice choice;
    std::vector<std::size_t> taken;
    choice.label.assign(count, 0);
    for (;;) {
      const auto highest = std::max_element(gains.begin(), gains.end());
      if (highest == gains.end() || *highest <= 0)
        break;
      const auto best = static_cast<std::size_t>(highest - gains.begin());
      const double bound = *highest;
      *highest = gainOf(best);
      if (*highest < bound)
        continue;
      *highest = 0;
      for (const auto& [cell, cost] : near[best])
        if (cost < lowest[cell]) {
          lowest[cell] = cost;
          choice.label[cell] = static_cast<std::int32_t>(choice.facets.size());
        }
      choice.facets.push_back(proposals[best]);
      taken.push_back(best);
    }
    choice.costs.resize(choice.facets.size());
    forEach(choice.facets.size(), [&](std::size_t k) {
      choice.costs[k] = taken[k] < known.size()
                            ? known[taken[k]]
                            : costsOf(choice.facets[k].slab, evidence_);
    });
    return choice;
  }

  std::vector<std::vector<std::size_t>> cellsOf(const FacetChoice& choice) const
  {
    std::vector<std::vector<std::size_t>> own(choice.facets.size());
    for (std::size_t cell = 0; cell < choice.label.size(); ++cell)
      if (isSeen(cell))
        own[static_cast<std::size_t>(choice.label[cell])].push_back(cell);
    return own;
  }

  double costOver(const FacetProposal& facet,
                  const std::vector<std::size_t>& cells) const
  {
    double sum = penaltyOf(parametersOf(facet.kind));
    for (const std::size_t cell : cells)
      sum += costIn(cell, facet.slab, evidence_);
    return sum;
  }

  /** @brief Of all shapes through some cells the one that costs least; none if that is
   * the known one. */
  std::optional<FacetProposal> betterShape(const FacetProposal& known,
                                           const std::vector<std::size_t>& own) const
  {
    if (own.size() < min_cells)
      return {};
    std::optional<FacetProposal> best;
    double least = costOver(known, own);
    const auto consider = [&](FacetProposal facet) {
      if (!isBuilt(facet, evidence_.parameters))
        return;
      const double cost = costOver(facet, own);
      if (cost >= least)
        return;
      least = cost;
      best = std::move(facet);
    };
    FacetProposal refined = known;
    refineShape(known.kind, cells_.pointsOf(own, 5000), evidence_.deviation,
                refined.slab, settled);
    consider(refined);
    for (const ShapeKind kind : kinds_)
      consider(fitFacet(kind, evidence_, own));
    return best;
  }

  /** @brief Fits every facet to its cells, and drops those without any. */
  void refit(FacetChoice& choice) const
  {
    const auto own = cellsOf(choice);
    forEach(own.size(), [&](std::size_t k) {
      auto better =
          own[k].empty() ? std::nullopt : betterShape(choice.facets[k], own[k]);
      if (!better)
        return;
      choice.facets[k] = std::move(*better);
      choice.costs[k] = costsOf(choice.facets[k].slab, evidence_);
    });
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < own.size(); ++k)
      if (!own[k].empty())
        kept.push_back(k);
    choice.keep(kept);
  }

  /** @brief Pairs of facets that share a border. */
  std::set<std::pair<std::size_t, std::size_t>>
  neighbours(const FacetChoice& choice) const
  {
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t cell = 0; cell < choice.label.size(); ++cell)
      cells_.grid().forAllSides(cell, [&](std::size_t next) {
        if (choice.label[cell] < choice.label[next] && cells_.isInside(cell) &&
            cells_.isInside(next))
          pairs.emplace(choice.label[cell], choice.label[next]);
      });
    return pairs;
  }

  /** @brief Neighbouring facets as one. */
  std::vector<FacetProposal> others(const FacetChoice& choice) const
  {
    constexpr std::size_t few_points = 300; // most pairs are no one shape
    const auto own = cellsOf(choice);
    const auto pairs = neighbours(choice);
    std::vector<FacetProposal> all;
    for (const auto& [a, b] : pairs) {
      std::vector<std::size_t> both = own[a];
      both.insert(both.end(), own[b].begin(), own[b].end());
      std::sort(both.begin(), both.end());
      std::vector<FacetProposal> found(both.size() < min_cells ? 0 : kinds_.size());
      forEach(found.size(), [&](std::size_t k) {
        found[k] = fitFacet(kinds_[k], evidence_, both, few_points);
      });
      for (FacetProposal& facet : found)
        if (isBuilt(facet, evidence_.parameters))
          all.push_back(std::move(facet));
    }
    return all;
  }

  const FacetEvidence& evidence_;
  const CellPoints& cells_;
  std::vector<ShapeKind> kinds_; ///< that facets may be of
  double patches_ = 0;           ///< with points
};

} // namespace

bool
FacetChoice::explains(std::size_t cell, const FacetEvidence& evidence) const
{
  return evidence.cells.isInside(cell) && !evidence.cells.isEmpty(cell) &&
         !facets.empty() &&
         evidence.isExplained(costs[static_cast<std::size_t>(label[cell])].cost[cell]);
}

void
FacetChoice::keep(const std::vector<std::size_t>& order)
{
  FacetChoice kept;
  std::vector<std::int32_t> number(facets.size(), 0);
  for (const std::size_t k : order) {
    number[k] = static_cast<std::int32_t>(kept.facets.size());
    kept.facets.push_back(std::move(facets[k]));
    kept.costs.push_back(std::move(costs[k]));
  }
  for (const std::int32_t l : label)
    kept.label.push_back(l < 0 ? l : number[static_cast<std::size_t>(l)]);
  *this = std::move(kept);
}

void
FacetChoice::sortBySize()
{
  std::vector<std::pair<std::int64_t, std::size_t>> sizes;
  for (std::size_t k = 0; k < facets.size(); ++k)
    sizes.emplace_back(0, k);
  for (const std::int32_t l : label)
    if (l >= 0)
      --sizes[static_cast<std::size_t>(l)].first;
  std::sort(sizes.begin(), sizes.end());
  std::vector<std::size_t> order;
  for (const auto& [size, k] : sizes)
    if (size < 0)
      order.push_back(k);
  keep(order);
}

FacetChoice
chooseFacets(const FacetEvidence& evidence, std::vector<FacetProposal> proposals)
{
  FacetChoice choice = Chooser(evidence).run(std::move(proposals));
  if (!evidence.parameters.is_floor)
    addReliefs(evidence, choice);
  return choice;
}

} // namespace pcl::sedr
