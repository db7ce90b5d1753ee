// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_drawing.h"

#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

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

/** @brief A drawing of cut solids: what is filled below its outlines. */
struct CutDrawing : Drawing {
  std::vector<PlanLoop> bodies; ///< of walls and slabs, metres
  std::vector<DrawingLabel> labels{};
  TitleTexts title{};
};

/** @brief Returns whether an element of an outline is upright. */
bool isUpright(const PlanElement& e);

PlanLoop rectangleOf(double left, double right, double bottom, double top);

/** @brief Adds dimensions, layout and texts to a drawing with outlines and bodies:
 * breadths below, heights on the left, both overall. */
void complete(CutDrawing& drawing, const DrawingSettings& settings);

/** @brief Returns the drawing as a sheet. */
Sheet cutSheet(const CutDrawing& drawing, const DrawingSettings& settings);

std::string written(const CutDrawing& drawing,
                    DrawingFormat format,
                    const DrawingSettings& settings);

/** @brief Returns the loops in which the vertical plane through a line cuts a closed
 * mesh, counter-clockwise around what it encloses. Places are metres along the line
 * from its start, and heights. A corner on the plane counts as beyond it. O(triangles).
 */
std::vector<PlanLoop> cutOf(const TriangleMesh& mesh, const SectionLine& line);

/** @brief Returns the outlines of some triangles that face one side, holes clockwise.
 * @param place where a vertex is on the drawing */
std::vector<PlanLoop>
outlinesOf(const TriangleMesh& mesh,
           const std::vector<std::size_t>& triangles,
           const std::function<Eigen::Vector2d(const Eigen::Vector3d&)>& place);

/** @brief Returns the ranges in which a line runs within a loop, metres from its start;
 * it goes on beyond both ends. */
std::vector<std::pair<double, double>> rangesIn(const PlanLoop& loop,
                                                const SectionLine& line);

} // namespace pcl::sedr
