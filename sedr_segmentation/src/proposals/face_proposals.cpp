// SPDX-License-Identifier: BSD-3-Clause
#include "face_proposals.h"

#include "../curves/fitted_curve.h"
#include "island_proposals.h"
#include "main_angles.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double max_hole = 0.6; // metres, within another curve
constexpr double step = 0.1;     // metres, along curves that are remembered

/** @brief The proposals, as they are found. */
class FaceProposal {
public:
  FaceProposal(const FacePlaces& places, const RadiusRange& radii, unsigned threads)
      : places_(places)
      , radii_(radii)
      , threads_(threads)
  {
    findMainDirections();
    for (const Eigen::Vector2d& normal : normals_)
      addLines(normal);
    addChains();
    for (const FaceCurve& found : proposeIslands(places_))
      if (radii_.allows(found.curve, places_.sigma))
        found_.push_back(found);
  }

  FaceCurves found() && { return {std::move(found_), std::move(normals_)}; }

private:
  void findMainDirections()
  {
    const double step = radians(0.1);
    std::map<long, double> turns; // of normals, in steps
    for (const FacePlace& place : places_.places)
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
      const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
      addLines(normal);
      std::vector<std::pair<double, std::size_t>> places; // by offset
      for (std::size_t i = 0; i < places_.places.size(); ++i)
        places.emplace_back(normal.dot(places_.places[i].at), i);
      std::sort(places.begin(), places.end());
      for (std::size_t k = first; k < found_.size(); ++k) {
        const FaceCurve& line = found_[k];
        if (line.to - line.from < long_face)
          continue;
        std::vector<Eigen::Vector2d> on;
        const double offset = normal.dot(line.curve.point);
        for (auto of = std::lower_bound(places.begin(), places.end(),
                                        std::make_pair(offset - near, std::size_t{0}));
             of != places.end() && of->first < offset + near; ++of) {
          const FacePlace& place = places_.places[of->second];
          if (const double s = line.along(place.at);
              s >= line.from && s <= line.to &&
              std::abs(line.curve.direction.dot(place.normal)) < 0.05)
            on.push_back(place.at);
        }
        if (on.size() < 10)
          continue;
        const Eigen::Vector2d way = fitCurve(false, on, places_.sigma).direction;
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
    for (FaceCurve& line : linesAlong(places_.alongDirection(normal), normal,
                                      {0.015, 0.025, max_gap, 0.1})) {
      line.is_main = true;
      found_.push_back(line);
    }
  }

  /** @brief Follows neighbouring places both ways while their normals turn steadily. */
  std::vector<Eigen::Vector2d> chainFrom(std::size_t seed, double half) const
  {
    constexpr double steady = 0.85; // cosine of the turn in a step
    const double step = FaceCurve::bin * places_.scale;
    std::vector<Eigen::Vector2d> chain{places_.places[seed].at};
    for (const double side : {1.0, -1.0}) {
      Eigen::Vector2d at = places_.places[seed].at;
      Eigen::Vector2d way = side * leftOf(places_.places[seed].normal);
      for (double s = step; s < half; s += step) {
        const Eigen::Vector2d ahead = at + step * way;
        std::size_t nearest = places_.places.size();
        double least = 1.2 * step;
        places_.points.forEachIndexWithin(ahead, least, [&](std::size_t i) {
          const double d = (places_.places[i].at - ahead).norm();
          if (d < least &&
              std::abs(leftOf(places_.places[i].normal).dot(way)) > steady) {
            least = d;
            nearest = i;
          }
        });
        if (nearest == places_.places.size())
          break;
        const Eigen::Vector2d on = leftOf(places_.places[nearest].normal);
        way = on.dot(way) > 0 ? on : -on;
        at = places_.places[nearest].at;
        chain.push_back(at);
      }
    }
    return chain;
  }

  /** @brief Adds what fits chains, one from each 10 cm of faces. */
  void addChains()
  {
    constexpr double apart = 0.1; // metres
    std::set<std::pair<long, long>> taken;
    std::vector<std::size_t> seeds;
    for (std::size_t i = 0; i < places_.places.size(); ++i) {
      const FacePlace& place = places_.places[i];
      if (!place.normal.isZero() && taken
                                        .insert({std::lround(place.at.x() / apart),
                                                 std::lround(place.at.y() / apart)})
                                        .second)
        seeds.push_back(i);
    }
    std::vector<std::vector<FaceCurve>> grown(seeds.size());
    parallelBlocks(seeds.size(), 1, threads_,
                   [&](std::size_t k, std::size_t) { grown[k] = grownFrom(seeds[k]); });
    for (std::size_t c = 0; c < found_.size(); ++c)
      remember(c);
    for (const std::vector<FaceCurve>& curves : grown)
      for (const FaceCurve& curve : curves)
        if (!isKnown(curve)) {
          found_.push_back(curve);
          remember(found_.size() - 1);
        }
  }

  /** @brief Returns the lines through chains from a place, and the circles through
   * those that a circle fits better. Chains along a curve that grew from a longer one
   * add nothing. */
  std::vector<FaceCurve> grownFrom(std::size_t seed) const
  {
    std::vector<FaceCurve> grown;
    for (const double half : {1.2, 0.6, 0.3}) {
      const std::vector<Eigen::Vector2d> chain = chainFrom(seed, half);
      if (static_cast<double>(chain.size()) * FaceCurve::bin * places_.scale < half ||
          isAlongAny(grown, chain))
        continue;
      const PlanCurve line = fitCurve(false, chain, places_.sigma);
      if (!mainNormalOf(line, normals_))
        addGrown(line, chain.front(), grown);
      if (chain.size() <= 4)
        continue;
      const PlanCurve circle = fitCurve(true, chain, places_.sigma);
      if (misfitOf(line, chain) - misfitOf(circle, chain) >
          0.5 * std::log(static_cast<double>(chain.size()))) // BIC
        addGrown(circle, chain.front(), grown);
    }
    return grown;
  }

  /** @brief Checks whether one of some curves explains a chain to within one nat a
   * place.
   */
  bool isAlongAny(const std::vector<FaceCurve>& curves,
                  const std::vector<Eigen::Vector2d>& chain) const
  {
    return std::any_of(curves.begin(), curves.end(), [&](const FaceCurve& found) {
      return misfitOf(found.curve, chain) < static_cast<double>(chain.size());
    });
  }

  /** @brief Returns how badly a curve fits a chain, nats. */
  double misfitOf(const PlanCurve& curve,
                  const std::vector<Eigen::Vector2d>& chain) const
  {
    double misfit = 0;
    for (const Eigen::Vector2d& place : chain)
      misfit += std::min(std::pow(curve.distance(place) / places_.sigma, 2) / 2, 4.5);
    return misfit;
  }

  /** @brief Adds the curve through a chain, grown to its support. */
  void addGrown(const PlanCurve& curve,
                const Eigen::Vector2d& seed,
                std::vector<FaceCurve>& grown) const
  {
    constexpr int rounds = 3;
    FaceCurve found;
    found.curve = curve;
    for (int r = 0; r < rounds; ++r) {
      if (!radii_.allows(found.curve, places_.sigma))
        return;
      const std::vector<Eigen::Vector2d> support = supportOf(found, seed);
      if (support.size() < 5)
        return;
      if (r + 1 < rounds)
        found.curve = fitCurve(curve.isCircle(), support, places_.sigma);
    }
    if (found.to - found.from >= 0.3)
      grown.push_back(found);
  }

  /** @brief Returns the places on a curve that hang together with one; sets its ends.
   */
  std::vector<Eigen::Vector2d> supportOf(FaceCurve& found,
                                         const Eigen::Vector2d& seed) const
  {
    const PlanCurve& curve = found.curve;
    const double near = 3 * places_.sigma;
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
        places_.points.forEachIndexWithin(
            p, std::hypot(near, FaceCurve::bin / 2), [&](std::size_t i) {
              const FacePlace& place = places_.places[i];
              if (curve.distance(place.at) > near || !place.mayLieOn(curve))
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

  const FacePlaces& places_;
  RadiusRange radii_;
  unsigned threads_;
  std::vector<Eigen::Vector2d> normals_;
  std::vector<FaceCurve> found_;
  CellGrid cells_{2 * step};
  std::unordered_map<CellKey, std::vector<std::size_t>> through_; ///< curves, by cell
};

} // namespace

const Eigen::Vector2d*
mainNormalOf(const PlanCurve& curve, const std::vector<Eigen::Vector2d>& normals)
{
  constexpr double along = 0.02; // radians
  const auto found =
      std::find_if(normals.begin(), normals.end(), [&](const Eigen::Vector2d& normal) {
        return !curve.isCircle() && std::abs(curve.direction.dot(normal)) < along;
      });
  return found == normals.end() ? nullptr : &*found;
}

FaceCurves
proposeFaces(const FacePlaces& places, const RadiusRange& radii, unsigned threads)
{
  return FaceProposal(places, radii, threads).found();
}

} // namespace pcl::sedr
