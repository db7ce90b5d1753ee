// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "storey_samples.h"
#include "wall_noise.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A curve that the loops of a storey may follow. */
struct LoopCandidate {
  SeededCurve path;
  double cost = 0;   ///< nats, once for all loops that follow it
  double unseen = 0; ///< share of an outlier that it costs where nobody saw a wall
  std::vector<std::uint32_t> samples; ///< it may be followed at: numbers, increasing
  std::vector<float> costs;           ///< of these

  const PlanCurve& curve() const { return path.curve; }
};

/** @brief Makes candidates of curves, and tells what they cost (LoopEnergy). */
class CandidateMaker {
public:
  /** @param samples must outlive this */
  CandidateMaker(const StoreySamples& samples,
                 const LoopEnergy& energy,
                 double spacing,
                 const WallNoise& noise);

  const StoreySamples& samples() const { return samples_; }
  const LoopEnergy& energy() const { return energy_; }
  const LoopSearch& search() const { return search_; }
  double sigma() const { return noise_.sigma; }

  /** @brief Returns the nats of a parameter of a curve. */
  double parameter() const { return parameter_; }

  /** @brief Returns what a sample costs that its curve does not explain, nats. */
  double outlier() const { return outlier_; }

  /** @brief Returns the main directions of the walls, radians modulo a quarter turn. */
  const std::vector<double>& directions() const { return directions_; }
  void setDirections(std::vector<double> directions);

  /** @brief Returns a curve with what it costs, without samples. */
  LoopCandidate priced(const SeededCurve& path) const;

  /** @brief Returns a curve with the samples that may follow it: those near it, up to
   * some metres beyond the surfaces on it. */
  LoopCandidate candidate(const SeededCurve& path) const
  {
    return candidate(priced(path));
  }

  /** @brief The same of a candidate that has its price. */
  LoopCandidate candidate(LoopCandidate candidate) const;

  /** @brief Returns the candidates without those that run along a better one: where
   * they explain samples, it is within `same` metres. Better is what costs least for
   * each sample that it explains. O(candidates x those beside them). */
  std::vector<LoopCandidate> distinct(std::vector<LoopCandidate> candidates,
                                      double same) const;

  /** @brief Returns what a sample costs on a curve, nats. */
  double costOf(std::size_t sample, const LoopCandidate& candidate) const;

  /** @brief Returns the seen samples whose surface is on a curve and along it: numbers,
   * and how far from its seed. The curve ends at gaps of `gap` metres. */
  std::vector<std::pair<std::uint32_t, double>> support(const SeededCurve& path,
                                                        double gap) const;

  /** @brief Fits a line to its support, in steps to farther parts of it. */
  SeededCurve grown(SeededCurve path) const;

  /** @brief Returns a line turned into the main direction next to it; none if it is in
   * one, or 4 degrees off. */
  std::vector<SeededCurve> snapped(const SeededCurve& path) const;

  /** @brief Returns whether a circle is one that walls may have. */
  bool isPossible(const PlanCurve& curve) const
  {
    return !curve.isCircle() || (curve.radius > energy_.min_radius - noise_.sigma &&
                                 curve.radius < energy_.max_radius);
  }

private:
  std::vector<std::pair<std::uint32_t, double>>
  explainedBy(const LoopCandidate& candidate) const;
  double offsetAt(std::size_t i, const PlanCurve& curve) const;
  double angleFromMain(const PlanCurve& curve) const;

  const StoreySamples& samples_;
  LoopEnergy energy_;
  LoopSearch search_;
  WallNoise noise_;
  double outlier_;
  double parameter_;
  std::vector<double> directions_;
};

} // namespace pcl::sedr
