// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief Points and the label of each. */
struct LabelledPoints {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr points;
  std::vector<std::uint32_t> labels; ///< StructureLabel values, one a point
  pcl::PointCloud<pcl::Normal>::ConstPtr normals = nullptr; ///< of a structure
};

/** @brief How often a label was found, and how often rightly. */
struct LabelScore {
  std::size_t truth = 0;     ///< points that have the label
  std::size_t predicted = 0; ///< points that were given it
  std::size_t right = 0;     ///< points of both kinds

  double recall() const;    ///< right of truth; NaN without any
  double precision() const; ///< right of predicted; NaN without any
};

/** @brief The labels that are scored. A column counts as wall. */
constexpr std::array<StructureLabel, 4> scored_labels{
    StructureLabel::Ceiling, StructureLabel::Floor, StructureLabel::Wall,
    StructureLabel::Detail};

/** @brief A score for each of scored_labels, in their order. */
using LabelScores = std::array<LabelScore, scored_labels.size()>;

/** @brief The label as it is scored: columns are walls, values above 5 are other (0).
 */
std::uint32_t scoredAs(std::uint32_t label);

/** @brief Distance between the points of a scan that are scored, metres: so that what
 * lies near the scanner does not count a hundredfold. */
constexpr double scoring_spacing = 0.02;

/** @brief At most one point in each cube of `spacing` metres, the first of it; points
 * that are not finite are left out. */
LabelledPoints thinned(const LabelledPoints& cloud, double spacing);

/** @brief The label of the structure's point nearest to each of `points`, 0 where none
 * is as near as `radius` metres, or where the surface there, if the structure has
 * normals, is farther than `off_surface` metres. */
std::vector<std::uint32_t>
predictedLabels(const LabelledPoints& structure,
                const pcl::PointCloud<pcl::PointXYZ>& points,
                double radius,
                unsigned threads = 0,
                double off_surface = std::numeric_limits<double>::infinity());

/** @brief Compares true and predicted labels, as many of either. */
LabelScores compareLabels(const std::vector<std::uint32_t>& truth,
                          const std::vector<std::uint32_t>& predicted);

/** @brief The same the other way round: the points of the structure that have a point
 * of the scan within `radius` are compared with the nearest of them. What was closed
 * where nothing was scanned does not count, nor does what stands near a surface. */
LabelScores scoreStructure(const LabelledPoints& structure,
                           const LabelledPoints& scan,
                           double radius,
                           unsigned threads = 0);

/** @brief How many points of each label, whatever its values mean, were predicted to be
 * what: index 0 other, then scored_labels in their order. */
using LabelTable =
    std::map<std::uint32_t, std::array<std::size_t, scored_labels.size() + 1>>;

/** @brief Counts labels and what they were taken for, as many of either. */
LabelTable tabulateLabels(const std::vector<std::uint32_t>& labels,
                          const std::vector<std::uint32_t>& predicted);

/** @brief How well a structure tells the labels of a scan: each of its points is
 * predicted to be what the nearest point of the structure is.
 * @param structure finite points, as the chain leaves them
 * @param scan with true labels; it is thinned to scoring_spacing
 * @param radius metres within which a point of the structure must lie; the diagonal of
 * a voxel leaves none out */
LabelScores scoreLabels(const LabelledPoints& structure,
                        const LabelledPoints& scan,
                        double radius,
                        unsigned threads = 0);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
