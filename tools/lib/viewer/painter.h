// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"
#include "results/storey_rule.h"
#include "viewed_result.h"

#include <pcl/sedr_surface/mesh_distance.h>

#include <Eigen/Core>

#include <map>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Coloured points, or triangle corners in groups of three. */
struct ColouredPoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<Colour> colours;

  void add(const Eigen::Vector3f& point, Colour colour)
  {
    points.push_back(point);
    colours.push_back(colour);
  }
};

/** @brief Straight lines, two points each. */
using ColouredLines = ColouredPoints;

/** @brief Computes what a state shows of a result, and in which colours, independent of
 * windows. Costly parts are computed once, on first use. */
class Painter {
public:
  /** @param result must outlive this object
   * @param range distance with the last colour, metres */
  explicit Painter(const ViewedResult& result, double range = 0.05);

  /** @brief Returns the visible points of a cloud: all, those of one storey, or those
   * below the ceilings. Clipping is not applied. */
  ColouredPoints points(Layer layer, const ViewState& state) const;

  /** @brief As above for the triangles of a mesh. */
  ColouredPoints triangles(Layer layer, const ViewState& state) const;

  /** @brief Returns the plan's elements at floor and ceiling, and vertical lines at
   * corners; without ceilings, only those at the floor. */
  ColouredLines planLines(const ViewState& state) const;

  /** @brief Returns the edges of the solid's faces. */
  ColouredLines solidEdges(const ViewState& state) const;

  /** @brief Returns the distance of a cloud's points from the mesh, metres; for points
   * more than a metre outside its box, from the box. Empty without a mesh. */
  const std::vector<double>& distances(Layer layer) const;

  double range() const { return range_; }

  const StoreyRule& storeys() const { return storeys_; }

private:
  const std::vector<bool>& ceilingOf(Layer layer) const;

  /** @brief Returns whether a state shows a triangle of a mesh. */
  bool shows(Layer layer, std::size_t triangle, const ViewState& state) const;

  Colour colourOfPoint(Layer layer, std::size_t i, const ViewState& state) const;

  const ViewedResult& result_;
  double range_;
  CeilingRule rule_;
  StoreyRule storeys_;
  HeightRange heights_; ///< of the model
  mutable std::map<Layer, std::vector<bool>> ceilings_;
  mutable std::map<Layer, std::vector<double>> distances_;
};

/** @brief Returns the colour of a room; grey for none. */
Colour roomColour(std::uint32_t room);

} // namespace pcl::sedr::tools
