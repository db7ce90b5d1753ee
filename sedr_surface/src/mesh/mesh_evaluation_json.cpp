// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/mesh_evaluation.h>

#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {
namespace {

// Members of an object as text, in the order of insertion.
class JsonObject {
public:
  explicit JsonObject(int indent)
      : indent_(indent)
  {}

  void add(const std::string& name, const std::string& json)
  {
    members_.emplace_back(name, json);
  }

  void add(const std::string& name, double value)
  {
    std::ostringstream text;
    text << std::setprecision(9) << value;
    add(name, std::isfinite(value) ? text.str() : std::string("null"));
  }

  void add(const std::string& name, std::size_t value)
  {
    add(name, std::to_string(value));
  }

  void add(const std::string& name, bool value)
  {
    add(name, std::string(value ? "true" : "false"));
  }

  int inner() const { return indent_ + 2; }

  std::string text() const
  {
    std::string text = "{";
    for (const auto& member : members_)
      text += (text == "{" ? "\n" : ",\n") +
              std::string(static_cast<std::size_t>(inner()), ' ') + "\"" +
              member.first + "\": " + member.second;
    return text + "\n" + std::string(static_cast<std::size_t>(indent_), ' ') + "}";
  }

private:
  int indent_;
  std::vector<std::pair<std::string, std::string>> members_;
};

std::string
list(const std::vector<std::string>& values)
{
  std::string text = "[";
  for (const auto& value : values)
    text += (text == "[" ? "" : ", ") + value;
  return text + "]";
}

std::string
toJson(const DistanceStatistics& statistics, int indent)
{
  JsonObject object(indent);
  object.add("count", statistics.count);
  object.add("mean", statistics.mean);
  object.add("rms", statistics.rms);
  object.add("median", statistics.median);
  object.add("p95", statistics.p95);
  object.add("p99", statistics.p99);
  object.add("max", statistics.max);
  object.add("within_1cm", statistics.within_1cm);
  object.add("within_5cm", statistics.within_5cm);
  object.add("beyond_5cm", 1 - statistics.within_5cm);
  std::vector<std::string> bins;
  for (const auto count : statistics.histogram)
    bins.push_back(std::to_string(count));
  object.add("histogram_range", statistics.histogram_range);
  object.add("histogram", list(bins));
  object.add("beyond_histogram", statistics.beyond_histogram);
  return object.text();
}

std::string
toJson(const MeshComponent& component, int indent)
{
  JsonObject object(indent);
  object.add("triangles", component.triangles);
  object.add("area", component.area);
  object.add("volume", component.signed_volume);
  object.add("closed", component.closed);
  return object.text();
}

std::string
toJson(const MeshFigures& figures, int indent)
{
  const MeshTopology& topology = figures.topology;
  JsonObject object(indent);
  object.add("closed_manifold", figures.closed);
  object.add("closed_manifold_when_welded", figures.closed_when_welded);
  object.add("closed", topology.isClosed());
  object.add("edge_manifold", topology.isEdgeManifold());
  object.add("vertex_manifold", topology.isVertexManifold());
  object.add("oriented", topology.isOriented());
  object.add("area", figures.area);
  object.add("volume", figures.volume);
  object.add("vertices", topology.vertices);
  object.add("edges", topology.edges);
  object.add("triangles", topology.triangles);
  object.add("euler_characteristic", std::to_string(topology.euler_characteristic));
  object.add("boundary_edges", topology.boundary_edges);
  object.add("non_manifold_edges", topology.non_manifold_edges);
  object.add("non_manifold_vertices", topology.non_manifold_vertices);
  object.add("inconsistent_edges", topology.inconsistent_edges);
  object.add("degenerate_triangles", topology.degenerate_triangles);
  object.add("duplicate_triangles", topology.duplicate_triangles);
  object.add("zero_area_triangles", topology.zero_area_triangles);
  if (figures.self_intersections)
    object.add("self_intersections", *figures.self_intersections);
  object.add("component_count", topology.components.size());
  // A broken mesh can have thousands of small components; the largest are listed.
  std::vector<std::string> components;
  for (std::size_t i = 0; i < topology.components.size() && i < 100; ++i)
    components.push_back(toJson(topology.components[i], object.inner()));
  object.add("components", list(components));
  return object.text();
}

} // namespace

void
writeJson(std::ostream& stream, const MeshEvaluationResult& result, int indent)
{
  JsonObject object(indent);
  object.add("mesh", toJson(result.mesh, object.inner()));
  if (result.truth)
    object.add("truth", toJson(*result.truth, object.inner()));
  const std::pair<const char*, const std::optional<DistanceStatistics>&> distances[] = {
      {"cloud_to_mesh", result.cloud_to_mesh},
      {"mesh_to_truth", result.mesh_to_truth},
      {"truth_to_mesh", result.truth_to_mesh}};
  for (const auto& entry : distances)
    if (entry.second)
      object.add(entry.first, toJson(*entry.second, object.inner()));
  if (result.truth)
    object.add("sample_spacing", result.sample_spacing);
  if (result.cloud_to_mesh)
    object.add("skipped_points", result.skipped_points);
  stream << object.text();
}

} // namespace pcl::sedr
