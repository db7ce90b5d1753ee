// SPDX-License-Identifier: BSD-3-Clause
#include "face_curves.h"

#include "../curves/place_sums.h"
#include "../curves/plan_points.h"
#include "../faces/wall_lines.h"
#include "../loops/loop_curve.h"
#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/smooth_counts.h"
#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double bin = 0.05;        // metres along a curve
constexpr double near_curve = 0.03; // metres, of places from theirs
constexpr double rate = 40;         // nats a metre of a face that is explained
constexpr double parameter = 5.4;   // nats of a line along a main direction
constexpr double oblique = 13.7;    // nats of another one
constexpr double round = 23;        // nats of a circle
constexpr double max_within = 5;    // metres, within a line along a main direction
constexpr double max_hole = 0.6;    // metres, within another curve

/** @brief A place on a face. */
struct FacePlace {
  Eigen::Vector2d at;     ///< mean of those around, as far as the normal is known
  Eigen::Vector2d normal; ///< of the face there; zero if unknown, as at corners
  double length = 0;      ///< of the face that it stands for, metres
};

/** @brief The places, and curves through them. */
class FaceSearch {
public:
  FaceSearch(const std::vector<Eigen::Vector2d>& places, const RadiusRange& radii)
      : points_(places, 0.15)
      , radii_(radii)
  {
    orient();
    findMainDirections();
    for (const Eigen::Vector2d& normal : normals_)
      addLines(normal);
    addChains();
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
  /** @brief Finds the normal of each place, and moves it to the mean of those beside it
   * along the face. */
  void orient()
  {
    constexpr double reach = 0.15;  // metres
    constexpr double beside = 0.06; // metres
    std::map<std::pair<long, long>, double> counts;
    const auto cellOf = [](const Eigen::Vector2d& p) {
      return std::make_pair(std::lround(p.x() / bin), std::lround(p.y() / bin));
    };
    for (const Eigen::Vector2d& p : points_.all())
      ++counts[cellOf(p)];
    setStrip();
    std::vector<Eigen::Vector2d> around;
    for (const Eigen::Vector2d& p : points_.all()) {
      around.clear();
      points_.forEachWithin(
          p, reach, [&](const Eigen::Vector2d& q) { around.emplace_back(q - p); });
      FacePlace place{p, localNormal(around), bin / counts[cellOf(p)]};
      double n = 0;
      double offset = 0;
      for (const Eigen::Vector2d& d : around)
        if (std::abs(leftOf(place.normal).dot(d)) < beside &&
            std::abs(place.normal.dot(d)) < strip_) {
          ++n;
          offset += place.normal.dot(d);
        }
      place.at += offset / n * place.normal;
      places_.push_back(place);
    }
    std::vector<double> scatter;
    for (const FacePlace& place : places_) {
      double n = 0;
      double sum = 0;
      if (!place.normal.isZero())
        points_.forEachIndexWithin(place.at, reach, [&](std::size_t i) {
          const double d = place.normal.dot(places_[i].at - place.at);
          if (std::abs(d) < strip_) {
            ++n;
            sum += d * d;
          }
        });
      if (n > 0)
        scatter.push_back(std::sqrt(sum / n));
    }
    sigma_ = std::max(0.002, scatter.empty() ? 0 : middleValue(std::move(scatter)));
  }

  /** @brief Measures how wide a face is by its noise. */
  void setStrip()
  {
    constexpr double reach = 0.15; // metres
    constexpr double least = 0.012;
    constexpr double most = 0.045;
    std::vector<double> scatter;
    for (const Eigen::Vector2d& p : points_.all()) {
      PlaceSums sums; // relative: far from the origin, squares lose their digits
      points_.forEachWithin(p, reach,
                            [&](const Eigen::Vector2d& q) { sums.add(q - p); });
      const Eigen::Vector2d normal = sums.normal();
      if (sums.n >= 5)
        scatter.push_back(
            std::sqrt(std::max(0.0, normal.dot(sums.covariance() * normal))));
    }
    strip_ = scatter.empty()
                 ? least
                 : std::clamp(2.5 * middleValue(std::move(scatter)), least, most);
  }

  /** @brief Returns the normal of the narrow strip through a place that holds most of
   * the places around it; zero if it is short.
   * @param around relative to the place */
  Eigen::Vector2d localNormal(const std::vector<Eigen::Vector2d>& around) const
  {
    constexpr int turns = 24;       // of half a turn
    constexpr double least = 0.025; // metres: deviation along the strip
    PlaceSums best;
    for (int k = 0; k < turns; ++k) {
      const double angle = k * M_PI / turns;
      const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
      PlaceSums sums;
      for (const Eigen::Vector2d& d : around)
        if (std::abs(normal.dot(d)) < strip_)
          sums.add(d);
      if (sums.n > best.n)
        best = sums;
    }
    const Eigen::Vector2d normal = best.normal();
    const Eigen::Vector2d way = leftOf(normal);
    return way.dot(best.covariance() * way) > least * least ? normal
                                                            : Eigen::Vector2d::Zero();
  }

  void findMainDirections()
  {
    const double step = radians(0.1);
    std::map<long, double> turns; // of normals, in steps
    for (const FacePlace& place : places_)
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
    constexpr double longest = 1;                 // metre
    constexpr double near = 0.1;                  // metres
    std::vector<std::pair<double, double>> turns; // weight: length
    double half = 0;
    for (const double angle : {axis, axis + M_PI / 2}) {
      const std::size_t first = found_.size();
      addLines({std::cos(angle), std::sin(angle)});
      for (std::size_t k = first; k < found_.size(); ++k) {
        const FaceCurve& line = found_[k];
        if (line.to - line.from < longest)
          continue;
        std::vector<Eigen::Vector2d> on;
        for (const FacePlace& place : places_)
          if (const double s = line.along(place.at);
              s >= line.from && s <= line.to && line.curve.distance(place.at) < near &&
              std::abs(line.curve.direction.dot(place.normal)) < 0.05)
            on.push_back(place.at);
        if (on.size() < 10)
          continue;
        const Eigen::Vector2d way = fitCurve(false, on, sigma_).direction;
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

  /** @brief Returns the places with others beside them along a direction, so that they
   * may be on a face there: offset, along. */
  std::vector<std::pair<double, double>>
  alongDirection(const Eigen::Vector2d& normal) const
  {
    constexpr double reach = 0.13; // metres
    constexpr int bins = 2;        // with such places, besides its own
    const Eigen::Vector2d way = leftOf(normal);
    std::vector<std::pair<double, double>> found;
    for (const FacePlace& place : places_) {
      if (!place.normal.isZero() && std::abs(place.normal.dot(normal)) < 0.8)
        continue;
      unsigned filled = 0;
      points_.forEachWithin(place.at, reach, [&](const Eigen::Vector2d& q) {
        const Eigen::Vector2d d = q - place.at;
        if (std::abs(normal.dot(d)) < strip_)
          filled |= 1U << (3 + static_cast<int>(std::lround(way.dot(d) / bin)));
      });
      const auto isFilled = [&](int k) { return (filled >> (3 + k) & 1U) != 0; };
      int beside = 0;
      for (int side : {-1, 1})
        for (int k = side; std::abs(k) < 3 && isFilled(k); k += side)
          ++beside;
      if (beside >= bins)
        found.emplace_back(normal.dot(place.at), way.dot(place.at));
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  /** @brief Adds a line for each run of places with one offset along a direction. */
  void addLines(const Eigen::Vector2d& normal)
  {
    constexpr double apart = 0.04;   // metres, of two lines along each other
    constexpr double spread = 0.015; // metres
    constexpr double around = 0.025; // metres
    constexpr int shortest = 2;      // bins
    const Eigen::Vector2d way = leftOf(normal);
    const std::vector<std::pair<double, double>> places = alongDirection(normal);
    if (places.empty())
      return;
    for (const double offset : peaksOf(places, spread, apart)) {
      std::vector<std::pair<double, double>> on; // along, offset
      for (auto i = std::lower_bound(places.begin(), places.end(),
                                     std::make_pair(offset - around, -1e9));
           i != places.end() && i->first < offset + around; ++i)
        on.emplace_back(i->second, i->first);
      std::sort(on.begin(), on.end());
      for (std::size_t i = 0, j = 0; i < on.size(); i = j) {
        std::vector<double> offsets;
        std::set<long> bins;
        for (j = i;
             j < on.size() && (j == i || on[j].first - on[j - 1].first < max_within);
             ++j) {
          offsets.push_back(on[j].second);
          bins.insert(std::lround(on[j].first / bin));
        }
        if (bins.size() < shortest)
          continue;
        FaceCurve line;
        line.curve.direction = way;
        line.curve.point = middleValue(std::move(offsets)) * normal;
        line.from = on[i].first;
        line.to = on[j - 1].first;
        line.is_main = true;
        found_.push_back(line);
      }
    }
  }

  /** @brief Returns the offsets at which most places lie, the highest peak first, none
   * within `apart` of a higher one. */
  static std::vector<double>
  peaksOf(const std::vector<std::pair<double, double>>& places,
          double spread,
          double apart)
  {
    std::vector<double> offsets;
    for (const auto& [offset, s] : places)
      offsets.push_back(offset);
    const SmoothCounts smooth(offsets, spread);
    const std::vector<double>& counts = smooth.counts;
    std::vector<std::pair<double, double>> peaks; // height, offset
    for (std::size_t k = 1; k + 1 < counts.size(); ++k)
      if (counts[k] > counts[k - 1] && counts[k] >= counts[k + 1])
        peaks.emplace_back(-counts[k],
                           smooth.first + static_cast<double>(k) * smooth.bin);
    std::sort(peaks.begin(), peaks.end());
    std::vector<double> kept;
    for (const auto& [height, offset] : peaks)
      if (std::none_of(kept.begin(), kept.end(), [&, o = offset](double other) {
            return std::abs(other - o) < apart;
          }))
        kept.push_back(offset);
    return kept;
  }

  /** @brief Follows neighbouring places both ways while their normals turn steadily. */
  std::vector<Eigen::Vector2d> chainFrom(std::size_t seed, double half) const
  {
    constexpr double step = 0.05;   // metres
    constexpr double steady = 0.85; // cosine of the turn in a step
    std::vector<Eigen::Vector2d> chain{places_[seed].at};
    for (const double side : {1.0, -1.0}) {
      Eigen::Vector2d at = places_[seed].at;
      Eigen::Vector2d way = side * leftOf(places_[seed].normal);
      for (double s = step; s < half; s += step) {
        const Eigen::Vector2d ahead = at + step * way;
        std::size_t nearest = places_.size();
        double least = 0.06;
        points_.forEachIndexWithin(ahead, least, [&](std::size_t i) {
          const double d = (places_[i].at - ahead).norm();
          if (d < least && std::abs(leftOf(places_[i].normal).dot(way)) > steady) {
            least = d;
            nearest = i;
          }
        });
        if (nearest == places_.size())
          break;
        const Eigen::Vector2d on = leftOf(places_[nearest].normal);
        way = on.dot(way) > 0 ? on : -on;
        at = places_[nearest].at;
        chain.push_back(at);
      }
    }
    return chain;
  }

  void addChains()
  {
    constexpr double seeds = 0.1; // metres apart
    std::set<std::pair<long, long>> taken;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const FacePlace& place = places_[i];
      if (place.normal.isZero() || !taken
                                        .insert({std::lround(place.at.x() / seeds),
                                                 std::lround(place.at.y() / seeds)})
                                        .second)
        continue;
      for (const double half : {0.3, 0.6, 1.2}) {
        const std::vector<Eigen::Vector2d> chain = chainFrom(i, half);
        if (static_cast<double>(chain.size()) * 0.05 < half)
          break;
        if (!mainNormalOf(fitCurve(false, chain, sigma_)))
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
    found.curve = fitCurve(is_circle, chain, sigma_);
    for (int r = 0; r < rounds; ++r) {
      if (is_circle && !(found.curve.radius > radii_.min - 3 * sigma_ &&
                         found.curve.radius < radii_.max))
        return;
      const std::vector<Eigen::Vector2d> support = supportOf(found, chain.front());
      if (support.size() < 5)
        return;
      if (r + 1 < rounds)
        found.curve = fitCurve(is_circle, support, sigma_);
    }
    if (found.to - found.from < 0.3 || isKnown(found))
      return;
    found_.push_back(found);
  }

  /** @brief Returns the places on a curve that hang together with one; sets its ends.
   */
  std::vector<Eigen::Vector2d> supportOf(FaceCurve& found,
                                         const Eigen::Vector2d& seed) const
  {
    const PlanCurve& curve = found.curve;
    const double near = 3 * sigma_;
    const double half = curve.isCircle() ? M_PI * curve.radius : 50;
    found.from = -1e9;
    const double start = found.along(seed);
    std::vector<Eigen::Vector2d> support;
    double ends[2] = {0, 0};
    for (const int side : {0, 1}) {
      double last = 0;
      for (double s = 0; s < std::min(last + max_hole, half); s += bin) {
        const Eigen::Vector2d p = found.at(start + (side ? s : -s));
        bool is_seen = false;
        points_.forEachIndexWithin(p, std::hypot(near, bin / 2), [&](std::size_t i) {
          const FacePlace& place = places_[i];
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

  /** @brief Checks whether a curve is nearly one that was found. */
  bool isKnown(const FaceCurve& curve) const
  {
    return std::any_of(found_.begin(), found_.end(), [&](const FaceCurve& other) {
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
    });
  }

  /** @brief Returns the places that a curve explains, and how well. */
  std::vector<std::pair<std::uint32_t, float>> explainedBy(const FaceCurve& found) const
  {
    const double near = std::max(near_curve, 8 * sigma_);
    std::vector<std::pair<std::uint32_t, float>> explained;
    const auto steps =
        static_cast<std::size_t>(std::ceil((found.to - found.from) / bin)) + 1;
    for (std::size_t k = 0; k < steps; ++k)
      points_.forEachIndexWithin(
          found.at(found.from + static_cast<double>(k) * bin),
          std::hypot(near, bin / 2), [&](std::size_t i) {
            const FacePlace& place = places_[i];
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

  void keepBest()
  {
    std::vector<float> explained(places_.size(), 0);
    std::vector<std::vector<std::pair<std::uint32_t, float>>> of(found_.size());
    std::priority_queue<std::pair<double, std::size_t>> queue;
    const auto gainOf = [&](std::size_t c) {
      double gain = 0;
      for (const auto& [i, share] : of[c])
        gain += std::max(0.F, share - explained[i]) * places_[i].length;
      return rate * gain - costOf(found_[c]);
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
    std::vector<std::pair<float, std::size_t>> best(places_.size(), {0.F, 0});
    for (std::size_t c = 0; c < found_.size(); ++c)
      for (const auto& [i, share] : explainedBy(found_[c]))
        if (share > best[i].first)
          best[i] = {share, c};
    std::vector<std::vector<Eigen::Vector2d>> of(found_.size());
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (best[i].first > 0)
        of[best[i].second].push_back(places_[i].at);
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
          offsets.push_back(normal.dot(p));
        face.curve.point = middleValue(std::move(offsets)) * normal;
        continue;
      }
      const Eigen::Vector2d way = face.curve.direction;
      const double length = face.to - face.from;
      const double around = 2 * M_PI * face.curve.radius;
      face.curve = fitCurve(face.curve.isCircle(), of[c], sigma_);
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

  static double costOf(const FaceCurve& found)
  {
    return found.curve.isCircle() ? round : found.is_main ? parameter : oblique;
  }

  PlanPoints points_;
  RadiusRange radii_;
  std::vector<FacePlace> places_; ///< of each of the points
  double strip_ = 0;              ///< half of the width of a face, metres
  double sigma_ = 0;              ///< noise of its mean, metres
  std::vector<Eigen::Vector2d> normals_;
  std::vector<FaceCurve> found_;
};

} // namespace

double
FaceCurve::along(const Eigen::Vector2d& p) const
{
  if (!curve.isCircle())
    return curve.direction.dot(p - curve.point);
  const Eigen::Vector2d d = p - curve.point;
  const double around = 2 * M_PI * curve.radius;
  const double s = std::atan2(d.y(), d.x()) * curve.radius;
  return from < -1e8 ? s : s + around * std::ceil((from - s) / around);
}

Eigen::Vector2d
FaceCurve::at(double s) const
{
  if (!curve.isCircle())
    return curve.point + s * curve.direction;
  const double angle = s / curve.radius;
  return curve.point + curve.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

FaceCurves
faceCurves(const std::vector<Eigen::Vector2d>& places, const RadiusRange& radii)
{
  return FaceSearch(places, radii).best();
}

} // namespace pcl::sedr
