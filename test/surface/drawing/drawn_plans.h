// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "says.h"
#include "two_storeys.h"

#include "sedr_surface/src/drawing/plan_drawing.h"

#include <map>
#include <sstream>
#include <string>

namespace sedr_test {

using namespace pcl::sedr;

inline Floorplan
planOf(const PlanLoop& boundary)
{
  return {{roomOf(boundary, 2.5)}};
}

inline std::string
svgOf(const Floorplan& plan, const DrawingSettings& settings = {})
{
  return drawFloorplan(plan, {DrawingFormat::Svg}, settings)[0];
}

inline std::string
dxfOf(const Floorplan& plan, const DrawingSettings& settings = {})
{
  return drawFloorplan(plan, {DrawingFormat::Dxf}, settings)[0];
}

/** Number of entities of a type on a layer of a DXF. */
inline std::size_t
countOf(const std::string& dxf, const std::string& type, const std::string& layer)
{
  std::size_t count = 0;
  bool is_type = false;
  std::istringstream lines(dxf);
  for (std::string code, value;
       std::getline(lines, code) && std::getline(lines, value);)
    if (code == "0")
      is_type = value == type;
    else if (code == "8")
      count += is_type && value == layer ? 1 : 0;
  return count;
}

/** The sum of the lengths of lines on a layer of a DXF. */
inline double
lineLength(const std::string& layer, const std::string& dxf)
{
  double length = 0;
  bool is_line = false;
  std::map<std::string, double> at; // by code
  std::istringstream lines(dxf);
  for (std::string code, value;
       std::getline(lines, code) && std::getline(lines, value);)
    if (code == "0") {
      if (is_line)
        length += std::hypot(at["11"] - at["10"], at["21"] - at["20"]);
      is_line = value == "LINE";
    }
    else if (code == "8")
      is_line = is_line && value == layer;
    else if (is_line && code.size() == 2 && value.find('.') != std::string::npos)
      at[code] = std::stod(value);
  return length;
}

/** The sum of the areas of polylines, or of hatches, whose holes count as negative, on
 * a layer of a DXF. */
inline double
areaOf(const std::string& type, const std::string& layer, const std::string& dxf)
{
  double area = 0;
  std::vector<Eigen::Vector2d> corners;
  const auto close = [&] {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Eigen::Vector2d& next = corners[(k + 1) % corners.size()];
      area += (corners[k].x() * next.y() - next.x() * corners[k].y()) / 2;
    }
    corners.clear();
  };
  bool is_outline = false;
  std::istringstream lines(dxf);
  for (std::string code, value;
       std::getline(lines, code) && std::getline(lines, value);)
    if (code == "0") {
      close();
      is_outline = value == type;
    }
    else if (code == "92") // the next loop of a hatch
      close();
    else if (code == "8")
      is_outline = is_outline && value == layer;
    else if (is_outline && code == "10")
      corners.emplace_back(std::stod(value), 0);
    else if (is_outline && code == "20")
      corners.back().y() = std::stod(value);
  return area;
}

/** The sum of the areas of the outlines in a DXF. */
inline double
outlinedArea(const std::string& dxf)
{
  return areaOf("LWPOLYLINE", "A-AREA", dxf);
}

/** Settings with the given scale. */
inline DrawingSettings
scaled(double scale)
{
  DrawingSettings settings;
  settings.scale = scale;
  return settings;
}

inline DrawingSettings
ofCeiling(double scale = 50)
{
  DrawingSettings settings = scaled(scale);
  settings.view = DrawingView::Ceiling;
  return settings;
}

inline DrawingSettings
sheetOf(const PlanStorey& storey)
{
  DrawingSettings settings;
  settings.storey = &storey;
  return settings;
}

} // namespace sedr_test
