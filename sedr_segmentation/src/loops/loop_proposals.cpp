// SPDX-License-Identifier: BSD-3-Clause
#include "loop_proposals.h"

#include "../curves/fitted_curve.h"
#include "sedr_filters/src/base/densest_window.h"
#include "sedr_filters/src/base/middle_value.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief The seen ones of consecutive samples. */
struct Window {
  std::vector<std::size_t> samples;
  std::vector<Eigen::Vector2d> anchors;
};

/** @brief Takes proposals as long as they explain what none before them does. */
class ProposalSearch {
public:
  ProposalSearch(const std::vector<LoopContour>& contours, CandidateMaker& maker)
      : contours_(contours)
      , maker_(maker)
      , samples_(maker.samples())
  {}

  std::vector<LoopCandidate> find(const std::vector<WallLine>& lines)
  {
    startAgain();
    for (const WallLine& line : lines)
      takeParts(line);
    takeWindows(false);
    maker_.setDirections(directions());
    for (std::size_t c = 0; c < contours_.size(); ++c)
      addFaces(c);
    startAgain();
    takeWindows(true);
    for (std::size_t c = 0; c < contours_.size(); ++c)
      addUnseen(c);
    const std::size_t seen = curves_.size();
    for (std::size_t k = 0; k < seen; ++k)
      for (const SeededCurve& turned : maker_.snapped(curves_[k]))
        curves_.push_back(turned);
    std::vector<LoopCandidate> candidates;
    for (const SeededCurve& curve : curves_)
      candidates.push_back(maker_.candidate(curve));
    return maker_.distinct(std::move(candidates), maker_.sigma() / 4);
  }

private:
  /** @brief Forgets what is explained: circles do not compete with lines. */
  void startAgain()
  {
    left_.resize(samples_.size());
    for (std::size_t i = 0; i < left_.size(); ++i)
      left_[i] = maker_.outlier() * samples_[i].seen;
  }

  /** @brief Takes a curve if what it explains beyond those before is worth `least`. */
  void take(const SeededCurve& path, double least)
  {
    const LoopCandidate candidate = maker_.priced(path);
    std::vector<std::pair<std::uint32_t, double>> costs;
    double gain = 0;
    for (const auto& [i, s] : maker_.support(path, maker_.search().beyond)) {
      const double cost = maker_.costOf(i, candidate);
      gain += std::max(0.0, left_[i] - cost);
      costs.push_back({i, cost});
    }
    if (gain < least)
      return;
    for (const auto& [i, cost] : costs)
      left_[i] = std::min(left_[i], cost);
    curves_.push_back(path);
  }

  /** @brief Takes the parts of a wall's line on which a surface was seen. */
  void takeParts(const WallLine& line)
  {
    PlanCurve curve;
    curve.direction = leftOf(line.normal);
    const auto is = [&](std::size_t i, AlongLine what) {
      return i < line.places.size() && line.places[i] == what;
    };
    for (std::size_t i = 0; i < line.places.size(); ++i)
      if (is(i, AlongLine::Surface) && !(i > 0 && is(i - 1, AlongLine::Surface))) {
        std::size_t end = i;
        while (is(end, AlongLine::Surface))
          ++end;
        curve.point = line.at(static_cast<double>(i + end) / 2);
        take({curve, curve.point}, maker_.parameter());
      }
  }

  Window windowAt(std::size_t c, std::size_t from, std::size_t length) const
  {
    Window window;
    const std::size_t n = contours_[c].samples.size();
    for (std::size_t k = 0; k < std::min(length, n); ++k) {
      const std::size_t i = samples_.firstOf(c) + (from + k) % n;
      if (samples_[i].isSeen()) {
        window.samples.push_back(i);
        window.anchors.push_back(samples_[i].anchor);
      }
    }
    return window;
  }

  /** @brief Takes lines or circles through windows of samples, the longest first. */
  void takeWindows(bool is_circle)
  {
    for (const std::size_t length : {48, 24, 12, 6})
      for (std::size_t c = 0; c < contours_.size(); ++c) {
        if (is_circle && length < 12 && !contours_[c].is_hole)
          continue;
        const std::size_t n = contours_[c].samples.size();
        for (std::size_t s = 0; s < n; s += std::max<std::size_t>(2, length / 4)) {
          const Window window = windowAt(c, s, length);
          if (static_cast<double>(window.anchors.size()) >=
                  maker_.search().min_seen * static_cast<double>(std::min(length, n)) &&
              window.anchors.size() > 3 && isLeft(window))
            takeThrough(window.anchors, is_circle);
        }
      }
  }

  /** @brief Returns whether enough of a window is not explained yet. */
  bool isLeft(const Window& window) const
  {
    double left = 0;
    for (const std::size_t i : window.samples)
      left += left_[i];
    return left > maker_.parameter();
  }

  void takeThrough(const std::vector<Eigen::Vector2d>& places, bool is_circle)
  {
    SeededCurve path;
    path.seed = places[places.size() / 2];
    path.curve = fitCurve(is_circle, places, maker_.sigma());
    if (!maker_.isPossible(path.curve))
      return;
    path = maker_.grown(path);
    if (maker_.isPossible(path.curve))
      take(path, is_circle ? 3 * maker_.parameter() : maker_.parameter());
  }

  /** @brief Returns the main directions of the lines taken, by the squares of what
   * supports them. */
  std::vector<double> directions() const
  {
    std::vector<double> angles;
    std::vector<double> weights;
    for (const SeededCurve& path : curves_) {
      const auto on =
          static_cast<double>(maker_.support(path, maker_.search().beyond).size());
      angles.push_back(std::atan2(path.curve.direction.y(), path.curve.direction.x()));
      weights.push_back(on * on);
    }
    return mainAngles(angles, weights, 4, 0.15);
  }

  /** @brief Adds lines in the main directions through points that no curve explains:
   * faces of pilasters and steps, which are shorter than any window. */
  void addFaces(std::size_t c)
  {
    constexpr std::size_t window = 8; // samples
    const LoopContour& contour = contours_[c];
    const std::size_t n = contour.samples.size();
    for (std::size_t s = 0; s < n; s += window / 2) {
      std::vector<Eigen::Vector2d> left;
      for (std::size_t k = 0; k < window; ++k) {
        const std::size_t i = (s + k) % n;
        if (left_[samples_.firstOf(c) + i] > maker_.outlier() / 2)
          left.insert(left.end(),
                      contour.points.begin() +
                          static_cast<std::ptrdiff_t>(contour.first[i]),
                      contour.points.begin() +
                          static_cast<std::ptrdiff_t>(contour.first[i + 1]));
      }
      for (const double axis : maker_.directions())
        for (const double turn : {axis, axis + M_PI / 2})
          addFace(left, {std::cos(turn), std::sin(turn)});
    }
  }

  /** @brief Adds the line square to `v` with the most of some points, a third of them
   * at least. */
  void addFace(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& v)
  {
    std::vector<double> offsets;
    for (const Eigen::Vector2d& p : points)
      offsets.push_back(v.dot(p));
    std::sort(offsets.begin(), offsets.end());
    const auto [first, last] = densestWindow(offsets, 3 * maker_.sigma());
    if (points.size() > 3 && 3 * (last - first + 1) >= points.size())
      addSquareTo(v, offsets[(first + last) / 2], points[points.size() / 2]);
  }

  /** @brief Adds the line square to `v` at an offset along it, from a place on. */
  void addSquareTo(const Eigen::Vector2d& v, double offset, const Eigen::Vector2d& near)
  {
    PlanCurve line;
    line.direction = leftOf(v);
    line.point = near + (offset - v.dot(near)) * v;
    curves_.push_back({line, line.point});
  }

  /** @brief Adds lines through the unseen stretches of a contour. */
  void addUnseen(std::size_t c)
  {
    const std::size_t n = contours_[c].samples.size();
    std::vector<std::size_t> seen(n);
    for (std::size_t i = 0; i < n; ++i)
      seen[i] = contours_[c].samples[i].isSeen() ? 1 : 0;
    for (const auto& [first, length] : labelRuns(seen))
      if (!seen[first])
        addAligned(c, first, length);
  }

  /** @brief Adds lines in the main directions through the middle of an unseen stretch.
   */
  void addAligned(std::size_t c, std::size_t first, std::size_t length)
  {
    const std::vector<LoopSample>& samples = contours_[c].samples;
    const std::size_t n = samples.size();
    Eigen::Vector2d out = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < length; ++k)
      out += samples[(first + k) % n].normal;
    for (const double axis : maker_.directions())
      for (const double turn : {axis, axis + M_PI / 2}) {
        Eigen::Vector2d v(std::cos(turn), std::sin(turn));
        if (std::abs(v.dot(out)) <= 0.5 * out.norm())
          continue;
        std::vector<double> offsets;
        for (std::size_t k = 0; k < length; ++k)
          offsets.push_back(v.dot(samples[(first + k) % n].place));
        addSquareTo(v, middleValue(std::move(offsets)),
                    samples[(first + length / 2) % n].place);
      }
  }

  const std::vector<LoopContour>& contours_;
  CandidateMaker& maker_;
  const StoreySamples& samples_;
  std::vector<double> left_; ///< nats of each sample that nothing explains yet
  std::vector<SeededCurve> curves_;
};

} // namespace

std::vector<std::pair<std::size_t, std::size_t>>
labelRuns(const std::vector<std::size_t>& labels)
{
  const std::size_t n = labels.size();
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < n; ++i)
    if (labels[i] != labels[(i + n - 1) % n])
      starts.push_back(i);
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  for (std::size_t k = 0; k < starts.size(); ++k)
    runs.push_back(
        {starts[k], (starts[(k + 1) % starts.size()] + n - starts[k] - 1) % n + 1});
  if (runs.empty())
    runs.push_back({0, n});
  return runs;
}

std::vector<LoopCandidate>
proposedCurves(const std::vector<LoopContour>& contours,
               const std::vector<WallLine>& lines,
               CandidateMaker& maker)
{
  return ProposalSearch(contours, maker).find(lines);
}

} // namespace pcl::sedr
