// SPDX-License-Identifier: BSD-3-Clause
#include "face_lines.h"

#include "sedr_filters/src/base/quantiles.h"
#include "sedr_filters/src/base/smooth_counts.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl::sedr {

namespace {

/** @brief Returns the offsets at which most places lie, the highest peak first, none
 * near a higher one. */
std::vector<double>
peaksOf(const std::vector<std::pair<double, double>>& places, const RunLimits& limits)
{
  constexpr double apart = 0.04; // metres
  std::vector<double> offsets;
  for (const auto& [offset, s] : places)
    offsets.push_back(offset);
  const SmoothCounts smooth(offsets, limits.spread);
  const std::vector<double>& counts = smooth.counts;
  std::vector<std::pair<double, double>> peaks; // height, offset
  for (std::size_t k = 1; k + 1 < counts.size(); ++k)
    if (counts[k] > counts[k - 1] && counts[k] >= counts[k + 1] &&
        counts[k] > 2 * limits.length / FaceCurve::bin)
      peaks.emplace_back(-counts[k],
                         smooth.first + static_cast<double>(k) * smooth.bin);
  std::sort(peaks.begin(), peaks.end());
  std::vector<double> kept;
  for (const auto& [height, offset] : peaks)
    if (std::none_of(kept.begin(), kept.end(), [o = offset](double other) {
          return std::abs(other - o) < apart;
        }))
      kept.push_back(offset);
  return kept;
}

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

std::vector<FaceCurve>
linesAlong(std::vector<std::pair<double, double>> places,
           const Eigen::Vector2d& normal,
           const RunLimits& limits)
{
  std::vector<FaceCurve> lines;
  if (places.empty())
    return lines;
  std::sort(places.begin(), places.end());
  for (const double offset : peaksOf(places, limits)) {
    std::vector<std::pair<double, double>> on; // along, offset
    for (auto i = std::lower_bound(places.begin(), places.end(),
                                   std::make_pair(offset - limits.around, -1e9));
         i != places.end() && i->first < offset + limits.around; ++i)
      on.emplace_back(i->second, i->first);
    std::sort(on.begin(), on.end());
    for (std::size_t i = 0, j = 0; i < on.size(); i = j) {
      std::vector<double> offsets;
      std::set<long> bins;
      for (j = i;
           j < on.size() && (j == i || on[j].first - on[j - 1].first < limits.gap);
           ++j) {
        offsets.push_back(on[j].second);
        bins.insert(std::lround(on[j].first / FaceCurve::bin));
      }
      if (static_cast<double>(bins.size()) * FaceCurve::bin < limits.length)
        continue;
      FaceCurve line;
      line.curve.direction = leftOf(normal);
      line.curve.point = middleValue(std::move(offsets)) * normal;
      line.from = on[i].first;
      line.to = on[j - 1].first;
      lines.push_back(line);
    }
  }
  return lines;
}

} // namespace pcl::sedr
