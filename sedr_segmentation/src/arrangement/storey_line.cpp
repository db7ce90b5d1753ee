// SPDX-License-Identifier: BSD-3-Clause
#include "storey_line.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double max_hidden = 5;   // metres, between parts of a face, or to a corner
constexpr std::ptrdiff_t hole = 4; // bins, in the places on a face: they are sparse

/** @brief Closes holes of up to 0.2 m and drops parts shorter than 0.15 m. */
void
clean(std::vector<float>& bins)
{
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

/** @brief Checks whether a surface up to the ceiling is seen on a line at a place of
 * it, or near enough to go on there hidden. A turn that goes on is seen. */
bool
mayReach(const StoreyLine& line, const Eigen::Vector2d& p)
{
  const double hidden = line.curve.isCircle() ? 0 : max_hidden;
  const double t = line.along(p);
  if (t < line.from - hidden || t > line.to + hidden)
    return false;
  const auto binAt = [&](double at) {
    return line.tall.begin() +
           static_cast<std::ptrdiff_t>(
               (std::clamp(at, line.from, line.to) - line.from) / StoreyLine::bin);
  };
  return std::any_of(binAt(t - hidden), binAt(t + hidden) + 1,
                     [](float v) { return v > 0; });
}

/** @brief Returns the way back, or on, from each bin to the next one with a surface,
 * metres. */
std::vector<double>
waysToSurface(const std::vector<float>& tall, bool back)
{
  std::vector<double> ways(tall.size());
  double way = 1e6;
  for (std::size_t k = 0; k < tall.size(); ++k) {
    const std::size_t i = back ? k : tall.size() - 1 - k;
    ways[i] = way = tall[i] > 0 ? 0 : way + StoreyLine::bin;
  }
  return ways;
}

/** @brief Calls `visit(first, last)` for each value with those up to `reach` beside it.
 */
template <typename Value, typename Visitor>
void
forWindows(const std::vector<Value>& values, std::ptrdiff_t reach, Visitor visit)
{
  for (auto at = values.begin(); at != values.end(); ++at)
    visit(at - std::min(reach, at - values.begin()),
          at + std::min(reach + 1, values.end() - at));
}

} // namespace

double
StoreyLine::seenAt(const Eigen::Vector2d& p) const
{
  const double s = along(p);
  return s < from || s >= to || curve.distance(p) > near
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

Eigen::AlignedBox2d
StoreyLine::box() const
{
  Eigen::AlignedBox2d around;
  if (curve.isCircle()) {
    const Eigen::Vector2d reach = Eigen::Vector2d::Constant(curve.radius);
    around.extend(curve.point - reach);
    around.extend(curve.point + reach);
  }
  else {
    around.extend(at(from));
    around.extend(at(to));
  }
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(near);
  return {around.min() - margin, around.max() + margin};
}

LineEvidence::LineEvidence(const StoreyEvidence& storey, const FacePlaces& faces)
    : storey_(storey)
    , faces_(faces)
{
  const auto near = [](const CellMask& cells) {
    return dilated(cells, 1.5); // cells: also across corners
  };
  std::vector<Eigen::Vector2d> parts;
  std::vector<Eigen::Vector2d> places;
  for (const std::size_t r : storey.storey.rooms) {
    const RoomCells& room = storey.cells[r];
    wall_rooms_.resize(wall_rooms_.size() + room.wall_points.size(),
                       static_cast<std::uint32_t>(r));
    parts.insert(parts.end(), room.part_points.begin(), room.part_points.end());
    for (const Eigen::Vector3f& p : room.height_points) {
      places.emplace_back(p.head<2>().cast<double>());
      heights_.push_back(p.z());
    }
    opaque_.push_back(near(unite(subtract(room.solid, room.glass), room.pillar)));
    part_.push_back(near(unite(unite(room.base, room.riser), room.glass)));
  }
  parts_ = PlanPoints(parts, 2 * StoreyLine::bin);
  height_points_ = PlanPoints(places, 2 * StoreyLine::bin);
}

bool
LineEvidence::isIn(const std::vector<CellMask>& masks, Cell cell)
{
  return std::any_of(masks.begin(), masks.end(),
                     [&](const CellMask& mask) { return mask.at(cell) != 0; });
}

Cell
LineEvidence::cellAt(const StoreyLine& line, std::size_t bin) const
{
  const Eigen::Vector2d p =
      line.at(line.from + (static_cast<double>(bin) + 0.5) * StoreyLine::bin);
  return storey_.grid.at(p.x(), p.y());
}

template <typename Visitor>
void
LineEvidence::forEachOn(const StoreyLine& line,
                        const PlanPoints& points,
                        Visitor visit) const
{
  const double step = 2 * StoreyLine::bin;
  const auto steps =
      static_cast<std::size_t>(std::ceil((line.to - line.from) / step)) + 1;
  for (std::size_t k = 0; k < steps; ++k)
    points.forEachIndexWithin(
        line.at(std::min(line.to, line.from + static_cast<double>(k) * step)),
        std::hypot(line.near, step), [&](std::size_t i) {
          const Eigen::Vector2d& p = points.all()[i];
          const double d = line.curve.distance(p) / line.near;
          if (const double s = line.along(p); d < 1 && s >= line.from && s <= line.to)
            visit(i, static_cast<std::size_t>((s - line.from) / StoreyLine::bin), s, d);
        });
}

void
LineEvidence::observe(StoreyLine& line) const
{
  const auto bins =
      static_cast<std::size_t>(std::ceil((line.to - line.from) / StoreyLine::bin)) + 1;
  line.any.assign(bins, 0);
  line.seen.clear();
  line.edges.clear();
  std::vector<std::pair<double, double>> ends(bins, {line.to, line.from}); // of places
  forEachOn(line, faces_.points, [&](std::size_t k, std::size_t i, double s, double d) {
    if (!faces_.places[k].mayLieOn(line.curve, 0.7)) // of a reveal or another wall
      return;
    std::vector<float>& seen = line.seen[wall_rooms_[faces_.points.given(k)]];
    seen.resize(bins, 0);
    seen[i] = std::max(seen[i], static_cast<float>(1 - d * d));
    ends[i] = {std::min(ends[i].first, s), std::max(ends[i].second, s)};
  });
  for (auto room = line.seen.begin(); room != line.seen.end();) {
    const std::vector<float>& seen = room->second;
    clean(room->second);
    for (std::size_t i = 0; i < bins; ++i)
      line.any[i] = std::max(line.any[i], seen[i]);
    const bool is_seen =
        std::any_of(seen.begin(), seen.end(), [](float v) { return v > 0; });
    room = is_seen ? std::next(room) : line.seen.erase(room);
  }
  for (std::size_t i = 0; i < bins; ++i) {
    if (line.any[i] > 0 && (i == 0 || !(line.any[i - 1] > 0)))
      line.edges.push_back(ends[i].first - StoreyLine::bin / 2);
    if (line.any[i] > 0 && (i + 1 == bins || !(line.any[i + 1] > 0)))
      line.edges.push_back(ends[i].second + StoreyLine::bin / 2);
  }
  line.tall = line.any;
  for (std::size_t i = 0; i < bins; ++i)
    if (line.tall[i] > 0 && !isIn(opaque_, cellAt(line, i)))
      line.tall[i] = 0;
  clean(line.tall);
}

void
LineEvidence::findHeights(StoreyLine& line) const
{
  using Levels = std::uint16_t; // a bit for each of as many shares of the height
  const int count = std::numeric_limits<Levels>::digits;
  std::vector<Levels> levels(line.any.size(), 0);
  forEachOn(line, height_points_, [&](std::size_t k, std::size_t i, double, double) {
    const auto level =
        static_cast<int>(heights_[height_points_.given(k)] * static_cast<float>(count));
    levels[i] = static_cast<Levels>(levels[i] | 1U << std::min(level, count - 1));
  });
  std::vector<float> shares;
  forWindows(levels, hole, [&](auto first, auto last) {
    const unsigned near = std::accumulate(first, last, 0U, std::bit_or<>());
    shares.push_back(static_cast<float>(__builtin_popcount(near)) /
                     static_cast<float>(count));
  });
  // Beside its windows a wall is seen from floor to ceiling.
  const auto reach = static_cast<std::ptrdiff_t>(max_gap / StoreyLine::bin);
  line.height.clear();
  forWindows(shares, reach, [&](auto first, auto last) {
    line.height.push_back(*std::max_element(first, last));
  });
}

void
LineEvidence::extendToCorners(const std::vector<StoreyLine>& lines,
                              StoreyLine& line) const
{
  constexpr double past = 0.1;     // metres
  constexpr double parallel = 0.7; // cosine
  if (line.curve.isCircle() || line.edges.empty())
    return;
  const double first = line.edges.front() - max_hidden;
  const double last = line.edges.back() + max_hidden;
  Eigen::AlignedBox2d box(line.at(first));
  box.extend(line.at(last));
  const Eigen::Vector2d hidden = Eigen::Vector2d::Constant(max_hidden); // of others
  box = {box.min() - hidden, box.max() + hidden};
  double before = first - 1; // the next corners
  double after = last + 1;
  for (const StoreyLine& other : lines) {
    if (!box.intersects(other.box()))
      continue;
    for (const Eigen::Vector2d& p : intersections(line.curve, other.curve)) {
      const double s = line.along(p);
      if ((s >= line.from && s <= line.to) ||
          std::abs(line.curve.tangentAt(p).dot(other.curve.tangentAt(p))) > parallel ||
          !mayReach(other, p))
        continue;
      if (s < line.from)
        before = std::max(before, s);
      else
        after = std::min(after, s);
    }
  }
  if (before >= first)
    line.from = before - past;
  if (after <= last)
    line.to = after + past;
  observe(line);
}

void
LineEvidence::findBetween(StoreyLine& line) const
{
  findHeights(line);
  const std::size_t bins = line.tall.size();
  const std::vector<double> since = waysToSurface(line.tall, true);
  const std::vector<double> until = waysToSurface(line.tall, false);
  const double support = line.support();
  line.part.assign(bins, 0);
  forEachOn(line, parts_,
            [&](std::size_t, std::size_t i, double, double) { line.part[i] = 1; });
  clean(line.part);
  line.between.assign(bins, StoreyLine::Between::Beyond);
  for (std::size_t i = 0; i < bins; ++i) {
    const double gap = since[i] + until[i];
    const Cell cell = cellAt(line, i);
    // A wall of which more is seen than the gap is long may have a blind behind it.
    const bool is_opening = line.part[i] > 0 && gap < std::min(support, max_hidden);
    if (is_opening || (isIn(part_, cell) && !isIn(opaque_, cell)))
      line.between[i] = StoreyLine::Between::Partly;
    else if (gap < max_hidden)
      line.between[i] = StoreyLine::Between::Gap;
  }
}

} // namespace pcl::sedr
