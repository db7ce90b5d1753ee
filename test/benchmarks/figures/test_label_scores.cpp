// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/figures/label_map.h"
#include "benchmark/figures/label_scores.h"
#include "tool_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl::sedr::benchmark;

struct Point {
  float x;
  float y;
  float z;
  std::uint32_t label;
};

LabelledPoints
labelled(const std::vector<Point>& points)
{
  LabelledPoints result;
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const Point& p : points) {
    cloud->emplace_back(p.x, p.y, p.z);
    result.labels.push_back(p.label);
  }
  result.points = cloud;
  return result;
}

constexpr std::size_t ceiling = 0;
constexpr std::size_t floor_ = 1;
constexpr std::size_t wall = 2;
constexpr std::size_t detail = 3;

TEST(LabelScores, counts_what_was_found_and_what_was_right)
{
  const LabelScores scores =
      compareLabels({1, 1, 1, 2, 3, 0, 0}, {1, 1, 0, 3, 3, 3, 0});
  EXPECT_EQ(scores[ceiling].truth, 3u);
  EXPECT_EQ(scores[ceiling].predicted, 2u);
  EXPECT_DOUBLE_EQ(scores[ceiling].recall(), 2.0 / 3);
  EXPECT_DOUBLE_EQ(scores[ceiling].precision(), 1);
  EXPECT_DOUBLE_EQ(scores[floor_].recall(), 0);
  EXPECT_TRUE(std::isnan(scores[floor_].precision())); // never predicted
  EXPECT_DOUBLE_EQ(scores[wall].recall(), 1);
  EXPECT_DOUBLE_EQ(scores[wall].precision(), 1.0 / 3);
  EXPECT_TRUE(std::isnan(scores[detail].recall())); // there is none
}

TEST(LabelScores, a_column_is_a_wall_and_unknown_labels_are_other)
{
  EXPECT_EQ(scoredAs(4), 4u);
  EXPECT_EQ(scoredAs(5), 3u);
  EXPECT_EQ(scoredAs(6), 0u);
  const LabelScores scores = compareLabels({3, 5, 5, 7, 255}, {5, 3, 5, 0, 12});
  EXPECT_EQ(scores[wall].truth, 3u);
  EXPECT_EQ(scores[wall].right, 3u);
  EXPECT_EQ(scores[wall].predicted, 3u);
}

TEST(LabelScores, predict_by_the_nearest_point_within_the_radius)
{
  const LabelledPoints structure = labelled({{0, 0, 0, 2}, {1, 0, 0, 3}});
  const LabelledPoints scan = labelled({{0.05f, 0, 0, 2},     // floor, near floor
                                        {0.94f, 0, 0, 3},     // wall, near wall
                                        {0, 0, 0.05f, 0},     // furniture near floor
                                        {0, 0, 0.09f, 2},     // floor, too far
                                        {1, 0, 0.0861f, 3}}); // just within reach
  const auto predicted = predictedLabels(structure, *scan.points, 0.0866);
  EXPECT_EQ(predicted, (std::vector<std::uint32_t>{2, 3, 2, 0, 3}));
  const LabelScores scores = scoreLabels(structure, scan, 0.0866);
  EXPECT_DOUBLE_EQ(scores[floor_].recall(), 0.5);
  EXPECT_DOUBLE_EQ(scores[floor_].precision(), 0.5);
  EXPECT_DOUBLE_EQ(scores[wall].recall(), 1);
}

TEST(LabelScores, what_is_off_the_surface_is_other)
{
  LabelledPoints structure = labelled({{0, 0, 0, 2}});
  const pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  normals->push_back(pcl::Normal(0, 0, 1));
  structure.normals = normals;
  const LabelledPoints scan = labelled({{0.05f, 0, 0.009f, 2},    // beside, on it
                                        {0.05f, 0, 0.011f, 2},    // above
                                        {0.05f, 0, -0.011f, 2}}); // below
  EXPECT_EQ(predictedLabels(structure, *scan.points, 0.0866, 0, 0.01),
            (std::vector<std::uint32_t>{2, 0, 0}));
}

TEST(LabelScores, without_a_structure_everything_is_other)
{
  const LabelScores scores =
      scoreLabels(labelled({}), labelled({{0, 0, 0, 1}, {1, 0, 0, 2}}), 0.1);
  EXPECT_DOUBLE_EQ(scores[ceiling].recall(), 0);
  EXPECT_TRUE(std::isnan(scores[ceiling].precision()));
}

TEST(LabelScores, dense_places_count_as_much_as_sparse_ones)
{
  std::vector<Point> points{{1.01f, 0.01f, 0.01f, 1}};
  for (int i = 0; i < 100; ++i) // a hundred points in a cube of 2 cm
    points.push_back({0.001f + 0.0001f * static_cast<float>(i), 0.001f, 0.001f, 2});
  const LabelledPoints thin = thinned(labelled(points), 0.02);
  ASSERT_EQ(thin.points->size(), 2u);
  EXPECT_EQ(thin.labels, (std::vector<std::uint32_t>{2, 1}));
  EXPECT_FLOAT_EQ((*thin.points)[0].x, 0.001f); // the first of them, unchanged
}

TEST(LabelScores, thinning_keeps_each_point_with_its_label)
{
  const LabelledPoints thin = thinned(labelled({{0, 0, 1, 7}, {0, 0, 0, 3}}), 0.02);
  ASSERT_EQ(thin.points->size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(thin.labels[i], (*thin.points)[i].z > 0.5f ? 7u : 3u);
}

TEST(LabelScores, points_that_are_not_finite_are_left_out)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const LabelScores scores = scoreLabels(labelled({{0, 0, 0, 1}}),
                                         labelled({{nan, 0, 0, 1}, {0, 0, 0, 1}}), 0.1);
  EXPECT_EQ(scores[ceiling].truth, 1u);
}

TEST(LabelScores, of_the_structure_count_only_where_it_was_scanned)
{
  const LabelledPoints structure = labelled({{0, 0, 0, 2},   // on the floor
                                             {1, 0, 0, 2},   // below a table's leg
                                             {2, 0, 0, 2}}); // not scanned
  const LabelledPoints scan =
      labelled({{0, 0, 0.01f, 2}, {1, 0, 0.02f, 0}, {0, 0, 0.06f, 0}});
  const LabelScores scores = scoreStructure(structure, scan, 0.0866);
  EXPECT_EQ(scores[floor_].predicted, 2u);
  EXPECT_EQ(scores[floor_].right, 1u);
}

TEST(LabelScores, a_table_tells_what_each_label_was_taken_for)
{
  const LabelTable table = tabulateLabels({12, 12, 6, 6}, {0, 5, 3, 4});
  EXPECT_EQ(table.at(12), (LabelTable::mapped_type{1, 0, 0, 1, 0}));
  EXPECT_EQ(table.at(6), (LabelTable::mapped_type{0, 0, 0, 1, 1}));
}

TEST(LabelMap, gives_labels_their_meaning_all_at_once)
{
  const LabelMap map = labelMapOf("0=1,1=2,2=3,12=0", "map");
  EXPECT_EQ(mapped({0, 1, 2, 12, 5, 9}, map),
            (std::vector<std::uint32_t>{1, 2, 3, 0, 5, 9}));
  EXPECT_EQ(mapped({0, 7}, labelMapOf("", "map")), (std::vector<std::uint32_t>{0, 7}));
}

TEST(LabelMap, refuses_what_is_no_map)
{
  for (const char* text : {"7", "7=", "=3", "7=6", "7=3,", "7=-1", "a=1", "1=2,1=3",
                           "4294967296=1", "7:3"})
    EXPECT_THROW(labelMapOf(text, "map"), pcl::sedr::tools::ToolError) << text;
}

} // namespace
