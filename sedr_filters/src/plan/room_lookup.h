// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../grids/place_table.h"
#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A loop prepared for many containment queries: a query only looks at the
 * elements near its y coordinate. */
class LoopLookup {
public:
  /** @param loop must not move while this object exists */
  explicit LoopLookup(const PlanLoop& loop);

  /** @brief Checks as PlanLoop::contains(). */
  bool contains(const Eigen::Vector2d& p) const;

private:
  const PlanLoop* loop_;
  double low_ = 0;
  double high_ = -1;
  double band_ = 1; ///< metres
  std::vector<std::vector<std::uint32_t>> bands_;
};

/** @brief A room prepared for many queries of what is at a place in plan. Results are
 * those of PlanRoom, in a time independent of the size of the room. */
class RoomLookup {
public:
  /** @param room must not move or change while this object exists */
  explicit RoomLookup(const PlanRoom& room);

  const PlanRoom& room() const { return *room_; }

  bool contains(const Eigen::Vector2d& p) const;

  /** @brief Checks whether a point lies between the walls at its height, and outside
   * every column. */
  bool holds(const Eigen::Vector3d& p) const;

  /** @brief Returns whether any wall is tilted. */
  bool isTilted() const { return is_tilted_; }

  bool isWithinBoundary(const Eigen::Vector2d& p) const
  {
    return boundary_.contains(p);
  }

  int detailAt(const Eigen::Vector2d& p) const;
  int floorDetailAt(const Eigen::Vector2d& p) const;
  int nicheAt(const Eigen::Vector2d& p) const;

  double floorAt(const Eigen::Vector2d& p) const
  {
    return room_->floorSlab(floorDetailAt(p)).heightAt(p);
  }

  double ceilingAt(const Eigen::Vector2d& p) const
  {
    return room_->ceilingSlab(detailAt(p)).heightAt(p);
  }

private:
  static constexpr double table_cell = 0.5; ///< of the tables, metres

  bool isInColumn(const Eigen::Vector2d& p) const;

  const PlanRoom* room_;
  bool is_tilted_;
  LoopLookup boundary_;
  PlaceTable columns_{table_cell};
  PlaceTable details_{table_cell};
  PlaceTable floor_details_{table_cell};
  PlaceTable niches_{table_cell};
};

} // namespace pcl::sedr
