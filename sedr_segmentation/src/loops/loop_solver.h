// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../faces/wall_lines.h"
#include "cycle_labels.h"
#include "loop_candidates.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::sedr {

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
 * (PEARL: Isack and Boykov 2012). O(samples x candidates of each squared). The result
 * is the same for any number of threads. */
class LoopSolver {
public:
  /** @param contours with their surfaces, see findSurfaces(); must outlive this
   * @param lines of the storey's walls, the first proposals
   * @param noise of the walls, see wallNoise() */
  LoopSolver(const std::vector<LoopContour>& contours,
             const std::vector<WallLine>& lines,
             const LoopEnergy& energy,
             double spacing,
             const WallNoise& noise,
             unsigned threads);

  /** @brief Minimises the energy. */
  void solve();

  const LoopContour& contour(std::size_t c) const { return contours_[c]; }

  /** @brief Returns the curve of each sample of a contour, as an index. */
  const std::vector<std::size_t>& labels(std::size_t c) const { return labels_[c]; }

  const LoopCandidate& candidate(std::size_t i) const { return pool_[i]; }

  /** @brief Returns the cheapest way from one curve to another near the contour. */
  LoopJoint joint(const LoopCandidate& from,
                  const LoopCandidate& to,
                  const Eigen::Vector2d& near) const;

private:
  static constexpr double impossible = 1e9; ///< nats

  /** @brief The candidates of a contour's samples and their costs. */
  struct Table {
    std::vector<std::size_t> list;   ///< candidates of each sample: indices in the pool
    std::vector<double> cost;        ///< of these
    CycleCosts cycle;                ///< of these, as far as they are allowed
    std::vector<std::size_t> places; ///< in `list`, of the labels
  };

  /** @brief A run of samples around a contour. */
  struct Span {
    std::size_t first = 0;
    std::size_t length = 0;
  };

  double
  jointCost(std::size_t c, std::size_t from, std::size_t to, std::size_t i) const;
  void prepare();
  void prepareContour(std::size_t c,
                      const std::vector<std::vector<std::pair<std::size_t, float>>>&);
  void setEntries(std::size_t c, std::size_t i);
  void use(std::size_t label, int count);
  void useLabels(std::size_t c, int count);
  double costOf(std::size_t c, const Span& span) const;
  double total() const;
  void readLabels(std::size_t c, const Span& span);
  void setPlaces(std::size_t c);
  void descend();
  void solveSpan(std::size_t c, const Span& span);
  void setAllowed(std::size_t c, const Span& span, std::size_t label, bool is);
  bool tryWithout(std::size_t label);
  void prune();
  std::vector<Span> spansOf(std::size_t c, std::size_t label) const;
  double leastIncrease(std::size_t label) const;
  std::vector<LoopCandidate> improvements() const;
  bool pays(std::size_t c, const Span& span, const LoopCandidate& instead) const;
  void renew(std::vector<LoopCandidate> more);

  const std::vector<LoopContour>& contours_;
  const std::vector<WallLine>& lines_;
  StoreySamples samples_;
  CandidateMaker maker_;
  unsigned threads_;
  double corner_; ///< nats of a change
  std::vector<LoopCandidate> pool_;
  std::vector<Table> tables_;
  std::vector<std::vector<std::size_t>> labels_;
  std::vector<std::size_t> use_; ///< samples that use each candidate
  double models_ = 0;            ///< cost of the candidates that are used
};

} // namespace pcl::sedr
