// SPDX-License-Identifier: BSD-3-Clause
#include "facet_borders.h"

#include "cell_points.h"
#include "shape_fit.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

using Place = Eigen::Vector2d;

constexpr double fine = 2e-4;    ///< metres that a border may be off
constexpr double reach = 2.5;    ///< cells that a label may be off where it was seen
constexpr double far_reach = 10; ///< cells that it may be off elsewhere

Place
gradientOf(const PlanSlab& slab, const Place& p)
{
  if (slab.curve)
    return slab.curve->gradientAt(p);
  return -slab.plane.head<2>() / slab.plane[2];
}

/** @brief A part of a border that follows one line: that on which two facets meet, or
 * a straight step. */
struct BorderPart {
  const PlanSlab* one = nullptr; ///< null: of a step
  const PlanSlab* other = nullptr;
  Place through = Place::Zero();
  Place normal = Place::Zero();
  std::vector<Place> samples;

  bool meets() const { return one != nullptr; }

  /** @brief Which side of the line a place lies on, about how far, and the unit way to
   * more. */
  std::pair<double, Place> sideOf(const Place& p) const
  {
    if (!meets())
      return {normal.dot(p - through), normal};
    const Place slope = gradientOf(*one, p) - gradientOf(*other, p);
    const double size = std::max(slope.norm(), 1e-6);
    return {(one->heightAt(p) - other->heightAt(p)) / size, slope / size};
  }

  /** @brief The place of the line that is nearest, if there is one within `farthest`
   * metres. */
  std::optional<Place> project(const Place& from, double farthest) const
  {
    constexpr int most_steps = 12;
    constexpr double exact = 1e-6;
    Place p = from;
    for (int step = 0; step < most_steps; ++step) {
      const auto [off, way] = sideOf(p);
      if (std::abs(off) < exact)
        return p;
      if (!(std::abs(off) < 2 * farthest))
        return std::nullopt;
      p -= off * way;
      if ((p - from).norm() > farthest)
        return std::nullopt;
    }
    return std::abs(sideOf(p).first) < fine ? std::optional<Place>(p) : std::nullopt;
  }
};

/** @brief Where two lines cross, near a place. */
std::optional<Place>
crossing(const BorderPart& a, const BorderPart& b, const Place& near, double farthest)
{
  constexpr int most_steps = 15;
  constexpr double least_angle = 0.15; // sine
  Place p = near;
  for (int step = 0; step < most_steps; ++step) {
    const auto [off_a, way_a] = a.sideOf(p);
    const auto [off_b, way_b] = b.sideOf(p);
    Eigen::Matrix2d rows;
    rows << way_a.transpose(), way_b.transpose();
    if (std::abs(rows.determinant()) < least_angle)
      return std::nullopt;
    const Place move = rows.inverse() * Place(off_a, off_b);
    p -= move;
    if (!p.allFinite() || (p - near).norm() > farthest)
      return std::nullopt;
    if (move.norm() < 1e-7)
      return p;
  }
  return std::nullopt;
}

/** @brief The corners of a line of places that keep it within a tolerance (Douglas and
 * Peucker 1973): indices, both ends included. */
void
simplify(const std::vector<Place>& line,
         std::size_t first,
         std::size_t last,
         double tolerance,
         std::vector<std::size_t>& corners)
{
  const Place way = line[last] - line[first];
  std::size_t farthest = first;
  double most = tolerance;
  for (std::size_t k = first + 1; k < last; ++k) {
    const Place off = line[k] - line[first];
    const double share = way.squaredNorm() > 0
                             ? std::clamp(off.dot(way) / way.squaredNorm(), 0.0, 1.0)
                             : 0;
    const double distance = (off - share * way).norm();
    if (distance <= most)
      continue;
    most = distance;
    farthest = k;
  }
  if (farthest == first) {
    corners.push_back(last);
    return;
  }
  simplify(line, first, farthest, tolerance, corners);
  simplify(line, farthest, last, tolerance, corners);
}

std::vector<Place>
simplified(const std::vector<Place>& line, double tolerance)
{
  if (line.size() < 3)
    return line;
  std::vector<std::size_t> corners{0};
  simplify(line, 0, line.size() - 1, tolerance, corners);
  std::vector<Place> simple;
  for (const std::size_t k : corners)
    simple.push_back(line[k]);
  return simple;
}

/** @brief Finds the borders of a sheet. */
class BorderFinder {
public:
  BorderFinder(const Sheet& sheet,
               const CellCracks& cracks,
               const std::vector<Eigen::Vector3d>& points,
               const std::vector<double>& directions)
      : sheet_(sheet)
      , cracks_(cracks)
      , cells_(sheet.grid, sheet.is_inside, points)
      , directions_(directions)
  {}

  std::vector<std::vector<Place>> run()
  {
    for (const CrackChain& chain : cracks_.chains)
      parts_.push_back(partsOf(chain));
    placeNodes();
    std::vector<std::vector<Place>> borders;
    for (std::size_t c = 0; c < cracks_.chains.size(); ++c)
      borders.push_back(lineOf(c));
    return borders;
  }

private:
  Place placeOf(const CrackVertex& v) const
  {
    return sheet_.grid.origin + sheet_.grid.size * Place(v.x, v.y);
  }

  const PlanSlab& facetOf(std::int32_t piece) const
  {
    const std::size_t cell = cracks_.first_cell[static_cast<std::size_t>(piece)];
    return sheet_.facets[static_cast<std::size_t>(sheet_.label[cell])];
  }

  template <typename Is>
  bool anyCell(const CrackVertex& v, int around, Is is) const
  {
    for (int y = v.y - around; y < v.y + around; ++y)
      for (int x = v.x - around; x < v.x + around; ++x)
        if (sheet_.grid.holds(x, y) && is(sheet_.grid.indexOf(x, y)))
          return true;
    return false;
  }

  bool isInside(const CrackVertex& v) const
  {
    return anyCell(v, 1, [&](std::size_t cell) { return sheet_.is_inside[cell] != 0; });
  }

  double reachAt(const CrackVertex& v) const
  {
    const bool is_seen =
        anyCell(v, 2, [&](std::size_t cell) { return sheet_.is_seen[cell] != 0; });
    return sheet_.grid.size * (is_seen ? reach : far_reach);
  }

  /** @brief Parts a chain, as far as it is in the room, where facets cease to meet. */
  std::vector<BorderPart> partsOf(const CrackChain& chain) const
  {
    if (chain.left < 0 || chain.right < 0)
      return {};
    BorderPart meeting;
    meeting.one = &facetOf(chain.left);
    meeting.other = &facetOf(chain.right);
    std::vector<Place> raw;
    std::vector<std::optional<Place>> met;
    for (const CrackVertex& v : chain.vertices)
      if (isInside(v)) {
        raw.push_back(placeOf(v));
        met.push_back(meeting.project(raw.back(), reachAt(v)));
      }
    const std::vector<bool> meets = smoothed(met);
    std::vector<BorderPart> parts;
    for (std::size_t first = 0; first < raw.size();) {
      std::size_t last = first + 1;
      while (last < raw.size() && meets[last] == meets[first])
        ++last;
      if (meets[first]) {
        parts.push_back(meeting);
        for (std::size_t k = first; k < last; ++k)
          if (met[k])
            parts.back().samples.push_back(*met[k]);
      }
      else
        addSteps({raw.begin() + static_cast<std::ptrdiff_t>(first),
                  raw.begin() + static_cast<std::ptrdiff_t>(last)},
                 chain, parts);
      first = last;
    }
    parts.erase(std::remove_if(parts.begin(), parts.end(),
                               [](const BorderPart& p) { return p.samples.empty(); }),
                parts.end());
    return parts;
  }

  /** @brief Whether most around a vertex of a chain meet. */
  static std::vector<bool> smoothed(const std::vector<std::optional<Place>>& met)
  {
    constexpr std::ptrdiff_t around = 4; // vertices to each side
    std::vector<bool> meets;
    const auto count = static_cast<std::ptrdiff_t>(met.size());
    for (std::ptrdiff_t k = 0; k < count; ++k) {
      int votes = 0;
      for (std::ptrdiff_t n = std::max<std::ptrdiff_t>(0, k - around);
           n <= std::min(count - 1, k + around); ++n)
        votes += met[static_cast<std::size_t>(n)] ? 1 : -1;
      meets.push_back(votes > 0);
    }
    return meets;
  }

  /** @brief Adds the straight steps along a line of vertices. */
  void addSteps(const std::vector<Place>& line,
                const CrackChain& chain,
                std::vector<BorderPart>& parts) const
  {
    const std::vector<Place> corners = simplified(line, 1.2 * sheet_.grid.size);
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      const Place way = corners[k + 1] - corners[k];
      if (way.norm() < 1e-9)
        continue;
      BorderPart part;
      part.samples = {corners[k], corners[k + 1]};
      const Place along = alongWalls(way.normalized());
      part.normal = Place(-along.y(), along.x()); // to the left
      part.through = (corners[k] + corners[k + 1]) / 2;
      part.through += bestShift(part, way.norm(), chain) * part.normal;
      // What runs on along the same line is one step.
      if (!parts.empty() && !parts.back().meets() &&
          std::abs(parts.back().normal.dot(part.normal)) > 0.999 &&
          std::abs(part.normal.dot(parts.back().through - part.through)) <
              sheet_.grid.size) {
        parts.back().samples.push_back(corners[k + 1]);
        continue;
      }
      parts.push_back(std::move(part));
    }
  }

  Place alongWalls(const Place& way) const
  {
    constexpr double nearly = 0.26; // radians: a line of cells tells no more
    for (const double direction : directions_)
      for (const double turn : {0.0, M_PI / 2}) {
        const Place wall(std::cos(direction + turn), std::sin(direction + turn));
        if (std::abs(wall.dot(way)) > std::cos(nearly))
          return wall.dot(way) > 0 ? wall : Place(-wall);
      }
    return way;
  }

  /** @brief How far a step lies to the left of where its cells say, such that most
   * points lie on the side of their facet. */
  double bestShift(const BorderPart& part, double length, const CrackChain& chain) const
  {
    const double most = reach * sheet_.grid.size;
    const Place along(part.normal.y(), -part.normal.x());
    const double deviation = std::max(0.003, 2 * sheet_.noise);
    std::vector<std::pair<double, double>> votes; // place across, for the left facet
    const auto cell_reach = static_cast<int>(length / sheet_.grid.size) + 4;
    const std::size_t middle = sheet_.grid.at(part.through);
    if (middle >= sheet_.grid.count())
      return 0;
    for (const std::size_t cell : cells_.window(middle, cell_reach))
      for (const Eigen::Vector3d* p = cells_.begin(cell); p != cells_.end(cell); ++p) {
        const Place off = p->head<2>() - part.through;
        const double across = off.dot(part.normal);
        if (std::abs(off.dot(along)) > length / 2 || std::abs(across) > most)
          continue;
        const auto misfit = [&](std::int32_t piece) {
          const double share = distanceOf(facetOf(piece), *p) / deviation;
          return std::min(share * share, 4.0);
        };
        votes.emplace_back(across, misfit(chain.right) - misfit(chain.left));
      }
    std::sort(votes.begin(), votes.end());
    return middleOfBest(votes);
  }

  /** @brief The middle of the places that have most votes on their left, those on their
   * right taken away; 0 where all are alike. */
  static double middleOfBest(const std::vector<std::pair<double, double>>& votes)
  {
    std::vector<double> sums{0};
    for (const auto& vote : votes)
      sums.front() += vote.second;
    for (const auto& vote : votes)
      sums.push_back(sums.back() - 2 * vote.second);
    const double best = *std::max_element(sums.begin(), sums.end()) - 1e-9;
    std::size_t first = 0;
    while (sums[first] < best)
      ++first;
    std::size_t last = first;
    while (last + 1 < sums.size() && sums[last + 1] >= best)
      ++last;
    if (first == 0 || last + 1 == sums.size())
      return 0; // points on one side only
    return (votes[first - 1].first + votes[last].first) / 2;
  }

  /** @brief Finds the places where chains end. */
  void placeNodes()
  {
    std::map<CrackVertex, std::vector<const BorderPart*>> ends;
    for (std::size_t c = 0; c < cracks_.chains.size(); ++c) {
      const auto& vertices = cracks_.chains[c].vertices;
      if (parts_[c].empty() || vertices.front() == vertices.back())
        continue;
      if (isInside(vertices.front()))
        ends[vertices.front()].push_back(&parts_[c].front());
      if (isInside(vertices.back()))
        ends[vertices.back()].push_back(&parts_[c].back());
    }
    for (const auto& [vertex, parts] : ends)
      node_[vertex] = nodeOf(vertex, parts);
  }

  Place nodeOf(const CrackVertex& vertex,
               const std::vector<const BorderPart*>& parts) const
  {
    const Place raw = placeOf(vertex);
    const double farthest = 2 * reachAt(vertex);
    std::optional<Place> best;
    double nearest = std::numeric_limits<double>::infinity();
    // Where facets meet counts more than where they step.
    for (const int steps : {0, 1, 2}) {
      for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          if ((parts[i]->meets() ? 0 : 1) + (parts[j]->meets() ? 0 : 1) != steps)
            continue;
          const auto place = crossing(*parts[i], *parts[j], raw, farthest);
          if (!place || (*place - raw).norm() >= nearest)
            continue;
          nearest = (*place - raw).norm();
          best = place;
        }
      if (best)
        return *best;
    }
    for (const BorderPart* part : parts)
      if (const auto place = part->project(raw, farthest))
        return *place;
    return raw;
  }

  /** @brief The whole line of a chain. */
  std::vector<Place> lineOf(std::size_t c) const
  {
    const CrackChain& chain = cracks_.chains[c];
    const auto& vertices = chain.vertices;
    const std::vector<BorderPart>& parts = parts_[c];
    if (parts.empty())
      return rawLine(vertices);
    std::vector<Place> line;
    const bool is_closed = vertices.front() == vertices.back();
    const auto start = node_.find(vertices.front());
    const auto end = node_.find(vertices.back());
    if (!is_closed)
      addStart(vertices, parts.front(), start, line);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (k > 0)
        line.push_back(jointOf(parts[k - 1], parts[k]));
      else if (is_closed)
        line.push_back(jointOf(parts.back(), parts.front()));
      if (parts[k].meets())
        addSamples(parts[k], line);
    }
    if (is_closed)
      line.push_back(line.front());
    else
      addEnd(vertices, parts.back(), end, line);
    return refined(line, parts);
  }

  std::vector<Place> rawLine(const std::vector<CrackVertex>& vertices) const
  {
    std::vector<Place> line;
    for (const CrackVertex& v : vertices)
      line.push_back(placeOf(v));
    return simplified(line, fine);
  }

  using Node = std::map<CrackVertex, Place>::const_iterator;

  void addStart(const std::vector<CrackVertex>& vertices,
                const BorderPart& part,
                const Node& node,
                std::vector<Place>& line) const
  {
    if (node != node_.end()) {
      line.push_back(node->second);
      return;
    }
    line.push_back(placeOf(vertices.front()));
    line.push_back(beyond(part, part.samples.front(), line.front()));
  }

  void addEnd(const std::vector<CrackVertex>& vertices,
              const BorderPart& part,
              const Node& node,
              std::vector<Place>& line) const
  {
    if (node != node_.end()) {
      line.push_back(node->second);
      return;
    }
    const Place last = placeOf(vertices.back());
    line.push_back(beyond(part, part.samples.back(), last));
    line.push_back(last);
  }

  /** @brief A place on the line of a part, a little farther out than its sample. */
  Place beyond(const BorderPart& part, const Place& sample, const Place& outside) const
  {
    const double step = 2.2 * sheet_.grid.size;
    const Place on_line = part.project(sample, step).value_or(sample);
    const Place normal = part.sideOf(on_line).second;
    Place way(-normal.y(), normal.x());
    if (way.dot(outside - on_line) < 0)
      way = -way;
    const Place out = on_line + step * way;
    return part.project(out, step).value_or(out);
  }

  Place jointOf(const BorderPart& before, const BorderPart& after) const
  {
    const Place raw = (before.samples.back() + after.samples.front()) / 2;
    const double farthest = 2 * reach * sheet_.grid.size;
    if (const auto place = crossing(before, after, raw, farthest))
      return *place;
    return after.project(raw, farthest).value_or(raw);
  }

  /** @brief Adds the samples of a part that do not lie beside its ends. */
  void addSamples(const BorderPart& part, std::vector<Place>& line) const
  {
    const double margin = 2 * sheet_.grid.size;
    const Place& first = part.samples.front();
    const Place& last = part.samples.back();
    const bool is_round = (first - last).norm() < margin && part.samples.size() > 8;
    for (const Place& sample : part.samples)
      if (is_round ||
          ((sample - first).norm() > margin && (sample - last).norm() > margin))
        line.push_back(sample);
  }

  /** @brief A line as exact as its parts are, of as few corners as that takes. */
  std::vector<Place> refined(const std::vector<Place>& line,
                             const std::vector<BorderPart>& parts) const
  {
    std::vector<Place> exact{line.front()};
    for (std::size_t k = 1; k < line.size(); ++k)
      addBetween(line[k - 1], line[k], parts, 0, exact);
    return simplified(exact, fine);
  }

  /** @brief Adds the places of a curved border from one to another. */
  void addBetween(const Place& from,
                  const Place& to,
                  const std::vector<BorderPart>& parts,
                  int depth,
                  std::vector<Place>& line) const
  {
    constexpr int deepest = 7;
    const Place middle = (from + to) / 2;
    const double length = (to - from).norm();
    for (const BorderPart& part : parts) {
      if (depth >= deepest || !part.meets() || length < fine ||
          std::abs(part.sideOf(from).first) > fine ||
          std::abs(part.sideOf(to).first) > fine)
        continue;
      const auto place = part.project(middle, length / 2);
      if (!place || (*place - middle).norm() < fine / 2)
        continue;
      addBetween(from, *place, parts, depth + 1, line);
      addBetween(*place, to, parts, depth + 1, line);
      return;
    }
    line.push_back(to);
  }

  const Sheet& sheet_;
  const CellCracks& cracks_;
  CellPoints cells_;
  const std::vector<double>& directions_;
  std::vector<std::vector<BorderPart>> parts_; ///< of each chain
  std::map<CrackVertex, Place> node_;          ///< of those in the room
};

} // namespace

std::vector<std::vector<Eigen::Vector2d>>
bordersOf(const Sheet& sheet,
          const CellCracks& cracks,
          const std::vector<Eigen::Vector3d>& points,
          const std::vector<double>& directions)
{
  return BorderFinder(sheet, cracks, points, directions).run();
}

} // namespace sedr
} // namespace pcl
