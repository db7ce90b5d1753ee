// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "constrained_triangulation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A triangulation whose inner sides can be swapped for the other diagonal of
 * their two triangles. */
class SwappableTriangulation {
public:
  static constexpr std::uint32_t none = PlanTriangulation::none;

  /** @param triangles counter-clockwise, covering the points' convex hull */
  SwappableTriangulation(const std::vector<GridPoint>& points,
                         std::vector<std::array<std::uint32_t, 3>> triangles);

  /** @brief Swaps sides until one joins a and b, and fixes that side.
   * @return false if a point or a fixed side is in the way */
  bool insertEdge(std::uint32_t a, std::uint32_t b);

  /** @brief Swaps sides that are not fixed until all are Delaunay. */
  void improve();

  const PlanTriangulation& triangulation() const { return mesh_; }

private:
  /** @brief Side `number` of a triangle: from that corner to the next. */
  struct Side {
    std::uint32_t triangle = none;
    std::size_t number = 0;
  };
  using Ends = std::pair<std::uint32_t, std::uint32_t>; ///< lower index first

  void connect();

  std::uint32_t corner(std::uint32_t t, std::size_t i) const
  {
    return mesh_.triangles[t][i % 3];
  }

  std::uint32_t neighbour(const Side& side) const
  {
    return mesh_.neighbours[side.triangle][side.number % 3];
  }

  /** @brief Returns the same side seen from the triangle across it, starting at the
   * other end; the side must be inner. */
  Side across(const Side& side) const;

  /** @brief Returns which corner of t is point p. */
  std::size_t numberOf(std::uint32_t t, std::uint32_t p) const;

  /** @brief Calls `visit(triangle, corner number)` for the triangles at a point until
   * it returns true. */
  template <typename Visit>
  void visitAround(std::uint32_t point, Visit visit) const;

  /** @brief Returns the side that joins two points; its triangle is none if there is
   * none. */
  Side find(const Ends& ends) const;

  /** @brief Finds the sides that the segment from a to b crosses, in order.
   * @return false if a point lies on the segment */
  bool crossedBy(std::uint32_t a, std::uint32_t b, std::vector<Ends>& crossed) const;

  bool crosses(const Ends& side, std::uint32_t a, std::uint32_t b) const;

  bool isConvex(const Side& side) const;

  /** @brief Returns whether the opposite corner lies within the triangle's
   * circumcircle. */
  bool isWorse(const Side& side) const;

  /** @brief Swaps a side for the other diagonal and returns the ends of that. */
  Ends swap(const Side& side);

  void relink(std::uint32_t triangle, std::uint32_t from, std::uint32_t to);

  const std::vector<GridPoint>& points_;
  PlanTriangulation mesh_;
  std::vector<std::uint32_t> anchor_; ///< a triangle at each point
  std::vector<std::uint32_t> degree_; ///< triangles at each point
  std::set<Ends> fixed_;
};

} // namespace pcl::sedr
