// SPDX-License-Identifier: BSD-3-Clause
#include "triangulation.h"

#include <boost/polygon/polygon.hpp>
#include <boost/polygon/segment_utils.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>

namespace pcl::sedr {

namespace {

/** @brief A part of a segment, in the segment's direction. */
struct Piece {
  GridPoint from;
  GridPoint to;
  std::size_t segment = 0;
};

using Pieces = std::vector<Piece>;

constexpr std::int32_t highest = 1 << 30; ///< beyond all coordinates
constexpr std::int32_t lowest = -highest;

/** @brief Removes pieces of zero length and pieces that a segment traverses in both
 * directions. Leading it through vertices may fold it. */
void
unfold(Pieces& pieces)
{
  std::map<std::tuple<std::size_t, GridPoint, GridPoint>, int> runs;
  for (const Piece& p : pieces) {
    if (p.from == p.to)
      continue;
    const bool forward = p.from < p.to;
    runs[{p.segment, forward ? p.from : p.to, forward ? p.to : p.from}] +=
        forward ? 1 : -1;
  }
  pieces.clear();
  for (const auto& [run, net] : runs)
    for (int k = 0; k < std::abs(net); ++k) {
      const auto& [segment, low, high] = run;
      pieces.push_back(net > 0 ? Piece{low, high, segment} : Piece{high, low, segment});
    }
}

/** @brief Splits the pieces where they cross or touch; exactly, except for the rounding
 * of crossings to the grid. */
void
cutAtCrossings(Pieces& pieces)
{
  namespace polygon = boost::polygon;
  using Point = polygon::point_data<std::int32_t>;
  using Segment = polygon::segment_data<std::int32_t>;
  std::vector<Segment> segments;
  segments.reserve(pieces.size());
  for (const Piece& p : pieces)
    segments.emplace_back(Point(p.from.x, p.from.y), Point(p.to.x, p.to.y));
  std::vector<std::pair<std::size_t, Segment>> parts;
  polygon::intersect_segments(parts, segments.begin(), segments.end());
  Pieces cut;
  cut.reserve(parts.size());
  for (const auto& [parent, part] : parts) {
    const GridPoint low{polygon::low(part).x(), polygon::low(part).y()};
    const GridPoint high{polygon::high(part).x(), polygon::high(part).y()};
    const Piece& whole = pieces[parent];
    // Rounding keeps the order along either axis, so the sign is certain.
    const bool forward = way(whole.from, whole.to).dot(way(low, high)) > 0;
    cut.push_back(forward ? Piece{low, high, whole.segment}
                          : Piece{high, low, whole.segment});
  }
  unfold(cut);
  pieces.swap(cut);
}

std::vector<GridPoint>
verticesOf(const Pieces& pieces)
{
  std::vector<GridPoint> vertices;
  vertices.reserve(2 * pieces.size());
  for (const Piece& p : pieces) {
    vertices.push_back(p.from);
    vertices.push_back(p.to);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/** @brief Ranks of vertices: of two that are too near, the lower rank stays. Ends of
 * early segments come first, then crossings in order of appearance. Vertices that
 * stayed once keep staying, so the rounds terminate. */
using Ranks = std::map<GridPoint, std::size_t>;

/** @brief Merges each vertex into one of lower rank that is nearer than `separation`.
 * @return whether any was merged */
bool
weld(double separation, Ranks& ranks, Pieces& pieces)
{
  std::map<GridPoint, GridPoint> joins;
  std::set<GridPoint> kept;
  const auto reach = static_cast<std::int32_t>(std::ceil(separation));
  std::vector<std::pair<std::size_t, GridPoint>> ranked;
  for (const GridPoint& v : verticesOf(pieces))
    ranked.emplace_back(ranks.emplace(v, ranks.size()).first->second, v);
  std::sort(ranked.begin(), ranked.end());
  for (const auto& [rank, v] : ranked) {
    const auto first = kept.lower_bound({v.x - reach, lowest});
    const auto last = kept.upper_bound({v.x + reach, highest});
    const auto near = std::find_if(first, last, [&at = v, separation](GridPoint k) {
      return distance(k, at) < separation;
    });
    if (near == last)
      kept.insert(v);
    else
      joins[v] = *near;
  }
  for (Piece& p : pieces)
    for (GridPoint* end : {&p.from, &p.to}) {
      const auto join = joins.find(*end);
      if (join != joins.end())
        *end = join->second;
    }
  return !joins.empty();
}

/** @brief Returns the vertices nearer to a piece than `separation`, in order along it.
 * They see the ends at more than a right angle. A piece led through a vertex above its
 * end would be led back in the next round. */
std::vector<GridPoint>
verticesBeside(const Piece& piece,
               const std::vector<GridPoint>& vertices,
               double separation)
{
  const auto reach = static_cast<std::int32_t>(std::ceil(separation));
  const double length = distance(piece.from, piece.to);
  const GridPoint low{std::min(piece.from.x, piece.to.x) - reach, lowest};
  const GridPoint high{std::max(piece.from.x, piece.to.x) + reach, highest};
  std::vector<std::pair<double, GridPoint>> beside;
  const auto last = std::upper_bound(vertices.begin(), vertices.end(), high);
  for (auto v = std::lower_bound(vertices.begin(), vertices.end(), low); v != last;
       ++v) {
    if (*v == piece.from || *v == piece.to)
      continue;
    const Eigen::Vector2d back = way(*v, piece.from);
    const Eigen::Vector2d ahead = way(*v, piece.to);
    if (back.dot(ahead) < 0 &&
        std::abs(static_cast<double>(turn(piece.from, piece.to, *v))) <
            separation * length)
      beside.emplace_back(-back.dot(way(piece.from, piece.to)), *v);
  }
  std::sort(beside.begin(), beside.end());
  std::vector<GridPoint> result;
  for (const auto& b : beside)
    result.push_back(b.second);
  return result;
}

/** @brief Leads pieces through the vertices beside them.
 * @return whether any piece changed */
bool
bend(double separation, Pieces& pieces)
{
  const std::vector<GridPoint> vertices = verticesOf(pieces);
  Pieces bent;
  bent.reserve(pieces.size());
  for (Piece rest : pieces) {
    for (const GridPoint& v : verticesBeside(rest, vertices, separation)) {
      bent.push_back({rest.from, v, rest.segment});
      rest.from = v;
    }
    bent.push_back(rest);
  }
  const bool is_changed = bent.size() != pieces.size();
  pieces.swap(bent);
  return is_changed;
}

Arrangement
assemble(const Pieces& pieces)
{
  Arrangement result;
  result.vertices = verticesOf(pieces);
  const auto indexOf = [&](const GridPoint& p) {
    return static_cast<std::uint32_t>(
        std::lower_bound(result.vertices.begin(), result.vertices.end(), p) -
        result.vertices.begin());
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<SegmentUse>> uses;
  for (const Piece& p : pieces) {
    const bool forward = p.from < p.to;
    const std::uint32_t a = indexOf(forward ? p.from : p.to);
    const std::uint32_t b = indexOf(forward ? p.to : p.from);
    uses[{a, b}].push_back({p.segment, forward});
  }
  result.edges.reserve(uses.size());
  for (auto& [ends, list] : uses)
    result.edges.push_back({ends.first, ends.second, std::move(list)});
  return result;
}

} // namespace

void
arrangeSegments(const std::vector<GridSegment>& segments,
                double separation,
                Arrangement& arrangement)
{
  Pieces pieces;
  for (std::size_t i = 0; i < segments.size(); ++i)
    pieces.push_back({segments[i].from, segments[i].to, i});
  unfold(pieces);
  Ranks ranks;
  for (const GridSegment& s : segments)
    for (const GridPoint& end : {s.from, s.to})
      ranks.emplace(end, ranks.size());
  bool is_near = true;
  cutAtCrossings(pieces);
  for (int round = 0; round < 50 && is_near; ++round) {
    is_near = weld(separation, ranks, pieces);
    unfold(pieces);
    is_near = bend(separation, pieces) || is_near;
    if (is_near)
      cutAtCrossings(pieces);
  }
  arrangement = assemble(pieces);
}

} // namespace pcl::sedr
