// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/plan_frame.h"
#include "../sheet/sheet.h"
#include "../sheet/text_places.h"
#include "plan_drawing.h"

#include <pcl/sedr_filters/floorplan.h>

namespace pcl {
namespace sedr {

/** @brief Writes the texts within a plan on a sheet: of rooms, heights, columns,
 * doorways, walls. What matters more takes its place first; what finds none is left
 * out, or told in fewer words. */
class PlanTexts {
public:
  /** @param frame from the plan to the sheet */
  PlanTexts(Sheet& sheet, TextPlaces& places, const PlanFrame& frame);

  /** @param drawn its lines, whose notes are written along them */
  void write(const Floorplan& plan, const std::vector<DrawnElement>& drawn);

private:
  void writeRoom(const PlanRoom& room, const TextSpot& spot);
  void writeAlong(const PlanElement& element,
                  const std::string& look,
                  const std::string& text,
                  double off);
  void writeColumn(const PlanLoop& column);
  void writeWays(const Floorplan& plan);
  /** @brief The largest font at which lines about a place are free there. */
  bool writeAt(const std::string& look,
               const Eigen::Vector2d& place,
               const std::vector<std::string>& lines,
               double font);
  void add(const std::string& look,
           const TextBox& box,
           double font,
           const std::string& text);

  Sheet& sheet_;
  TextPlaces& places_;
  PlanFrame frame_;
};

} // namespace sedr
} // namespace pcl
