// SPDX-License-Identifier: BSD-3-Clause
#include "dimension_rows.h"

#include "plan_layers.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <numeric>

namespace pcl::sedr {
namespace {

// Millimetres of paper.
constexpr double first_row = 9;       ///< from the plan to the first row
constexpr double next_row = 8;        ///< from row to row
constexpr double last_row = 5;        ///< what a row needs outwards
constexpr double beyond = 1.5;        ///< overshoot of extension lines
constexpr double min_dimension = 0.7; ///< of nearer places only one is drawn

/** @brief Returns the extension line from a corner to the dimension line; only its last
 * part if it would be long. */
PlanElement
extensionLine(const Eigen::Vector2d& corner, const Eigen::Vector2d& at)
{
  constexpr double gap = 1.5;
  constexpr double longest = 50;
  constexpr double extension = 4;
  const double length = (at - corner).norm();
  const Eigen::Vector2d off = (at - corner) / std::max(length, 1e-9);
  return segment(corner + (length > longest ? length - extension : gap) * off,
                 at + beyond * off);
}

std::vector<SheetDimension>
dimensionsOf(const DimensionRow& row,
             const Eigen::AlignedBox2d& box,
             const PlanFrame& frame)
{
  const DimensionChain& chain = row.chain;
  const Eigen::Vector2d along = wayAlong(chain.side);
  const double line =
      std::max(box.min().dot(chain.side), box.max().dot(chain.side)) + row.off;
  const auto onLine = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return p.dot(along) * along + line * chain.side;
  };
  std::vector<SheetDimension> dimensions;
  for (std::size_t k = 0; k + 1 < chain.places.size(); ++k) {
    const Eigen::Vector2d from = frame(chain.places[k]);
    const Eigen::Vector2d to = frame(chain.places[k + 1]);
    dimensions.push_back({from, to, onLine(from), onLine(to), chain.length(k)});
  }
  return dimensions;
}

/** @brief Returns candidate boxes for the text of a dimension, the best first: on its
 * line, in its middle or else between its ends, else beyond or beside it. */
std::vector<TextBox>
boxesFor(const SheetDimension& d, const std::string& text, const Eigen::Vector2d& side)
{
  constexpr double rise = 2.1; // of the text above its line
  const Eigen::Vector2d along = wayAlong(side);
  const Eigen::Vector2d up = leftOf(along);
  const Eigen::Vector2d half = small_font * halfSizeOf({text});
  const double stretch = (d.end - d.start).norm();
  const double below = beyond + half.y() + 0.1;
  std::vector<TextBox> boxes;
  const auto add = [&](double shift, const Eigen::Vector2d& off) {
    boxes.push_back(
        {(d.start + d.end) / 2 + shift * along + off, half, along.x() > 0 ? 0. : 90.});
  };
  add(0, rise * up);
  add(0, below * side);
  for (double shift = half.x(); shift + half.x() < stretch / 2; shift += half.x())
    for (const double sign : {1.0, -1.0})
      add(sign * shift, rise * up);
  for (const double shift : {half.x(), 2 * half.x(), 3 * half.x()})
    for (const double sign : {1.0, -1.0}) {
      add(sign * (stretch / 2 + shift), rise * up);
      add(sign * shift, below * side);
    }
  return boxes;
}

/** @brief Places the texts of a row, longer ones first, in the better places. */
void
placeTexts(TextPlaces& places,
           const Eigen::Vector2d& side,
           std::vector<SheetDimension>& row)
{
  std::vector<std::size_t> order(row.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return row[a].length > row[b].length;
  });
  for (const std::size_t k : order) {
    const std::string text = decimalText(row[k].length, 2);
    if (const auto box = places.takeFirst(boxesFor(row[k], text, side)))
      row[k].text = SheetText{styleOf(PlanLayer::Dimension).text, box->middle,
                              small_font, text, box->degrees};
  }
}

/** @brief Joins each dimension of a row without a text with the shorter one of its
 * neighbours.
 * @return whether there was one */
bool
joinUnreadable(const std::vector<SheetDimension>& row, DimensionChain& chain)
{
  bool has_joined = false;
  for (std::size_t k = row.size(); k-- > 0;) {
    if (row[k].text)
      continue;
    has_joined = true;
    const std::size_t last = chain.places.size() - 1;
    if (last == 1) {
      chain.places.clear();
      break;
    }
    const bool is_before =
        k + 1 == last || (k > 0 && chain.length(k - 1) < chain.length(k + 1));
    chain.places.erase(chain.places.begin() +
                       static_cast<std::ptrdiff_t>(is_before ? k : k + 1));
    k -= is_before && k > 0 ? 1 : 0; // the one before is longer now
  }
  return has_joined;
}

} // namespace

std::vector<PlanElement>
linesOf(const SheetDimension& d)
{
  return {segment(d.start, d.end), extensionLine(d.from, d.start),
          extensionLine(d.to, d.end)};
}

std::vector<PlanElement>
ticksOf(const SheetDimension& d)
{
  const Eigen::Vector2d slant = 0.9 * Eigen::Vector2d(1, 1);
  return {segment(d.start - slant, d.start + slant),
          segment(d.end - slant, d.end + slant)};
}

std::vector<DimensionRow>
rowsAround(const Floorplan& plan, double turn, double max_wall)
{
  std::vector<PlanElement> walls;
  Eigen::AlignedBox2d whole; // without niches and reveals
  const PlanFrame turned{turn};
  for (const PlanRoom& room : plan.rooms) {
    whole.extend(boundsOf(turned(room.boundary)));
    for (std::size_t e = 0; e < room.boundary.elements.size(); ++e)
      if (!wallShares(plan, room, e).isGuess())
        walls.push_back(turned(room.boundary.elements[e]));
  }
  std::vector<DimensionChain> chains = openingChains(plan, turned, whole);
  for (const DimensionChain& chain : wallChains(walls, max_wall))
    chains.push_back(chain);
  chains.push_back({{0, -1}, {whole.min(), {whole.max().x(), whole.min().y()}}});
  chains.push_back({{-1, 0}, {whole.min(), {whole.min().x(), whole.max().y()}}});
  std::vector<DimensionRow> rows;
  for (const DimensionChain& chain : chains) {
    const auto inside =
        std::count_if(rows.begin(), rows.end(), [&](const DimensionRow& other) {
          return other.chain.side == chain.side;
        });
    rows.push_back({chain, first_row + static_cast<double>(inside) * next_row});
  }
  return rows;
}

Eigen::AlignedBox2d
spaceOf(const std::vector<DimensionRow>& rows)
{
  constexpr double without_row = 4;
  Eigen::AlignedBox2d space(Eigen::Vector2d::Constant(without_row),
                            Eigen::Vector2d::Constant(without_row));
  for (const DimensionRow& row : rows) {
    const Eigen::Vector2d& side = row.chain.side;
    Eigen::Vector2d& needed = side.sum() < 0 ? space.min() : space.max();
    needed = needed.cwiseMax((row.off + last_row) * side.cwiseAbs()).eval();
  }
  return space;
}

std::vector<SheetDimension>
placedRows(std::vector<DimensionRow> rows,
           const Eigen::AlignedBox2d& box,
           const PlanFrame& frame,
           TextPlaces& places)
{
  const PlanFrame of_walls{0, frame.scale, frame.shift};
  for (DimensionRow& row : rows)
    dropSmallSteps(row.chain, min_dimension / frame.scale);
  while (true) {
    TextPlaces tried = places;
    std::vector<std::vector<SheetDimension>> placed;
    for (const DimensionRow& row : rows) {
      placed.push_back(dimensionsOf(row, box, of_walls));
      for (const SheetDimension& d : placed.back())
        for (const PlanElement& line : linesOf(d))
          tried.keepOff(line.start, line.end);
    }
    bool is_complete = true;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      placeTexts(tried, rows[r].chain.side, placed[r]);
      is_complete = !joinUnreadable(placed[r], rows[r].chain) && is_complete;
    }
    if (!is_complete)
      continue;
    places = tried;
    std::vector<SheetDimension> all;
    for (const std::vector<SheetDimension>& row : placed)
      all.insert(all.end(), row.begin(), row.end());
    return all;
  }
}

void
addDimensions(Sheet& sheet, const std::vector<SheetDimension>& dimensions)
{
  for (const SheetDimension& d : dimensions) {
    for (const PlanElement& line : linesOf(d))
      sheet.addLine(looks::thin, {line.start, line.end});
    for (const PlanElement& tick : ticksOf(d))
      sheet.addLine(looks::tick, {tick.start, tick.end});
    if (d.text)
      sheet.add(*d.text);
  }
}

} // namespace pcl::sedr
