// SPDX-License-Identifier: BSD-3-Clause
#include "loop_solver.h"

#include "../curves/fitted_curve.h"
#include "loop_proposals.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

LoopSolver::LoopSolver(const std::vector<LoopContour>& contours,
                       const std::vector<WallLine>& lines,
                       const LoopEnergy& energy,
                       double spacing,
                       const WallNoise& noise,
                       unsigned threads)
    : contours_(contours)
    , lines_(lines)
    , samples_(contours)
    , maker_(samples_, energy, spacing, noise)
    , threads_(threads)
    , corner_(std::log(energy.wall / spacing))
    , tables_(contours.size())
    , labels_(contours.size())
{}

LoopJoint
LoopSolver::joint(const LoopCandidate& from,
                  const LoopCandidate& to,
                  const Eigen::Vector2d& near) const
{
  const LoopEnergy& energy = maker_.energy();
  const double corner = corner_;
  const double sigma = maker_.sigma();
  const PlanCurve& first = from.curve();
  const PlanCurve& second = to.curve();
  const Eigen::Vector2d end = first.project(near);
  const Eigen::Vector2d start = second.project(near);
  const double gap = (end - start).norm();
  LoopJoint best;
  best.cost = 2 * corner + maker_.parameter() + energy.bend * gap;
  Eigen::Vector2d place;
  if (meet(first, second, near, place)) {
    const double length = (place - end).norm() + (place - start).norm();
    const double cost =
        corner + energy.bend / 2 * std::max(0.0, length - energy.free_extension);
    if (length < maker_.search().max_extension && cost < best.cost)
      best = {LoopJoint::Kind::Corner, cost, place};
  }
  if ((first.isCircle() || second.isCircle()) && gap < 2 * sigma) {
    const double cost = corner + 0.5 * (gap / sigma) * (gap / sigma);
    if (cost < best.cost - (best.kind == LoopJoint::Kind::Corner ? 1 : 0))
      best = {LoopJoint::Kind::Smooth, cost, (end + start) / 2};
  }
  return best;
}

/** @brief Returns what the change from a candidate of a sample to one of the next
 * costs. */
double
LoopSolver::jointCost(std::size_t c,
                      std::size_t from,
                      std::size_t to,
                      std::size_t i) const
{
  if (from == to)
    return 0;
  const auto& samples = contours_[c].samples;
  const Eigen::Vector2d near =
      (samples[i].place + samples[(i + 1) % samples.size()].place) / 2;
  return joint(pool_[from], pool_[to], near).cost;
}

void
LoopSolver::use(std::size_t label, int count)
{
  if (use_[label] == 0)
    models_ += pool_[label].cost;
  use_[label] += static_cast<std::size_t>(count);
  if (use_[label] == 0)
    models_ -= pool_[label].cost;
}

void
LoopSolver::useLabels(std::size_t c, int count)
{
  for (const std::size_t label : labels_[c])
    use(label, count);
}

/** @brief Returns what the samples of a span and the changes to, within and from it
 * cost. */
double
LoopSolver::costOf(std::size_t c, const Span& span) const
{
  const Table& table = tables_[c];
  const std::size_t n = labels_[c].size();
  double cost = 0;
  for (std::size_t k = 0; k < span.length; ++k) {
    const std::size_t i = (span.first + k) % n;
    cost += table.cycle.own[table.cycle.first[i] + table.places[i]];
  }
  const std::size_t changes = std::min(n, span.length + 1);
  for (std::size_t k = 0; k < changes; ++k) {
    const std::size_t i = (span.first + n - 1 + k) % n;
    const std::size_t j = (i + 1) % n;
    cost += static_cast<double>(
        table.cycle
            .change[table.cycle.pairs[i] + table.places[i] * table.cycle.candidates(j) +
                    table.places[j]]);
  }
  return cost;
}

double
LoopSolver::total() const
{
  double sum = models_;
  for (std::size_t c = 0; c < labels_.size(); ++c)
    if (!labels_[c].empty())
      sum += costOf(c, {0, labels_[c].size()});
  return sum;
}

/** @brief Sets the labels of a span from its candidates, and uses them. */
void
LoopSolver::readLabels(std::size_t c, const Span& span)
{
  const Table& table = tables_[c];
  const std::size_t n = table.places.size();
  for (std::size_t k = 0; k < span.length; ++k) {
    const std::size_t i = (span.first + k) % n;
    labels_[c][i] = table.list[table.cycle.first[i] + table.places[i]];
    use(labels_[c][i], 1);
  }
}

/** @brief Solves all loops anew, and keeps those that cost less than before. */
void
LoopSolver::descend()
{
  std::vector<std::vector<std::size_t>> found(contours_.size());
  parallelBlocks(contours_.size(), 1, threads_, [&](std::size_t c, std::size_t) {
    const CycleCosts& cycle = tables_[c].cycle;
    for (std::size_t i = 0; i < cycle.places(); ++i)
      if (cycle.candidates(i) == 0)
        return;
    for (std::size_t i = 0; i < cycle.places(); ++i)
      setEntries(c, i);
    found[c] = cheapestCycle(cycle);
  });
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    if (found[c].empty())
      continue;
    const std::size_t n = found[c].size();
    const bool is_first = labels_[c].empty();
    const std::vector<std::size_t> labels = labels_[c];
    const std::vector<std::size_t> places = tables_[c].places;
    const double before = is_first ? 0 : models_ + costOf(c, {0, n});
    useLabels(c, -1);
    tables_[c].places = std::move(found[c]);
    labels_[c].resize(n);
    readLabels(c, {0, n});
    if (is_first || models_ + costOf(c, {0, n}) < before)
      continue;
    useLabels(c, -1);
    labels_[c] = labels;
    tables_[c].places = places;
    useLabels(c, 1);
  }
}

/** @brief Replaces the pool by the curves used and more. */
void
LoopSolver::renew(std::vector<LoopCandidate> more)
{
  std::vector<std::size_t> place(pool_.size(), 0);
  std::vector<LoopCandidate> pool;
  for (std::size_t p = 0; p < pool_.size(); ++p)
    if (use_[p] > 0) {
      place[p] = pool.size();
      pool.push_back(std::move(pool_[p]));
    }
  for (LoopCandidate& candidate : more)
    pool.push_back(std::move(candidate));
  pool_ = std::move(pool);
  use_.assign(pool_.size(), 0);
  models_ = 0;
  for (std::size_t c = 0; c < labels_.size(); ++c) {
    for (std::size_t& label : labels_[c])
      label = place[label];
    useLabels(c, 1);
  }
  prepare();
}

void
LoopSolver::solve()
{
  constexpr int rounds = 8;
  renew(proposedCurves(contours_, lines_, maker_));
  descend(); // each loop by itself,
  descend(); // then with the curves of all
  prune();
  double energy = total();
  for (int round = 0; round < rounds; ++round) {
    std::vector<LoopCandidate> more = improvements();
    if (more.empty())
      break;
    renew(std::move(more));
    descend();
    prune();
    const double less = total();
    if (less > energy - maker_.search().least_fall)
      break;
    energy = less;
  }
}

} // namespace pcl::sedr
