// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dxf_text.h"
#include "../drawing/plan_drawing.h"

#include <Eigen/Geometry>

#include <string>

namespace pcl {
namespace sedr {

/** @brief Layers of a DXF that are not those of lines. */
namespace dxf_layers {
constexpr const char* area_layer = "A-AREA";
constexpr const char* door_layer = "A-DOOR";
constexpr const char* name_layer = "A-AREA-IDEN";
constexpr const char* size_layer = "A-ANNO-DIMS";
constexpr const char* text_layer = "A-ANNO-TEXT";
constexpr const char* height_layer = "A-CLNG-IDEN";
} // namespace dxf_layers

/** @brief The layer of a line. */
const char* nameOf(DrawnLayer layer);

/** @brief Writes the texts of a plan. Letters are as high as on the sheet, where they
 * are 1.8 and 2.5 mm. */
class DxfTexts {
public:
  /** @param scale of the sheet: 50 for 1:50 */
  DxfTexts(DxfText& dxf, double scale)
      : dxf_(dxf)
      , height_(1.8e-3 * scale)
      , name_height_(2.5e-3 * scale)
  {}

  /** @brief Number, area and height of a room, heights of its details and eaves, radii
   * of its arcs, sizes of its columns. */
  void writeRoom(const PlanRoom& room);

  /** @brief Beside the middle of a line, so many heights off it; nothing where the text
   * is longer. */
  void writeAlong(const char* layer,
                  const PlanElement& line,
                  const std::string& text,
                  double off);

  /** @brief The outline of each doorway within its wall, and words at stairs. */
  void writeWays(const Floorplan& plan);

  /** @brief A line of text below the plan, `rows` rows below it. Not ASCII: "?". */
  void writeBelow(const Eigen::AlignedBox2d& bounds, std::string text, double rows);

private:
  void writeColumn(const PlanLoop& column);

  DxfText& dxf_;
  double height_;
  double name_height_;
};

} // namespace sedr
} // namespace pcl
