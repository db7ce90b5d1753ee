// SPDX-License-Identifier: BSD-3-Clause
#include "painter.h"

#include "map_cells.h"
#include "progress.h"
#include "results/distance_colour.h"
#include "results/shown_mesh.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr::tools {

namespace {

constexpr double plan_chord = 0.005; // metres, between an arc and its chords
constexpr double lift = 0.01;        // metres, of lines in front of their faces

/** @brief Returns a grey that becomes lighter with height. */
Colour
heightColour(double z, HeightRange heights)
{
  const double share = (z - heights.low) / std::max(1e-6, heights.high - heights.low);
  return mixed(Colour{60, 66, 78}, Colour{206, 208, 212}, std::clamp(share, 0.0, 1.0));
}

StructureLabel
labelAt(const std::vector<std::uint32_t>& labels, std::size_t i)
{
  return labels.empty() ? StructureLabel::Other
                        : static_cast<StructureLabel>(labels[i]);
}

/** @brief Returns the lit colour of a point, if its normal is known. */
Colour
litPoint(const DisplayCloud& cloud, std::size_t i, Colour colour)
{
  const bool has_normal = !cloud.normals.empty() && cloud.normals[i].allFinite();
  return has_normal ? litColour(colour, cloud.normals[i].cast<double>()) : colour;
}

} // namespace

Colour
roomColour(std::uint32_t room)
{
  return room == 0 ? colours::other : colourNumber(room - 1);
}

Painter::Painter(const ViewedResult& result, double range)
    : result_(result)
    , range_(range)
    , rule_(result.plan)
    , storeys_(result.plan)
{
  const auto box = result.bounds();
  if (!box.isEmpty())
    heights_ = {box.min().z(), box.max().z()};
}

const std::vector<bool>&
Painter::ceilingOf(Layer layer) const
{
  const auto known = ceilings_.find(layer);
  if (known != ceilings_.end())
    return known->second;
  const auto* cloud = result_.cloudOf(layer);
  return ceilings_[layer] =
             cloud ? rule_.ofCloud(*cloud) : rule_.ofMesh(*result_.meshOf(layer));
}

const std::vector<double>&
Painter::distances(Layer layer) const
{
  const auto known = distances_.find(layer);
  if (known != distances_.end())
    return known->second;
  std::vector<double>& distances = distances_[layer];
  const auto* cloud = result_.cloudOf(layer);
  if (!cloud || result_.mesh.empty())
    return distances;
  const Progress progress("measuring distances");
  // Far outside, the locator is slowest, and the distance from the box suffices.
  constexpr double far = 1; // metres
  const Eigen::AlignedBox3d box = result_.mesh.bounds();
  std::vector<std::size_t> near;
  std::vector<Eigen::Vector3d> points;
  for (const auto& point : cloud->points) {
    const Eigen::Vector3d p = point.cast<double>();
    distances.push_back(box.exteriorDistance(p));
    if (distances.back() > far)
      continue;
    near.push_back(distances.size() - 1);
    points.push_back(p);
  }
  const auto measured = MeshDistance(result_.mesh).distances(points);
  for (std::size_t k = 0; k < near.size(); ++k)
    distances[near[k]] = measured[k];
  return distances;
}

Colour
Painter::colourOfPoint(Layer layer, std::size_t i, const ViewState& state) const
{
  const DisplayCloud& cloud = *result_.cloudOf(layer);
  switch (state.colouring) {
  case Colouring::Distance: {
    const auto& all = distances(layer);
    return all.empty() ? colours::other : distanceColour(all[i], range_);
  }
  case Colouring::Label:
    if (!cloud.labels.empty())
      return litPoint(cloud, i, colourOf(labelAt(cloud.labels, i)));
    break;
  case Colouring::Room:
    if (!cloud.rooms.empty())
      return litPoint(cloud, i, roomColour(cloud.rooms[i]));
    break;
  case Colouring::Plain:
    break;
  }
  return heightColour(cloud.points[i].z(), heights_);
}

ColouredPoints
Painter::points(Layer layer, const ViewState& state) const
{
  ColouredPoints shown;
  const DisplayCloud* cloud = result_.cloudOf(layer);
  if (!cloud)
    return shown;
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if ((state.ceiling || !ceilingOf(layer)[i]) &&
        storeys_.holds(state.storey, cloud->rooms.empty() ? 0 : cloud->rooms[i],
                       cloud->points[i].z()))
      shown.add(cloud->points[i], colourOfPoint(layer, i, state));
  return shown;
}

bool
Painter::shows(Layer layer, std::size_t triangle, const ViewState& state) const
{
  const TriangleMesh& mesh = *result_.meshOf(layer);
  const double z = (mesh.corner(triangle, 0).z() + mesh.corner(triangle, 1).z() +
                    mesh.corner(triangle, 2).z()) /
                   3;
  return (state.ceiling || !ceilingOf(layer)[triangle]) &&
         storeys_.holds(state.storey, mesh.rooms.empty() ? 0 : mesh.rooms[triangle], z);
}

ColouredPoints
Painter::triangles(Layer layer, const ViewState& state) const
{
  ColouredPoints shown;
  const TriangleMesh* mesh = result_.meshOf(layer);
  if (!mesh)
    return shown;
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
    if (!shows(layer, t, state))
      continue;
    const Eigen::Vector3d normal = mesh->scaledNormal(t).normalized();
    Colour colour = colourOf(labelAt(mesh->labels, t));
    if (state.colouring == Colouring::Room && !mesh->rooms.empty())
      colour = roomColour(mesh->rooms[t]);
    else if (state.colouring == Colouring::Distance)
      colour = lightened(colours::other, 0.5); // the points matter more
    colour = litColour(colour, normal);
    for (int k = 0; k < 3; ++k)
      shown.add(mesh->corner(t, k).cast<float>(), colour);
  }
  return shown;
}

ColouredLines
Painter::planLines(const ViewState& state) const
{
  ColouredLines lines;
  const auto add = [&](const Eigen::Vector2d& a, double at_a, const Eigen::Vector2d& b,
                       double at_b, Colour colour) {
    lines.add({static_cast<float>(a.x()), static_cast<float>(a.y()),
               static_cast<float>(at_a)},
              colour);
    lines.add({static_cast<float>(b.x()), static_cast<float>(b.y()),
               static_cast<float>(at_b)},
              colour);
  };
  const auto addLoop = [&](const PlanLoop& loop, const PlanSlab& low,
                           const PlanSlab& high, Colour straight, Colour bent) {
    for (const auto& element : loop.elements) {
      const Colour colour = element.isArc() ? bent : straight;
      const auto corners = PlanLoop{{element}}.polygon(plan_chord);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Eigen::Vector2d& a = corners[k];
        const Eigen::Vector2d b = k + 1 < corners.size() ? corners[k + 1] : element.end;
        add(a, low.heightAt(a) + lift, b, low.heightAt(b) + lift, colour);
        if (state.ceiling)
          add(a, high.heightAt(a) - lift, b, high.heightAt(b) - lift, colour);
      }
      add(element.start, low.heightAt(element.start), element.start,
          high.heightAt(element.start), colour);
    }
  };
  for (const auto& room : result_.plan.rooms) {
    if (!storeys_.holds(state.storey, room.id, 0))
      continue;
    addLoop(room.boundary, room.floor, room.ceiling, colours::ink, colours::arc);
    for (const auto& column : room.columns)
      addLoop(column, room.floor, room.ceiling, colours::column, colours::column);
    for (const auto& niche : room.niches)
      addLoop(niche.boundary, niche.bottom, niche.top, colours::wall, colours::wall);
    for (const auto& step : room.floor_details)
      addLoop(step.boundary, room.floor, step.slab, colours::floor, colours::floor);
    if (state.ceiling)
      for (const auto& detail : room.details)
        addLoop(detail.boundary, detail.slab, room.ceiling, colours::detail,
                colours::detail);
  }
  return lines;
}

ColouredLines
Painter::solidEdges(const ViewState& state) const
{
  TriangleMesh shown = result_.solid;
  std::vector<bool> keep;
  for (std::size_t t = 0; t < shown.triangles.size(); ++t)
    keep.push_back(shows(Layer::Solid, t, state));
  shown.keepTriangles(keep);
  ColouredLines lines;
  for (const auto& [a, b] : elementEdges(shown)) {
    lines.add(a.cast<float>(), colours::ink);
    lines.add(b.cast<float>(), colours::ink);
  }
  return lines;
}

} // namespace pcl::sedr::tools
