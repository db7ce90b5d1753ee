// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_loops.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_segmentation/opening_detection.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace pcl::sedr {

/** A rectangle in a wall, by its place along it and its heights; its head may be half
 * an ellipse. */
struct Cut {
  double from;
  double to;
  double bottom;
  double top;
  double rise = 0;

  double headAt(double s) const
  {
    const double x = (2 * s - from - to) / (to - from);
    return top - rise * (1 - std::sqrt(std::max(0.0, 1 - x * x)));
  }

  bool contains(double s, double z) const
  {
    return s > from && s < to && z > bottom && z < headAt(s);
  }
};

/** Two rooms of 5 m x 4 m, 2.5 m high, beside each other in y, with a wall of 12 cm
 * between them: faces at y = 4 and y = 4.12. Points lie on a grid of 1.5 cm with noise
 * along the normals of their surfaces. */
class TwoRooms {
public:
  static constexpr double face = 4;
  static constexpr double back = 4.12;

  explicit TwoRooms(double noise)
      : noise_(0, noise)
  {
    using sedr_test::rectangle;
    plan.rooms = {sedr_test::roomOf(rectangle(0, 0, 5, face), 2.5, 1),
                  sedr_test::roomOf(rectangle(0, back, 5, 8.12), 2.5, 2)};
  }

  /** Scans the wall between the rooms with holes in both faces, and their reveals. */
  void scanMiddleWall(const std::vector<Cut>& cuts, const std::vector<Cut>& hidden = {})
  {
    std::vector<Cut> holes = cuts;
    holes.insert(holes.end(), hidden.begin(), hidden.end());
    scanFace({0, 5, 0, 2.5}, face, holes);
    scanFace({0, 5, 0, 2.5}, back, cuts);
    for (const Cut& cut : cuts)
      reveals(cut, face, back);
  }

  /** Scans the outer wall of the first room, at y = 0, with holes and their reveals. */
  void scanOuterWall(const std::vector<Cut>& cuts, const std::vector<Cut>& hidden = {})
  {
    std::vector<Cut> holes = cuts;
    holes.insert(holes.end(), hidden.begin(), hidden.end());
    scanFace({0, 5, 0, 2.5}, 0, holes);
    for (const Cut& cut : cuts)
      reveals(cut, -0.2, 0);
  }

  /** Draws the plan of the first room to a pane at y behind its outer wall, between two
   * places along it. */
  void drawPlanToPane(double from, double to, double y)
  {
    std::vector<Eigen::Vector2d> corners{{from, y}, {to, y},   {to, 0},
                                         {5, 0},    {5, face}, {0, face}};
    if (from > 0)
      corners.insert(corners.end(), {{0, 0}, {from, 0}});
    plan.rooms[0].boundary = sedr_test::polygon(corners);
  }

  /** Tilts the outer wall with all that was scanned of it, about its foot. */
  void tiltOuterWall(double radians)
  {
    plan.rooms[0].boundary.elements[0].tilt = radians;
    for (pcl::PointXYZ& p : *cloud)
      p.y += p.z * static_cast<float>(std::tan(radians));
  }

  /** Scans a face of a wall parallel to x with holes in it. */
  void scanFace(const Cut& face, double y, const std::vector<Cut>& cuts)
  {
    sheet(face.from, face.to, face.bottom, face.top,
          [&](double s, double z, double off) {
            const auto isIn = [&](const Cut& cut) { return cut.contains(s, z); };
            if (std::none_of(cuts.begin(), cuts.end(), isIn))
              add(s, y + off, z);
          });
  }

  void reveals(const Cut& cut, double y0, double y1)
  {
    sheet(y0, y1, cut.bottom, cut.top - cut.rise, [&](double y, double z, double off) {
      add(cut.from + off, y, z);
      add(cut.to + off, y, z);
    });
    sheet(cut.from, cut.to, y0, y1, [&](double s, double y, double off) {
      add(s, y, cut.headAt(s) + off);
      add(s, y, cut.bottom + off);
    });
  }

  /** Scans a sheet parallel to the walls, one in `every` of its points. */
  void scanSheet(const Cut& at, double y, int every = 1)
  {
    int count = 0;
    sheet(at.from, at.to, at.bottom, at.top, [&](double s, double z, double off) {
      if (++count % every == 0)
        add(s, y + off, z);
    });
  }

  /** Scans the ceiling of the first room. */
  void scanCeiling()
  {
    sheet(0, 5, 0, face, [&](double x, double y, double off) { add(x, y, 2.5 + off); });
  }

  /** Scans the leaf of a door, hinged at x, y and turned by an angle from x. */
  void scanLeaf(double x, double y, double degrees, double width, double height)
  {
    const double a = degrees * M_PI / 180;
    sheet(0, width, 0.01, height, [&](double s, double z, double off) {
      add(x + s * std::cos(a) - off * std::sin(a),
          y + s * std::sin(a) + off * std::cos(a), z);
    });
  }

  template <typename Test>
  void leaveOut(const Test& test)
  {
    auto& points = cloud->points;
    points.erase(std::remove_if(points.begin(), points.end(), test), points.end());
    cloud->width = static_cast<std::uint32_t>(points.size());
    cloud->height = 1;
  }

  Floorplan plan;
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud{new pcl::PointCloud<pcl::PointXYZ>};

private:
  template <typename See>
  void sheet(double s0, double s1, double z0, double z1, const See& see)
  {
    constexpr double step = 0.015;
    for (double s = s0 + step / 2; s < s1; s += step)
      for (double z = z0 + step / 2; z < z1; z += step)
        see(s, z, noise_(random_));
  }

  void add(double x, double y, double z)
  {
    cloud->push_back(pcl::PointXYZ(static_cast<float>(x), static_cast<float>(y),
                                   static_cast<float>(z)));
  }

  std::mt19937 random_{1};
  std::normal_distribution<double> noise_;
};

inline const Cut door{1.5, 2.4, 0, 2.05};
inline const Cut window{1, 2.5, 0.9, 2.1};

inline std::vector<PlanOpening>
openingsOf(const TwoRooms& scene)
{
  pcl::OpeningDetection<pcl::PointXYZ> detection;
  detection.setInputCloud(scene.cloud);
  Floorplan plan = scene.plan;
  EXPECT_TRUE(detection.segment(plan)) << detection.getErrorMessage();
  return plan.openings;
}

/** Returns the only opening of a scene, which must be of a kind. */
inline PlanOpening
openingOf(const TwoRooms& scene, OpeningKind kind)
{
  const auto found = openingsOf(scene);
  EXPECT_EQ(found.size(), 1u);
  const PlanOpening only = found.size() == 1 ? found[0] : PlanOpening();
  EXPECT_EQ(only.kind, kind);
  return only;
}

inline void
expectEdges(const PlanOpening& found, const Cut& cut, double y, double tolerance)
{
  EXPECT_NEAR(std::min(found.start.x(), found.end.x()), cut.from, tolerance);
  EXPECT_NEAR(std::max(found.start.x(), found.end.x()), cut.to, tolerance);
  EXPECT_NEAR(found.bottom, cut.bottom, tolerance);
  EXPECT_NEAR(found.top, cut.top, tolerance);
  EXPECT_NEAR(found.start.y(), y, 0.01);
  EXPECT_NEAR(found.end.y(), y, 0.01);
}

} // namespace pcl::sedr
