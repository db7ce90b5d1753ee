// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/label_map.h"
#include "benchmark/label_scores.h"
#include "run_tool.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include <cmath>
#include <cstdio>
#include <string>

using namespace pcl::sedr::benchmark;
using namespace pcl::sedr::tools;

namespace {

struct Settings {
  std::string structure;
  std::string labelled;
  std::string map;
  double radius = 0.0866; ///< the diagonal of a voxel of 5 cm
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

std::string
percent(double share)
{
  char text[16];
  std::snprintf(text, sizeof text, "%.2f", 100 * share);
  return std::isnan(share) ? "-" : text;
}

void
print(const LabelScores& scores)
{
  std::printf("%-10s %9s %9s %9s %11s\n", "label", "true", "predicted", "recall, %",
              "precision, %");
  for (std::size_t k = 0; k < scores.size(); ++k)
    std::printf("%-10s %9zu %9zu %9s %11s\n", toString(scored_labels[k]),
                scores[k].truth, scores[k].predicted,
                percent(scores[k].recall()).c_str(),
                percent(scores[k].precision()).c_str());
}

int
run(const Settings& settings)
{
  const LabelMap map = labelMapOf(settings.map, "map");
  const LabelledPoints structure = loadLabelled(settings.structure);
  LabelledPoints scan = loadLabelled(settings.labelled);
  applyTo(scan.labels, map);
  const LabelScores scores =
      scoreLabels(structure, scan, settings.radius, settings.threads);
  std::size_t labelled = 0;
  for (const LabelScore& score : scores)
    labelled += score.truth;
  if (labelled == 0)
    throw ToolError("no point of " + settings.labelled +
                        " is a ceiling, floor, wall, detail or column; --map says what "
                        "its labels mean",
                    NothingFound);
  print(scores);
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
  options.text("map", settings.map,
               "what the scan's labels mean here, such as 0=1,1=2,2=3; those not named "
               "stay, and above 5 they are other");
  options.number("threads", settings.threads, "", "threads, 0 for all processors",
                 Range::between(0, 256));
  return runTool(options, argc, argv, [&] { return run(settings); });
}
