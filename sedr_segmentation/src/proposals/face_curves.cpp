// SPDX-License-Identifier: BSD-3-Clause
#include "face_curves.h"

#include "../curves/fitted_curve.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/quantiles.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief The choice among proposals. */
class FaceChoice {
public:
  FaceChoice(const FacePlaces& places,
             const RadiusRange& radii,
             FaceCurves proposals,
             unsigned threads)
      : places_(places)
      , radii_(radii)
      , threads_(threads)
      , normals_(std::move(proposals.normals))
      , found_(std::move(proposals.curves))
  {
    measureFaces();
  }

  /** @brief Keeps the curves that explain what no better one does, fitted to the places
   * that they explain best (Isack and Boykov 2012). */
  FaceCurves best()
  {
    constexpr int rounds = 8;
    for (int round = 0; round < rounds; ++round) {
      keepBest();
      refit();
    }
    return {found_, normals_, certainty()};
  }

private:
  using Explained = std::vector<std::pair<std::uint32_t, float>>; ///< place, how well

  /** @brief Returns the places that a curve explains. */
  Explained explainedBy(const FaceCurve& found) const
  {
    const double near = std::max(std::min(costs_.reach, stray_), 8 * places_.sigma);
    Explained explained;
    const auto steps =
        static_cast<std::size_t>(std::ceil((found.to - found.from) / step)) + 1;
    for (std::size_t k = 0; k < steps; ++k)
      places_.points.forEachIndexWithin(
          found.at(std::min(found.to, found.from + static_cast<double>(k) * step)),
          std::hypot(near, step / 2), [&](std::size_t i) {
            const FacePlace& place = places_.places[i];
            const double d = found.curve.distance(place.at) / near;
            if (d >= 1 || !place.mayLieOn(found.curve))
              return;
            explained.emplace_back(static_cast<std::uint32_t>(i),
                                   static_cast<float>(1 - d * d));
          });
    std::sort(explained.begin(), explained.end());
    explained.erase(std::unique(explained.begin(), explained.end()), explained.end());
    return explained;
  }

  /** @brief Returns what each curve explains that is longer than some metres. */
  std::vector<Explained> explainedByEach(double min_length) const
  {
    std::vector<Explained> of(found_.size());
    parallelBlocks(found_.size(), 1, threads_, [&](std::size_t c, std::size_t) {
      if (found_[c].to - found_[c].from > min_length)
        of[c] = explainedBy(found_[c]);
    });
    return of;
  }

  /** @brief Measures how many places are on no long face: in a room without furniture
   * they are a column's, in others mostly not structure. By that follows what a metre
   * of face costs that no curve explains. */
  void measureFaces()
  {
    std::vector<std::uint8_t> is_on(places_.places.size(), 0);
    for (const Explained& explained : explainedByEach(long_face))
      for (const auto& [i, share] : explained)
        if (share > 0.9F)
          is_on[i] = 1;
    double all = 1e-9;
    double beside = 0;
    for (std::size_t i = 0; i < places_.places.size(); ++i) {
      all += places_.places[i].length;
      beside += is_on[i] ? 0 : places_.places[i].length;
    }
    stray_ = std::clamp(beside / all, 0.005, 0.3);
    const double anywhere = costs_.anywhere / (std::sqrt(2 * M_PI) * places_.sigma);
    face_ = std::log((1 - stray_) / stray_ * anywhere) / costs_.correlation;
  }

  /** @brief Returns what a metre of surface tells that it is structure, nats. */
  double certainty() const { return std::log((1 - stray_) / stray_) / costs_.together; }

  void keepBest()
  {
    std::vector<float> explained(places_.places.size(), 0);
    std::vector<Explained> of = explainedByEach(0);
    std::priority_queue<std::pair<double, std::size_t>> queue;
    const auto gainOf = [&](std::size_t c) {
      double gain = 0;
      for (const auto& [i, share] : of[c])
        gain += std::max(0.F, share - explained[i]) * places_.places[i].length *
                places_.places[i].share;
      return face_ * gain - costOf(found_[c]);
    };
    for (std::size_t c = 0; c < found_.size(); ++c)
      queue.emplace(gainOf(c), c);
    std::vector<FaceCurve> kept;
    explained_.clear();
    while (!queue.empty()) {
      const auto [gain, c] = queue.top();
      queue.pop();
      const double now = gainOf(c);
      if (now < 0)
        continue;
      if (now < gain - 1e-9) {
        queue.emplace(now, c);
        continue;
      }
      for (const auto& [i, share] : of[c])
        explained[i] = std::max(explained[i], share);
      kept.push_back(found_[c]);
      explained_.push_back(std::move(of[c]));
    }
    found_ = std::move(kept);
  }

  /** @brief Fits each curve to the places that it explains best. */
  void refit()
  {
    std::vector<std::pair<float, std::size_t>> best(places_.places.size(), {0.F, 0});
    for (std::size_t c = 0; c < found_.size(); ++c)
      for (const auto& [i, share] : explained_[c])
        if (share > best[i].first)
          best[i] = {share, c};
    std::vector<std::vector<Eigen::Vector2d>> of(found_.size());
    for (std::size_t i = 0; i < places_.places.size(); ++i)
      if (best[i].first > 0)
        of[best[i].second].push_back(places_.places[i].at);
    for (std::size_t c = 0; c < found_.size(); ++c) {
      FaceCurve& face = found_[c];
      if (of[c].size() < 5)
        continue;
      const Eigen::Vector2d start = face.at(face.from);
      const Eigen::Vector2d end = face.at(face.to);
      if (face.is_main) {
        const Eigen::Vector2d normal = leftOf(face.curve.direction);
        std::vector<double> offsets;
        for (const Eigen::Vector2d& p : of[c])
          offsets.push_back(normal.dot(p - face.curve.point));
        face.curve.point += middleValue(std::move(offsets)) * normal;
        continue;
      }
      const Eigen::Vector2d way = face.curve.direction;
      const double length = face.to - face.from;
      const double around = 2 * M_PI * face.curve.radius;
      const PlanCurve fitted = fitCurve(face.curve.isCircle(), of[c], places_.sigma);
      if (!fitted.point.allFinite() || !radii_.allows(fitted, places_.sigma))
        continue; // places nearly on a line
      face.curve = fitted;
      if (const Eigen::Vector2d* const normal = mainNormalOf(face.curve, normals_)) {
        face.curve.direction = leftOf(*normal);
        face.is_main = true;
      }
      if (face.curve.direction.dot(way) < 0)
        face.curve.direction = -face.curve.direction;
      face.from = -1e9;
      face.from = face.along(start);
      face.to = face.curve.isCircle() && length > around - 1e-6
                    ? face.from + 2 * M_PI * face.curve.radius
                    : face.along(end);
    }
  }

  double costOf(const FaceCurve& found) const
  {
    const double chance = costs_.chance * stray_;
    return found.curve.isCircle() ? costs_.circle + chance
           : found.is_main        ? costs_.line
                           : costs_.line + (costs_.direction + chance) / found.shared;
  }

  static constexpr double step = 0.1; ///< metres

  const FacePlaces& places_;
  RadiusRange radii_;
  unsigned threads_;
  FaceCosts costs_;
  double stray_ = 0.1; ///< share of the places that are on no long face
  double face_ = 0;    ///< a metre that is explained, nats
  std::vector<Eigen::Vector2d> normals_;
  std::vector<FaceCurve> found_;
  std::vector<Explained> explained_; ///< by each curve that was kept
};

} // namespace

FaceCurves
faceCurves(const FacePlaces& places, const RadiusRange& radii, unsigned threads)
{
  return FaceChoice(places, radii, proposeFaces(places, radii, threads), threads)
      .best();
}

} // namespace pcl::sedr
