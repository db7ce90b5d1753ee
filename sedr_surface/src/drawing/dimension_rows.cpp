// SPDX-License-Identifier: BSD-3-Clause
#include "dimension_rows.h"

#include "../formats/decimal_text.h"
#include "plan_layers.h"

#include <pcl/sedr_filters/wall_shares.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl::sedr {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

/** @brief What is visible at a place along a side: a wall, null for none, and its depth
 * there. */
struct Sight {
  const PlanElement* wall = nullptr;
  double depth = nowhere;
};

/** @brief Walls turned so that the side is at the bottom: x to the right along it, y
 * into the plan. */
class SideView {
public:
  SideView(const std::vector<PlanElement>& walls, DrawingSide side)
  {
    const Eigen::Vector2d off = wayOff(side);
    frame_.turn = -M_PI / 2 - std::atan2(off.y(), off.x());
    for (const PlanElement& wall : walls)
      walls_.push_back(frame_(wall));
  }

  Eigen::Vector2d toPlan(const Eigen::Vector2d& p) const { return frame_.toPlan(p); }

  /** @brief Returns the ends of walls along the side, sorted. */
  std::vector<double> ends() const
  {
    std::vector<double> ends;
    for (const PlanElement& e : walls_) {
      ends.push_back(e.start.x());
      ends.push_back(e.end.x());
      // The extremes of an arc are two points of its circle.
      for (const double sign : {-1.0, 1.0}) {
        const Eigen::Vector2d place = e.centre + Eigen::Vector2d(sign * e.radius, 0);
        if (e.isArc() && e.distance(place) < 1e-6 * e.radius)
          ends.push_back(place.x());
      }
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  Sight sightAt(double x) const
  {
    Sight nearest;
    for (const PlanElement& wall : walls_) {
      const double depth = depthAt(wall, x);
      if (depth < nearest.depth)
        nearest = {&wall, depth};
    }
    return nearest;
  }

private:
  static double depthAt(const PlanElement& e, double x)
  {
    if (!e.isArc()) {
      const double share = (x - e.start.x()) / (e.end.x() - e.start.x());
      return share >= 0 && share <= 1 ? e.start.y() + share * (e.end.y() - e.start.y())
                                      : nowhere;
    }
    const double half = e.radius * e.radius - (x - e.centre.x()) * (x - e.centre.x());
    for (const double sign : {-1.0, 1.0}) {
      const double y = e.centre.y() + sign * std::sqrt(std::max(half, 0.0));
      if (half > 0 && e.distance({x, y}) < 1e-6 * e.radius)
        return y;
    }
    return nowhere;
  }

  PlanFrame frame_;
  std::vector<PlanElement> walls_;
};

/** @brief Returns whether one wall goes on as another, as a straight one in two parts.
 */
bool
goesOn(const Sight& before, const Sight& after)
{
  constexpr double off = 0.01; // metres
  if (before.wall == after.wall)
    return true;
  if (!before.wall || !after.wall || before.wall->isArc() || after.wall->isArc())
    return false;
  const auto line =
      Eigen::Hyperplane<double, 2>::Through(before.wall->start, before.wall->end);
  return line.absDistance(after.wall->start) < off &&
         line.absDistance(after.wall->end) < off;
}

/** @brief Returns the ends with a minimum distance, including the first and last
 * one. */
std::vector<double>
placesOf(const std::vector<double>& ends, double least)
{
  std::vector<double> places;
  for (const double x : ends)
    if (places.empty() || x - places.back() >= least)
      places.push_back(x);
  if (places.size() > 1)
    places.back() = ends.back();
  return places;
}

/** @brief Returns whether two chains have the same dimensions. */
bool
areAlike(const DimensionChain& a, const DimensionChain& b, double least)
{
  if (a.places.size() != b.places.size())
    return false;
  for (std::size_t k = 0; k < a.places.size(); ++k)
    if (std::abs(a.along(k) - b.along(k)) > least)
      return false;
  return true;
}

/** @brief Removes places until no two neighbouring dimensions are both shorter than
 * `room`, as on ragged walls; the shortest pair first. A single short one, such as a
 * wall thickness, stays. */
void
thinOut(DimensionChain& chain, double room)
{
  while (true) {
    std::size_t shortest = 0;
    double least = nowhere;
    for (std::size_t k = 1; k + 1 < chain.places.size(); ++k) {
      const double before = chain.along(k) - chain.along(k - 1);
      const double after = chain.along(k + 1) - chain.along(k);
      if (std::max(before, after) < room && before + after < least) {
        least = before + after;
        shortest = k;
      }
    }
    if (shortest == 0)
      return;
    chain.places.erase(chain.places.begin() + static_cast<std::ptrdiff_t>(shortest));
  }
}

/** @brief Returns the corners of walls that are visible from a side, in order. What
 * lies behind a gap that is no wider than a wall does not count. */
DimensionChain
chainAlong(const std::vector<PlanElement>& walls,
           DrawingSide side,
           double max_wall,
           double least)
{
  const SideView view(walls, side);
  const std::vector<double> places = placesOf(view.ends(), least);
  std::vector<Sight> sights{{}}; // before, between and after the places
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
    sights.push_back(view.sightAt((places[k] + places[k + 1]) / 2));
  sights.emplace_back();
  for (std::size_t first = 1; first + 1 < sights.size(); ++first) {
    const double rim = sights[first - 1].depth + max_wall;
    std::size_t last = first; // sights[first] to sights[last - 1] are in a gap
    while (last + 1 < sights.size() && sights[last].depth > rim)
      ++last;
    if (sights[last].wall && last > first &&
        places[last - 1] - places[first - 1] <= max_wall)
      std::fill(sights.begin() + static_cast<std::ptrdiff_t>(first),
                sights.begin() + static_cast<std::ptrdiff_t>(last), Sight{});
  }
  DimensionChain chain{side, {}};
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (goesOn(sights[k], sights[k + 1]))
      continue;
    // Where walls meet, the nearer of their ends.
    const double off = least / 4;
    double depth = std::min(view.sightAt(places[k] - off).depth,
                            view.sightAt(places[k] + off).depth);
    if (depth == nowhere)
      depth = std::min(sights[k].depth, sights[k + 1].depth);
    chain.places.push_back(view.toPlan({places[k], depth}));
  }
  std::sort(chain.places.begin(), chain.places.end(),
            [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
              return a.dot(wayAlong(side)) < b.dot(wayAlong(side));
            });
  return chain;
}

/** @brief Returns the chains that a drawing needs: bottom and left, and the opposite
 * sides where they differ. Chains with only the overall dimension are omitted, and two
 * neighbouring dimensions that are both too short for their texts are one. Cost: walls
 * squared.
 * @param walls of all rooms, including arcs, metres
 * @param max_wall maximum thickness of a wall, metres: what is visible through a gap as
 * narrow is ignored
 * @param least corners nearer to each other are merged; metres, e.g. 0.03
 * @param room space for the text of a length along its chain, metres */
std::vector<DimensionChain>
wallChains(const std::vector<PlanElement>& walls,
           double max_wall,
           double least,
           double room)
{
  std::vector<DimensionChain> chains;
  for (const auto& [side, opposite] :
       {std::make_pair(DrawingSide::Bottom, DrawingSide::Top),
        std::make_pair(DrawingSide::Left, DrawingSide::Right)}) {
    DimensionChain first = chainAlong(walls, side, max_wall, least);
    DimensionChain second = chainAlong(walls, opposite, max_wall, least);
    thinOut(first, room);
    thinOut(second, room);
    if (first.places.size() > 2)
      chains.push_back(first);
    if (second.places.size() > 2 && !areAlike(first, second, least))
      chains.push_back(second);
  }
  return chains;
}

// Millimetres of paper.
constexpr double first_row = 9;       ///< from the plan to the first row
constexpr double next_row = 8;        ///< from row to row
constexpr double last_row = 5;        ///< what a row needs outwards
constexpr double beyond = 1.5;        ///< overshoot of extension lines
constexpr double min_dimension = 0.7; ///< nearer places are merged

using Line = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

/** @brief Returns the extension line from a corner to the dimension line; only its last
 * part if it would be long. */
Line
extensionLine(const Eigen::Vector2d& corner, const Eigen::Vector2d& at)
{
  constexpr double gap = 1.5;
  constexpr double longest = 50;
  constexpr double extension = 4;
  const double length = (at - corner).norm();
  const Eigen::Vector2d off = (at - corner) / std::max(length, 1e-9);
  return {corner + (length > longest ? length - extension : gap) * off,
          at + beyond * off};
}

/** @brief Returns the lines of a dimension: its own, and both extension lines. */
std::vector<Line>
linesOf(const SheetDimension& d)
{
  return {{d.start, d.end}, extensionLine(d.from, d.start), extensionLine(d.to, d.end)};
}

std::vector<SheetDimension>
dimensionsOf(const DimensionRow& row, const PlanFrame& frame)
{
  const DimensionChain& chain = row.chain;
  const Eigen::Vector2d along = wayAlong(chain.side);
  const auto onLine = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return p.dot(along) * along + row.line * wayOff(chain.side);
  };
  std::vector<SheetDimension> dimensions;
  for (std::size_t k = 0; k + 1 < chain.places.size(); ++k) {
    const Eigen::Vector2d from = frame(chain.places[k]);
    const Eigen::Vector2d to = frame(chain.places[k + 1]);
    dimensions.push_back(
        {from, to, onLine(from), onLine(to), chain.along(k + 1) - chain.along(k)});
  }
  return dimensions;
}

/** @brief Returns candidate boxes for the text of a dimension, the best first: on its
 * line, else beyond or beside it. */
std::vector<TextBox>
boxesFor(const SheetDimension& d, const std::string& text, DrawingSide side)
{
  constexpr double rise = 2.1; // of the text above its line
  const Eigen::Vector2d along = wayAlong(side);
  const Eigen::Vector2d up(-along.y(), along.x());
  const Eigen::Vector2d half = small_font * halfSizeOf({text});
  const double stretch = (d.end - d.start).norm();
  const double below = beyond + half.y() + 0.1;
  std::vector<TextBox> boxes;
  const auto add = [&](double shift, const Eigen::Vector2d& off) {
    boxes.push_back(
        {(d.start + d.end) / 2 + shift * along + off, half, along.x() > 0 ? 0. : 90.});
  };
  add(0, rise * up);
  add(0, below * wayOff(side));
  for (const double shift : {half.x(), 2 * half.x(), 3 * half.x()})
    for (const double sign : {1.0, -1.0}) {
      add(sign * (stretch / 2 + shift), rise * up);
      add(sign * shift, below * wayOff(side));
    }
  return boxes;
}

/** @brief Places the texts of a row, longer ones first, in the better places.
 * @return the first dimension whose text has no place, or their number */
std::size_t
placeTexts(TextPlaces& places, DrawingSide side, std::vector<SheetDimension>& row)
{
  std::vector<std::size_t> order(row.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return row[a].length > row[b].length;
  });
  std::size_t without = row.size();
  for (const std::size_t k : order) {
    const std::string text = decimalText(row[k].length, 2);
    if (const auto box = places.takeFirst(boxesFor(row[k], text, side)))
      row[k].text = SheetText{styleOf(PlanLayer::Dimension).text, box->middle,
                              small_font, text, box->degrees};
    else
      without = std::min(without, k);
  }
  return without;
}

/** @brief Takes the place at one end of a dimension out of its chain, so that it is
 * joined with the shorter one of its neighbours. */
void
joinWithNeighbour(DimensionChain& chain, std::size_t dimension)
{
  const std::size_t last = chain.places.size() - 1;
  const auto length = [&](std::size_t k) {
    return chain.along(k + 1) - chain.along(k);
  };
  const bool is_before =
      dimension + 1 == last ||
      (dimension > 0 && length(dimension - 1) < length(dimension + 1));
  const std::size_t removed = is_before ? dimension : dimension + 1;
  chain.places.erase(chain.places.begin() + static_cast<std::ptrdiff_t>(removed));
}

} // namespace

Eigen::Vector2d
wayAlong(DrawingSide side)
{
  return wayOff(side).cwiseAbs().reverse();
}

Eigen::Vector2d
wayOff(DrawingSide side)
{
  switch (side) {
  case DrawingSide::Bottom:
    return {0, -1};
  case DrawingSide::Left:
    return {-1, 0};
  case DrawingSide::Top:
    return {0, 1};
  default:
    return {1, 0};
  }
}

std::vector<DimensionRow>
rowsAround(const Floorplan& plan, const PlanFrame& frame, double max_wall)
{
  std::vector<PlanElement> walls;
  Eigen::AlignedBox2d whole; // without niches and reveals
  const PlanFrame turned{frame.turn};
  for (const PlanRoom& room : plan.rooms) {
    whole.extend(boundsOf(turned(room.boundary)));
    for (std::size_t e = 0; e < room.boundary.elements.size(); ++e)
      if (!wallShares(plan, room, e).isGuess())
        walls.push_back(turned(room.boundary.elements[e]));
  }
  const Eigen::AlignedBox2d bounds = boundsOf(plan, frame);
  const double text = 2 * small_font * halfSizeOf({"0.00"}).x();
  std::vector<DimensionChain> chains =
      wallChains(walls, max_wall, min_dimension / frame.scale, text / frame.scale);
  chains.push_back(
      {DrawingSide::Bottom, {whole.min(), {whole.max().x(), whole.min().y()}}});
  chains.push_back(
      {DrawingSide::Left, {whole.min(), {whole.min().x(), whole.max().y()}}});
  std::vector<DimensionRow> rows;
  for (const DimensionChain& chain : chains) {
    const auto inside =
        std::count_if(rows.begin(), rows.end(), [&](const DimensionRow& other) {
          return other.chain.side == chain.side;
        });
    const Eigen::Vector2d way = wayOff(chain.side);
    rows.push_back({chain, std::max(bounds.min().dot(way), bounds.max().dot(way)) +
                               first_row + static_cast<double>(inside) * next_row});
  }
  return rows;
}

Eigen::AlignedBox2d
spaceOf(const std::vector<DimensionRow>& rows, const Eigen::AlignedBox2d& plan)
{
  constexpr double without_row = 4;
  Eigen::AlignedBox2d space(Eigen::Vector2d::Constant(without_row),
                            Eigen::Vector2d::Constant(without_row));
  for (const DimensionRow& row : rows) {
    const Eigen::Vector2d way = wayOff(row.chain.side);
    const double off =
        row.line + last_row - std::max(plan.min().dot(way), plan.max().dot(way));
    (way.sum() < 0 ? space.min() : space.max()).array() =
        (way.sum() < 0 ? space.min() : space.max())
            .cwiseMax(off * way.cwiseAbs())
            .array();
  }
  return space;
}

std::vector<SheetDimension>
placedRows(std::vector<DimensionRow> rows, const PlanFrame& frame, TextPlaces& places)
{
  const PlanFrame of_walls{0, frame.scale, frame.shift};
  for (bool is_complete = false; !is_complete;) {
    TextPlaces tried = places;
    std::vector<std::vector<SheetDimension>> placed;
    for (const DimensionRow& row : rows) {
      placed.push_back(dimensionsOf(row, of_walls));
      for (const SheetDimension& d : placed.back())
        for (const Line& line : linesOf(d))
          tried.keepOff(line.first, line.second);
    }
    is_complete = true;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::size_t without = placeTexts(tried, rows[r].chain.side, placed[r]);
      if (without == placed[r].size())
        continue;
      is_complete = false;
      if (placed[r].size() > 1)
        joinWithNeighbour(rows[r].chain, without);
      else
        rows[r].chain.places.clear();
    }
    if (!is_complete)
      continue;
    places = tried;
    std::vector<SheetDimension> all;
    for (const std::vector<SheetDimension>& row : placed)
      all.insert(all.end(), row.begin(), row.end());
    return all;
  }
  return {};
}

void
addDimensions(Sheet& sheet, const std::vector<SheetDimension>& dimensions)
{
  const Eigen::Vector2d slant = 0.9 * Eigen::Vector2d(1, 1);
  for (const SheetDimension& d : dimensions) {
    for (const Line& line : linesOf(d))
      sheet.addLine(looks::thin, {line.first, line.second});
    for (const Eigen::Vector2d& at : {d.start, d.end})
      sheet.addLine(looks::tick, {at - slant, at + slant});
    if (d.text)
      sheet.add(*d.text);
  }
}

} // namespace pcl::sedr
