// SPDX-License-Identifier: BSD-3-Clause
#include "label_scores.h"

#include "nearest_points.h"

#include "sedr_filters/src/voxels/voxel_sums.h"
#include "sedr_filters/src/voxels/voxel_visit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr::benchmark {

namespace {

double
shareOf(std::size_t part, std::size_t whole)
{
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

double
LabelScore::recall() const
{
  return shareOf(right, truth);
}

double
LabelScore::precision() const
{
  return shareOf(right, predicted);
}

std::uint32_t
scoredAs(std::uint32_t label)
{
  constexpr auto column = static_cast<std::uint32_t>(StructureLabel::Column);
  if (label == column)
    return static_cast<std::uint32_t>(StructureLabel::Wall);
  return label < column ? label : 0;
}

LabelledPoints
thinned(const LabelledPoints& cloud, double spacing)
{
  const PointView all(*cloud.points);
  VoxelSums sums(Eigen::Array3f::Constant(static_cast<float>(1 / spacing)));
  sums.add(all);
  const VoxelIndex index(sums.frame(), sums.take());
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> first(index.voxels().size(), none);
  visitVoxels(index, all, nullptr, 0, [&](std::size_t voxel, std::size_t i) {
    first[voxel] = std::min(first[voxel], i);
  });
  LabelledPoints result;
  pcl::PointCloud<pcl::PointXYZ>::Ptr points(new pcl::PointCloud<pcl::PointXYZ>);
  for (const std::size_t i : first) {
    points->push_back((*cloud.points)[i]);
    result.labels.push_back(cloud.labels[i]);
  }
  result.points = points;
  return result;
}

std::vector<std::uint32_t>
predictedLabels(const LabelledPoints& structure,
                const pcl::PointCloud<pcl::PointXYZ>& points,
                double radius,
                unsigned threads,
                double off_surface)
{
  const auto isOff = [&](std::size_t i, const pcl::PointXYZ& point) {
    if (!structure.normals)
      return false;
    const Eigen::Vector3f way =
        point.getVector3fMap() - (*structure.points)[i].getVector3fMap();
    return !(std::abs(way.dot((*structure.normals)[i].getNormalVector3fMap())) <=
             off_surface);
  };
  const auto nearest = nearestWithin(structure.points, points, radius, threads);
  std::vector<std::uint32_t> labels(points.size(), 0);
  for (std::size_t k = 0; k < nearest.size(); ++k) {
    const auto i = static_cast<std::size_t>(nearest[k]);
    if (nearest[k] >= 0 && !isOff(i, points[k]))
      labels[k] = structure.labels[i];
  }
  return labels;
}

LabelScores
compareLabels(const std::vector<std::uint32_t>& truth,
              const std::vector<std::uint32_t>& predicted)
{
  LabelScores scores;
  for (std::size_t k = 0; k < scores.size(); ++k) {
    const auto label = static_cast<std::uint32_t>(scored_labels[k]);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const bool is_true = scoredAs(truth[i]) == label;
      const bool is_predicted = scoredAs(predicted[i]) == label;
      scores[k].truth += is_true ? 1 : 0;
      scores[k].predicted += is_predicted ? 1 : 0;
      scores[k].right += is_true && is_predicted ? 1 : 0;
    }
  }
  return scores;
}

LabelScores
scoreStructure(const LabelledPoints& structure,
               const LabelledPoints& scan,
               double radius,
               unsigned threads)
{
  std::vector<std::uint32_t> truth;
  std::vector<std::uint32_t> predicted;
  const auto nearest = nearestWithin(scan.points, *structure.points, radius, threads);
  for (std::size_t i = 0; i < nearest.size(); ++i)
    if (nearest[i] >= 0) {
      truth.push_back(scan.labels[static_cast<std::size_t>(nearest[i])]);
      predicted.push_back(structure.labels[i]);
    }
  return compareLabels(truth, predicted);
}

LabelTable
tabulateLabels(const std::vector<std::uint32_t>& labels,
               const std::vector<std::uint32_t>& predicted)
{
  LabelTable table;
  for (std::size_t i = 0; i < labels.size(); ++i)
    ++table[labels[i]][scoredAs(predicted[i])];
  return table;
}

LabelScores
scoreLabels(const LabelledPoints& structure,
            const LabelledPoints& scan,
            double radius,
            unsigned threads)
{
  const LabelledPoints sample = thinned(scan, scoring_spacing);
  return compareLabels(sample.labels,
                       predictedLabels(structure, *sample.points, radius, threads));
}

} // namespace pcl::sedr::benchmark
