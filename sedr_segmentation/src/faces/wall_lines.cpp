// SPDX-License-Identifier: BSD-3-Clause
#include "wall_lines.h"

#include "../curves/place_sums.h"
#include "../curves/plan_points.h"
#include "sedr_filters/src/base/densest_window.h"
#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::sedr {

namespace {

struct Line {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double offset = 0;
};

/** @brief The places of surfaces with their normals, from which lines are taken. */
class LineSearch {
public:
  LineSearch(const std::vector<SurfacePlace>& places, const WallLineParameters& p)
      : p_(p)
      , places_(positions(places), 0.5)
      , normals_(places_.size(), Eigen::Vector2d::UnitX())
      , is_left_(places_.size(), 1)
  {
    for (std::size_t i = 0; i < size(); ++i)
      rooms_.push_back(places[places_.given(i)].room);
    // Relative to the first place: far from the origin, squares lose their digits.
    for (std::size_t i = 0; i < size(); ++i) {
      PlaceSums sums;
      places_.forEachIndexWithin(at(i), p.neighbours,
                                 [&](std::size_t k) { sums.add(at(k) - at(i)); });
      if (sums.n > 2)
        normals_[i] = sums.normal();
    }
  }

  std::size_t size() const { return places_.size(); }
  const Eigen::Vector2d& at(std::size_t i) const { return places_.all()[i]; }

  bool isOn(const Line& line, std::size_t i, double tolerance) const
  {
    constexpr double aligned = 0.9; // cosine
    return std::abs(line.normal.dot(at(i)) - line.offset) < tolerance &&
           std::abs(line.normal.dot(normals_[i])) > aligned;
  }

  /** @brief Takes the lines with at least `least` places out, the straightest
   * surroundings first. */
  std::vector<Line> takeLines(std::size_t least)
  {
    constexpr double local = 0.5;
    std::vector<std::size_t> support(size(), 0);
    for (std::size_t i = 0; i < size(); ++i) {
      const Line line{normals_[i], normals_[i].dot(at(i))};
      places_.forEachIndexWithin(at(i), local, [&](std::size_t k) {
        support[i] += isOn(line, k, p_.tolerance) ? 1 : 0;
      });
    }
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return support[a] > support[b];
    });
    std::vector<Line> lines;
    for (const std::size_t seed : order) {
      if (!is_left_[seed])
        continue;
      Line line{normals_[seed], normals_[seed].dot(at(seed))};
      std::size_t on = 0;
      for (const double reach : {0.5, 1.0, 2.0, 5.0, 1e9, 1e9})
        if (on = fitNear(seed, reach, line); on < 3 && reach > 2)
          break; // few places are on it: all of the storey need not be asked
      if (on < least)
        continue;
      for (std::size_t k = 0; k < size(); ++k)
        if (is_left_[k] && isOn(line, k, 1.5 * p_.tolerance))
          is_left_[k] = 0;
      lines.push_back(line);
    }
    return lines;
  }

  std::uint32_t room(std::size_t i) const { return rooms_[i]; }

private:
  static std::vector<Eigen::Vector2d> positions(const std::vector<SurfacePlace>& places)
  {
    std::vector<Eigen::Vector2d> all;
    for (const SurfacePlace& place : places)
      all.push_back(place.at);
    return all;
  }

  /** @brief Fits a line to the places left on it within `reach` of a seed.
   * @return their number */
  std::size_t fitNear(std::size_t seed, double reach, Line& line) const
  {
    PlaceSums sums;
    const auto add = [&](std::size_t k) {
      if (is_left_[k] && isOn(line, k, p_.tolerance))
        sums.add(at(k) - at(seed));
    };
    if (reach < 1e6)
      places_.forEachIndexWithin(at(seed), reach, add);
    else
      for (std::size_t k = 0; k < size(); ++k)
        add(k);
    if (sums.n < 3)
      return 0;
    line.normal = sums.normal();
    line.offset = line.normal.dot(sums.sum / sums.n + at(seed));
    return static_cast<std::size_t>(sums.n);
  }

  const WallLineParameters& p_;
  PlanPoints places_;
  std::vector<std::uint32_t> rooms_; ///< of each place
  std::vector<Eigen::Vector2d> normals_;
  std::vector<std::uint8_t> is_left_;
};

/** @brief Turns a line into a main direction if most of its places agree, or if it is
 * a degree off at least. */
void
snap(const LineSearch& search,
     const std::vector<double>& axes,
     const WallLineParameters& p,
     Line& line)
{
  const double angle = std::atan2(line.normal.y(), line.normal.x());
  const double turn = angleOff(angle, axes);
  if (!(std::abs(turn) < radians(p.snap)))
    return;
  const Eigen::Vector2d v(std::cos(angle - turn), std::sin(angle - turn));
  std::vector<double> offsets;
  for (std::size_t i = 0; i < search.size(); ++i)
    if (search.isOn(line, i, p.tolerance))
      offsets.push_back(v.dot(search.at(i)));
  if (offsets.empty())
    return;
  std::sort(offsets.begin(), offsets.end());
  const auto [first, last] = densestWindow(offsets, 2 * p.tolerance);
  constexpr double most_agree = 0.7;
  if (static_cast<double>(last - first + 1) >
          most_agree * static_cast<double>(offsets.size()) ||
      std::abs(turn) > radians(p.same_direction))
    line = {v, offsets[(first + last) / 2]};
}

using Part = std::pair<std::size_t, std::size_t>; ///< [first, last) of cells

/** @brief Returns the runs of cells in which a surface was seen, without small holes
 * and short parts. */
std::vector<Part>
partsOf(const std::vector<std::uint8_t>& cells, const WallLineParameters& p)
{
  const auto hole = static_cast<std::size_t>(std::lround(p.max_hole / p.cell));
  const auto shortest = static_cast<std::size_t>(std::lround(p.min_part / p.cell));
  std::vector<Part> parts;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i]) {
      if (!parts.empty() && i - parts.back().second <= 2 * hole)
        parts.back().second = i + 1;
      else
        parts.push_back({i, i + 1});
    }
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                             [&](const auto& part) {
                               return part.second - part.first < shortest;
                             }),
              parts.end());
  return parts;
}

} // namespace

double
angleOff(double angle, const std::vector<double>& axes)
{
  double least = M_PI / 2;
  for (const double axis : axes) {
    const double d = std::remainder(angle - axis, M_PI / 2);
    if (std::abs(d) < std::abs(least))
      least = d;
  }
  return least;
}

std::vector<double>
mainAngles(const std::vector<double>& angles,
           const std::vector<double>& weights,
           std::size_t most,
           double least)
{
  constexpr std::size_t steps = 360; // of a quarter turn
  const double spread = radians(0.7);
  const double near = radians(1.5);
  const double apart = radians(5);
  std::vector<double> axes;
  std::vector<double> height(steps, 0);
  const auto angleAt = [](std::size_t g) {
    return static_cast<double>(g) * (M_PI / 2) / static_cast<double>(steps);
  };
  for (std::size_t g = 0; g < steps; ++g)
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const double d = std::remainder(angles[i] - angleAt(g), M_PI / 2) / spread;
      if (std::abs(d) < 5)
        height[g] += weights[i] * std::exp(-0.5 * d * d);
    }
  double first = 0;
  while (axes.size() < most) {
    const auto top = std::max_element(height.begin(), height.end());
    if (axes.empty())
      first = *top;
    if (!(*top > 0) || *top < least * first)
      break;
    const double angle = angleAt(static_cast<std::size_t>(top - height.begin()));
    std::vector<std::pair<double, double>> turns; // from the angle, weight
    double left = 0; // half of the weight: a median, since some lines lean
    for (std::size_t i = 0; i < angles.size(); ++i)
      if (const double d = std::remainder(angles[i] - angle, M_PI / 2);
          std::abs(d) < near) {
        turns.push_back({d, weights[i]});
        left += weights[i] / 2;
      }
    std::sort(turns.begin(), turns.end());
    std::size_t middle = 0;
    while (middle + 1 < turns.size() && (left -= turns[middle].second) > 0)
      ++middle;
    axes.push_back(angle + (turns.empty() ? 0 : turns[middle].first));
    for (std::size_t g = 0; g < steps; ++g)
      if (std::abs(std::remainder(angleAt(g) - axes.back(), M_PI / 2)) <= apart)
        height[g] = 0;
  }
  return axes;
}

std::vector<WallLine>
wallLines(std::vector<SurfacePlace> places,
          const std::vector<SurfacePlace>& lower,
          const WallLineParameters& p)
{
  constexpr std::size_t least = 6; // places of a line: 0.3 m
  std::vector<WallLine> result;
  if (places.size() < least)
    return result;
  LineSearch search(std::move(places), p);
  std::vector<Line> lines = search.takeLines(least);
  std::vector<double> angles;
  std::vector<double> weights;
  for (const Line& line : lines) {
    angles.push_back(std::atan2(line.normal.y(), line.normal.x()));
    double on = 0;
    for (std::size_t i = 0; i < search.size(); ++i)
      on += search.isOn(line, i, p.tolerance) ? 1 : 0;
    weights.push_back(on);
  }
  const std::vector<double> axes = mainAngles(angles, weights, 3, 0.2);
  for (Line& line : lines) {
    snap(search, axes, p, line);
    const Eigen::Vector2d along(-line.normal.y(), line.normal.x());
    std::vector<std::pair<double, std::uint32_t>> s; // along the line, room
    for (std::size_t i = 0; i < search.size(); ++i)
      if (search.isOn(line, i, 1.5 * p.tolerance))
        s.push_back({along.dot(search.at(i)), search.room(i)});
    if (s.empty())
      continue;
    std::sort(s.begin(), s.end());
    const double low = s.front().first;
    const double high = s.back().first;
    const auto beyond = static_cast<std::size_t>(std::lround(p.beyond / p.cell));
    WallLine wall;
    wall.normal = line.normal;
    wall.offset = line.offset;
    wall.start = low - p.beyond;
    wall.cell = p.cell;
    std::vector<std::uint8_t> cells(
        static_cast<std::size_t>((high - low) / p.cell) + 1 + 2 * beyond, 0);
    wall.owner.assign(cells.size(), 0);
    for (const auto& [at, room] : s) {
      const auto cell = static_cast<std::size_t>((at - wall.start) / p.cell);
      cells[cell] = 1;
      wall.owner[cell] = room;
    }
    for (std::size_t i = 1; i < cells.size(); ++i) // small holes have the owner before
      if (!cells[i])
        wall.owner[i] = wall.owner[i - 1];
    const auto parts = partsOf(cells, p);
    std::size_t longest = 0;
    for (const auto& [from, to] : parts)
      longest = std::max(longest, to - from);
    const bool is_oblique =
        std::abs(angleOff(std::atan2(wall.normal.y(), wall.normal.x()), axes)) > 1e-6;
    if (parts.empty() ||
        (is_oblique && static_cast<double>(longest) * p.cell < p.min_oblique))
      continue;
    std::vector<std::uint8_t> is_low(cells.size(), 0);
    for (const auto& [q, room] : lower)
      if (std::abs(line.normal.dot(q) - line.offset) < p.cell)
        if (const double at = (along.dot(q) - wall.start) / p.cell;
            at >= 0 && at < static_cast<double>(cells.size()))
          is_low[static_cast<std::size_t>(at)] = 1;
    wall.places.assign(cells.size(), AlongLine::Nothing);
    const auto fill = [&](const Part& part, AlongLine what) {
      std::fill(wall.places.begin() + static_cast<std::ptrdiff_t>(part.first),
                wall.places.begin() + static_cast<std::ptrdiff_t>(part.second), what);
    };
    for (const auto& [from, to] : parts)
      fill({from - std::min(from, beyond), std::min(to + beyond, cells.size())},
           AlongLine::Ended);
    const auto hole = static_cast<std::size_t>(std::lround(p.max_hole / p.cell));
    for (const Part& low_part : partsOf(is_low, p)) {
      const auto isBeside = [&](const Part& part) {
        return part.first <= low_part.second + 2 * hole &&
               low_part.first <= part.second + 2 * hole;
      };
      if (std::any_of(parts.begin(), parts.end(), isBeside))
        fill(low_part, AlongLine::Lower);
    }
    const auto wide = static_cast<std::size_t>(std::lround(p.max_gap / p.cell));
    for (std::size_t k = 1; k < parts.size(); ++k)
      if (parts[k].first - parts[k - 1].second < wide)
        fill({parts[k - 1].second, parts[k].first}, AlongLine::Gap);
    for (const Part& part : parts)
      fill(part, AlongLine::Surface);
    result.push_back(std::move(wall));
  }
  return result;
}

} // namespace pcl::sedr
