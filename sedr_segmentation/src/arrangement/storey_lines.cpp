// SPDX-License-Identifier: BSD-3-Clause
#include "storey_lines.h"

#include "../curves/place_sums.h"
#include "../curves/plan_points.h"
#include "../faces/wall_lines.h"
#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/smooth_counts.h"
#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double near_line = 0.03; // metres, of surfaces from their line
constexpr double apart = 0.04;     // metres, of two lines along each other
constexpr double max_gap = 5;      // metres, within a line
constexpr double beyond = 2.5;     // metres that a line goes on
constexpr double aligned = 0.966;  // cosine

/** @brief A place at a surface or at the end of air, and the normal there. */
struct NormalPlace {
  Eigen::Vector2d at;
  Eigen::Vector2d normal;
};

/** @brief Returns the places of surfaces around which others lie along a line. */
std::vector<NormalPlace>
surfacesOf(const std::vector<Eigen::Vector2d>& places)
{
  constexpr double reach = 0.15; // metres
  constexpr double flat = 0.15;  // variance across to that along
  std::vector<NormalPlace> found;
  const PlanPoints points(places, reach);
  for (const Eigen::Vector2d& p : points.all()) {
    PlaceSums sums; // relative to here: far from the origin, squares lose their digits
    points.forEachWithin(p, reach, [&](const Eigen::Vector2d& q) { sums.add(q - p); });
    const Eigen::Vector2d normal = sums.normal();
    const double across = normal.dot(sums.covariance() * normal);
    if (sums.n >= 5 && across < flat * (sums.covariance().trace() - across))
      found.push_back({p, normal});
  }
  return found;
}

/** @brief Returns the places where the seen air of a room ends, normals out of it. */
std::vector<NormalPlace>
endsOfAir(const RoomCells& room, const CellGrid& grid)
{
  constexpr double holes = 3; // cells
  constexpr int reach = 3;    // cells
  const CellMask seen = eroded(dilated(room.seen, holes), holes);
  std::vector<NormalPlace> ends;
  for (std::size_t i = 0; i < seen.values().size(); ++i) {
    const Cell cell = seen.cellAt(i);
    if (!seen.values()[i] ||
        (seen.at({cell.x + 1, cell.y}) && seen.at({cell.x - 1, cell.y}) &&
         seen.at({cell.x, cell.y + 1}) && seen.at({cell.x, cell.y - 1})))
      continue;
    Eigen::Vector2d out = Eigen::Vector2d::Zero();
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        if (!seen.at({cell.x + x, cell.y + y}))
          out += Eigen::Vector2d(x, y);
    if (out.norm() > 0)
      ends.push_back(
          {grid.centre(cell) + grid.size() / 2 * out.normalized(), out.normalized()});
  }
  return ends;
}

/** @brief Returns the offsets at which most places lie along a direction, the highest
 * peak first, none within `apart` metres of a higher one. */
std::vector<double>
peaksOf(const std::vector<std::pair<double, double>>& places,
        double sigma,
        double least)
{
  std::vector<double> offsets;
  for (const auto& [offset, s] : places)
    offsets.push_back(offset);
  const SmoothCounts smooth(offsets, sigma);
  const std::vector<double>& counts = smooth.counts;
  std::vector<std::pair<double, double>> peaks; // height, offset
  for (std::size_t k = 1; k + 1 < counts.size(); ++k)
    if (counts[k] > counts[k - 1] && counts[k] >= counts[k + 1] && counts[k] > least)
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

/** @brief Limits of the runs of places that make a line, metres. */
struct RunLimits {
  double sigma;  ///< of the offsets of one line
  double around; ///< farthest of its places from it
  double gap;    ///< within it
  double length; ///< minimum, in bins that hold a place
};

/** @brief Appends a line for each run of places with one offset along a direction.
 * @param normal of the lines */
void
appendRuns(const std::vector<NormalPlace>& surfaces,
           const Eigen::Vector2d& normal,
           const RunLimits& limits,
           std::vector<StoreyLine>& lines)
{
  const Eigen::Vector2d way = leftOf(normal);
  std::vector<std::pair<double, double>> places; // offset, along
  for (const NormalPlace& surface : surfaces)
    if (std::abs(surface.normal.dot(normal)) > aligned)
      places.emplace_back(normal.dot(surface.at), way.dot(surface.at));
  if (places.empty())
    return;
  std::sort(places.begin(), places.end());
  for (const double offset :
       peaksOf(places, limits.sigma, 2 * limits.length / StoreyLine::bin)) {
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
        bins.insert(std::lround(on[j].first / StoreyLine::bin));
      }
      if (static_cast<double>(bins.size()) * StoreyLine::bin < limits.length)
        continue;
      StoreyLine line;
      line.curve.direction = way;
      line.curve.point = middleValue(std::move(offsets)) * normal;
      line.from = on[i].first;
      line.to = on[j - 1].first;
      lines.push_back(std::move(line));
    }
  }
}

/** @brief Closes holes of up to 0.2 m and drops parts shorter than 0.15 m. */
void
clean(std::vector<float>& bins)
{
  constexpr std::ptrdiff_t hole = 4;
  constexpr std::ptrdiff_t shortest = 3;
  for (const bool is_hole : {true, false})
    for (auto first = bins.begin(); first != bins.end();) {
      const bool is_seen = *first > 0;
      const auto last =
          std::find_if(first, bins.end(), [&](float v) { return (v > 0) != is_seen; });
      if (is_hole && !is_seen && last - first <= hole && first != bins.begin() &&
          last != bins.end())
        std::fill(first, last, std::min(*std::prev(first), *last));
      if (!is_hole && is_seen && last - first < shortest)
        std::fill(first, last, 0.F);
      first = last;
    }
}

/** @brief Finds where each room saw the surface of a line. */
void
observe(const Storey& storey, const std::vector<RoomCells>& cells, StoreyLine& line)
{
  const auto bins =
      static_cast<std::size_t>(std::ceil((line.to - line.from) / StoreyLine::bin)) + 1;
  line.any.assign(bins, 0);
  for (const std::size_t r : storey.rooms) {
    std::vector<float> seen(bins, 0);
    for (const Eigen::Vector2d& p : cells[r].wall_points) {
      const double d = line.curve.distance(p) / near_line;
      const double s = d < 1 ? line.along(p) : line.to + 1;
      if (s < line.from || s > line.to)
        continue;
      float& value = seen[static_cast<std::size_t>((s - line.from) / StoreyLine::bin)];
      value = std::max(value, static_cast<float>(1 - d * d));
    }
    clean(seen);
    for (std::size_t i = 0; i < bins; ++i)
      line.any[i] = std::max(line.any[i], seen[i]);
    if (std::any_of(seen.begin(), seen.end(), [](float v) { return v > 0; }))
      line.seen.emplace(static_cast<std::uint32_t>(r), std::move(seen));
  }
  const auto n = static_cast<std::ptrdiff_t>(bins);
  const auto none = static_cast<std::ptrdiff_t>(1e6);
  std::vector<std::ptrdiff_t> since(bins, none); // bins from the surface before
  std::vector<std::ptrdiff_t> until(bins, none); // and to the next one
  for (std::ptrdiff_t i = 0, count = none; i < n; ++i)
    since[static_cast<std::size_t>(i)] = count =
        line.any[static_cast<std::size_t>(i)] > 0 ? 0 : count + 1;
  for (std::ptrdiff_t i = n, count = none; i-- > 0;)
    until[static_cast<std::size_t>(i)] = count =
        line.any[static_cast<std::size_t>(i)] > 0 ? 0 : count + 1;
  line.between.assign(bins, StoreyLine::Between::Nothing);
  for (std::size_t i = 0; i < bins; ++i)
    if (static_cast<double>(since[i] + until[i]) < max_gap / StoreyLine::bin)
      line.between[i] = StoreyLine::Between::Gap;
    else if (static_cast<double>(std::min(since[i], until[i])) <
             beyond / StoreyLine::bin)
      line.between[i] = StoreyLine::Between::Beyond;
}

/** @brief Appends the long lines along no main direction, and the arcs that are known.
 */
void
appendOthers(const Storey& storey,
             const std::vector<double>& axes,
             const std::vector<PlanRoom>& rooms,
             std::vector<StoreyLine>& lines)
{
  constexpr double shortest = 1; // metre, of an oblique surface
  const double max_turn = radians(3);
  for (const WallLine& wall : storey.lines) {
    const double angle = std::atan2(wall.normal.y(), wall.normal.x());
    const auto is_seen = [](AlongLine what) { return what == AlongLine::Surface; };
    const auto first = std::find_if(wall.places.begin(), wall.places.end(), is_seen);
    const auto last = std::find_if(wall.places.rbegin(), wall.places.rend(), is_seen);
    StoreyLine line;
    line.parameters = 2;
    line.curve.direction = leftOf(wall.normal);
    line.curve.point = wall.offset * wall.normal;
    line.from =
        wall.start + static_cast<double>(first - wall.places.begin()) * wall.cell;
    line.to = wall.start + static_cast<double>(wall.places.rend() - last) * wall.cell;
    if (std::abs(angleOff(angle, axes)) > max_turn && line.to - line.from > shortest)
      lines.push_back(std::move(line));
  }
  for (const std::size_t r : storey.rooms)
    for (const PlanElement& e : rooms[r].boundary.elements) {
      if (!e.isArc())
        continue;
      const Eigen::Vector2d start = (e.counter_clockwise ? e.start : e.end) - e.centre;
      StoreyLine arc;
      arc.parameters = 3;
      arc.curve = carrierOf(e);
      arc.from = std::atan2(start.y(), start.x()) * e.radius;
      arc.to = arc.from + e.length();
      lines.push_back(std::move(arc));
    }
}

/** @brief Appends the lines at which the air of a room ends without a surface. */
void
appendEnds(const RoomCells& room,
           const CellGrid& grid,
           const std::vector<Eigen::Vector2d>& normals,
           std::vector<StoreyLine>& lines)
{
  constexpr double near = 0.2; // metres
  constexpr double on = 1;     // metre that a line goes on
  std::vector<NormalPlace> ends;
  for (const NormalPlace& end : endsOfAir(room, grid)) {
    const auto isBeside = [&](const StoreyLine& line) {
      const double s = line.along(end.at);
      return !line.is_end && line.curve.distance(end.at) < near &&
             s > line.from - near && s < line.to + near &&
             std::abs(line.curve.tangentAt(end.at).dot(end.normal)) < 0.7;
    };
    if (std::none_of(lines.begin(), lines.end(), isBeside))
      ends.push_back(end);
  }
  const std::size_t first = lines.size();
  for (const Eigen::Vector2d& normal : normals)
    appendRuns(ends, normal, {grid.size(), 2 * grid.size(), 1, 0.5}, lines);
  for (std::size_t k = first; k < lines.size(); ++k) {
    lines[k].is_end = true;
    lines[k].from -= on;
    lines[k].to += on;
  }
}

} // namespace

double
StoreyLine::along(const Eigen::Vector2d& p) const
{
  if (!curve.isCircle())
    return curve.direction.dot(p - curve.point);
  const Eigen::Vector2d d = p - curve.point;
  double s = std::atan2(d.y(), d.x()) * curve.radius;
  while (s < from)
    s += 2 * M_PI * curve.radius;
  return s;
}

Eigen::Vector2d
StoreyLine::at(double s) const
{
  if (!curve.isCircle())
    return curve.point + s * curve.direction;
  const double angle = s / curve.radius;
  return curve.point + curve.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

double
StoreyLine::seenAt(const Eigen::Vector2d& p) const
{
  const double s = along(p);
  return s < from || s >= to
             ? -1
             : static_cast<double>(
                   any[static_cast<std::size_t>((s - from) / StoreyLine::bin)]);
}

double
StoreyLine::support() const
{
  return StoreyLine::bin * static_cast<double>(std::count_if(
                               any.begin(), any.end(), [](float v) { return v > 0; }));
}

std::vector<StoreyLine>
storeyLines(const Storey& storey,
            const std::vector<RoomCells>& cells,
            const CellGrid& grid,
            const std::vector<PlanRoom>& rooms)
{
  std::vector<double> angles;
  std::vector<double> weights;
  for (const WallLine& line : storey.lines) {
    angles.push_back(std::atan2(line.normal.y(), line.normal.x()));
    weights.push_back(static_cast<double>(
        std::count(line.places.begin(), line.places.end(), AlongLine::Surface)));
  }
  const std::vector<double> axes = mainAngles(angles, weights, 3, 0.2);
  std::vector<Eigen::Vector2d> normals;
  for (const double axis : axes) {
    normals.emplace_back(std::cos(axis), std::sin(axis));
    normals.push_back(leftOf(normals.back()));
  }
  std::vector<NormalPlace> surfaces;
  for (const std::size_t r : storey.rooms) {
    const std::vector<NormalPlace> of_room = surfacesOf(cells[r].wall_points);
    surfaces.insert(surfaces.end(), of_room.begin(), of_room.end());
  }
  std::vector<StoreyLine> lines;
  for (const Eigen::Vector2d& normal : normals)
    appendRuns(surfaces, normal, {0.015, 0.025, max_gap, 0.2}, lines);
  appendOthers(storey, axes, rooms, lines);
  for (const std::size_t r : storey.rooms)
    appendEnds(cells[r], grid, normals, lines);
  for (StoreyLine& line : lines) {
    if (!line.curve.isCircle() && !line.is_end) {
      line.from -= beyond;
      line.to += beyond;
    }
    observe(storey, cells, line);
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const StoreyLine& a, const StoreyLine& b) {
                     return std::make_tuple(a.is_end, -a.support(), a.from - a.to) <
                            std::make_tuple(b.is_end, -b.support(), b.from - b.to);
                   });
  return lines;
}

} // namespace pcl::sedr
