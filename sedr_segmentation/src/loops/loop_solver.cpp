// SPDX-License-Identifier: BSD-3-Clause
#include "loop_solver.h"

#include "../faces/wall_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl::sedr {

namespace {

constexpr std::size_t max_labels = 16;  // candidates of a sample
constexpr double impossible = 1e9;      // nats
constexpr double longest_extension = 3; // metres

} // namespace

LoopSolver::LoopSolver(std::vector<LoopContour>& contours,
                       const LoopEnergy& energy,
                       double spacing,
                       const WallNoise& noise,
                       std::vector<PlanCurve> known)
    : contours_(contours)
    , energy_(energy)
    , outlier_(energy.outlier * spacing / noise.correlation)
    , sigma_(noise.sigma)
    , parameter_(std::log(energy.reach / noise.sigma))
    , corner_(0)
    , known_(std::move(known))
    , blocked_(contours.size())
{
  std::vector<double> sizes;
  for (const LoopContour& contour : contours_)
    sizes.push_back(static_cast<double>(contour.samples.size()));
  std::sort(sizes.begin(), sizes.end());
  corner_ = std::log(std::max(20.0, sizes.empty() ? 0 : sizes[sizes.size() / 2]));
}

double
LoopSolver::sampleCost(const LoopContour& contour,
                       std::size_t i,
                       std::size_t candidate) const
{
  const LoopCandidate& c = pool_[candidate];
  const LoopSample& sample = contour.samples[i];
  if (c.curve.distance(sample.place) > energy_.reach)
    return impossible;
  const Eigen::Vector2d foot = c.curve.project(sample.place);
  if (!c.curve.isCircle()) {
    const double s = (foot - c.curve.point).dot(c.curve.direction);
    if (s < c.from || s > c.to)
      return impossible;
  }
  const AreaTable table;
  double unexplained = 1;
  if (sample.seen > 0)
    for (std::size_t q = 0; q < sample.weight.size(); ++q)
      if (sample.before[q] < 1) {
        const double d =
            c.curve.distance(sample.place + sample.offset[q] * sample.normal) /
            (3 * sigma_);
        unexplained = std::min(unexplained, sample.before[q] + d * d);
      }
  const double t = (foot - sample.place).dot(sample.normal);
  return outlier_ * (sample.seen * unexplained + (1 - sample.seen) * c.unseen) +
         contour.area[i * static_cast<std::size_t>(table.columns()) +
                      static_cast<std::size_t>(table.at(t))];
}

LoopJoint
LoopSolver::joint(std::size_t a, std::size_t b, const Eigen::Vector2d& near) const
{
  const PlanCurve& first = pool_[a].curve;
  const PlanCurve& second = pool_[b].curve;
  const Eigen::Vector2d end = first.project(near);
  const Eigen::Vector2d start = second.project(near);
  const double gap = (end - start).norm();
  LoopJoint best;
  best.cost = 2 * corner_ + energy_.bend * gap;
  Eigen::Vector2d place;
  if (meet(first, second, near, place)) {
    const double length = (place - end).norm() + (place - start).norm();
    const double cost =
        corner_ + energy_.bend / 2 * std::max(0.0, length - energy_.free_extension);
    if (length < longest_extension && cost < best.cost)
      best = {LoopJoint::Kind::Corner, cost, place};
  }
  if ((first.isCircle() || second.isCircle()) && gap < 2 * sigma_) {
    const double cost = corner_ + 0.5 * (gap / sigma_) * (gap / sigma_);
    if (cost < best.cost - (best.kind == LoopJoint::Kind::Corner ? 1 : 0))
      best = {LoopJoint::Kind::Smooth, cost, (end + start) / 2};
  }
  return best;
}

double
LoopSolver::costAt(std::size_t c, std::size_t i, std::size_t candidate) const
{
  const Table& table = tables_[c];
  const auto at = std::lower_bound(table.near.begin(), table.near.end(), candidate);
  if (at == table.near.end() || *at != candidate)
    return impossible;
  return table
      .cost[i * table.near.size() + static_cast<std::size_t>(at - table.near.begin())];
}

void
LoopSolver::prepareContour(std::size_t c, const std::vector<std::size_t>* now)
{
  const LoopContour& contour = contours_[c];
  const std::size_t n = contour.samples.size();
  Table& table = tables_[c];
  table = {};
  std::vector<float> column(n);
  std::vector<std::vector<float>> columns;
  for (std::size_t p = 0; p < pool_.size(); ++p) {
    bool is_near = false;
    for (std::size_t i = 0; i < n; ++i) {
      column[i] = static_cast<float>(sampleCost(contour, i, p));
      is_near = is_near || column[i] < impossible;
    }
    if (!is_near)
      continue;
    table.near.push_back(p);
    columns.push_back(column);
  }
  const std::size_t m = table.near.size();
  table.cost.resize(n * m);
  for (std::size_t p = 0; p < m; ++p)
    for (std::size_t i = 0; i < n; ++i)
      table.cost[i * m + p] = columns[p][i];
  // The cheapest around each sample compete.
  const std::size_t k = std::min(max_labels, m);
  table.list.assign(n * k, 0);
  std::vector<std::vector<float>> rank(m, std::vector<float>(n));
  for (std::size_t p = 0; p < m; ++p) {
    const auto mean = [&](std::size_t i, std::size_t half) {
      double sum = 0;
      for (std::size_t j = 0; j <= 2 * half; ++j)
        sum += std::min(30.0f, columns[p][(i + n * half + j - half) % n]);
      return sum / static_cast<double>(2 * half + 1);
    };
    for (std::size_t i = 0; i < n; ++i)
      rank[p][i] = static_cast<float>(std::min(mean(i, 2), mean(i, 10) + 1));
  }
  std::vector<std::size_t> order(m);
  for (std::size_t i = 0; i < n; ++i) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t p) {
      return now && (*now)[i] == table.near[p] ? -1.0f : rank[p][i];
    };
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k),
                      order.end(), [&](std::size_t a, std::size_t b) {
                        return std::make_pair(key(a), a) < std::make_pair(key(b), b);
                      });
    for (std::size_t q = 0; q < k; ++q)
      table.list[i * k + q] = order[q];
  }
  table.cycle.labels = k;
  table.cycle.own.resize(n * k);
  table.cycle.entry.resize(n * k);
  table.cycle.change.resize(n * k * k);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const Eigen::Vector2d near =
        (contour.samples[i].place + contour.samples[j].place) / 2;
    for (std::size_t a = 0; a < k; ++a) {
      const std::size_t from = table.near[table.list[i * k + a]];
      table.cycle.own[i * k + a] = table.cost[i * m + table.list[i * k + a]];
      for (std::size_t b = 0; b < k; ++b) {
        const std::size_t to = table.near[table.list[j * k + b]];
        table.cycle.change[(i * k + a) * k + b] =
            from == to ? 0 : joint(from, to, near).cost;
      }
    }
  }
  for (std::size_t& entry : table.list)
    entry = table.near[entry];
}

void
LoopSolver::prepare(const Labels* now)
{
  tables_.resize(contours_.size());
  for (std::size_t c = 0; c < contours_.size(); ++c)
    prepareContour(c, now ? &(*now)[c] : nullptr);
  is_banned_.assign(pool_.size(), 0);
  for (auto& blocked : blocked_)
    blocked.clear();
}

std::vector<std::size_t>
LoopSolver::cheapest(std::size_t c)
{
  Table& table = tables_[c];
  const std::size_t k = table.cycle.labels;
  const std::size_t n = table.cycle.places();
  CycleCosts& costs = table.cycle;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t a = 0; a < k; ++a) {
      const std::size_t label = table.list[i * k + a];
      const bool is_out = is_banned_[label] || blocked_[c].count({i, label}) > 0;
      costs.own[i * k + a] = is_out ? impossible : costAt(c, i, label);
      // A curve that no loop uses yet is paid wherever a run of it begins: an upper
      // bound, exact for the present loops.
      costs.entry[i * k + a] = use_[label] > 0 ? 0 : pool_[label].cost;
    }
  std::vector<std::size_t> labels = cheapestCycle(costs);
  for (std::size_t i = 0; i < n; ++i)
    labels[i] = table.list[i * k + labels[i]];
  return labels;
}

double
LoopSolver::costOf(std::size_t c, const std::vector<std::size_t>& labels) const
{
  const LoopContour& contour = contours_[c];
  const std::size_t n = labels.size();
  double cost = 0;
  for (std::size_t i = 0; i < n; ++i) {
    cost += costAt(c, i, labels[i]);
    const std::size_t before = (i + n - 1) % n;
    if (labels[before] != labels[i])
      cost += joint(labels[before], labels[i],
                    (contour.samples[before].place + contour.samples[i].place) / 2)
                  .cost;
  }
  return cost;
}

double
LoopSolver::total() const
{
  return std::accumulate(costs_.begin(), costs_.end(), models_);
}

/** @brief Gives a contour its labels, and counts which candidates are used. */
void
LoopSolver::assign(std::size_t c, std::vector<std::size_t> labels)
{
  const auto distinctOf = [](std::vector<std::size_t> all) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  };
  for (const std::size_t label : distinctOf(labels_[c]))
    if (--use_[label] == 0)
      models_ -= pool_[label].cost;
  for (const std::size_t label : distinctOf(labels))
    if (use_[label]++ == 0)
      models_ += pool_[label].cost;
  labels_[c] = std::move(labels);
  costs_[c] = labels_[c].empty() ? 0 : costOf(c, labels_[c]);
}

/** @brief Gives all contours their labels in a new pool. */
void
LoopSolver::assignAll(const Labels& labels)
{
  labels_.assign(contours_.size(), {});
  costs_.assign(contours_.size(), 0);
  use_.assign(pool_.size(), 0);
  models_ = 0;
  for (std::size_t c = 0; c < contours_.size(); ++c)
    assign(c, labels[c]);
}

/** @brief Solves the loops one by one; none may cost more than before. */
void
LoopSolver::descend()
{
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    if (tables_[c].cycle.labels == 0)
      continue;
    const std::vector<std::size_t> before = labels_[c];
    const double energy = total();
    assign(c, cheapest(c));
    if (!before.empty() && total() > energy)
      assign(c, before);
  }
}

/** @brief Returns a lower bound of the change of the energy if a curve was banned: its
 * samples take their next best curve, and nothing that joins them costs anything. */
double
LoopSolver::leastIncrease(std::size_t candidate) const
{
  double change = -pool_[candidate].cost;
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    const Table& table = tables_[c];
    const std::size_t k = table.cycle.labels;
    const std::size_t n = labels_[c].size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = labels_[c][(i + n - 1) % n];
      if (before != labels_[c][i] &&
          (labels_[c][i] == candidate || before == candidate))
        change -= joint(before, labels_[c][i],
                        (contours_[c].samples[(i + n - 1) % n].place +
                         contours_[c].samples[i].place) /
                            2)
                      .cost;
      if (labels_[c][i] != candidate)
        continue;
      double next = impossible;
      for (std::size_t a = 0; a < k; ++a)
        if (const std::size_t other = table.list[i * k + a];
            other != candidate && !is_banned_[other])
          next = std::min(next, costAt(c, i, other));
      change += next - costAt(c, i, candidate);
    }
  }
  return change;
}

/** @brief Takes curves out one by one as long as the energy falls. */
double
LoopSolver::prune()
{
  double energy = total();
  for (int round = 0; round < 3; ++round) {
    bool has_fallen = false;
    std::vector<std::pair<std::size_t, std::size_t>> order; // samples, candidate
    std::vector<std::size_t> samples(pool_.size(), 0);
    for (const auto& labels : labels_)
      for (const std::size_t label : labels)
        ++samples[label];
    for (std::size_t p = 0; p < pool_.size(); ++p)
      if (samples[p] > 0)
        order.push_back({samples[p], p});
    std::sort(order.begin(), order.end());
    for (const auto& [count, p] : order) {
      if (use_[p] == 0 || leastIncrease(p) > 0)
        continue;
      std::vector<std::pair<std::size_t, std::vector<std::size_t>>> before;
      is_banned_[p] = 1;
      for (std::size_t c = 0; c < contours_.size(); ++c)
        if (std::find(labels_[c].begin(), labels_[c].end(), p) != labels_[c].end()) {
          before.push_back({c, labels_[c]});
          assign(c, cheapest(c));
        }
      if (const double now = total(); now < energy - 1e-6) {
        energy = now;
        has_fallen = true;
        continue;
      }
      is_banned_[p] = 0;
      for (auto& [c, labels] : before)
        assign(c, std::move(labels));
    }
    if (!has_fallen)
      break;
  }
  return energy;
}

std::vector<std::size_t>
LoopSolver::seenSamples(std::size_t c, const std::vector<std::size_t>& run) const
{
  std::vector<std::size_t> seen;
  for (const std::size_t i : run)
    if (contours_[c].samples[i].isSeen())
      seen.push_back(i);
  return seen;
}

void
LoopSolver::solve(int rounds)
{
  std::vector<PlanCurve> curves;
  for (const LoopContour& contour : contours_)
    for (PlanCurve& curve : proposals(contour))
      curves.push_back(std::move(curve));
  curves = distinct(std::move(curves), 1.5);
  findDirections(curves);
  for (const LoopContour& contour : contours_)
    for (PlanCurve& curve : unseenProposals(contour))
      curves.push_back(std::move(curve));
  const std::size_t count = curves.size();
  for (std::size_t i = 0; i < count; ++i)
    for (const PlanCurve& turned : snapped(curves[i]))
      curves.push_back(turned);
  pool_.clear();
  for (const PlanCurve& curve : known_) {
    LoopCandidate candidate;
    candidate.curve = curve;
    candidate.is_known = true;
    pool_.push_back(candidate);
  }
  for (const PlanCurve& curve : curves)
    pool_.push_back(candidateOf(curve));
  prepare(nullptr);
  assignAll(Labels(contours_.size()));
  descend();
  double energy = prune();
  for (int round = 0; round < rounds; ++round) {
    const std::vector<LoopCandidate> pool = pool_;
    const Labels labels = labels_;
    const Labels now = improve();
    prepare(&now);
    assignAll(now);
    descend();
    const double less = prune();
    if (less > energy - 0.5) {
      if (less > energy) {
        pool_ = pool;
        prepare(&labels);
        assignAll(labels);
      }
      break;
    }
    energy = less;
  }
}

void
LoopSolver::block(std::size_t contour,
                  const std::vector<std::pair<std::size_t, std::size_t>>& places)
{
  blocked_[contour].insert(places.begin(), places.end());
  assign(contour, cheapest(contour));
}

} // namespace pcl::sedr
