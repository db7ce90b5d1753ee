// SPDX-License-Identifier: BSD-3-Clause
#include "loop_solver.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>

namespace pcl::sedr {

/** @brief Gives each sample of a contour its candidates: its label, and the cheapest
 * around it.
 * @param near candidates of each sample and what they cost */
void
LoopSolver::prepareContour(
    std::size_t c,
    const std::vector<std::vector<std::pair<std::size_t, float>>>& near)
{
  constexpr std::size_t half = 4; // samples: candidates are compared over twice as many
  constexpr float most = 30;      // nats
  const std::size_t n = contours_[c].samples.size();
  Table& table = tables_[c];
  table.list.clear();
  table.cost.clear();
  table.cycle = {};
  table.cycle.first.assign(1, 0);
  std::vector<std::pair<double, std::size_t>> order; // rank, place in near
  for (std::size_t i = 0; i < n; ++i) {
    const auto& here = near[i];
    order.clear();
    for (std::size_t k = 0; k < here.size(); ++k) {
      double rank = 0;
      for (const std::size_t j :
           {n - half, n - half / 2, std::size_t{0}, half / 2, half}) {
        const auto& there = near[(i + j) % n];
        const auto at =
            std::lower_bound(there.begin(), there.end(),
                             std::pair<std::size_t, float>(here[k].first, 0));
        rank += static_cast<double>(at != there.end() && at->first == here[k].first
                                        ? std::min(most, at->second)
                                        : most);
      }
      if (!labels_[c].empty() && labels_[c][i] == here[k].first)
        rank = -1;
      order.push_back({rank, k});
    }
    const std::size_t kept = std::min(maker_.search().candidates, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept),
                      order.end());
    for (std::size_t q = 0; q < kept; ++q) {
      table.list.push_back(here[order[q].second].first);
      table.cost.push_back(static_cast<double>(here[order[q].second].second));
    }
    table.cycle.first.push_back(table.list.size());
  }
  table.cycle.pairs.assign(1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    for (std::size_t a = table.cycle.first[i]; a < table.cycle.first[i + 1]; ++a)
      for (std::size_t b = table.cycle.first[j]; b < table.cycle.first[j + 1]; ++b)
        table.cycle.change.push_back(
            static_cast<float>(jointCost(c, table.list[a], table.list[b], i)));
    table.cycle.pairs.push_back(table.cycle.change.size());
  }
  table.cycle.entry.resize(table.list.size());
  table.cycle.own = table.cost;
  setPlaces(c);
}

/** @brief Prepares all contours for the present pool. */
void
LoopSolver::prepare()
{
  std::vector<std::vector<std::vector<std::pair<std::size_t, float>>>> near;
  for (const LoopContour& contour : contours_)
    near.emplace_back(contour.samples.size());
  for (std::size_t p = 0; p < pool_.size(); ++p)
    for (std::size_t k = 0; k < pool_[p].samples.size(); ++k) {
      const std::size_t i = pool_[p].samples[k];
      const std::size_t c = samples_.contourOf(i);
      near[c][i - samples_.firstOf(c)].push_back({p, pool_[p].costs[k]});
    }
  parallelBlocks(contours_.size(), 1, threads_, [&](std::size_t c, std::size_t) {
    // Where no curve is near, those of the sample before may go on.
    const std::size_t n = near[c].size();
    for (std::size_t k = 0; k < 2 * n; ++k)
      if (near[c][(k + 1) % n].empty())
        near[c][(k + 1) % n] = near[c][k % n];
    prepareContour(c, near[c]);
  });
}

/** @brief Sets what it costs to begin a run at a sample. A curve that no loop uses yet
 * is paid wherever a run of it begins: an upper bound, exact for the present loops. */
void
LoopSolver::setEntries(std::size_t c, std::size_t i)
{
  Table& table = tables_[c];
  for (std::size_t a = table.cycle.first[i]; a < table.cycle.first[i + 1]; ++a)
    table.cycle.entry[a] = use_[table.list[a]] > 0 ? 0 : pool_[table.list[a]].cost;
}

/** @brief Finds the labels of a contour among the candidates of its samples. */
void
LoopSolver::setPlaces(std::size_t c)
{
  Table& table = tables_[c];
  table.places.assign(labels_[c].size(), 0);
  for (std::size_t i = 0; i < labels_[c].size(); ++i)
    for (std::size_t a = 0; a < table.cycle.candidates(i); ++a)
      if (table.list[table.cycle.first[i] + a] == labels_[c][i])
        table.places[i] = a;
}

} // namespace pcl::sedr
