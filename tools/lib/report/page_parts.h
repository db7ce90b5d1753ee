// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/result_folder.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <string>

namespace pcl::sedr::tools {

/** @brief Writes a mesh without elements as binary glTF, with one element per room and
 * label, as solidToGlb() does for solids. Rooms that the plan lacks are put on a storey
 * of their own.
 * @param mesh triangles face out of the rooms */
std::string meshToGlb(TriangleMesh mesh, const Floorplan& plan);

/** @brief Returns a mesh of at most `most` triangles for display: its vertices are
 * clustered room by room in cells of one size (vtkQuadricClustering), so that corners
 * and edges stay. Small meshes are returned as they are. Labels and rooms are kept,
 * elements are not. */
TriangleMesh reducedMesh(const TriangleMesh& mesh, std::size_t most);

/** @brief Returns the points of the page: the scan, thinned to some hundred thousand
 * points as far as it lies within a metre of the model, or the refined structure if
 * there is no scan. Null without points.
 *
 * `places` are three 16-bit numbers a point, from `low` to `high`; `distances` of the
 * points from the mesh (absent without a mesh) one byte each in fiftieths of `range`,
 * 255 for more than half a metre; both are base64. The first `below` points lie below
 * the ceilings. `points` is the size of the whole scan.
 * @param path of the scan; empty: none
 * @param range distance that has the last colour, metres */
ResultFolder::Json pagePoints(const ResultFolder& folder,
                              const std::string& path,
                              const Floorplan& plan,
                              const TriangleMesh& mesh,
                              const TriangleMesh& solid,
                              double range);

/** @brief Number of steps in which colours of distances change. */
constexpr int distance_steps = 50;

/** @brief Returns bytes in base64. */
std::string base64(const void* bytes, std::size_t size);

// The files of these names, embedded by embed_text.cmake.
extern const char* const page_html;
extern const char* const page_css;
extern const char* const page_js;
extern const char* const model_js;
extern const char* const texts_js;

} // namespace pcl::sedr::tools
