// SPDX-License-Identifier: BSD-3-Clause
#include "label_texts.h"

#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

std::string
levelText(double level)
{
  constexpr double half_a_unit = 0.005;
  return std::abs(level) < half_a_unit ? "±0.00"
                                       : (level < 0 ? "" : "+") + decimalText(level, 2);
}

std::string
titleOf(const PlanRoom& room)
{
  const std::string number = std::to_string(room.id);
  return room.name.empty() ? "Room " + number : number + " " + room.name;
}

std::vector<std::string>
roomTexts(const CeilingFaces& ceiling, DrawingView view, double zero)
{
  const PlanRoom& room = ceiling.room;
  const double usual = clearHeight(room).usual;
  std::string height = usual > 0 ? decimalText(usual, 2) : "";
  if (room.hasFacets())
    if (const auto [eaves, ridge] = heightRange(ceiling); eaves > 0)
      height = decimalText(eaves, 2) + " - " + decimalText(ridge, 2);
  std::vector<std::string> lines{titleOf(room)};
  const bool is_floor = view == DrawingView::Floor;
  lines.push_back(is_floor ? decimalText(room.area(), 2) + " m²"
                           : "ceiling " + decimalText(ceiling.area(), 2) + " m²");
  if (!height.empty() && (is_floor || room.hasFacets()))
    lines.push_back("h " + height + " m");
  if (is_floor)
    lines.push_back("▼ " + levelText(heightsOf(room).low - zero));
  return lines;
}

std::string
columnText(const PlanLoop& column)
{
  constexpr double same = 0.02;
  const std::vector<PlanElement>& e = column.elements;
  const auto isRound = [&](const PlanElement& part) {
    return part.isArc() && std::abs(part.radius - e.front().radius) < same;
  };
  if (!e.empty() && std::all_of(e.begin(), e.end(), isRound))
    return "Ø " + decimalText(2 * e.front().radius, 2);
  const bool is_quad =
      e.size() == 4 && std::none_of(e.begin(), e.end(), [](const PlanElement& part) {
        return part.isArc();
      });
  return is_quad ? decimalText(e[0].length(), 2) + " x " + decimalText(e[1].length(), 2)
                 : "";
}

std::string
textOf(const OpeningGap& opening)
{
  return opening.mark + " " + decimalText(opening.width, 2) + " x " +
         decimalText(opening.height, 2) +
         (opening.kind == OpeningKind::Window ? " sill " + decimalText(opening.sill, 2)
                                              : "");
}

} // namespace pcl::sedr
