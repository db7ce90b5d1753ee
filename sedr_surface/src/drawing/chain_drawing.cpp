// SPDX-License-Identifier: BSD-3-Clause
#include "chain_drawing.h"

#include "../formats/decimal_text.h"
#include "../sheet/sheet_layout.h"

#include <algorithm>
#include <vector>

namespace pcl {
namespace sedr {
namespace {

using namespace sheet_measures;

/** @brief Draws the dimensions of one row. */
class ChainWriter {
public:
  ChainWriter(Sheet& sheet, TextPlaces& texts, DrawingSide side, double line)
      : sheet_(sheet)
      , texts_(texts)
      , along_(wayAlong(side))
      , off_(wayOff(side))
      , line_(line)
  {}

  Eigen::Vector2d onLine(const Eigen::Vector2d& p) const
  {
    return p.dot(along_) * along_ + line_ * off_;
  }

  /** @brief A stroke on the line, and a thin line from the corner, unless that is far.
   */
  void addPlace(const Eigen::Vector2d& corner)
  {
    constexpr double gap = 1.5;
    constexpr double beyond = 1.5;
    constexpr double tick = 0.9;
    constexpr double longest = 50;
    constexpr double stub = 4;
    const Eigen::Vector2d at = onLine(corner);
    const double length = (at - corner).dot(off_);
    const double start = length > longest ? length - stub : gap;
    const Eigen::Vector2d slant = tick * Eigen::Vector2d(1, 1);
    sheet_.addLine("line", {corner + start * off_, at + beyond * off_});
    sheet_.addLine("tick", {at - slant, at + slant});
  }

  /** @brief The length between two places of the line. */
  void addLength(const Eigen::Vector2d& from,
                 const Eigen::Vector2d& to,
                 const std::string& text)
  {
    sheet_.addLine("line", {from, to});
    const Eigen::Vector2d half = small_font * halfSizeOf({text});
    const Eigen::Vector2d middle = (from + to) / 2;
    const double stretch = (to - from).dot(along_);
    const auto boxAt = [&](double shift, double rise) {
      return TextBox{middle + shift * along_ + rise * up(), half, degrees()};
    };
    constexpr double rise = 2.1; // of the text from its line
    std::vector<TextBox> boxes;
    if (2 * half.x() < stretch)
      boxes.push_back(boxAt(0, rise));
    boxes.push_back(boxAt(0, -rise));
    for (const double steps : {1.0, 1.5, 2.0, 2.5, 3.0})
      for (const double sign : {1.0, -1.0})
        boxes.push_back(boxAt(sign * (stretch / 2 + steps * half.x()), -rise));
    const auto box = texts_.takeFirst(boxes);
    if (!box)
      return;
    const double shift = (box->middle - middle).dot(along_);
    if (shift != 0)
      sheet_.addLine("line", {middle, middle + shift * along_ - 0.9 * up() -
                                          (shift > 0 ? 1 : -1) * half.x() * along_});
    sheet_.add(SheetText{"size", box->middle, small_font, text, degrees()});
  }

private:
  /** @brief Texts are read from below or from the right. */
  double degrees() const { return along_.x() > 0 ? 0 : 90; }
  Eigen::Vector2d up() const { return {-along_.y(), along_.x()}; }

  Sheet& sheet_;
  TextPlaces& texts_;
  Eigen::Vector2d along_;
  Eigen::Vector2d off_;
  double line_;
};

} // namespace

void
addChain(Sheet& sheet,
         TextPlaces& texts,
         const DimensionChain& chain,
         const PlanFrame& frame,
         double line)
{
  ChainWriter writer(sheet, texts, chain.side, line);
  for (const Eigen::Vector2d& corner : chain.places)
    writer.addPlace(frame(corner));
  // Longer ones first: they have the better places.
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k + 1 < chain.places.size(); ++k)
    order.push_back(k);
  const auto length = [&](std::size_t k) {
    return chain.along(k + 1) - chain.along(k);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return length(a) > length(b); });
  for (const std::size_t k : order)
    writer.addLength(writer.onLine(frame(chain.places[k])),
                     writer.onLine(frame(chain.places[k + 1])),
                     decimalText(length(k), 2));
}

} // namespace sedr
} // namespace pcl
