// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"
#include "results/display_cloud.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Parts of a result that can be shown, in the order of their keys: scan,
 * structure, mesh, solid, plan, openings. */
extern const std::vector<std::string> layer_names;

/** @brief A result to display. Parts that are missing are absent from the maps. */
struct ViewedResult {
  std::string name;                           ///< of the folder or file
  std::map<std::string, DisplayCloud> clouds; ///< layers "scan" and "structure"
  std::map<std::string, TriangleMesh> meshes; ///< layers "mesh" and "solid"
  Floorplan plan;                             ///< layers "plan" and "openings"
  PlanRules rules;                            ///< of the plan
  std::vector<std::string> notes; ///< missing parts and reasons, a sentence each

  /** @brief Returns whether a layer has something to show. */
  bool has(const std::string& layer) const;

  /** @brief Returns the mesh of a layer, empty if there is none. */
  const TriangleMesh& mesh(const std::string& layer) const;

  /** @brief Returns the box around the model or, without a model, around the clouds;
   * metres. */
  Eigen::AlignedBox3d bounds() const;
};

/** @brief Settings for reading a result. */
struct ReadSettings {
  std::string scan;                 ///< raw scan; empty: from report.json
  std::size_t max_points = 1000000; ///< maximum to show per cloud; 0: all
};

/** @brief Reads a result folder of pcl_sedr, or one file: a floor plan, a mesh, a
 * solid, or a cloud. A cloud with labels or rooms, as from a stage, is structure;
 * others are scans. Throws ToolError if the main file cannot be read; missing parts
 * become notes. */
ViewedResult readResult(const std::string& path, const ReadSettings& settings);

/** @brief What is shown, set by keys and options. */
struct ViewState {
  std::set<std::string> layers;
  std::string colour = "label"; ///< or "room", "distance" from the mesh, "height"
  std::string view = "iso";     ///< or "top"
  bool ceilings = false;
  double clip_height = std::numeric_limits<double>::infinity(); ///< metres
  bool legend = true;
  std::uint32_t storey = 0; ///< number of the only visible storey; 0: all
  std::uint32_t room = 0;   ///< number of the only visible room; 0: all
  double range = 0.05;      ///< distance of the last colour, metres
};

/** @brief A line of the legend, optionally with a colour that it explains. */
struct LegendLine {
  std::string text; ///< ASCII
  std::optional<Colour> colour{};
};

/** @brief Makes the shapes that a state shows of a result. Clipping is left to the
 * mapper. Distances are measured once, on first use. */
class Shapes {
public:
  /** @param result must outlive this object */
  explicit Shapes(const ViewedResult& result);

  /** @brief Returns a layer as vertices, triangles or lines with colours as point
   * scalars: without ceilings, other storeys and other rooms unless the state shows
   * them. The plan has its elements at floor and ceiling, and lines at corners;
   * openings are outlines with the feet of their leaves. */
  vtkSmartPointer<vtkPolyData> of(const std::string& layer,
                                  const ViewState& state) const;

  /** @brief Returns the edges of the solid's faces: where it bends by more than 15
   * degrees, and the borders of what is shown. */
  vtkSmartPointer<vtkPolyData> solidEdges(const ViewState& state) const;

  /** @brief Returns the layers, the meanings of colours, and rooms with their areas,
   * from top to bottom. */
  std::vector<LegendLine> legend(const ViewState& state) const;

private:
  /** @brief Returns whether a part with these properties is shown. */
  bool shows(StructureLabel label,
             std::uint32_t room,
             const Eigen::Vector3d& place,
             const ViewState& state) const;
  bool shows(const PlanOpening& opening, const ViewState& state) const;

  /** @brief Returns the distances of a cloud's points from the mesh, metres; for points
   * more than a metre outside its box, from the box. Empty without a mesh. */
  const std::vector<double>& distances(const std::string& layer) const;

  void addDistances(const ViewState& state, std::vector<LegendLine>& lines) const;

  const ViewedResult& result_;
  Eigen::AlignedBox3d bounds_;
  mutable std::map<std::string, std::vector<double>> distances_;
};

} // namespace pcl::sedr::tools
