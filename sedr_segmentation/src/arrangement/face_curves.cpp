// SPDX-License-Identifier: BSD-3-Clause
#include "face_curves.h"

#include "../curves/fitted_curve.h"
#include "../faces/wall_lines.h"
#include "face_places.h"
#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <unordered_map>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double max_within = 5; // metres, within a line along a main direction
constexpr double max_hole = 0.6; // metres, within another curve
constexpr double long_face = 1;  // metre

/** @brief The places, and curves through them. */
class FaceSearch : FacePlaces {
public:
  FaceSearch(const std::vector<Eigen::Vector2d>& given, const RadiusRange& radii)
      : FacePlaces(given)
      , radii_(radii)
  {
    findMainDirections();
    for (const Eigen::Vector2d& normal : normals_)
      addLines(normal);
    addChains();
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
    return {found_, normals_};
  }

private:
  void findMainDirections()
  {
    const double step = radians(0.1);
    std::map<long, double> turns; // of normals, in steps
    for (const FacePlace& place : places)
      if (!place.normal.isZero())
        turns[std::lround(
            std::remainder(std::atan2(place.normal.y(), place.normal.x()), M_PI / 2) /
            step)] += place.length;
    std::vector<double> angles;
    std::vector<double> weights;
    for (const auto& [turn, weight] : turns) {
      angles.push_back(static_cast<double>(turn) * step);
      weights.push_back(weight);
    }
    std::vector<double> axes;
    for (const double axis : mainAngles(angles, weights, 3, 0.2)) {
      constexpr double same = 0.02; // radians
      const double refined = axis + turnOfLongLines(axis);
      if (std::any_of(axes.begin(), axes.end(), [&](double other) {
            return std::abs(std::remainder(refined - other, M_PI / 2)) < same;
          }))
        continue;
      axes.push_back(refined);
      normals_.emplace_back(std::cos(refined), std::sin(refined));
      normals_.push_back(leftOf(normals_.back()));
    }
  }

  /** @brief Returns how far the long lines about a direction are turned from it: the
   * median by length, radians. */
  double turnOfLongLines(double axis)
  {
    constexpr double near = 0.1;                  // metres
    std::vector<std::pair<double, double>> turns; // weight: length
    double half = 0;
    for (const double angle : {axis, axis + M_PI / 2}) {
      const std::size_t first = found_.size();
      addLines({std::cos(angle), std::sin(angle)});
      for (std::size_t k = first; k < found_.size(); ++k) {
        const FaceCurve& line = found_[k];
        if (line.to - line.from < long_face)
          continue;
        std::vector<Eigen::Vector2d> on;
        for (const FacePlace& place : places)
          if (const double s = line.along(place.at);
              s >= line.from && s <= line.to && line.curve.distance(place.at) < near &&
              std::abs(line.curve.direction.dot(place.normal)) < 0.05)
            on.push_back(place.at);
        if (on.size() < 10)
          continue;
        const Eigen::Vector2d way = fitCurve(false, on, sigma).direction;
        turns.emplace_back(
            std::remainder(std::atan2(way.y(), way.x()) - axis, M_PI / 2),
            line.to - line.from);
        half += (line.to - line.from) / 2;
      }
      found_.resize(first);
    }
    std::sort(turns.begin(), turns.end());
    for (const auto& [turn, length] : turns)
      if ((half -= length) <= 0)
        return turn;
    return 0;
  }

  void addLines(const Eigen::Vector2d& normal)
  {
    for (FaceCurve& line :
         linesAlong(alongDirection(normal), normal, {0.015, 0.025, max_within, 0.1})) {
      line.is_main = true;
      found_.push_back(line);
    }
  }

  /** @brief Follows neighbouring places both ways while their normals turn steadily. */
  std::vector<Eigen::Vector2d> chainFrom(std::size_t seed, double half) const
  {
    constexpr double step = 0.05;   // metres
    constexpr double steady = 0.85; // cosine of the turn in a step
    std::vector<Eigen::Vector2d> chain{places[seed].at};
    for (const double side : {1.0, -1.0}) {
      Eigen::Vector2d at = places[seed].at;
      Eigen::Vector2d way = side * leftOf(places[seed].normal);
      for (double s = step; s < half; s += step) {
        const Eigen::Vector2d ahead = at + step * way;
        std::size_t nearest = places.size();
        double least = 0.06;
        points.forEachIndexWithin(ahead, least, [&](std::size_t i) {
          const double d = (places[i].at - ahead).norm();
          if (d < least && std::abs(leftOf(places[i].normal).dot(way)) > steady) {
            least = d;
            nearest = i;
          }
        });
        if (nearest == places.size())
          break;
        const Eigen::Vector2d on = leftOf(places[nearest].normal);
        way = on.dot(way) > 0 ? on : -on;
        at = places[nearest].at;
        chain.push_back(at);
      }
    }
    return chain;
  }

  void addChains()
  {
    constexpr double seeds = 0.1; // metres apart
    std::set<std::pair<long, long>> taken;
    for (std::size_t c = 0; c < found_.size(); ++c)
      remember(c);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const FacePlace& place = places[i];
      if (place.normal.isZero() || !taken
                                        .insert({std::lround(place.at.x() / seeds),
                                                 std::lround(place.at.y() / seeds)})
                                        .second)
        continue;
      for (const double half : {0.3, 0.6, 1.2}) {
        const std::vector<Eigen::Vector2d> chain = chainFrom(i, half);
        if (static_cast<double>(chain.size()) * 0.05 < half)
          break;
        if (!mainNormalOf(fitCurve(false, chain, sigma)))
          addGrown(false, chain);
        if (chain.size() > 4)
          addGrown(true, chain);
      }
    }
  }

  /** @brief Returns the normal of the main direction that a line is along, or null. */
  const Eigen::Vector2d* mainNormalOf(const PlanCurve& curve) const
  {
    constexpr double along = 0.02; // radians
    const auto found = std::find_if(
        normals_.begin(), normals_.end(), [&](const Eigen::Vector2d& normal) {
          return !curve.isCircle() && std::abs(curve.direction.dot(normal)) < along;
        });
    return found == normals_.end() ? nullptr : &*found;
  }

  /** @brief Adds the curve that fits a chain, grown to its support. */
  void addGrown(bool is_circle, const std::vector<Eigen::Vector2d>& chain)
  {
    constexpr int rounds = 3;
    FaceCurve found;
    found.curve = fitCurve(is_circle, chain, sigma);
    for (int r = 0; r < rounds; ++r) {
      if (is_circle && !(found.curve.radius > radii_.min - 3 * sigma &&
                         found.curve.radius < radii_.max))
        return;
      const std::vector<Eigen::Vector2d> support = supportOf(found, chain.front());
      if (support.size() < 5)
        return;
      if (r + 1 < rounds)
        found.curve = fitCurve(is_circle, support, sigma);
    }
    if (found.to - found.from < 0.3 || isKnown(found))
      return;
    found_.push_back(found);
    remember(found_.size() - 1);
  }

  /** @brief Returns the places on a curve that hang together with one; sets its ends.
   */
  std::vector<Eigen::Vector2d> supportOf(FaceCurve& found,
                                         const Eigen::Vector2d& seed) const
  {
    const PlanCurve& curve = found.curve;
    const double near = 3 * sigma;
    const double half = curve.isCircle() ? M_PI * curve.radius : 50;
    found.from = -1e9;
    const double start = found.along(seed);
    std::vector<Eigen::Vector2d> support;
    double ends[2] = {0, 0};
    for (const int side : {0, 1}) {
      double last = 0;
      for (double s = 0; s < std::min(last + max_hole, half); s += FaceCurve::bin) {
        const Eigen::Vector2d p = found.at(start + (side ? s : -s));
        bool is_seen = false;
        points.forEachIndexWithin(
            p, std::hypot(near, FaceCurve::bin / 2), [&](std::size_t i) {
              const FacePlace& place = places[i];
              if (curve.distance(place.at) > near ||
                  (!place.normal.isZero() &&
                   std::abs(curve.tangentAt(place.at).dot(place.normal)) > 0.4))
                return;
              is_seen = true;
              support.push_back(place.at);
            });
        if (is_seen)
          last = s;
      }
      ends[side] = last;
    }
    found.from = start - ends[0];
    found.to = start + ends[1];
    if (curve.isCircle() && found.to - found.from > 2 * M_PI * curve.radius - max_hole)
      found.to = found.from + 2 * M_PI * curve.radius;
    return support;
  }

  /** @brief Remembers through which cells a curve goes. */
  void remember(std::size_t c)
  {
    const FaceCurve& found = found_[c];
    const double end = found.to + step / 2;
    for (double s = found.from; s < end; s += step) {
      const Eigen::Vector2d p = found.at(std::min(s, found.to));
      std::vector<std::size_t>& there = through_[keyOf(cells_.at(p.x(), p.y()))];
      if (there.empty() || there.back() != c)
        there.push_back(c);
    }
  }

  /** @brief Checks whether a curve is nearly one that was found. */
  bool isKnown(const FaceCurve& curve) const
  {
    const auto isNearly = [&](std::size_t c) {
      const FaceCurve& other = found_[c];
      if (other.curve.isCircle() != curve.curve.isCircle())
        return false;
      for (const double t : {0.0, 0.5, 1.0}) {
        const Eigen::Vector2d p = curve.at(curve.from + t * (curve.to - curve.from));
        const double s = other.along(p);
        if (other.curve.distance(p) > 0.005 || s < other.from - 0.1 ||
            s > other.to + 0.1)
          return false;
      }
      return true;
    };
    const Eigen::Vector2d middle = curve.at((curve.from + curve.to) / 2);
    std::set<CellKey> near;
    for (const double x : {-step, step})
      for (const double y : {-step, step})
        near.insert(keyOf(cells_.at(middle.x() + x, middle.y() + y)));
    return std::any_of(near.begin(), near.end(), [&](CellKey key) {
      const auto there = through_.find(key);
      return there != through_.end() &&
             std::any_of(there->second.begin(), there->second.end(), isNearly);
    });
  }

  /** @brief Returns the places that a curve explains, and how well. */
  std::vector<std::pair<std::uint32_t, float>> explainedBy(const FaceCurve& found) const
  {
    const double near = std::max(costs_.reach, 8 * sigma);
    std::vector<std::pair<std::uint32_t, float>> explained;
    const auto steps =
        static_cast<std::size_t>(std::ceil((found.to - found.from) / step)) + 1;
    for (std::size_t k = 0; k < steps; ++k)
      points.forEachIndexWithin(
          found.at(std::min(found.to, found.from + static_cast<double>(k) * step)),
          std::hypot(near, step / 2), [&](std::size_t i) {
            const FacePlace& place = places[i];
            const double d = found.curve.distance(place.at) / near;
            if (d >= 1 ||
                (!place.normal.isZero() &&
                 std::abs(found.curve.tangentAt(place.at).dot(place.normal)) > 0.4))
              return;
            explained.emplace_back(static_cast<std::uint32_t>(i),
                                   static_cast<float>(1 - d * d));
          });
    std::sort(explained.begin(), explained.end());
    explained.erase(std::unique(explained.begin(), explained.end()), explained.end());
    return explained;
  }

  /** @brief Measures what a metre of face that no curve explains costs, by how many
   * places there are on no long one: in a room without furniture they are a column's,
   * in others mostly not structure. */
  void measureFaces()
  {
    std::vector<std::uint8_t> is_on(places.size(), 0);
    for (const FaceCurve& found : found_)
      if (found.to - found.from > long_face)
        for (const auto& [i, share] : explainedBy(found))
          if (share > 0.9F)
            is_on[i] = 1;
    double all = 1e-9;
    double beside = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      all += places[i].length;
      beside += is_on[i] ? 0 : places[i].length;
    }
    const double stray = std::clamp(beside / all, 0.005, 0.5);
    face_ = std::log((1 - stray) / stray * costs_.anywhere /
                     (std::sqrt(2 * M_PI) * sigma)) /
            costs_.correlation;
  }

  void keepBest()
  {
    std::vector<float> explained(places.size(), 0);
    std::vector<std::vector<std::pair<std::uint32_t, float>>> of(found_.size());
    std::priority_queue<std::pair<double, std::size_t>> queue;
    const auto gainOf = [&](std::size_t c) {
      double gain = 0;
      for (const auto& [i, share] : of[c])
        gain += std::max(0.F, share - explained[i]) * places[i].length;
      return face_ * gain - costOf(found_[c]);
    };
    for (std::size_t c = 0; c < found_.size(); ++c) {
      of[c] = explainedBy(found_[c]);
      queue.emplace(gainOf(c), c);
    }
    std::vector<FaceCurve> kept;
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
    }
    found_ = std::move(kept);
  }

  /** @brief Fits each curve to the places that it explains best. */
  void refit()
  {
    std::vector<std::pair<float, std::size_t>> best(places.size(), {0.F, 0});
    for (std::size_t c = 0; c < found_.size(); ++c)
      for (const auto& [i, share] : explainedBy(found_[c]))
        if (share > best[i].first)
          best[i] = {share, c};
    std::vector<std::vector<Eigen::Vector2d>> of(found_.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      if (best[i].first > 0)
        of[best[i].second].push_back(places[i].at);
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
      face.curve = fitCurve(face.curve.isCircle(), of[c], sigma);
      if (const Eigen::Vector2d* const normal = mainNormalOf(face.curve)) {
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
    return found.curve.isCircle() ? costs_.circle
           : found.is_main        ? costs_.line
                                  : costs_.oblique;
  }

  static constexpr double step = 0.1; ///< metres

  CellGrid cells_{2 * step};
  std::unordered_map<CellKey, std::vector<std::size_t>> through_; ///< curves, by cell
  FaceCosts costs_;
  double face_ = 0; ///< a metre that is explained, nats
  RadiusRange radii_;
  std::vector<Eigen::Vector2d> normals_;
  std::vector<FaceCurve> found_;
};

} // namespace

FaceCurves
faceCurves(const std::vector<Eigen::Vector2d>& places, const RadiusRange& radii)
{
  return FaceSearch(places, radii).best();
}

} // namespace pcl::sedr
