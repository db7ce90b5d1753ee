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

namespace pcl::sedr::benchmark {

/** @brief Points and their labels. */
struct LabelledPoints {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr points;
  std::vector<std::uint32_t> labels; ///< StructureLabel values, one per point
  pcl::PointCloud<pcl::Normal>::ConstPtr normals = nullptr; ///< of a structure, or null
};

/** @brief Counts of the true, predicted and correct points of a label. */
struct LabelScore {
  std::size_t truth = 0;     ///< points that have the label
  std::size_t predicted = 0; ///< points predicted to have it
  std::size_t right = 0;     ///< points with both

  double recall() const;    ///< share of the true points; NaN without any
  double precision() const; ///< share of the predicted points; NaN without any
};

/** @brief The labels that are scored. Columns count as walls. */
constexpr std::array<StructureLabel, 4> scored_labels{
    StructureLabel::Ceiling, StructureLabel::Floor, StructureLabel::Wall,
    StructureLabel::Detail};

/** @brief A score for each of scored_labels, in their order. */
using LabelScores = std::array<LabelScore, scored_labels.size()>;

/** @brief Returns the label that is scored: wall for columns, other (0) for values
 * above 5. */
std::uint32_t scoredAs(std::uint32_t label);

/** @brief Spacing in metres of the points of a scan that are scored. It equalises the
 * density, which is a hundred times higher near the scanner. */
constexpr double scoring_spacing = 0.02;

/** @brief Returns the first point in each cube of `spacing` metres. Points that are not
 * finite are left out. */
LabelledPoints thinned(const LabelledPoints& cloud, double spacing);

/** @brief Returns the label of the structure's point nearest to each of `points`; 0 if
 * none is within `radius` metres. If the structure has normals, the label is also 0
 * farther than `off_surface` metres from the surface there. */
std::vector<std::uint32_t>
predictedLabels(const LabelledPoints& structure,
                const pcl::PointCloud<pcl::PointXYZ>& points,
                double radius,
                unsigned threads = 0,
                double off_surface = std::numeric_limits<double>::infinity());

/** @brief Compares true and predicted labels, given in the same order. */
LabelScores compareLabels(const std::vector<std::uint32_t>& truth,
                          const std::vector<std::uint32_t>& predicted);

/** @brief Scores the points of the structure against the nearest points of the scan.
 * Those without a point of the scan within `radius` metres do not count, such as points
 * that close a hole. Objects near a surface do not count either. */
LabelScores scoreStructure(const LabelledPoints& structure,
                           const LabelledPoints& scan,
                           double radius,
                           unsigned threads = 0);

/** @brief Number of points of each input label by predicted label: index 0 is other,
 * then scored_labels in their order. */
using LabelTable =
    std::map<std::uint32_t, std::array<std::size_t, scored_labels.size() + 1>>;

/** @brief Counts the points by label and predicted label, given in the same order. */
LabelTable tabulateLabels(const std::vector<std::uint32_t>& labels,
                          const std::vector<std::uint32_t>& predicted);

/** @brief Scores how well a structure predicts the labels of a scan. Each point of the
 * scan gets the label of the nearest point of the structure.
 * @param structure finite points, as from the chain
 * @param scan with true labels; it is thinned to scoring_spacing
 * @param radius maximum distance in metres; the diagonal of a voxel covers all points
 */
LabelScores scoreLabels(const LabelledPoints& structure,
                        const LabelledPoints& scan,
                        double radius,
                        unsigned threads = 0);

} // namespace pcl::sedr::benchmark
