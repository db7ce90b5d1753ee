// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cycle_labels.h"
#include "loop_curve.h"
#include "loop_samples.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A curve that the loops of a storey may follow. */
struct LoopCandidate {
  PlanCurve curve;
  double cost = 0;       ///< nats, once for all loops that follow it
  bool is_known = false; ///< given, not fitted: it costs nothing and stays as it is
  double unseen = 0;     ///< share of an outlier that it costs where nobody saw a wall
  double from = -1e9;    ///< of a line: where along it evidence is near,
  double to = 1e9;       ///< metres along its direction from its point
};

/** @brief How a loop goes over from one curve to the next. */
struct LoopJoint {
  enum class Kind { Corner, Smooth, Piece };
  Kind kind = Kind::Piece;
  double cost = 0;
  Eigen::Vector2d place = Eigen::Vector2d::Zero(); ///< unless it is a piece
};

/** @brief The curves of the loops of a storey by one energy (LoopEnergy): curves are
 * proposed from the samples, each loop's labels are the cheapest cycle, curves are
 * fitted to their samples again and replaced by others, as long as the energy falls
 * (PEARL: Isack and Boykov 2012). */
class LoopSolver {
public:
  /** @param contours with their surfaces, see findSurfaces(); must outlive this
   * @param noise of the walls, see findSurfaces()
   * @param known curves that exist already and cost nothing */
  LoopSolver(std::vector<LoopContour>& contours,
             const LoopEnergy& energy,
             double spacing,
             const WallNoise& noise,
             std::vector<PlanCurve> known = {});

  /** @brief Minimises the energy, at most `rounds` times. */
  void solve(int rounds = 8);

  /** @brief Forbids a curve at samples of a contour, and solves it again. */
  void block(std::size_t contour,
             const std::vector<std::pair<std::size_t, std::size_t>>&);

  const LoopContour& contour(std::size_t c) const { return contours_[c]; }
  std::size_t contours() const { return contours_.size(); }

  /** @brief Returns the curve of each sample of a contour, as an index. */
  const std::vector<std::size_t>& labels(std::size_t c) const { return labels_[c]; }

  const LoopCandidate& candidate(std::size_t i) const { return pool_[i]; }

  LoopJoint joint(std::size_t a, std::size_t b, const Eigen::Vector2d& near) const;

  double sigma() const { return sigma_; }

  /** @brief Returns the main directions of the walls, radians modulo a quarter turn. */
  const std::vector<double>& directions() const { return directions_; }

private:
  /** @brief The candidates of a contour's samples and their costs. */
  struct Table {
    std::vector<std::size_t> near; ///< indices in the pool
    std::vector<float> cost;       ///< of each of them at each sample
    std::vector<std::size_t> list; ///< the cheapest at each sample: indices in the pool
    CycleCosts cycle;              ///< of these
  };

  using Labels = std::vector<std::vector<std::size_t>>;

  LoopCandidate candidateOf(const PlanCurve& curve) const;
  double angleFromMain(const PlanCurve& curve) const;
  std::vector<PlanCurve> snapped(const PlanCurve& curve) const;
  void setExtent(LoopCandidate& candidate) const;

  std::vector<PlanCurve> proposals(const LoopContour& contour) const;
  std::vector<PlanCurve> unseenProposals(const LoopContour& contour) const;
  std::vector<PlanCurve> distinct(std::vector<PlanCurve> curves,
                                  double tolerance) const;
  void findDirections(const std::vector<PlanCurve>& curves);

  double
  sampleCost(const LoopContour& contour, std::size_t i, std::size_t candidate) const;
  double costAt(std::size_t c, std::size_t i, std::size_t candidate) const;
  void prepare(const Labels* now);
  void prepareContour(std::size_t c, const std::vector<std::size_t>* now);
  std::vector<std::size_t> cheapest(std::size_t c);
  double leastIncrease(std::size_t candidate) const;
  double costOf(std::size_t c, const std::vector<std::size_t>& labels) const;
  double total() const;
  void assign(std::size_t c, std::vector<std::size_t> labels);
  void assignAll(const Labels& labels);
  void descend();
  double prune();
  Labels improve();
  std::vector<std::size_t> seenSamples(std::size_t c,
                                       const std::vector<std::size_t>& run) const;

  std::vector<LoopContour>& contours_;
  LoopEnergy energy_;
  double outlier_; ///< nats of a sample
  double sigma_;
  double parameter_; ///< nats of a parameter of a curve
  double corner_;    ///< nats of a change
  std::vector<double> directions_;
  std::vector<PlanCurve> known_;
  std::vector<LoopCandidate> pool_;
  std::vector<Table> tables_;
  Labels labels_;
  std::vector<double> costs_;    ///< of each contour's labels
  std::vector<std::size_t> use_; ///< contours that use each candidate
  double models_ = 0;            ///< cost of the candidates that are used
  std::vector<std::uint8_t> is_banned_;
  std::vector<std::set<std::pair<std::size_t, std::size_t>>> blocked_;
};

} // namespace pcl::sedr
