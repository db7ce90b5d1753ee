// SPDX-License-Identifier: BSD-3-Clause
#include "loop_solver.h"

#include <algorithm>

namespace pcl::sedr {

/** @brief Returns the spans of a contour in which a label is used, with the samples
 * around them. */
std::vector<LoopSolver::Span>
LoopSolver::spansOf(std::size_t c, std::size_t label) const
{
  const std::size_t window = maker_.search().neighbours;
  const std::size_t n = labels_[c].size();
  std::vector<Span> spans;
  for (std::size_t i = 0; i < n; ++i) {
    if (labels_[c][i] != label)
      continue;
    if (spans.empty() || i > spans.back().first + spans.back().length + 2 * window)
      spans.push_back({i, 1});
    else
      spans.back().length = i + 1 - spans.back().first;
  }
  for (Span& span : spans) {
    span.first = span.first + n - std::min(n, window);
    span.length += 2 * window;
  }
  const bool is_long = std::any_of(spans.begin(), spans.end(), [&](const Span& span) {
    return span.length + 2 > n;
  });
  // The last may reach around to the first.
  if (is_long || (!spans.empty() && spans.back().first + spans.back().length + 2 >
                                        spans.front().first + n))
    spans.assign(1, {0, n});
  return spans;
}

/** @brief Returns a lower bound of the change of the energy without a curve: its
 * samples take their next best curve, and nothing that joins them costs anything. */
double
LoopSolver::leastIncrease(std::size_t label) const
{
  double change = -pool_[label].cost;
  for (const std::uint32_t number : pool_[label].samples) {
    const std::size_t c = samples_.contourOf(number);
    const std::size_t i = number - samples_.firstOf(c);
    if (labels_[c].empty() || labels_[c][i] != label)
      continue;
    const Table& table = tables_[c];
    const std::size_t n = labels_[c].size();
    double next = impossible;
    for (std::size_t a = table.cycle.first[i]; a < table.cycle.first[i + 1]; ++a)
      if (table.list[a] != label)
        next = std::min(next, table.cycle.own[a]);
    change += next - table.cycle.own[table.cycle.first[i] + table.places[i]];
    const std::size_t before = (i + n - 1) % n;
    if (labels_[c][before] != label)
      change -= jointCost(c, labels_[c][before], label, before);
    if (const std::size_t after = (i + 1) % n; labels_[c][after] != label)
      change -= jointCost(c, label, labels_[c][after], i);
  }
  return change;
}

/** @brief Solves a span of a contour again. */
void
LoopSolver::solveSpan(std::size_t c, const Span& span)
{
  Table& table = tables_[c];
  const std::size_t n = table.places.size();
  for (std::size_t k = 0; k < span.length; ++k) {
    const std::size_t i = (span.first + k) % n;
    setEntries(c, i);
    use(labels_[c][i], -1);
  }
  if (span.length == n)
    table.places = cheapestCycle(table.cycle);
  else
    cheapestWay(table.cycle, (span.first + n - 1) % n, span.length + 1, table.places);
  readLabels(c, span);
}

/** @brief Allows or forbids a curve in a span of a contour. */
void
LoopSolver::setAllowed(std::size_t c, const Span& span, std::size_t label, bool is)
{
  Table& table = tables_[c];
  const std::size_t n = table.places.size();
  for (std::size_t k = 0; k < span.length; ++k) {
    const std::size_t i = (span.first + k) % n;
    for (std::size_t a = table.cycle.first[i]; a < table.cycle.first[i + 1]; ++a)
      if (table.list[a] == label)
        table.cycle.own[a] = is ? table.cost[a] : impossible;
  }
}

/** @brief Takes a curve out, with the loops around it solved again, if the energy
 * falls.
 */
bool
LoopSolver::tryWithout(std::size_t label)
{
  struct Change {
    std::size_t contour;
    Span span;
    std::vector<std::size_t> places; ///< of the contour before
  };
  std::vector<Change> changes;
  double before = models_;
  std::size_t last = contours_.size();
  for (const std::uint32_t number : pool_[label].samples) {
    const std::size_t c = samples_.contourOf(number);
    if (c == last || labels_[c].empty())
      continue;
    last = c;
    for (const Span& span : spansOf(c, label)) {
      before += costOf(c, span);
      changes.push_back({c, span, tables_[c].places});
    }
  }
  double after = 0;
  for (const Change& change : changes) {
    setAllowed(change.contour, change.span, label, false);
    solveSpan(change.contour, change.span);
    after += costOf(change.contour, change.span);
  }
  if (after + models_ < before - 1e-6)
    return true;
  for (const auto& [c, span, places] : changes) {
    for (std::size_t k = 0; k < span.length; ++k) {
      const std::size_t i = (span.first + k) % places.size();
      use(labels_[c][i], -1);
      tables_[c].places[i] = places[i];
    }
    readLabels(c, span);
    setAllowed(c, span, label, true);
  }
  return false;
}

/** @brief Takes curves out one by one as long as the energy falls, those of few samples
 * first. */
void
LoopSolver::prune()
{
  for (int round = 0; round < 3; ++round) {
    std::vector<std::pair<std::size_t, std::size_t>> order; // samples, candidate
    for (std::size_t p = 0; p < pool_.size(); ++p)
      if (use_[p] > 0)
        order.push_back({use_[p], p});
    std::sort(order.begin(), order.end());
    bool has_fallen = false;
    for (const auto& [count, p] : order)
      has_fallen |= use_[p] > 0 && leastIncrease(p) < 0 && tryWithout(p);
    if (!has_fallen)
      return;
  }
}

} // namespace pcl::sedr
