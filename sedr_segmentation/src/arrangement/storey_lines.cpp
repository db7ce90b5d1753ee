// SPDX-License-Identifier: BSD-3-Clause
#include "storey_lines.h"

#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double beyond = 4; // metres that a line goes on past its seen ends,
constexpr double beyond_arc = 0.2;
constexpr double ended = 2.5;     // farthest from an end, of what counts as beyond it
constexpr double aligned = 0.966; // cosine

/** @brief A place at a surface or at the end of air, and the normal there. */
struct NormalPlace {
  Eigen::Vector2d at;
  Eigen::Vector2d normal;
};

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

/** @brief Checks whether a cell of a room has an opaque surface up to the ceiling, or
 * up to a beam. */
bool
isOpaque(const RoomCells& room, Cell cell)
{
  return (room.solid.at(cell) && !room.glass.at(cell)) || room.pillar.at(cell);
}

/** @brief Checks whether a cell of a room has a surface below a window or above it. */
bool
isPart(const RoomCells& room, Cell cell)
{
  return room.base.at(cell) || room.riser.at(cell) || room.glass.at(cell);
}

/** @brief Checks whether a room has cells of a kind at a place. */
template <typename Is>
bool
isNear(const std::vector<std::size_t>& rooms,
       const std::vector<RoomCells>& cells,
       Cell cell,
       Is is)
{
  for (const std::size_t r : rooms)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        if (is(cells[r], {cell.x + x, cell.y + y}))
          return true;
  return false;
}

/** @brief Returns where along a line another one meets it whose surface reaches up to
 * the ceiling there or not far away, as in a hidden corner. */
std::vector<double>
crossingsOf(const StoreyLine& line, const StoreyLine& other)
{
  constexpr double reach = 2;      // metres
  constexpr double parallel = 0.7; // cosine
  std::vector<double> crossings;
  for (const Eigen::Vector2d& p : intersections(line.curve, other.curve)) {
    const double s = line.along(p);
    const double t = other.along(p);
    if (s < line.from || s >= line.to || t < other.from || t >= other.to ||
        std::abs(line.curve.tangentAt(p).dot(other.curve.tangentAt(p))) > parallel)
      continue;
    const auto first = other.tall.begin();
    const auto bin = [&](double at) {
      return first +
             static_cast<std::ptrdiff_t>(
                 (std::clamp(at, other.from, other.to) - other.from) / StoreyLine::bin);
    };
    if (std::any_of(bin(t - reach), bin(t + reach) + 1, [](float v) { return v > 0; }))
      crossings.push_back(s);
  }
  return crossings;
}

/** @brief Finds where each room saw the surface of a line. */
void
observe(const Storey& storey,
        const std::vector<RoomCells>& cells,
        const CellGrid& grid,
        StoreyLine& line)
{
  const auto bins =
      static_cast<std::size_t>(std::ceil((line.to - line.from) / StoreyLine::bin)) + 1;
  line.any.assign(bins, 0);
  std::vector<std::pair<double, double>> ends(bins, {line.to, line.from}); // of places
  for (const std::size_t r : storey.rooms) {
    std::vector<float> seen(bins, 0);
    for (const Eigen::Vector2d& p : cells[r].wall_points) {
      const double d = line.curve.distance(p) / line.near;
      const double s = d < 1 ? line.along(p) : line.to + 1;
      if (s < line.from || s > line.to)
        continue;
      const auto i = static_cast<std::size_t>((s - line.from) / StoreyLine::bin);
      seen[i] = std::max(seen[i], static_cast<float>(1 - d * d));
      ends[i] = {std::min(ends[i].first, s), std::max(ends[i].second, s)};
    }
    clean(seen);
    for (std::size_t i = 0; i < bins; ++i)
      line.any[i] = std::max(line.any[i], seen[i]);
    if (std::any_of(seen.begin(), seen.end(), [](float v) { return v > 0; }))
      line.seen.emplace(static_cast<std::uint32_t>(r), std::move(seen));
  }
  for (std::size_t i = 0; i < bins; ++i) {
    if (line.any[i] > 0 && (i == 0 || !(line.any[i - 1] > 0)))
      line.edges.push_back(ends[i].first - StoreyLine::bin / 2);
    if (line.any[i] > 0 && (i + 1 == bins || !(line.any[i + 1] > 0)))
      line.edges.push_back(ends[i].second + StoreyLine::bin / 2);
  }
  const auto cellOf = [&](std::size_t i) {
    const Eigen::Vector2d p =
        line.at(line.from + (static_cast<double>(i) + 0.5) * StoreyLine::bin);
    return grid.at(p.x(), p.y());
  };
  line.tall = line.any;
  for (std::size_t i = 0; i < bins; ++i)
    if (line.tall[i] > 0 && !isNear(storey.rooms, cells, cellOf(i), isOpaque))
      line.tall[i] = 0;
  clean(line.tall);
}

/** @brief Returns the way back, or on, to the next bin of a kind, metres. */
template <typename Is>
std::vector<double>
waysTo(std::size_t bins, bool back, Is is)
{
  std::vector<double> ways(bins);
  double way = 1e6;
  for (std::size_t k = 0; k < bins; ++k) {
    const std::size_t i = back ? k : bins - 1 - k;
    ways[i] = way = is(i) ? 0 : way + StoreyLine::bin;
  }
  return ways;
}

/** @brief Finds what is on a line where no surface reaches up to the ceiling.
 * @param lines with their surfaces */
void
findBetween(const Storey& storey,
            const std::vector<RoomCells>& cells,
            const CellGrid& grid,
            const std::vector<StoreyLine>& lines,
            StoreyLine& line)
{
  const std::size_t bins = line.tall.size();
  const auto cellOf = [&](std::size_t i) {
    const Eigen::Vector2d p =
        line.at(line.from + (static_cast<double>(i) + 0.5) * StoreyLine::bin);
    return grid.at(p.x(), p.y());
  };
  std::vector<std::uint8_t> is_end(bins, 0);
  for (std::size_t i = 0; i < bins; ++i)
    is_end[i] = line.tall[i] > 0;
  for (const StoreyLine& other : lines)
    for (const double s : crossingsOf(line, other))
      is_end[static_cast<std::size_t>((s - line.from) / StoreyLine::bin)] = 1;
  const auto isTall = [&](std::size_t i) { return line.tall[i] > 0; };
  const auto isEnd = [&](std::size_t i) { return is_end[i] != 0; };
  const std::vector<double> since = waysTo(bins, true, isTall);
  const std::vector<double> until = waysTo(bins, false, isTall);
  const std::vector<double> since_end = waysTo(bins, true, isEnd);
  const std::vector<double> until_end = waysTo(bins, false, isEnd);
  line.between.assign(bins, StoreyLine::Between::Nothing);
  for (std::size_t i = 0; i < bins; ++i) {
    const bool in_gap = since[i] + until[i] < max_gap;
    const bool before_corner =
        std::min(since[i] + until_end[i], since_end[i] + until[i]) < max_gap;
    if (!in_gap && !before_corner && std::min(since[i], until[i]) > ended)
      continue;
    const Cell cell = cellOf(i);
    line.between[i] = isNear(storey.rooms, cells, cell, isPart) &&
                              !isNear(storey.rooms, cells, cell, isOpaque)
                          ? StoreyLine::Between::Partly
                      : in_gap ? StoreyLine::Between::Gap
                               : StoreyLine::Between::Beyond;
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
      if (line.is_end || line.curve.distance(end.at) > near)
        return false;
      const double s = line.along(end.at);
      return s > line.from - near && s < line.to + near &&
             std::abs(line.curve.tangentAt(end.at).dot(end.normal)) < 0.7;
    };
    if (std::none_of(lines.begin(), lines.end(), isBeside))
      ends.push_back(end);
  }
  for (const Eigen::Vector2d& normal : normals) {
    std::vector<std::pair<double, double>> places; // offset, along
    for (const NormalPlace& end : ends)
      if (std::abs(end.normal.dot(normal)) > aligned)
        places.emplace_back(normal.dot(end.at), leftOf(normal).dot(end.at));
    for (const FaceCurve& run : linesAlong(std::move(places), normal,
                                           {grid.size(), 2 * grid.size(), 1, 0.5})) {
      StoreyLine& line = lines.emplace_back();
      static_cast<FaceCurve&>(line) = run;
      line.is_end = true;
      line.from -= on;
      line.to += on;
    }
  }
}

/** @brief Appends lines across the ends of faces that end at no other one. */
void
appendEdges(std::vector<StoreyLine>& lines)
{
  constexpr double reach = 0.6;    // metres to both sides
  constexpr double near = 0.06;    // metres, of another line
  constexpr double shortest = 0.2; // metres, of a face that is found
  const std::size_t faces = lines.size();
  for (std::size_t k = 0; k < faces; ++k) {
    const StoreyLine line = lines[k];
    if (line.is_end || line.isWhole())
      continue;
    for (const double s : line.edges) {
      const Eigen::Vector2d p = line.at(s);
      const Eigen::Vector2d way = line.curve.tangentAt(p);
      if (std::any_of(lines.begin(), lines.end(), [&](const StoreyLine& other) {
            const double t = other.along(p);
            return other.curve.distance(p) < near && t > other.from - reach &&
                   t < other.to + reach &&
                   std::abs(other.curve.tangentAt(p).dot(way)) < 0.7;
          }))
        continue;
      StoreyLine edge;
      edge.is_end = true;
      edge.curve.point = p;
      edge.curve.direction = leftOf(way);
      edge.from = -reach;
      edge.to = reach;
      edge.near = line.near;
      const auto bins = static_cast<std::size_t>(2 * reach / StoreyLine::bin) + 2;
      edge.any.assign(bins, 0);
      edge.tall = edge.any;
      edge.between.assign(bins, StoreyLine::Between::Nothing);
      for (std::size_t i = 0; i < bins; ++i) // sides of pilasters may be too short
        if (std::abs((static_cast<double>(i) + 0.5) * StoreyLine::bin - reach) <
            shortest)
          edge.between[i] = StoreyLine::Between::Beyond;
      lines.push_back(std::move(edge));
    }
  }
}

/** @brief Finds which surfaces are a line's own: no other one explains them better. */
void
findOwn(std::vector<StoreyLine>& lines)
{
  constexpr double beside = 0.04;   // metres
  constexpr double parallel = 0.98; // cosine
  for (std::size_t k = 0; k < lines.size(); ++k) {
    StoreyLine& line = lines[k];
    line.is_own.assign(line.any.size(), 1);
    for (std::size_t i = 0; i < line.any.size(); ++i) {
      if (!(line.any[i] > 0))
        continue;
      const Eigen::Vector2d p =
          line.at(line.from + (static_cast<double>(i) + 0.5) * StoreyLine::bin);
      const Eigen::Vector2d way = line.curve.tangentAt(p);
      line.is_own[i] =
          std::none_of(lines.begin(), lines.end(), [&](const StoreyLine& other) {
            if (other.curve.distance(p) > beside ||
                std::abs(other.curve.tangentAt(p).dot(way)) < parallel)
              return false;
            const double there = other.seenAt(other.curve.project(p));
            const double here = line.any[i];
            return &other < &line ? there >= here : there > here;
          });
    }
  }
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

StoreyLines
storeyLines(const Storey& storey,
            const std::vector<RoomCells>& cells,
            const CellGrid& grid,
            const RadiusRange& radii,
            double near)
{
  std::vector<Eigen::Vector2d> places;
  for (const std::size_t r : storey.rooms)
    places.insert(places.end(), cells[r].wall_points.begin(),
                  cells[r].wall_points.end());
  const FaceCurves faces = faceCurves(places, radii);
  StoreyLines storey_lines{{}, faces.certainty};
  std::vector<StoreyLine>& lines = storey_lines.lines;
  for (const FaceCurve& face : faces.curves) {
    StoreyLine& line = lines.emplace_back();
    static_cast<FaceCurve&>(line) = face;
    line.parameters = face.curve.isCircle() ? 3 : face.is_main ? 1 : 2;
  }
  for (const std::size_t r : storey.rooms)
    appendEnds(cells[r], grid, faces.normals, lines);
  for (StoreyLine& line : lines) {
    const double on =
        line.is_end ? 0
        : line.curve.isCircle()
            ? std::min(beyond_arc, M_PI * line.curve.radius - (line.to - line.from) / 2)
            : beyond;
    line.from -= on;
    line.to += on;
    line.near = near;
    observe(storey, cells, grid, line);
  }
  for (StoreyLine& line : lines)
    findBetween(storey, cells, grid, lines, line);
  appendEdges(lines);
  std::stable_sort(lines.begin(), lines.end(),
                   [](const StoreyLine& a, const StoreyLine& b) {
                     const auto order = [](const StoreyLine& line) {
                       return std::make_tuple(line.is_end, line.curve.isCircle(),
                                              -line.support(), line.from - line.to);
                     };
                     return order(a) < order(b);
                   });
  findOwn(lines);
  return storey_lines;
}

} // namespace pcl::sedr
