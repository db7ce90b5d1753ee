// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/figures/label_map.h"
#include "benchmark/figures/label_scores.h"
#include "benchmark/table/formatted.h"
#include "run_tool.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include <pcl/conversions.h>
#include <pcl/sedr_filters/row_source.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

using namespace pcl::sedr::benchmark;
using namespace pcl::sedr::tools;
using pcl::sedr::findField;

namespace {

struct Settings {
  std::string structure;
  std::string labelled;
  std::string map;
  double radius = 0.0866; ///< the diagonal of a voxel of 5 cm
  double off_surface = 0; ///< metres; 0: no limit
  unsigned threads = 0;
};

LabelledPoints
loadLabelled(const std::string& path)
{
  const ToolCloud cloud = loadCloud(path);
  if (!cloud.has_label)
    throw ToolError(path + " has no field 'label'");
  return {cloud.points, cloud.label};
}

LabelledPoints
loadStructure(const Settings& settings)
{
  LabelledPoints structure = loadLabelled(settings.structure);
  if (settings.off_surface == 0)
    return structure;
  const ToolCloud cloud = loadCloud(settings.structure);
  for (const char* name : {"normal_x", "normal_y", "normal_z"})
    if (!findField(cloud.blob.fields, name))
      throw ToolError(settings.structure + " has no field '" + name +
                      "': how far a point is off a surface cannot be told");
  const pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  pcl::fromPCLPointCloud2(cloud.blob, *normals);
  structure.normals = normals;
  return structure;
}

std::string
percent(double share)
{
  return std::isnan(share) ? "-" : formatted("%.2f", 100 * share);
}

void
print(const LabelScores& of_scan, const LabelScores& of_structure)
{
  std::printf("%-10s %9s %9s %10s %13s %15s\n", "label", "true", "predicted",
              "recall, %", "precision, %", "of structure, %");
  for (std::size_t k = 0; k < of_scan.size(); ++k)
    std::printf("%-10s %9zu %9zu %10s %13s %15s\n", toString(scored_labels[k]),
                of_scan[k].truth, of_scan[k].predicted,
                percent(of_scan[k].recall()).c_str(),
                percent(of_scan[k].precision()).c_str(),
                percent(of_structure[k].precision()).c_str());
}

/** @brief Prints the predicted labels of the points of each input label. */
void
print(const LabelTable& table)
{
  std::printf("\n%-10s %9s", "of label", "other");
  for (const auto label : scored_labels)
    std::printf(" %9s", toString(label));
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
  const LabelMap map = labelMapOf(settings.map, "map");
  const LabelledPoints structure = loadStructure(settings);
  const LabelledPoints scan = thinned(loadLabelled(settings.labelled), scoring_spacing);
  const auto predicted = predictedLabels(structure, *scan.points, settings.radius,
                                         settings.threads, settings.off_surface);
  const auto truth = mapped(scan.labels, map);
  if (std::all_of(truth.begin(), truth.end(),
                  [](std::uint32_t label) { return scoredAs(label) == 0; }))
    throw ToolError("no point of " + settings.labelled +
                        " is a ceiling, floor, wall, detail or column; --map says what "
                        "its labels mean",
                    NothingFound);
  print(compareLabels(truth, predicted),
        scoreStructure(structure, {scan.points, truth}, settings.radius,
                       settings.threads));
  print(tabulateLabels(scan.labels, predicted));
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
