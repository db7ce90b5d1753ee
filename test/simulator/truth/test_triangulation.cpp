// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/truth/triangulation.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

namespace pcl::sedr::sim {
namespace {

/** @brief Points and rings that are added together. */
struct Drawing {
  std::vector<Vec2> points;
  std::vector<Ring> rings;

  void add(const std::vector<Vec2>& corners)
  {
    Ring ring;
    for (const Vec2 corner : corners) {
      ring.push_back(points.size());
      points.push_back(corner);
    }
    rings.push_back(ring);
  }
};

double
areaOf(const std::vector<Vec2>& points, const Ring& ring)
{
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    area += cross(points[ring[i]], points[ring[(i + 1) % ring.size()]]) / 2;
  return area;
}

std::vector<Vec2>
clockwiseCircle(Vec2 center, double radius, int count)
{
  std::vector<Vec2> points;
  points.reserve(count);
  for (int i = 0; i < count; ++i)
    points.push_back(center + rotated({radius, 0.0}, -2.0 * pi * i / count));
  return points;
}

/** @brief Expects triangles that cover the polygon, with its rings as border. */
void
expectTriangulated(const Drawing& drawing)
{
  double expected = 0.0;
  for (const Ring& ring : drawing.rings)
    expected += areaOf(drawing.points, ring);

  double area = 0.0;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (const Triangle& t : triangulate(drawing.points, drawing.rings)) {
    const double part = areaOf(drawing.points, {t.begin(), t.end()});
    EXPECT_GT(part, 0.0);
    area += part;
    for (int i = 0; i < 3; ++i)
      ++edges[{t[i], t[(i + 1) % 3]}];
  }
  EXPECT_NEAR(area, expected, 1e-9);
  for (const Ring& ring : drawing.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      EXPECT_EQ((edges[{ring[i], ring[(i + 1) % ring.size()]}]), 1);
}

TEST(Triangulation, coversAConcavePolygon)
{
  Drawing drawing;
  drawing.add({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {4, 3}, {4, 4}, {0, 4}});
  expectTriangulated(drawing);
}

TEST(Triangulation, keepsEveryPointOnAStraightSide)
{
  Drawing drawing;
  drawing.add(
      {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {2, 2}, {0.5, 2}, {0, 2}, {0, 1}});
  expectTriangulated(drawing);
}

TEST(Triangulation, keepsPointsOnAChamferedSide)
{
  Drawing drawing;
  drawing.add(
      {{0, 0}, {7.3, 0}, {7.3, 3.7}, {6.9, 4.1}, {6.7, 4.3}, {6.1, 4.9}, {0, 4.9}});
  expectTriangulated(drawing);
}

TEST(Triangulation, cutsOutHoles)
{
  Drawing drawing;
  drawing.add({{0, 0}, {16, 0}, {16, 11}, {0, 11}});
  for (const double x : {4.0, 8.0, 12.0})
    for (const double y : {3.5, 7.5})
      drawing.add(clockwiseCircle({x, y}, 0.35, 60));
  drawing.add({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
  expectTriangulated(drawing);
}

TEST(Triangulation, coversAnIslandInAHole)
{
  Drawing drawing;
  drawing.add({{0, 0}, {9, 0}, {9, 9}, {0, 9}});
  drawing.add({{1, 1}, {1, 4}, {4, 4}, {4, 1}}); // a hole, and an island in it
  drawing.add({{2, 2}, {3, 2}, {3, 3}, {2, 3}});
  drawing.add(clockwiseCircle({2.5, 2.5}, 0.2, 8));
  expectTriangulated(drawing);
}

TEST(Triangulation, rejectsWhatIsNoPolygon)
{
  Drawing bow;
  bow.add({{0, 0}, {2, 2}, {2, 0}, {0, 2.1}});
  EXPECT_THROW(triangulate(bow.points, bow.rings), std::invalid_argument);
  Drawing lost;
  lost.add({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  lost.add(clockwiseCircle({5.0, 5.0}, 0.5, 8));
  EXPECT_THROW(triangulate(lost.points, lost.rings), std::invalid_argument);
}

} // namespace
} // namespace pcl::sedr::sim
