// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_annotations.h"

#include <pcl/sedr_filters/floorplan.h>

namespace pcl {
namespace sedr {

/** @brief Places the texts within a plan on a sheet: of rooms, heights, columns,
 * doorways, walls. What matters more takes its place first; what finds none is left
 * out, or told in fewer words. */
class PlanTexts {
public:
  /** @param frame from the plan to the sheet */
  PlanTexts(PlanAnnotations& annotations, TextPlaces& places, const PlanFrame& frame);

  /** @param drawn its lines, whose notes are written along them */
  void place(const Floorplan& plan, const std::vector<DrawnElement>& drawn);

private:
  void writeRoom(const PlanRoom& room, const TextSpot& spot);
  /** @brief A text beside a line, where there is space along it. */
  std::optional<SheetText> placeAlong(const PlanElement& element,
                                      const std::string& look,
                                      const std::string& text);
  void writeAlong(const PlanElement& element,
                  const std::string& look,
                  const std::string& text);
  void writeSize(const PlanElement& wall);
  void writeColumn(const PlanLoop& column);
  void writeWays(const Floorplan& plan);
  /** @brief The largest font at which lines about a place are free there. */
  bool writeAt(const std::string& look,
               const Eigen::Vector2d& place,
               const std::vector<std::string>& lines,
               double font);
  void add(const SheetText& text) { annotations_.texts.push_back(text); }

  PlanAnnotations& annotations_;
  TextPlaces& places_;
  PlanFrame frame_;
};

} // namespace sedr
} // namespace pcl
