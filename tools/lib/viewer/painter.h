// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"
#include "results/storey_rule.h"
#include "viewed_result.h"

#include <pcl/sedr_surface/mesh_distance.h>

#include <Eigen/Core>

#include <map>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Points or corners of triangles, three a triangle, each with its colour. */
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

/** @brief What of a result is shown in a state, and in which colours; knows nothing of
 * windows. What is costly is worked out once, when it is first asked for. */
class Painter {
public:
  /** @param result must stay where it is
   * @param range distance that has the last colour, metres */
  explicit Painter(const ViewedResult& result, double range = 0.05);

  /** @brief The points of a cloud that the state leaves: all, or those of one storey,
   * or those below the ceilings. Clipping is not done here. */
  ColouredPoints points(Layer layer, const ViewState& state) const;

  /** @brief The triangles of a mesh likewise. */
  ColouredPoints triangles(Layer layer, const ViewState& state) const;

  /** @brief The elements of the plan at floor and ceiling and their corners between;
   * without the ceilings those at the floor only. */
  ColouredLines planLines(const ViewState& state) const;

  /** @brief The edges of the solid's faces. */
  ColouredLines solidEdges(const ViewState& state) const;

  /** @brief Distance of a cloud's points from the mesh, metres; of those more than a
   * metre outside of its box that from the box. Empty without a mesh. */
  const std::vector<double>& distances(Layer layer) const;

  double range() const { return range_; }

  const StoreyRule& storeys() const { return storeys_; }

private:
  const std::vector<bool>& ceilingOf(Layer layer) const;

  /** @brief Whether a state shows a triangle of a mesh. */
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

/** @brief The colour of a room: grey for none. */
Colour roomColour(std::uint32_t room);

} // namespace tools
} // namespace sedr
} // namespace pcl
