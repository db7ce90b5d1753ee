// SPDX-License-Identifier: BSD-3-Clause
#include "label_loops.h"

#include "../curves/contour.h"
#include "../curves/fitted_curve.h"
#include <pcl/sedr_filters/plan_editor.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Numbers places; those within a hundredth of a millimetre are one. */
class PlaceNumbers {
public:
  std::size_t numberOf(const Eigen::Vector2d& p)
  {
    const auto x = static_cast<std::int64_t>(std::floor(p.x() / size));
    const auto y = static_cast<std::int64_t>(std::floor(p.y() / size));
    for (std::int64_t dy = -1; dy <= 1; ++dy)
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        const auto [begin, end] = numbers_.equal_range({x + dx, y + dy});
        for (auto found = begin; found != end; ++found)
          if ((places_[found->second] - p).norm() < size)
            return found->second;
      }
    numbers_.emplace(std::make_pair(x, y), places_.size());
    places_.push_back(p);
    return places_.size() - 1;
  }

  const Eigen::Vector2d& at(std::size_t number) const { return places_[number]; }

private:
  static constexpr double size = 1e-5; // metres
  std::multimap<std::pair<std::int64_t, std::int64_t>, std::size_t> numbers_;
  std::vector<Eigen::Vector2d> places_;
};

struct Piece {
  std::size_t from;
  std::size_t to;
  std::uint32_t line;
};

double
areaOf(const std::vector<Piece>& loop, const PlaceNumbers& places)
{
  std::vector<Eigen::Vector2d> corners;
  for (const Piece& piece : loop)
    corners.push_back(places.at(piece.from));
  return signedArea(corners);
}

/** @brief Follows pieces to closed loops; where several go on, the first to the left,
 * so that a loop touches itself at no corner from inside. */
std::vector<std::vector<Piece>>
loopsOf(const std::vector<Piece>& pieces, const PlaceNumbers& places)
{
  std::multimap<std::size_t, std::size_t> from;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    from.emplace(pieces[i].from, i);
  std::vector<std::uint8_t> is_taken(pieces.size(), 0);
  std::vector<std::vector<Piece>> loops;
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    if (is_taken[first])
      continue;
    std::vector<Piece> loop;
    std::size_t i = first;
    while (!is_taken[i]) {
      is_taken[i] = 1;
      loop.push_back(pieces[i]);
      const Eigen::Vector2d way = places.at(pieces[i].to) - places.at(pieces[i].from);
      double best = -10;
      std::size_t next = i;
      const auto [begin, end] = from.equal_range(pieces[i].to);
      for (auto k = begin; k != end; ++k) {
        if (is_taken[k->second] && k->second != first)
          continue;
        const Piece& piece = pieces[k->second];
        const Eigen::Vector2d on = places.at(piece.to) - places.at(piece.from);
        const double turn =
            std::atan2(way.x() * on.y() - way.y() * on.x(), way.dot(on));
        if (turn > best) {
          best = turn;
          next = k->second;
        }
      }
      if (next == i)
        break;
      i = next;
    }
    if (loop.size() > 2 && loop.back().to == loop.front().from)
      loops.push_back(std::move(loop));
  }
  return loops;
}

/** @brief Returns the element of pieces that lie on one curve. */
template <typename Iterator>
PlanElement
elementOf(Iterator first,
          Iterator end,
          const PlanCurve& curve,
          const PlaceNumbers& places)
{
  PlanElement e;
  e.start = places.at(first->from);
  e.end = places.at(std::prev(end)->to);
  e.inliers = 1;
  constexpr double off = 0.05; // metres: a chord goes on beyond its arc
  if (!curve.isCircle() || curve.distance((e.start + e.end) / 2) > off + e.length() / 2)
    return e;
  e.centre = curve.point;
  e.radius = curve.radius;
  double swept = 0; // by the pieces about the centre
  for (Iterator piece = first; piece != end; ++piece) {
    const Eigen::Vector2d a = places.at(piece->from) - curve.point;
    const Eigen::Vector2d b = places.at(piece->to) - curve.point;
    swept += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  e.counter_clockwise = swept > 0;
  return e;
}

constexpr double apart = 0.03;     // metres, of curves that nearly touch
constexpr double near_joint = 0.1; // metres, about where curves meet

/** @brief Finds where two curves nearly touch, near a place.
 * @return whether they do */
bool
touch(const PlanCurve& a,
      const PlanCurve& b,
      const Eigen::Vector2d& near,
      Eigen::Vector2d& place)
{
  const PlanCurve& arc = a.isCircle() ? a : b;
  if (!arc.isCircle())
    return false;
  const Eigen::Vector2d foot = (a.isCircle() ? b : a).project(arc.point);
  place = arc.project(foot);
  return (place - foot).norm() < apart &&
         (place - near).norm() < 2 * std::sqrt(2 * apart * arc.radius);
}

/** @brief Returns where two curves meet or touch, if that is near a place, else the
 * place on the arc. */
Eigen::Vector2d
jointOf(const PlanCurve& a, const PlanCurve& b, const Eigen::Vector2d& near)
{
  Eigen::Vector2d joint;
  if (touch(a, b, near, joint) ||
      (meet(a, b, near, joint) && (joint - near).norm() < near_joint))
    return joint;
  return (a.isCircle() ? a : b).project(near);
}

/** @brief Leaves out short pieces between curves that nearly touch, and moves the ends
 * of arcs, which lie on their chords, to their circles. */
void
closeArcs(PlanLoop& loop)
{
  std::vector<PlanElement>& elements = loop.elements;
  const auto at = [&](std::size_t i) -> PlanElement& {
    return elements[i % elements.size()];
  };
  for (std::size_t i = 0; elements.size() > 2 && i < elements.size(); ++i) {
    const PlanCurve before = carrierOf(at(i + elements.size() - 1));
    const PlanCurve after = carrierOf(at(i + 1));
    Eigen::Vector2d joint;
    if (at(i).length() < near_joint && touch(before, after, at(i).start, joint)) {
      at(i + elements.size() - 1).end = at(i + 1).start = joint;
      elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(i--));
    }
  }
  for (std::size_t i = 0; elements.size() == 2 && i < 2; ++i)
    if (at(i).isArc() &&
        carrierOf(at(i)).distance(at(i + 1).pointAt(at(i + 1).length() / 2)) < apart)
      elements = {at(i)};
  if (elements.size() == 1)
    elements[0].end = elements[0].start =
        carrierOf(elements[0]).project(elements[0].start);
  else
    for (std::size_t i = 0; i < elements.size(); ++i)
      if (at(i).isArc() || at(i + 1).isArc())
        at(i).end = at(i + 1).start =
            jointOf(carrierOf(at(i)), carrierOf(at(i + 1)), at(i).end);
}

/** @brief Gives pieces that part hardly any area from the curve before and after them
 * to that, as where another one touches it. */
void
bridgeTouching(std::vector<Piece>& pieces,
               const std::vector<PlanCurve>& curves,
               const PlaceNumbers& places)
{
  constexpr double least = 0.01; // square metres: 10 cm by 10 cm
  const std::size_t n = pieces.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t line = pieces[i].line;
    if (pieces[(i + 1) % n].line == line)
      continue;
    double area = 0;         // between the curve and the pieces on others
    std::size_t end = i + 1; // of these
    for (; end < i + n && pieces[end % n].line != line; ++end) {
      const Eigen::Vector2d& from = places.at(pieces[end % n].from);
      const Eigen::Vector2d& to = places.at(pieces[end % n].to);
      area += curves[line].distance((from + to) / 2) * (to - from).norm();
      if (area > least)
        break;
    }
    if (end < i + n && pieces[end % n].line == line)
      for (std::size_t k = i + 1; k < end; ++k)
        pieces[k % n].line = line;
  }
}

/** @brief Returns the loop of pieces.
 * @param keep_arcs false: each piece of an arc stays a segment, so that the loop
 * crosses itself as little as its pieces do */
PlanLoop
loopOf(std::vector<Piece> pieces,
       const std::vector<PlanCurve>& curves,
       const PlaceNumbers& places,
       bool keep_arcs)
{
  std::size_t first = 0; // where a curve begins
  while (first < pieces.size() &&
         pieces[first].line == pieces[(first + pieces.size() - 1) % pieces.size()].line)
    ++first;
  std::rotate(pieces.begin(),
              pieces.begin() + static_cast<std::ptrdiff_t>(first % pieces.size()),
              pieces.end());
  PlanLoop loop;
  for (auto i = pieces.cbegin(), j = i; i != pieces.cend(); i = j) {
    j = std::find_if(i, pieces.cend(),
                     [&](const Piece& piece) { return piece.line != i->line; });
    if (keep_arcs || !curves[i->line].isCircle())
      loop.elements.push_back(elementOf(i, j, curves[i->line], places));
    else
      for (auto k = i; k != j; ++k)
        loop.elements.push_back(elementOf(k, std::next(k), PlanCurve(), places));
  }
  if (!keep_arcs)
    return loop;
  closeArcs(loop);
  if (loop.elements.size() == 1 &&
      2 * std::abs(areaOf(pieces, places)) < std::abs(loop.area()))
    loop.elements.clear(); // a sliver between an arc and its chord, no circle
  return loop;
}

/** @brief Returns the outline that pieces are. */
PlanLoop
planLoop(const std::vector<Piece>& pieces,
         const std::vector<PlanCurve>& curves,
         const PlaceNumbers& places)
{
  const auto isOutline = [](const PlanLoop& loop) {
    return outlineProblem(loop.area() < 0 ? reversed(loop) : loop).empty();
  };
  std::vector<Piece> bridged = pieces;
  bridgeTouching(bridged, curves, places);
  PlanLoop loop = loopOf(std::move(bridged), curves, places, true);
  if (!isOutline(loop))
    loop = loopOf(pieces, curves, places, true);
  return loop.elements.empty() || isOutline(loop)
             ? loop
             : loopOf(pieces, curves, places, false);
}

} // namespace

LabelLoops
labelLoops(const std::vector<CellBorder>& borders,
           const std::vector<int>& labels,
           int label,
           const std::vector<PlanCurve>& curves)
{
  PlaceNumbers places;
  std::vector<Piece> pieces;
  for (const CellBorder& border : borders) {
    const bool is_left = labels[border.left] == label;
    if (is_left == (labels[border.right] == label))
      continue;
    const std::size_t a = places.numberOf(border.start);
    const std::size_t b = places.numberOf(border.end);
    if (a != b)
      pieces.push_back({is_left ? a : b, is_left ? b : a, border.line});
  }
  LabelLoops found;
  double largest = 0;
  for (const std::vector<Piece>& loop : loopsOf(pieces, places)) {
    const double area = areaOf(loop, places);
    if (area < 0)
      found.holes.push_back(planLoop(loop, curves, places));
    else if (area > largest) {
      largest = area;
      found.outer = planLoop(loop, curves, places);
    }
  }
  const auto isOutside = [&](const PlanLoop& hole) {
    return hole.elements.empty() || !found.outer.contains(hole.elements.front().start);
  };
  found.holes.erase(std::remove_if(found.holes.begin(), found.holes.end(), isOutside),
                    found.holes.end());
  return found;
}

} // namespace pcl::sedr
