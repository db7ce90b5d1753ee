// SPDX-License-Identifier: BSD-3-Clause
#include "link_views.h"

#include "../walls/wall_cells.h"
#include "link_fit.h"

#include <algorithm>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the number of points per metre along every link. */
std::vector<double>
densitiesOf(const LoopChain& chain,
            const PlanPoints& evidence,
            const LoopParameters& parameters)
{
  const double min_length = parameters.priors.evidence_cell / 10;
  std::vector<double> densities;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const double length = chain.element(i).length();
    densities.push_back(
        length < min_length
            ? 0
            : static_cast<double>(pointsAlong(chain, i, evidence, parameters).size()) /
                  length);
  }
  return densities;
}

} // namespace

std::vector<double>
sharesSeen(const LoopChain& chain,
           const PlanPoints& evidence,
           const LoopParameters& parameters)
{
  const std::vector<double> densities = densitiesOf(chain, evidence, parameters);
  std::vector<std::pair<double, double>> ordered; // densities and lengths
  double all = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    ordered.emplace_back(densities[i], chain.element(i).length());
    all += ordered.back().second;
  }
  std::sort(ordered.begin(), ordered.end());
  double usual = 0;
  double length = 0;
  for (const auto& [density, own] : ordered) {
    length += own;
    usual = density;
    if (2 * length >= all)
      break;
  }
  std::vector<double> shares;
  for (std::size_t i = 0; i < chain.size(); ++i)
    shares.push_back(usual > 0 && !chain.links[i].is_known ? densities[i] / usual : 1);
  return shares;
}

bool
isSeenInPart(const LoopChain& chain,
             std::size_t i,
             const PlanPoints& evidence,
             const LoopParameters& parameters)
{
  const PlanElement e = chain.element(i);
  WallCells cells(0, e.length(), parameters.priors.evidence_cell);
  for (const WeightedPoint& p : pointsAlong(chain, i, evidence, parameters))
    cells.add(e.project(p.position));
  return cells.shareSeen() < parameters.priors.share_half;
}

} // namespace pcl::sedr
