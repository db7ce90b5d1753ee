// SPDX-License-Identifier: BSD-3-Clause
#include "run_tool.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/voxels/voxel_sums.h"
#include "sedr_filters/src/voxels/voxel_visit.h"
#include <pcl/common/point_tests.h>
#include <pcl/conversions.h>
#include <pcl/search/kdtree.h>
#include <pcl/sedr_filters/point_view.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

using namespace pcl::sedr::tools;
using pcl::sedr::findField;
using pcl::sedr::StructureLabel;

namespace {

constexpr double spacing = 0.02; ///< metres, of the points of the scan that are scored
constexpr auto column = static_cast<std::uint32_t>(StructureLabel::Column);
constexpr auto wall = static_cast<std::uint32_t>(StructureLabel::Wall);
constexpr std::array<const char*, 5> names{"other", "ceiling", "floor", "wall",
                                           "detail"};
using Labels = std::vector<std::uint32_t>;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

struct Settings {
  std::string structure;
  std::string labelled;
  std::string map;
  double radius = 0.0866; ///< the diagonal of a voxel of 5 cm
  double off_surface = 0; ///< metres; 0: no limit
  unsigned threads = 0;
};

struct LabelledPoints {
  Cloud::ConstPtr points;
  Labels labels;
  pcl::PointCloud<pcl::Normal>::Ptr normals = nullptr; ///< of a structure, or null
};

/** @brief Numbers of points by their label and, in the order of `names`, the predicted
 * one. */
using Table = std::map<std::uint32_t, std::array<std::size_t, names.size()>>;

/** @brief Returns the label that is scored: walls for columns, other (0) for values
 * above 5. */
std::uint32_t
scoredAs(std::uint32_t label)
{
  return label == column ? wall : label < column ? label : 0;
}

/** @brief Parses pairs of a label and its meaning such as "7=3,8=3". */
std::map<std::uint32_t, std::uint32_t>
labelMapOf(const std::string& text)
{
  std::map<std::uint32_t, std::uint32_t> map;
  std::istringstream pairs(text.empty() ? "" : text + ",");
  for (std::string pair; std::getline(pairs, pair, ',');) {
    const char* const begin = pair.c_str();
    const char* const end = begin + pair.size();
    const char* const sign = std::find(begin, end, '=');
    std::uint32_t label = 0;
    std::uint32_t meaning = 0;
    const auto isNumber = [](const char* from, const char* to, std::uint32_t& value) {
      const auto [stop, error] = std::from_chars(from, to, value);
      return error == std::errc() && stop == to;
    };
    if (sign == end || !isNumber(begin, sign, label) ||
        !isNumber(sign + 1, end, meaning) || meaning > column ||
        !map.emplace(label, meaning).second)
      throw ToolError("--map takes pairs of a label of the scan and one from 0 to 5, "
                      "each label once, such as 7=3,8=3, not '" +
                      text + "'");
  }
  return map;
}

Labels
mapped(Labels labels, const std::map<std::uint32_t, std::uint32_t>& map)
{
  for (std::uint32_t& label : labels)
    if (const auto meaning = map.find(label); meaning != map.end())
      label = meaning->second;
  return labels;
}

LabelledPoints
loadLabelled(const std::string& path, bool with_normals = false)
{
  const ToolCloud cloud = loadCloud(path);
  if (!cloud.has_label)
    throw ToolError(path + " has no field 'label'");
  LabelledPoints result{cloud.points, cloud.label};
  if (!with_normals)
    return result;
  for (const char* name : {"normal_x", "normal_y", "normal_z"})
    if (!findField(cloud.blob.fields, name))
      throw ToolError(path + " has no field '" + name +
                      "': how far a point is off a surface cannot be told");
  result.normals.reset(new pcl::PointCloud<pcl::Normal>);
  pcl::fromPCLPointCloud2(cloud.blob, *result.normals);
  return result;
}

/** @brief Returns the first point in each cube of `spacing`, without those that are not
 * finite: the density is a hundred times higher near the scanner. */
LabelledPoints
thinned(const LabelledPoints& cloud)
{
  const pcl::sedr::PointView all(*cloud.points);
  pcl::sedr::VoxelSums sums(Eigen::Array3f::Constant(static_cast<float>(1 / spacing)));
  sums.add(all);
  const pcl::sedr::VoxelIndex index(sums.frame(), sums.take());
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> first(index.voxels().size(), none);
  pcl::sedr::visitVoxels(index, all, nullptr, 0, [&](std::size_t voxel, std::size_t i) {
    first[voxel] = std::min(first[voxel], i);
  });
  LabelledPoints result;
  const Cloud::Ptr points(new Cloud);
  for (const std::size_t i : first) {
    points->push_back((*cloud.points)[i]);
    result.labels.push_back(cloud.labels[i]);
  }
  result.points = points;
  return result;
}

/** @brief Returns the point of `cloud` nearest to each query, or -1 if none is within
 * the radius or the query is not finite. */
pcl::Indices
nearestPoints(const Cloud::ConstPtr& cloud,
              const Cloud& queries,
              const Settings& settings)
{
  pcl::Indices nearest(queries.size(), -1);
  if (cloud->empty())
    return nearest;
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  const auto limit = static_cast<float>(settings.radius * settings.radius);
  pcl::sedr::parallelBlocks(
      queries.size(), 4096, settings.threads, [&](std::size_t begin, std::size_t end) {
        pcl::Indices index(1);
        std::vector<float> squared(1);
        for (std::size_t i = begin; i < end; ++i)
          if (pcl::isFinite(queries[i]) &&
              tree.nearestKSearch(queries[i], 1, index, squared) == 1 &&
              squared[0] <= limit)
            nearest[i] = index[0];
      });
  return nearest;
}

/** @brief Returns the label of the structure's point nearest to each point of the scan;
 * 0 if none is near enough, or the point is too far off the surface there. */
Labels
predictedLabels(const LabelledPoints& structure,
                const Cloud& points,
                const Settings& settings)
{
  const pcl::Indices nearest = nearestPoints(structure.points, points, settings);
  Labels labels(points.size(), 0);
  for (std::size_t k = 0; k < nearest.size(); ++k) {
    if (nearest[k] < 0)
      continue;
    const auto i = static_cast<std::size_t>(nearest[k]);
    const Eigen::Vector3f way =
        points[k].getVector3fMap() - (*structure.points)[i].getVector3fMap();
    if (!structure.normals ||
        std::abs(way.dot((*structure.normals)[i].getNormalVector3fMap())) <=
            settings.off_surface)
      labels[k] = structure.labels[i];
  }
  return labels;
}

Table
tableOf(const Labels& truth, const Labels& predicted)
{
  Table table;
  for (std::size_t i = 0; i < truth.size(); ++i)
    ++table[truth[i]][scoredAs(predicted[i])];
  return table;
}

/** @brief Counts the points of the structure by the label of the nearest point of the
 * scan. Those without one do not count, such as points that close a hole. */
Table
tableOfStructure(const LabelledPoints& structure,
                 const LabelledPoints& scan,
                 const Settings& settings)
{
  Table table;
  const pcl::Indices nearest = nearestPoints(scan.points, *structure.points, settings);
  for (std::size_t i = 0; i < nearest.size(); ++i)
    if (nearest[i] >= 0)
      ++table[scan.labels[static_cast<std::size_t>(nearest[i])]]
             [scoredAs(structure.labels[i])];
  return table;
}

/** @brief Numbers of points of one scored label. */
struct Score {
  std::size_t truth = 0;
  std::size_t predicted = 0;
  std::size_t right = 0; ///< both
};

Score
scoreOf(const Table& table, std::uint32_t scored)
{
  Score score;
  for (const auto& [label, counts] : table) {
    score.predicted += counts[scored];
    if (scoredAs(label) != scored)
      continue;
    score.truth += std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    score.right += counts[scored];
  }
  return score;
}

std::string
percent(std::size_t part, std::size_t whole)
{
  char text[16] = "-";
  if (whole > 0)
    std::snprintf(text, sizeof text, "%.2f",
                  100 * (static_cast<double>(part) / static_cast<double>(whole)));
  return text;
}

void
printScores(const Table& of_scan, const Table& of_structure)
{
  std::printf("%-10s %9s %9s %10s %13s %15s\n", "label", "true", "predicted",
              "recall, %", "precision, %", "of structure, %");
  for (std::uint32_t label = 1; label < names.size(); ++label) {
    const Score scan = scoreOf(of_scan, label);
    const Score structure = scoreOf(of_structure, label);
    std::printf("%-10s %9zu %9zu %10s %13s %15s\n", names[label], scan.truth,
                scan.predicted, percent(scan.right, scan.truth).c_str(),
                percent(scan.right, scan.predicted).c_str(),
                percent(structure.right, structure.predicted).c_str());
  }
}

/** @brief Prints the predicted labels of the points of each input label. */
void
print(const Table& table)
{
  std::printf("\n%-10s", "of label");
  for (const char* name : names)
    std::printf(" %9s", name);
  std::printf("\n");
  for (const auto& [label, counts] : table) {
    std::printf("%-10u", label);
    for (const std::size_t count : counts)
      std::printf(" %9zu", count);
    std::printf("\n");
  }
}

int
run(const Settings& settings)
{
  const auto map = labelMapOf(settings.map);
  const LabelledPoints structure =
      loadLabelled(settings.structure, settings.off_surface > 0);
  LabelledPoints scan = thinned(loadLabelled(settings.labelled));
  const Labels given = scan.labels;
  scan.labels = mapped(given, map);
  if (std::all_of(scan.labels.begin(), scan.labels.end(),
                  [](std::uint32_t label) { return scoredAs(label) == 0; }))
    throw ToolError("no point of " + settings.labelled +
                        " is a ceiling, floor, wall, detail or column; --map says what "
                        "its labels mean",
                    NothingFound);
  const Labels predicted = predictedLabels(structure, *scan.points, settings);
  printScores(tableOf(scan.labels, predicted),
              tableOfStructure(structure, scan, settings));
  print(tableOf(given, predicted));
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  Options options(
      "pcl_label_evaluation",
      "Tells how well a structure tells ceiling, floor, walls and details of a "
      "labelled "
      "scan apart:\neach point of the scan, thinned to one in 2 cm, is predicted to be "
      "what the nearest point\nof the structure is. Columns count as walls.");
  options.file("STRUCTURE.pcd", settings.structure,
               "structure with labels, as pcl_sedr writes it");
  options.file("LABELLED.pcd", settings.labelled, "scan with true labels");
  options.number("radius", settings.radius, "m",
                 "within which a point of the structure must lie, or the prediction is "
                 "'other'",
                 Range::above(0));
  options.number("off-surface", settings.off_surface, "m",
                 "how far off the structure's surface a point may lie, or the "
                 "prediction is 'other'; 0: any",
                 Range::atLeast(0));
  options.text("map", settings.map,
               "what the scan's labels mean here, such as 0=1,1=2,2=3; those not named "
               "stay, and above 5 they are other");
  options.number("threads", settings.threads, "", "threads, 0 for all processors",
                 Range::between(0, 256));
  return runTool(options, argc, argv, [&] { return run(settings); });
}
