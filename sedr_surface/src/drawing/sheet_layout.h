// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/sheet.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <Eigen/Geometry>

#include <string>

namespace pcl::sedr {

/** @brief Maps a plan to a drawing: rotation, scale, shift. */
struct PlanFrame {
  double turn = 0; ///< radians, counter-clockwise
  double scale = 1;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const
  {
    return scale * (Eigen::Rotation2Dd(turn) * p) + shift;
  }
  PlanElement operator()(PlanElement element) const;
  PlanLoop operator()(PlanLoop loop) const;

  Eigen::Vector2d toPlan(const Eigen::Vector2d& p) const
  {
    return Eigen::Rotation2Dd(-turn) * Eigen::Vector2d((p - shift) / scale);
  }
};

/** @brief Returns the bounding box of all that is drawn of a plan, in a frame; empty
 * without rooms. */
Eigen::AlignedBox2d boundsOf(const Floorplan& plan,
                             const std::vector<PlanWall>& walls,
                             const PlanFrame& frame = {});

/** @brief Margins of a sheet, millimetres. The wider margin is for binding, as in ISO
 * 5457. */
namespace sheet_measures {
constexpr double margin_left = 20;
constexpr double margin = 10;       ///< on the other sides
constexpr double title_height = 27; ///< of the title strip, within the frame
constexpr double mark_space = 8;    ///< beside a plan, of marks of sections
} // namespace sheet_measures

/** @brief Position of a plan on its sheet. */
struct SheetLayout {
  double scale = 100;   ///< 1:100
  std::string paper;    ///< "A3"; "" if no usual size is large enough
  Eigen::Vector2d size; ///< of the sheet, millimetres
  PlanFrame frame;      ///< maps the plan to the sheet, y up
};

/** @brief Returns the part of a sheet above its title block, within its frame. */
inline Eigen::AlignedBox2d
drawingSpaceOf(const SheetLayout& layout)
{
  using namespace sheet_measures;
  return {Eigen::Vector2d(margin_left, margin + title_height),
          layout.size - Eigen::Vector2d::Constant(margin)};
}

/** @brief Chooses the largest usual scale at which every storey fits the paper with its
 * dimensions, in either orientation. With a given scale, chooses the smallest usual
 * paper from the given size on. Portrait is used only if it allows a larger scale or
 * smaller paper. */
SheetLayout layoutOf(const Floorplan& plan, const DrawingSettings& settings);

/** @brief Chooses scale and paper for another drawing.
 * @param bounds of it, metres
 * @param space around it, of dimensions: see spaceOf() */
SheetLayout layoutOf(const Eigen::AlignedBox2d& bounds,
                     const Eigen::AlignedBox2d& space,
                     const DrawingSettings& settings);

/** @brief What the title block of a drawing tells beside its settings. */
struct TitleTexts {
  std::string usual_title; ///< if none is given
  std::string part_caption;
  std::string part; ///< storey or section
  std::string summary_caption;
  std::string summary;
  std::string notes;
  bool has_north = true;
};

/** @brief Adds the frame of the sheet and the strip at its foot: title, project,
 * client, part, scale and bar, north arrow, and fields to be filled in by hand. */
void addTitleBlock(Sheet& sheet,
                   const SheetLayout& layout,
                   const DrawingSettings& settings,
                   const TitleTexts& texts);

} // namespace pcl::sedr
