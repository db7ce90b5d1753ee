// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_annotations.h"

#include <pcl/sedr_filters/floorplan.h>

namespace pcl::sedr {

/** @brief Places the texts within a plan on a sheet: rooms, heights, columns, doorways,
 * walls. More important texts are placed first; texts without space are shortened or
 * omitted. */
class PlanTexts {
public:
  /** @param frame maps the plan to the sheet */
  PlanTexts(PlanAnnotations& annotations, TextPlaces& places, const PlanFrame& frame);

  /** @param drawn lines, whose notes are placed along them
   * @param ceilings of each room, whose parts have notes */
  void place(const Floorplan& plan,
             const std::vector<DrawnElement>& drawn,
             const std::vector<CeilingLines>& ceilings);

private:
  /** @brief Returns the radius of a circle around the spot that contains the text,
   * metres. */
  double
  writeRoom(const PlanRoom& room, const CeilingLines& ceiling, const TextSpot& spot);
  /** @brief Places a text beside a line, if there is space. */
  std::optional<SheetText> placeAlong(const PlanElement& element,
                                      const std::string& look,
                                      const std::string& text);
  void writeAlong(const PlanElement& element,
                  const std::string& look,
                  const std::string& text);
  void writeSize(const PlanElement& wall);
  void writeColumn(const PlanLoop& column);
  void writeWays(const Floorplan& plan);
  /** @brief Writes lines about a place in the largest font that fits there. */
  std::optional<TextBox> writeAt(const std::string& look,
                                 const TextSpot& spot,
                                 const std::vector<std::string>& lines,
                                 double font);
  void add(const SheetText& text) { annotations_.texts.push_back(text); }

  PlanAnnotations& annotations_;
  TextPlaces& places_;
  PlanFrame frame_;
};

} // namespace pcl::sedr
