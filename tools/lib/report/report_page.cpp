// SPDX-License-Identifier: BSD-3-Clause
#include "report_page.h"

#include "bytes/whole_file.h"
#include "report/model/model_part.h"
#include "report/model/model_pictures.h"
#include "report/page/html_text.h"
#include "report/page/page_files.h"
#include "report/page/page_sections.h"
#include "results/distance_colour.h"
#include "results/result_folder.h"
#include "scan_file.h"

#include <pcl/sedr_surface/mesh_distance.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pcl::sedr::tools {

namespace {

constexpr std::size_t max_scan_points = 1500000;    // in the picture
constexpr std::size_t max_measured_points = 250000; // in the picture of distances
constexpr double farthest = 0.5; // in the picture of distances, metres

/** @brief Data of all pictures. */
struct Contents {
  ReportData data;
  CeilingRule rule;
  TriangleMesh mesh;  ///< triangles face into the rooms
  TriangleMesh solid; ///< triangles face into the rooms
  DisplayCloud scan;
  DisplayCloud thinned;
  DisplayCloud structure;
  double voxel_size = 0; ///< metres

  /** @brief Returns points that the pictures must show; empty without a model and
   * points. */
  std::vector<Eigen::Vector3d> outline() const
  {
    for (const auto* model : {&solid, &mesh})
      if (!model->empty())
        return model->vertices;
    std::vector<Eigen::Vector3d> points;
    for (const auto& p : (structure.empty() ? thinned : structure).points)
      points.push_back(p.cast<double>());
    return points;
  }
};

Contents
readContents(const ResultFolder& folder, const PageSettings& settings)
{
  Contents contents;
  contents.data = readReportData(folder);
  contents.voxel_size = folder.voxelSize();
  contents.rule = CeilingRule(contents.data.plan);
  contents.mesh = folder.mesh("mesh.ply");
  contents.solid = folder.mesh("solid.ply");
  contents.solid.flip();
  if (folder.has("structure.pcd"))
    contents.structure = displayCloudOf(ScanFile(folder.file("structure.pcd")), 0);
  const std::string path = settings.scan.empty() ? folder.scanPath() : settings.scan;
  if (path.empty())
    return contents;
  const ScanFile scan(path, folder.scanSettings());
  contents.scan = displayCloudOf(scan, max_scan_points);
  contents.scan.labels.clear(); // labels of a raw scan are meaningless
  contents.scan.rooms.clear();
  contents.thinned = thinnedCloudOf(scan, contents.voxel_size);
  return contents;
}

/** @brief Returns scan and model side by side. */
std::string
picturesPart(const Contents& contents, const ModelPictures& pictures)
{
  std::string html;
  if (!contents.scan.empty())
    html += htmlPicture(
        pictures.scan(contents.scan),
        "The scan, lighter the higher, cut off 15 cm below the ceilings: " +
            numberText(static_cast<double>(contents.scan.whole_size), 0) + " points");
  else
    html += "<p class=\"note\">The scan was not found where this page was written, so "
            "there is no picture of it.</p>\n";
  const TriangleMesh& shown = contents.solid.empty() ? contents.mesh : contents.solid;
  if (!shown.empty())
    html += htmlPicture(pictures.model(shown),
                        "The model without its ceilings and the walls in front: " +
                            numberText(static_cast<double>(shown.triangles.size()), 0) +
                            " triangles");
  return htmlSection("pictures", "Scan and model",
                     "<div class=\"pair\">\n" + html + "</div>\n" + labelKey());
}

/** @brief Selects the points for the picture of distances, as measuring all would take
 * long. */
DisplayCloud
shownOf(const DisplayCloud& cloud, const CeilingRule& rule, Eigen::AlignedBox3d box)
{
  box = Eigen::AlignedBox3d(box.min().array() - farthest, box.max().array() + farthest);
  const auto is_ceiling = rule.ofCloud(cloud);
  std::vector<Eigen::Vector3f> near;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (!is_ceiling[i] && box.contains(cloud.points[i].cast<double>()))
      near.push_back(cloud.points[i]);
  DisplayCloud shown;
  shown.whole_size = near.size();
  const std::size_t count = std::min(near.size(), max_measured_points);
  for (std::size_t k = 0; k < count; ++k)
    shown.points.push_back(near[k * near.size() / count]);
  return shown;
}

/** @brief Returns the picture of distances and the histogram (paper, Figure 11). */
std::string
distancesPart(const Contents& contents,
              const ModelPictures& pictures,
              const PageSettings& settings)
{
  std::string html = histogramPart(contents.data, settings.range);
  const bool has_scan = !contents.thinned.empty();
  const DisplayCloud cloud = shownOf(has_scan ? contents.thinned : contents.structure,
                                     contents.rule, contents.mesh.bounds());
  if (!contents.mesh.empty() && !cloud.empty()) {
    std::vector<Eigen::Vector3d> points;
    for (const auto& p : cloud.points)
      points.push_back(p.cast<double>());
    const auto distances = MeshDistance(contents.mesh).distances(points);
    const std::string caption =
        has_scan
            ? "The thinned scan by its distance from the mesh, ceilings and what is "
              "more than " +
                  distanceText(farthest) + " off left out; furniture is red"
            : "The refined structure by its distance from the mesh: the scan was not "
              "found where this page was written";
    const double part =
        static_cast<double>(cloud.size()) / static_cast<double>(cloud.whole_size);
    html += htmlPicture(pictures.distances(cloud, distances,
                                           contents.voxel_size / std::sqrt(part),
                                           settings.range, farthest),
                        caption) +
            distanceKey(settings.range);
  }
  return html.empty() ? "" : htmlSection("distances", "Distances from the model", html);
}

/** @brief Returns the page with its frame. */
std::string
frame(const std::string& folder, const ReportData& data, const std::string& body)
{
  const std::string name =
      escaped(std::filesystem::absolute(folder).lexically_normal().filename().string());
  const std::string title =
      name.empty() || name == "." ? "Model of an indoor scan" : "Model: " + name;
  std::string source = data.scan.empty() ? "" : "Scan: " + escaped(data.scan);
  if (data.points > 0)
    source += ", " + numberText(static_cast<double>(data.points), 0) + " points";
  if (data.unit != 1)
    source += ", unit " + numberText(data.unit, 4) + "&nbsp;m";
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"generator\" content=\"pcl_sedr_report\">\n<title>" +
         title + "</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n" +
         page_style + "</style>\n</head>\n<body>\n<header>\n<h1>" + title +
         "</h1>\n<p class=\"source\">" + source + "</p>\n" + figuresPart(data) +
         "</header>\n<main>\n" + body + "</main>\n</body>\n</html>\n";
}

} // namespace

std::string
makePage(const std::string& path, const PageSettings& settings)
{
  const ResultFolder folder(path);
  const Contents contents = readContents(folder, settings);
  std::string body =
      advicePart(contents.data) + coveragePart(contents.data) +
      storeysPart(contents.data) + planPart(contents.data) + roomsPart(contents.data) +
      modelPart(folder, contents.mesh, contents.solid, contents.data.plan, settings);
  const auto outline = contents.outline();
  if (!outline.empty()) {
    const ModelPictures pictures(outline, contents.rule);
    body += picturesPart(contents, pictures);
    body += distancesPart(contents, pictures, settings);
  }
  body += deliverablesPart(folder, contents.data);
  body += stagesPart(contents.data) + parametersPart(contents.data);
  return frame(path, contents.data, body);
}

std::string
writePage(const std::string& path, const PageSettings& settings)
{
  const std::string page = (std::filesystem::path(path) / "report.html").string();
  checkWritable(page);
  const std::string html = makePage(path, settings);
  writeWhole(page, [&](std::ostream& stream) { stream << html; });
  return page;
}

} // namespace pcl::sedr::tools
