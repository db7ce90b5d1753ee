// SPDX-License-Identifier: BSD-3-Clause
#include "chain_drawing.h"

#include "../formats/decimal_text.h"
#include "../sheet/sheet_layout.h"

#include <algorithm>

namespace pcl::sedr {
namespace {

using namespace sheet_measures;

constexpr double beyond = 1.5; ///< overshoot of extension lines over the dimension line

/** @brief Returns the extension line from a corner to the dimension line; only its last
 * part if it would be long. */
std::pair<Eigen::Vector2d, Eigen::Vector2d>
thinLine(const Eigen::Vector2d& corner, const Eigen::Vector2d& at)
{
  constexpr double gap = 1.5;
  constexpr double longest = 50;
  constexpr double extension = 4;
  const double length = (at - corner).norm();
  const Eigen::Vector2d off = (at - corner) / std::max(length, 1e-9);
  return {corner + (length > longest ? length - extension : gap) * off,
          at + beyond * off};
}

/** @brief Returns candidate boxes for the text of a dimension, the best first. */
std::vector<TextBox>
boxesFor(const PlacedDimension& dimension,
         const std::string& text,
         const Eigen::Vector2d& along,
         const Eigen::Vector2d& off)
{
  constexpr double rise = 2.1; // of the text above its line
  const Eigen::Vector2d up(-along.y(), along.x());
  const Eigen::Vector2d half = small_font * halfSizeOf({text});
  const Eigen::Vector2d middle = (dimension.start + dimension.end) / 2;
  const double stretch = (dimension.end - dimension.start).norm();
  const auto boxAt = [&](double shift, const Eigen::Vector2d& from_line) {
    return TextBox{middle + shift * along + from_line, half, along.x() > 0 ? 0. : 90.};
  };
  std::vector<TextBox> boxes{boxAt(0, rise * up)};
  const double below = beyond + half.y() + 0.1;
  boxes.push_back(boxAt(0, below * off));
  for (const double shift : {half.x(), 2 * half.x(), 3 * half.x()})
    for (const double sign : {1.0, -1.0}) {
      boxes.push_back(boxAt(sign * (stretch / 2 + shift), rise * up));
      boxes.push_back(boxAt(sign * shift, below * off));
    }
  return boxes;
}

} // namespace

std::vector<PlacedDimension>
linesOf(const DimensionChain& chain, const PlanFrame& frame, double line)
{
  const Eigen::Vector2d along = wayAlong(chain.side);
  const Eigen::Vector2d off = wayOff(chain.side);
  const auto onLine = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return p.dot(along) * along + line * off;
  };
  std::vector<PlacedDimension> row;
  for (std::size_t k = 0; k + 1 < chain.places.size(); ++k) {
    const Eigen::Vector2d from = frame(chain.places[k]);
    const Eigen::Vector2d to = frame(chain.places[k + 1]);
    row.push_back(
        {from, to, onLine(from), onLine(to), chain.along(k + 1) - chain.along(k)});
  }
  return row;
}

void
keepOff(TextPlaces& texts, const std::vector<PlacedDimension>& row)
{
  for (const PlacedDimension& dimension : row) {
    texts.keepOff(dimension.start, dimension.end);
    for (const auto& [corner, at] : {std::make_pair(dimension.from, dimension.start),
                                     std::make_pair(dimension.to, dimension.end)})
      texts.keepOff(thinLine(corner, at).first, thinLine(corner, at).second);
  }
}

void
placeTexts(TextPlaces& texts, DrawingSide side, std::vector<PlacedDimension>& row)
{
  // Longer ones are placed first, in the better places.
  std::vector<PlacedDimension*> order;
  for (PlacedDimension& dimension : row)
    order.push_back(&dimension);
  std::stable_sort(order.begin(), order.end(),
                   [](const PlacedDimension* a, const PlacedDimension* b) {
                     return a->length > b->length;
                   });
  for (PlacedDimension* dimension : order) {
    const std::string text = decimalText(dimension->length, 2);
    if (const auto box =
            texts.takeFirst(boxesFor(*dimension, text, wayAlong(side), wayOff(side))))
      dimension->text = SheetText{"size", box->middle, small_font, text, box->degrees};
  }
}

void
addChain(Sheet& sheet, const std::vector<PlacedDimension>& row)
{
  const auto addPlace = [&](const Eigen::Vector2d& corner, const Eigen::Vector2d& at) {
    const Eigen::Vector2d slant = 0.9 * Eigen::Vector2d(1, 1);
    sheet.addLine("line", {thinLine(corner, at).first, thinLine(corner, at).second});
    sheet.addLine("tick", {at - slant, at + slant});
  };
  for (const PlacedDimension& dimension : row) {
    addPlace(dimension.from, dimension.start);
    sheet.addLine("line", {dimension.start, dimension.end});
    if (dimension.text)
      sheet.add(*dimension.text);
  }
  if (!row.empty())
    addPlace(row.back().to, row.back().end);
}

} // namespace pcl::sedr
