// SPDX-License-Identifier: BSD-3-Clause
#include "ifc_bodies.h"
#include "ifc_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::sedr::ifc {
namespace {

constexpr double thinnest_slab = 0.05; ///< between two storeys, metres
constexpr double thickest_slab = 1.0;

/** @brief The slab between a room's floor and the rooms below. */
struct SlabBelow {
  std::vector<std::pair<std::size_t, double>> rooms; ///< and the areas below it
  double thickness = std::numeric_limits<double>::infinity(); ///< where it is thinnest
};

/** @brief Looks below the floor of a room at places all over it. */
SlabBelow
slabBelow(const Floorplan& plan,
          const std::vector<Eigen::AlignedBox2d>& boxes,
          std::size_t room)
{
  constexpr int places = 16;           // a side of the room's box
  constexpr double least_share = 0.02; // of them: less is a wall's thickness
  SlabBelow below;
  const PlanRoom& above = plan.rooms[room];
  const auto spotOf = [&](int k) {
    const Eigen::Vector2d part((k % places + 0.5) / places,
                               (k / places + 0.5) / places);
    return Eigen::Vector2d(boxes[room].min() + boxes[room].sizes().cwiseProduct(part));
  };
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    if (r == room || !boxes[r].intersects(boxes[room]))
      continue;
    int met = 0;
    double thickness = thickest_slab;
    for (int k = 0; k < places * places; ++k) {
      const Eigen::Vector2d spot = spotOf(k);
      if (!above.contains(spot) || !plan.rooms[r].contains(spot))
        continue;
      const double gap = above.floorAt(spot) - plan.rooms[r].ceilingAt(spot);
      if (gap < thinnest_slab || gap > thickest_slab)
        continue;
      thickness = std::min(thickness, gap);
      ++met;
    }
    if (met <= least_share * places * places)
      continue;
    below.rooms.push_back({r, boxes[room].volume() * met / (places * places)});
    below.thickness = std::min(below.thickness, thickness);
  }
  return below;
}

/** @brief Writes slabs and the space boundaries on them. */
class SlabWriter {
public:
  explicit SlabWriter(IfcDocument& document)
      : document_(document)
      , slab_above_(document.rooms.size())
      , covered_(document.rooms.size(), 0)
  {
    for (const PlanRoom& room : document.plan.rooms)
      boxes_.push_back(boundsOf(room.boundary));
  }

  void write()
  {
    for (std::size_t r = 0; r < document_.rooms.size(); ++r)
      writeFloor(r);
    for (std::size_t r = 0; r < document_.rooms.size(); ++r) {
      if (covered_[r] < document_.rooms[r].room.area() / 2)
        writeCeiling(r);
      for (const auto& [name, slab] : slab_above_[r])
        writeBoundary(document_, r, name, slab);
    }
  }

private:
  struct Slab {
    std::string name;
    StepRef ref;
  };

  /** @brief Adds the slab behind a face of a room, downwards if its thickness is below
   * 0, and the space boundary on it. It is swept if the face is level and
   * `may_be_swept`, else a mesh on parts of the room. */
  std::optional<Slab> add(std::size_t r,
                          const char* part,
                          const PlanSlab& face,
                          double thickness,
                          bool is_assumed,
                          bool may_be_swept,
                          const std::vector<std::string>& parts,
                          const char* colour,
                          const char* kind)
  {
    const IfcRoom& written = document_.rooms[r];
    const PlanRoom& room = written.room;
    const std::string name = nameIn(room, part);
    const auto level = levelOf(face, boundsOf(room.boundary));
    IfcBody body;
    if (level && may_be_swept)
      body = document_.shapes.extrusion(room.boundary, {},
                                        std::min(*level, *level + thickness) -
                                            document_.groundOf(written.storey),
                                        std::abs(thickness));
    else {
      const TriangleMesh mesh = bodyOn(r, parts, thickness);
      if (mesh.empty())
        return std::nullopt;
      body = document_.shapes.faceSet(mesh);
    }
    const StepRef place = document_.placeIn(written.storey);
    const StepRef shape = document_.shapeOf(body, colour);
    const StepRef slab = document_.addElement("IFCSLAB", name, written.storey, place,
                                              shape, {symbol(kind)});
    document_.addQuantities(slab, name, "Qto_SlabBaseQuantities",
                            {{"LENGTH", "Width", std::abs(thickness)},
                             {"AREA", "GrossArea", std::abs(room.boundary.area())}});
    std::vector<Property> properties{
        {"ThicknessAssumed", typed("IFCBOOLEAN", logical(is_assumed))},
        {"Residual", typed("IFCLENGTHMEASURE", face.residual)},
        {"Points", typed("IFCINTEGER", integer(face.inliers))}};
    appendAccuracy(face.accuracy, properties);
    document_.addProperties(slab, name, "Pset_SEDR", properties);
    ++document_.model.slabs;
    writeBoundary(document_, r, name, slab, is_assumed ? "NOTDEFINED" : "INTERNAL");
    return Slab{name, slab};
  }

  void writeFloor(std::size_t r)
  {
    const IfcRoom& written = document_.rooms[r];
    const PlanRoom& room = written.room;
    const SlabBelow below = slabBelow(document_.plan, boxes_, r);
    const bool is_assumed = below.rooms.empty();
    std::vector<std::string> parts{"floor"};
    for (std::size_t d = 0; d < room.floor_details.size(); ++d)
      if (sideOf(room.floor_details[d], room.floor) < 0)
        parts.push_back("floor_detail_" + std::to_string(d + 1));
    const auto slab =
        add(r, "floor_slab", room.floor,
            -(is_assumed ? document_.settings.assumed_thickness : below.thickness),
            is_assumed, parts.size() == 1, parts, "slab",
            written.storey == 0 && is_assumed ? "BASESLAB" : "FLOOR");
    for (const auto& [room_below, area] : below.rooms)
      if (slab) {
        slab_above_[room_below].push_back(*slab);
        covered_[room_below] += area;
      }
  }

  void writeCeiling(std::size_t r)
  {
    const PlanRoom& room = document_.rooms[r].room;
    const bool has_recess =
        std::any_of(room.details.begin(), room.details.end(),
                    [&](const PlanDetail& d) { return sideOf(d, room.ceiling) > 0; });
    add(r, "ceiling_slab", room.ceiling, document_.settings.assumed_thickness, true,
        !has_recess && !hasSlopingCeiling(room), ceilingParts(room), "ceiling", "ROOF");
  }

  /** @brief Returns the parts of the ceiling with facets and recesses, without what
   * hangs below. */
  static std::vector<std::string> ceilingParts(const PlanRoom& room)
  {
    std::vector<std::string> parts{"ceiling"};
    for (std::size_t d = 0; d < room.details.size(); ++d)
      if (room.details[d].is_facet || sideOf(room.details[d], room.ceiling) > 0)
        parts.push_back("detail_" + std::to_string(d + 1));
    return parts;
  }

  /** @brief Returns the body above parts of a room. Above a level ceiling with recesses
   * its top is level; else it has one thickness. */
  TriangleMesh
  bodyOn(std::size_t r, const std::vector<std::string>& parts, double thickness) const
  {
    const IfcRoom& written = document_.rooms[r];
    const std::vector<std::size_t> triangles = written.trianglesOf(parts);
    double end = -std::numeric_limits<double>::infinity();
    const double sign = thickness < 0 ? -1 : 1;
    for (const std::size_t t : triangles)
      for (int k = 0; k < 3; ++k)
        end = std::max(end, sign * written.solid.corner(t, k).z());
    const bool has_slopes = hasSlopingCeiling(written.room);
    return lowered(prismOn(written.solid, triangles,
                           [&](const Eigen::Vector3d& p) {
                             return has_slopes ? p.z() + thickness
                                               : sign * end + thickness;
                           }),
                   document_.groundOf(written.storey));
  }

  IfcDocument& document_;
  std::vector<Eigen::AlignedBox2d> boxes_;    ///< of the rooms
  std::vector<std::vector<Slab>> slab_above_; ///< floors above each room
  std::vector<double> covered_;               ///< area below them
};

} // namespace

void
writeSlabs(IfcDocument& document)
{
  SlabWriter(document).write();
}

} // namespace pcl::sedr::ifc
