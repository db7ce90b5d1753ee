// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include "run_tool.h"

#include "sedr_filters/src/base/number_text.h"
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/mesh_evaluation.h>

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr::tools {

namespace {

/** @brief Vertices, lines or triangles, each with points of its own and a colour. */
class ColouredShape {
public:
  ColouredShape()
  {
    colours_->SetNumberOfComponents(3);
    colours_->SetName("colours");
  }

  void add(const Eigen::Vector3d& point, Colour colour)
  {
    points_->InsertNextPoint(point.data());
    colours_->InsertNextTypedTuple(channelsOf(colour).data());
  }

  void addLine(const Eigen::Vector3d& a, const Eigen::Vector3d& b, Colour colour)
  {
    add(a, colour);
    add(b, colour);
  }

  /** @param corners of a cell: 1, 2 or 3 */
  vtkSmartPointer<vtkPolyData> data(int corners) const
  {
    vtkNew<vtkCellArray> cells;
    for (vtkIdType i = 0; i < points_->GetNumberOfPoints(); ++i) {
      if (i % corners == 0)
        cells->InsertNextCell(corners);
      cells->InsertCellPoint(i);
    }
    auto shape = vtkSmartPointer<vtkPolyData>::New();
    shape->SetPoints(points_);
    if (corners == 1)
      shape->SetVerts(cells);
    else if (corners == 2)
      shape->SetLines(cells);
    else
      shape->SetPolys(cells);
    shape->GetPointData()->SetScalars(colours_);
    return shape;
  }

private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colours_;
};

/** @brief Returns a grey that becomes lighter with height. */
Colour
heightColour(double z, const Eigen::AlignedBox3d& box)
{
  const double share = (z - box.min().z()) / std::max(1e-6, box.sizes().z());
  return mixed(0x3c424e, 0xced0d4, std::clamp(share, 0.0, 1.0));
}

StructureLabel
labelOf(const TriangleMesh& mesh, std::size_t t)
{
  return static_cast<StructureLabel>(mesh.labels.empty() ? 0 : mesh.labels[t]);
}

Eigen::Vector3d
centreOf(const TriangleMesh& mesh, std::size_t t)
{
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
}

/** @brief Adds a loop between two slabs, a little before its faces. */
void
addLoop(const PlanLoop& loop,
        const PlanSlab& low,
        const PlanSlab& high,
        bool with_high,
        Colour straight,
        Colour bent,
        ColouredShape& lines)
{
  constexpr double chord = 0.005; // metres, between an arc and its chords
  constexpr double lift = 0.01;   // metres
  const auto at = [](const Eigen::Vector2d& p, const PlanSlab& slab, double above) {
    return Eigen::Vector3d(p.x(), p.y(), slab.heightAt(p) + above);
  };
  for (const auto& element : loop.elements) {
    const Colour colour = element.isArc() ? bent : straight;
    auto corners = PlanLoop{{element}}.polygon(chord);
    corners.push_back(element.end);
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      lines.addLine(at(corners[k], low, lift), at(corners[k + 1], low, lift), colour);
      if (with_high)
        lines.addLine(at(corners[k], high, -lift), at(corners[k + 1], high, -lift),
                      colour);
    }
    lines.addLine(at(element.start, low, 0), at(element.start, high, 0), colour);
  }
}

void
addRoom(const Floorplan& plan,
        const PlanRoom& room,
        bool with_ceilings,
        ColouredShape& lines)
{
  using namespace colours;
  const auto add = [&](const PlanLoop& loop, const PlanSlab& low, const PlanSlab& high,
                       Colour straight, Colour bent) {
    addLoop(loop, low, high, with_ceilings, straight, bent, lines);
  };
  PlanLoop measured;
  PlanLoop guessed;
  for (std::size_t e = 0; e < room.boundary.elements.size(); ++e)
    (wallShares(plan, room, e).isGuess() ? guessed : measured)
        .elements.push_back(room.boundary.elements[e]);
  add(measured, room.floor, room.ceiling, ink, arc);
  add(guessed, room.floor, room.ceiling, other, other);
  for (const auto& loop : room.columns)
    add(loop, room.floor, room.ceiling, column, column);
  for (const auto& niche : room.niches)
    add(niche.boundary, niche.bottom, niche.top, wall, wall);
  for (const auto& step : room.floor_details)
    addLoop(step.boundary, room.floor, step.slab, true, floor, floor, lines);
  if (with_ceilings)
    for (const auto& soffit : room.details)
      add(soffit.boundary, soffit.slab, room.ceiling, detail, detail);
}

Colour
colourOf(OpeningKind kind)
{
  return kind == OpeningKind::Door      ? colours::detail
         : kind == OpeningKind::Window  ? colours::arc
         : kind == OpeningKind::Passage ? colours::column
                                        : colours::other;
}

/** @brief Adds the outline of an opening in the middle of its wall, and the feet of its
 * leaves, turned out of the wall by a right angle. */
void
addOpening(const PlanOpening& opening, ColouredShape& lines)
{
  const Colour colour = colourOf(opening.kind);
  constexpr int chords = 12; // of an arched head
  std::vector<Eigen::Vector3d> corners;
  const auto add = [&](double share, double z) {
    const Eigen::Vector2d p = opening.start + share * (opening.end - opening.start);
    corners.emplace_back(p.x(), p.y(), z);
  };
  add(0, opening.bottom);
  for (int k = 0; k <= chords; ++k) {
    const double along = 2.0 * k / chords - 1;
    add(static_cast<double>(k) / chords,
        opening.top - opening.rise * (1 - std::sqrt(1 - along * along)));
  }
  add(1, opening.bottom);
  for (std::size_t k = 0; k < corners.size(); ++k)
    lines.addLine(corners[k], corners[(k + 1) % corners.size()], colour);
  for (const OpeningLeaf& leaf : leavesOf(opening)) {
    const auto onFloor = [&](const Eigen::Vector2d& p) {
      return Eigen::Vector3d(p.x(), p.y(), opening.bottom);
    };
    lines.addLine(onFloor(leaf.hinge), onFloor(leaf.open), colour);
  }
}

} // namespace

Shapes::Shapes(const ViewedResult& result)
    : result_(result)
    , bounds_(result.bounds())
{}

bool
Shapes::shows(StructureLabel label,
              std::uint32_t room,
              const Eigen::Vector3d& place,
              const ViewState& state) const
{
  return (state.ceilings || !result_.rules.isCeiling(label, room, place)) &&
         result_.rules.isInStorey(state.storey, room, place.z()) &&
         result_.rules.isInRoom(state.room, room, place);
}

bool
Shapes::shows(const PlanOpening& opening, const ViewState& state) const
{
  return std::any_of(opening.rooms.begin(), opening.rooms.end(),
                     [&](std::uint32_t room) {
                       return room != 0 && shows(StructureLabel::Wall, room,
                                                 Eigen::Vector3d::Zero(), state);
                     });
}

vtkSmartPointer<vtkPolyData>
Shapes::of(const std::string& layer, const ViewState& state) const
{
  ColouredShape shape;
  const bool by_distance = state.colour == "distance";
  const auto cloud = result_.clouds.find(layer);
  if (cloud != result_.clouds.end()) {
    const DisplayCloud& points = cloud->second;
    const auto* measured = by_distance ? &distances(layer) : nullptr;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d place = points.points[i].cast<double>();
      if (!shows(points.label(i), points.room(i), place, state))
        continue;
      Colour colour = heightColour(place.z(), bounds_);
      if (by_distance)
        colour = measured->empty() ? colours::other
                                   : distanceColour((*measured)[i], state.range);
      else if (state.colour == "label" && !points.labels.empty())
        colour = colourOf(points.label(i));
      else if (state.colour == "room" && !points.rooms.empty())
        colour = roomColour(points.room(i));
      shape.add(place, colour);
    }
    return shape.data(1);
  }
  if (layer == "plan") {
    for (const auto& room : result_.plan.rooms)
      if (shows(StructureLabel::Wall, room.id, Eigen::Vector3d::Zero(), state))
        addRoom(result_.plan, room, state.ceilings, shape);
    return shape.data(2);
  }
  if (layer == "openings") {
    for (const auto& opening : result_.plan.openings)
      if (shows(opening, state))
        addOpening(opening, shape);
    return shape.data(2);
  }
  const TriangleMesh& mesh = result_.mesh(layer);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const StructureLabel label = labelOf(mesh, t);
    const std::uint32_t room = mesh.rooms.empty() ? 0 : mesh.rooms[t];
    if (!shows(label, room, centreOf(mesh, t), state))
      continue;
    const Colour colour = by_distance              ? lightened(colours::other, 0.5)
                          : state.colour == "room" ? roomColour(room)
                                                   : colourOf(label);
    for (int k = 0; k < 3; ++k)
      shape.add(mesh.corner(t, k), colour);
  }
  return shape.data(3);
}

vtkSmartPointer<vtkPolyData>
Shapes::solidEdges(const ViewState& state) const
{
  vtkNew<vtkCleanPolyData> joined; // its triangles have points of their own
  joined->SetInputData(of("solid", state));
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(joined->GetOutputPort());
  edges->SetFeatureAngle(15); // chords of arcs bend by less
  edges->ColoringOff();
  edges->Update();
  return edges->GetOutput();
}

const std::vector<double>&
Shapes::distances(const std::string& layer) const
{
  const auto [known, is_new] = distances_.emplace(layer, std::vector<double>());
  std::vector<double>& distances = known->second;
  const TriangleMesh& mesh = result_.mesh("mesh");
  if (!is_new || mesh.empty() || result_.clouds.count(layer) == 0)
    return distances;
  const Progress progress("measuring distances");
  constexpr double far = 1; // metres: from there on the distance from the box will do
  const Eigen::AlignedBox3d box = mesh.bounds();
  std::vector<std::size_t> near;
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& point : result_.clouds.at(layer).points) {
    distances.push_back(box.exteriorDistance(point.cast<double>()));
    if (distances.back() > far)
      continue;
    near.push_back(distances.size() - 1);
    points.push_back(point.cast<double>());
  }
  const auto measured = MeshDistance(mesh).distances(points);
  for (std::size_t k = 0; k < near.size(); ++k)
    distances[near[k]] = measured[k];
  return distances;
}

void
Shapes::addDistances(const ViewState& state, std::vector<LegendLine>& lines) const
{
  if (result_.mesh("mesh").empty()) {
    lines.push_back({"no distances: there is no mesh.ply"});
    return;
  }
  lines.push_back({"distance from the mesh"});
  constexpr int steps = 5;
  for (int k = 0; k <= steps; ++k) {
    const double distance = state.range * k / steps;
    lines.push_back({distanceText(distance) + (k == steps ? " or more" : ""),
                     distanceColour(distance, state.range)});
  }
  for (const auto& [layer, cloud] : result_.clouds)
    if (state.layers.count(layer) > 0) {
      const DistanceStatistics figures = summarizeDistances(distances(layer));
      lines.push_back({layer + ": half within " + distanceText(figures.median) +
                       ", 95 % within " + distanceText(figures.p95)});
    }
}

std::vector<LegendLine>
Shapes::legend(const ViewState& state) const
{
  constexpr std::size_t max_rooms = 14; // with a line each
  std::vector<LegendLine> lines;
  for (const std::string& layer : state.layers)
    lines.push_back({layer + (result_.has(layer) ? "" : ": not there")});
  if (state.colour == "distance")
    addDistances(state, lines);
  for (std::uint32_t k = 0; k < 6 && state.colour == "label"; ++k)
    lines.push_back({toString(static_cast<StructureLabel>(k)),
                     colourOf(static_cast<StructureLabel>(k))});
  if (state.layers.count("openings") > 0)
    for (const OpeningKind kind : {OpeningKind::Door, OpeningKind::Window,
                                   OpeningKind::Passage, OpeningKind::Unknown})
      if (const auto n =
              std::count_if(result_.plan.openings.begin(), result_.plan.openings.end(),
                            [&](const PlanOpening& opening) {
                              return opening.kind == kind && shows(opening, state);
                            });
          n > 0)
        lines.push_back(
            {std::string(nameOf(kind)) + ": " + std::to_string(n), colourOf(kind)});
  std::size_t told = 0;
  for (const auto& room : result_.plan.rooms)
    if (shows(StructureLabel::Wall, room.id, Eigen::Vector3d::Zero(), state) &&
        told++ < max_rooms) {
      lines.push_back({"room " + std::to_string(room.id) + "  " +
                       decimalText(room.area(), 1) + " m2"});
      if (state.colour == "room")
        lines.back().colour = roomColour(room.id);
    }
  if (told > max_rooms)
    lines.push_back({"and " + std::to_string(told - max_rooms) + " more"});
  if (state.storey != 0)
    lines.push_back({"storey " + std::to_string(state.storey) + " alone"});
  if (!state.ceilings)
    lines.push_back({"without ceilings"});
  if (std::isfinite(state.clip_height))
    lines.push_back({"cut at " + decimalText(state.clip_height, 2) + " m"});
  return lines;
}

} // namespace pcl::sedr::tools
