// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solid/plan_subdivision.h"
#include "ceiling_lines.h"
#include "ceiling_meeting.h"

#include "sedr_filters/src/grids/disjoint_sets.h"
#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <map>
#include <vector>

namespace pcl::sedr {

/** @brief Smallest part of a ceiling that is drawn, square millimetres of paper. */
constexpr double min_part_area = 25;

/** @brief The borders of a ceiling's facets that a drawing shows, see ceilingLines().
 */
class CeilingBorders {
public:
  static constexpr std::size_t ceiling_slab = 1; ///< its details follow

  /** @brief An edge of the subdivision as a border of two facets. */
  struct Border {
    bool is_drawn = false; ///< so far; never for what is no border of facets
    bool is_of_facets = false;
    bool is_step = false; ///< so is most of the line that it is drawn as
    Meeting meeting;
    double length = 0;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    Eigen::Vector2d normal = Eigen::Vector2d::Zero(); ///< to the left
  };

  CeilingBorders(const PlanRoom& room, double finest);

  const Border& border(std::size_t e) const { return edges_[e]; }
  const PlanSlab& slabOn(std::size_t e, bool is_left) const
  {
    return slab(is_left ? plan_.edges[e].left.ceiling : plan_.edges[e].right.ceiling);
  }

  /** @brief Returns the lines that are drawn, as edges one after the other: from end to
   * end, or closed. They end where others do, and where an arc begins. */
  std::vector<std::vector<std::size_t>> lines() const;

  /** @brief Returns the vertices along a line, each where the surfaces around it meet.
   */
  std::vector<Eigen::Vector2d> placesOf(const std::vector<std::size_t>& line) const;

  /** @brief Returns the arc that an edge is a chord of, or null. */
  const PlanElement* arcAt(std::size_t e) const;

  /** @brief Returns the share of a line's length at which something holds. */
  template <typename Holds>
  double share(const std::vector<std::size_t>& line, Holds holds) const
  {
    double part = 0;
    double length = 0;
    for (const std::size_t e : line) {
      length += edges_[e].length;
      part += holds(edges_[e].meeting) ? edges_[e].length : 0;
    }
    return length > 0 ? part / length : 0;
  }

  /** @brief As of CeilingLines. */
  std::vector<std::size_t> parts() const;
  const std::vector<int>& shown() const { return shown_; }
  CeilingLines::Borders borders() const;

  /** @brief Returns what an edge asks of the places of its line. */
  Limit limitOf(std::size_t e) const;

private:
  /** @brief A part between lines, and what it has in common with others. */
  struct Part {
    double area = 0;
    double perimeter = 0;
    std::map<std::size_t, double> beside;
  };

  const PlanSlab& slab(int k) const
  {
    return layers_.slabs[static_cast<std::size_t>(k)].slab;
  }
  int shownOn(std::size_t e, bool is_left) const
  {
    const SubdivisionEdge& edge = plan_.edges[e];
    const int k = is_left ? edge.left.ceiling : edge.right.ceiling;
    return shown_[static_cast<std::size_t>(k) - ceiling_slab];
  }
  double roughnessAt(const SubdivisionEdge& edge) const;
  bool isFacet(const PlanRegion& region) const;
  Border borderOf(const SubdivisionEdge& edge) const;
  std::size_t partOf(std::size_t e, bool is_left) const;
  std::map<std::size_t, Part> partsBetween() const;

  /** @brief Joins parts that are too small to the neighbours with the longest border in
   * common, the smallest first. */
  void joinSmallParts();
  void join(std::size_t small, std::size_t neighbour);

  /** @brief Decides border by border, not edge by edge, what is seen. */
  void joinWhereUnseen();

  /** @brief Takes away lines that end within a part soon after they began. */
  bool dropShortEnds();

  /** @brief Looks at the lines that are left from where the parts are that a drawing
   * shows: a strip between two vaults is a valley. */
  void lookFromAfar();
  void findSteps();

  /** @brief Moves each vertex once, so that the lines around it end at one place. */
  void moveVertices();

  /** @brief Returns how many lines end at each vertex; far more than two where a wall,
   * a column or the edge of a detail passes. */
  std::vector<int> endsAt() const;

  /** @brief As lines(), but they end where `kind` of the edges changes. */
  template <typename Kind>
  std::vector<std::vector<std::size_t>> linesOf(Kind kind) const;

  const PlanRoom& room_;
  double finest_;
  RoomLayers layers_;
  std::vector<int> shown_; ///< as of CeilingLines
  PlanSubdivision plan_;
  std::vector<Border> edges_;               ///< as in the subdivision
  std::vector<Eigen::Vector2d> places_;     ///< of its vertices
  mutable DisjointSets<std::size_t> parts_; ///< of slabs; finding shortens its paths
};

} // namespace pcl::sedr
