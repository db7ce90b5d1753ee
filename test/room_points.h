// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_loops.h"
#include <pcl/point_types.h>

#include "sedr_filters/src/plan/plan_surfaces.h"
#include <pcl/sedr_filters/point_view.h>

#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>
#include <random>

namespace sedr_test {

/** The indices of the points of a room's parts. */
struct RoomParts {
  std::vector<int> floor;   ///< platforms included
  std::vector<int> ceiling; ///< the main one
  std::vector<int> details; ///< undersides, risers and niches
  std::vector<int> walls;   ///< and faces of columns
};

/** Generates points on floors, ceilings and walls in closed form: one in the middle of
 * each square of a grid, with Gaussian noise of a fixed seed along the normal. */
class RoomPoints {
public:
  using InPlan = std::function<bool(double x, double y)>;
  using OnWall = std::function<bool(double s, double z)>;
  using InSpace = std::function<bool(const Eigen::Vector3d&)>;

  explicit RoomPoints(double spacing = 0.05, double noise = 0, unsigned seed = 1)
      : spacing_(spacing)
      , noise_(noise)
      , random_(seed)
  {}

  /** Adds points of a plane above the inside of a loop, where `keep` returns true. */
  std::vector<int> slab(
      const pcl::sedr::PlanLoop& loop,
      const pcl::sedr::PlanSlab& plane,
      const InPlan& keep = [](double, double) { return true; })
  {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
    Eigen::Vector2d high = -low;
    for (const auto& corner : loop.polygon(0.001)) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    const std::size_t first = points_.size();
    for (double y = low.y() + spacing_ / 2; y < high.y(); y += spacing_)
      for (double x = low.x() + spacing_ / 2; x < high.x(); x += spacing_)
        if (loop.contains({x, y}) && keep(x, y))
          add({x, y, plane.heightAt({x, y})}, plane.plane.head<3>());
    return from(first);
  }

  /** Adds points of a horizontal plane. */
  std::vector<int> slab(
      const pcl::sedr::PlanLoop& loop,
      double height,
      const InPlan& keep = [](double, double) { return true; })
  {
    return slab(loop, slabAt(height), keep);
  }

  /** Adds points of a vertical face above an element, where `keep` returns true. */
  std::vector<int> wall(
      const pcl::sedr::PlanElement& element,
      double low,
      double high,
      const OnWall& keep = [](double, double) { return true; })
  {
    const std::size_t first = points_.size();
    const double columns = parts(element.length());
    for (double c = 0.5; c < columns; ++c)
      column(element, element.length() * c / columns, low, high, keep);
    return from(first);
  }

  /** Adds a room's surfaces; `keep` selects points of walls, columns and risers,
   * `keep_ceiling` and `keep_floor` places of them. */
  RoomParts room(
      const pcl::sedr::PlanRoom& room,
      const InSpace& keep = [](const Eigen::Vector3d&) { return true; },
      const InPlan& keep_ceiling = [](double, double) { return true; },
      const InPlan& keep_floor = [](double, double) { return true; })
  {
    const auto isBelow = [&](int detail) {
      return [&, detail](double x, double y) {
        return room.contains({x, y}) && room.detailAt({x, y}) == detail &&
               keep_ceiling(x, y);
      };
    };
    RoomParts parts;
    const auto isAbove = [&](int detail) {
      return [&, detail](double x, double y) {
        return room.contains({x, y}) && room.floorDetailAt({x, y}) == detail &&
               keep_floor(x, y);
      };
    };
    parts.floor = slab(room.boundary, room.floor, isAbove(-1));
    for (std::size_t d = 0; d < room.floor_details.size(); ++d)
      for (const int i : slab(room.floor_details[d].boundary,
                              room.floor_details[d].slab, isAbove(static_cast<int>(d))))
        parts.floor.push_back(i);
    parts.ceiling = slab(room.boundary, room.ceiling, isBelow(-1));
    const std::size_t details = points_.size();
    for (std::size_t d = 0; d < room.details.size(); ++d)
      slab(room.details[d].boundary, room.details[d].slab,
           isBelow(static_cast<int>(d)));
    for (const auto& niche : room.niches)
      for (const auto* level : {&niche.bottom, &niche.top})
        slab(niche.boundary, *level);
    const auto verticals = pcl::sedr::verticalSurfaces(room);
    const auto addVerticals = [&](bool are_risers) {
      for (const auto& surface : verticals)
        if ((surface.label == pcl::sedr::StructureLabel::Detail) == are_risers)
          vertical(surface, keep);
    };
    addVerticals(true);
    parts.details = from(details);
    const std::size_t walls = points_.size();
    addVerticals(false);
    parts.walls = from(walls);
    return parts;
  }

  /** Adds all surfaces of a room without details. */
  RoomParts room(const pcl::sedr::PlanLoop& boundary, double floor, double ceiling)
  {
    pcl::sedr::PlanRoom plan = roomOf(boundary, ceiling);
    plan.floor = slabAt(floor);
    return room(plan);
  }

  /** Adds a single point without noise. */
  int point(double x, double y, double z)
  {
    points_.emplace_back(static_cast<float>(x), static_cast<float>(y),
                         static_cast<float>(z));
    return static_cast<int>(points_.size()) - 1;
  }

  std::size_t size() const { return points_.size(); }

  const Eigen::Vector3f& operator[](int i) const
  {
    return points_[static_cast<std::size_t>(i)];
  }

  std::vector<int> all() const { return from(0); }

  pcl::sedr::PointView view() const
  {
    return points_.empty()
               ? pcl::sedr::PointView()
               : pcl::sedr::PointView(points_[0].data(), sizeof(Eigen::Vector3f),
                                      points_.size());
  }

  template <typename PointT = pcl::PointXYZ>
  typename pcl::PointCloud<PointT>::Ptr cloud() const
  {
    auto result = std::make_shared<pcl::PointCloud<PointT>>();
    for (const auto& p : points_) {
      PointT point;
      point.getVector3fMap() = p;
      result->push_back(point);
    }
    return result;
  }

private:
  std::vector<int> from(std::size_t first) const
  {
    std::vector<int> indices(points_.size() - first);
    std::iota(indices.begin(), indices.end(), static_cast<int>(first));
    return indices;
  }

  /** Returns the number of equal parts whose length is closest to the spacing. */
  double parts(double length) const
  {
    return std::max(1.0, std::round(length / spacing_));
  }

  void column(const pcl::sedr::PlanElement& element,
              double s,
              double low,
              double high,
              const OnWall& keep)
  {
    const double rows = parts(high - low);
    const Eigen::Vector2d n = element.normalAt(s);
    for (double r = 0.5; r < rows; ++r) {
      Eigen::Vector3d p;
      p << element.pointAt(s), low + (high - low) * r / rows;
      if (keep(s, p.z()))
        add(p, {n.x(), n.y(), 0});
    }
  }

  void vertical(const pcl::sedr::VerticalSurface& surface, const InSpace& keep)
  {
    const pcl::sedr::PlanElement& element = *surface.element;
    const double columns = parts(element.length());
    for (double c = 0.5; c < columns; ++c) {
      const double s = element.length() * c / columns;
      const pcl::sedr::VerticalSpan span = surface.spanAt(s);
      const Eigen::Vector2d place = element.pointAt(s);
      if (span.high > span.low)
        column(element, s, span.low, span.high, [&](double, double z) {
          return keep({place.x(), place.y(), z});
        });
    }
  }

  void add(const Eigen::Vector3d& p, const Eigen::Vector3d& normal)
  {
    std::normal_distribution<double> off(0, 1);
    points_.push_back(
        (p + (noise_ > 0 ? noise_ * off(random_) : 0) * normal).cast<float>());
  }

  double spacing_;
  double noise_;
  std::mt19937 random_;
  std::vector<Eigen::Vector3f> points_;
};

/** Returns both lists as one. */
inline std::vector<int>
joined(std::vector<int> a, const std::vector<int>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/** Returns the indices in the form that PCL's setters take. */
inline std::shared_ptr<pcl::Indices>
shared(const std::vector<int>& indices)
{
  return std::make_shared<pcl::Indices>(indices.begin(), indices.end());
}

} // namespace sedr_test
