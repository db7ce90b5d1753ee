// SPDX-License-Identifier: BSD-3-Clause
#include "face_places.h"

#include "../curves/place_sums.h"
#include "face_lines.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/quantiles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double reach = 0.15; // metres to those that tell its direction

/** @brief Returns how far apart places along a face are, metres: the median distance
 * of some to the next one that is not beside them. */
double
spacingOf(const PlanPoints& points)
{
  constexpr double farthest = 0.3;
  constexpr std::size_t samples = 1000;
  std::vector<double> spacings;
  for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / samples) {
    const Eigen::Vector2d& p = points.all()[i];
    double next = farthest;
    points.forEachWithin(p, farthest, [&](const Eigen::Vector2d& q) {
      if (const double d = (q - p).norm(); d > 0.8 * FaceCurve::bin)
        next = std::min(next, d);
    });
    spacings.push_back(next);
  }
  return spacings.empty() ? FaceCurve::bin : middleValue(std::move(spacings));
}

/** @brief Returns the median of what is measured at each of n places, without what is
 * below 0; 0 without any. */
template <typename Measure>
double
middleOf(std::size_t n, unsigned threads, Measure measure)
{
  std::vector<double> values(n);
  parallelBlocks(n, 64, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      values[i] = measure(i);
  });
  values.erase(std::remove_if(values.begin(), values.end(),
                              [](double value) { return value < 0; }),
               values.end());
  return values.empty() ? 0 : middleValue(std::move(values));
}

/** @brief Measures half of the width of a face, by its noise. */
double
halfWidth(const PlanPoints& points, double around, unsigned threads)
{
  constexpr double least = 0.012;
  constexpr double most = 0.045;
  const double scatter = middleOf(points.size(), threads, [&](std::size_t i) {
    const Eigen::Vector2d& p = points.all()[i];
    PlaceSums sums; // relative: far from the origin, squares lose their digits
    points.forEachWithin(p, around, [&](const Eigen::Vector2d& q) { sums.add(q - p); });
    const Eigen::Vector2d normal = sums.normal();
    return sums.n < 5
               ? -1
               : std::sqrt(std::max(0.0, normal.dot(sums.covariance() * normal)));
  });
  return std::clamp(2.5 * scatter, least, most);
}

/** @brief Returns the normal of the narrow strip through a place that holds most of
 * the places around it; zero if it is short.
 * @param around relative to the place, within a radius
 * @param strip half of its width */
Eigen::Vector2d
localNormal(const std::vector<Eigen::Vector2d>& around, double radius, double strip)
{
  constexpr int turns = 24;       // of half a turn
  constexpr double least = 0.025; // metres: deviation along the strip
  PlaceSums best;
  double most = 0; // nearer places count more
  for (int k = 0; k < turns; ++k) {
    const double angle = k * M_PI / turns;
    const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
    PlaceSums sums;
    double count = 0;
    for (const Eigen::Vector2d& d : around)
      if (std::abs(normal.dot(d)) < strip) {
        sums.add(d);
        count += 1 - d.squaredNorm() / (radius * radius);
      }
    if (count > most) {
      most = count;
      best = sums;
    }
  }
  const Eigen::Vector2d normal = best.normal();
  const Eigen::Vector2d way = leftOf(normal);
  return way.dot(best.covariance() * way) > least * least ? normal
                                                          : Eigen::Vector2d::Zero();
}

} // namespace

FacePlaces::FacePlaces(const std::vector<Eigen::Vector2d>& given,
                       const std::vector<float>& shares,
                       unsigned threads)
    : points(given, reach)
{
  std::map<std::pair<long, long>, double> counts;
  const auto cellOf = [](const Eigen::Vector2d& p) {
    return std::make_pair(std::lround(p.x() / FaceCurve::bin),
                          std::lround(p.y() / FaceCurve::bin));
  };
  for (const Eigen::Vector2d& p : points.all())
    ++counts[cellOf(p)];
  scale = std::max(1.0, spacingOf(points) / FaceCurve::bin);
  const double beside = 0.06 * scale; // metres
  strip = halfWidth(points, reach * scale, threads);
  places.resize(points.size());
  parallelBlocks(places.size(), 64, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<Eigen::Vector2d> around;
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector2d& p = points.all()[i];
      around.clear();
      points.forEachWithin(p, reach * scale, [&](const Eigen::Vector2d& q) {
        around.emplace_back(q - p);
      });
      FacePlace& place = places[i];
      const float share = shares.empty() ? 1 : shares[points.given(i)];
      place = {p, localNormal(around, reach * scale, strip),
               scale * FaceCurve::bin / counts.at(cellOf(p)), share};
      double n = 0;
      double offset = 0;
      for (const Eigen::Vector2d& d : around)
        if (std::abs(leftOf(place.normal).dot(d)) < beside &&
            std::abs(place.normal.dot(d)) < strip) {
          ++n;
          offset += place.normal.dot(d);
        }
      place.at += offset / n * place.normal;
    }
  });
  const double scatter = middleOf(places.size(), threads, [&](std::size_t k) {
    const FacePlace& place = places[k];
    double n = 0;
    double sum = 0;
    if (!place.normal.isZero())
      points.forEachIndexWithin(place.at, reach * scale, [&](std::size_t i) {
        const double d = place.normal.dot(places[i].at - place.at);
        if (std::abs(d) < strip) {
          ++n;
          sum += d * d;
        }
      });
    return n > 0 ? std::sqrt(sum / n) : -1;
  });
  sigma = std::max(0.002, scatter);
}

std::vector<std::pair<double, double>>
FacePlaces::alongDirection(const Eigen::Vector2d& normal) const
{
  constexpr int bins = 2; // with such places, besides its own
  const double bin = FaceCurve::bin * scale;
  const double beside = 2.6 * bin;
  const Eigen::Vector2d way = leftOf(normal);
  std::vector<std::pair<double, double>> found;
  for (const FacePlace& place : places) {
    if (!place.normal.isZero() && std::abs(place.normal.dot(normal)) < 0.8)
      continue;
    unsigned filled = 0;
    points.forEachWithin(place.at, beside, [&](const Eigen::Vector2d& q) {
      const Eigen::Vector2d d = q - place.at;
      if (std::abs(normal.dot(d)) < strip)
        filled |= 1U << (3 + static_cast<int>(std::lround(way.dot(d) / bin)));
    });
    const auto isFilled = [&](int k) { return (filled >> (3 + k) & 1U) != 0; };
    int full = 0;
    for (int side : {-1, 1})
      for (int k = side; std::abs(k) < 3 && isFilled(k); k += side)
        ++full;
    if (full >= bins)
      found.emplace_back(normal.dot(place.at), way.dot(place.at));
  }
  return found;
}

} // namespace pcl::sedr
