// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/text_places.h"
#include "dimension_rows.h"
#include "opening_gaps.h"
#include "plan_lines.h"

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A text of a plan on its sheet. */
struct PlanText {
  PlanLayer layer = PlanLayer::Note;
  SheetText text;
};

/** @brief The texts within a plan. */
struct PlanTexts {
  std::vector<PlanText> texts;
  std::vector<SheetDimension> walls; ///< lengths on straight walls
  std::vector<PlanElement> leaders;  ///< from openings to their numbers; in the plan
  std::string unplaced;              ///< numbers of openings without space
};

/** @brief Which texts a plan has. */
struct PlanTextSettings {
  DrawingView view = DrawingView::Floor;
  double zero = 0; ///< height of level 0, metres
  bool wall_numbers = false;
};

/** @brief Places the texts within a plan by importance: rooms, stairs, heights of
 * details, notes of lines, eaves, columns, openings, walls. They overlap neither each
 * other nor what is occupied; one without space is shortened or left out, the number of
 * an opening at the end of a leader.
 * @param surfaces of each room
 * @param frame maps the plan to the sheet */
PlanTexts placedTexts(const Floorplan& plan,
                      const std::vector<DrawnSurfaces>& surfaces,
                      const std::vector<PlanLine>& lines,
                      const std::vector<OpeningGap>& openings,
                      const PlanFrame& frame,
                      const PlanTextSettings& settings,
                      TextPlaces& places);

/** @brief Lines of text within a loop. */
struct DrawingLabel {
  PlanLayer layer = PlanLayer::Room;
  PlanLoop within;
  std::vector<std::string> lines;
  std::vector<PlanLoop> off{}; ///< loops that it keeps off
};

/** @brief Places labels, those without space for all of their lines with the first
 * ones, then the notes of lines along them. */
PlanTexts placedLabels(const std::vector<DrawingLabel>& labels,
                       const std::vector<PlanLine>& lines,
                       const PlanFrame& frame,
                       TextPlaces& places);

} // namespace pcl::sedr
