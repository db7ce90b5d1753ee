// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "constrained_triangulation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A triangulation whose inner sides can be swapped for the other diagonal of
 * the two triangles beside them. */
class SwappableTriangulation {
public:
  static constexpr std::uint32_t none = PlanTriangulation::none;

  /** @param triangles counter-clockwise, a triangulation of the points' hull */
  SwappableTriangulation(const std::vector<GridPoint>& points,
                         std::vector<std::array<std::uint32_t, 3>> triangles);

  /** @brief Swaps sides until one joins a and b, which then stays.
   * @return false if a point, or a side that has to stay, is in the way */
  bool insertEdge(std::uint32_t a, std::uint32_t b);

  /** @brief Swaps the sides that need not stay until all are Delaunay's. */
  void improve();

  const PlanTriangulation& triangulation() const { return mesh_; }

private:
  /** @brief Side `number` of a triangle: from that corner to the next. */
  struct Side {
    std::uint32_t triangle = none;
    std::size_t number = 0;
  };
  using Ends = std::pair<std::uint32_t, std::uint32_t>; ///< the lesser first

  void connect();

  std::uint32_t corner(std::uint32_t t, std::size_t i) const
  {
    return mesh_.triangles[t][i % 3];
  }

  std::uint32_t neighbour(const Side& side) const
  {
    return mesh_.neighbours[side.triangle][side.number % 3];
  }

  /** @brief The corner across a side that is not of the hull, and that side's number
   * there. */
  Side across(const Side& side) const;

  /** @brief Number of the corner of t that is point p. */
  std::size_t numberOf(std::uint32_t t, std::uint32_t p) const;

  /** @brief Calls `visit(triangle, number of the corner)` for the triangles at a point
   * until it returns true. */
  template <typename Visit>
  void visitAround(std::uint32_t point, Visit visit) const;

  /** @brief The side that joins two points; its triangle is none where there is none.
   */
  Side find(const Ends& ends) const;

  /** @brief The sides that cross the way from a to b, in order.
   * @return false if a point is on the way */
  bool crossedBy(std::uint32_t a, std::uint32_t b, std::vector<Ends>& crossed) const;

  bool crosses(const Ends& side, std::uint32_t a, std::uint32_t b) const;

  bool isConvex(const Side& side) const;

  /** @brief Whether the corner across a side is within the circle of its triangle. */
  bool isWorse(const Side& side) const;

  /** @brief Swaps a side for the other diagonal, whose ends it returns. */
  Ends swap(const Side& side);

  void relink(std::uint32_t triangle, std::uint32_t from, std::uint32_t to);

  const std::vector<GridPoint>& points_;
  PlanTriangulation mesh_;
  std::vector<std::uint32_t> anchor_; ///< a triangle at each point
  std::vector<std::uint32_t> degree_; ///< triangles at each point
  std::set<Ends> fixed_;
};

} // namespace sedr
} // namespace pcl
