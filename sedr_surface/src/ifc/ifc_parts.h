// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../overhead/room_faces.h"
#include "../walls/wall_band.h"
#include "ifc_bodies.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_filters/src/walls/plan_walls.h"
#include "step_file.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_ifc.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::ifc {

/** @brief A named value of a property set. */
using Property = std::pair<std::string, StepValue>;

/** @brief A value of a quantity set; its kind is "LENGTH", "AREA" or "VOLUME". */
struct Quantity {
  const char* kind;
  std::string name;
  double value = 0;
};

/** @brief A room and the entities written for it so far. */
struct IfcRoom : RoomFaces {
  using RoomFaces::RoomFaces;
  std::size_t storey = 0; ///< index
  StepRef space;
  bool is_swept = false; ///< its space, from its plan
};

/** @brief A storey and the entities written for it so far. */
struct IfcStorey {
  PlanStorey storey;
  StepRef ref;
  StepRef placement;
  double ground = 0; ///< usual floor, metres
  std::vector<StepRef> spaces;
  std::vector<StepRef> elements;
};

/** @brief An IFC file under construction. The project and its storeys exist from the
 * start; their contents are added. */
class IfcDocument {
public:
  IfcDocument(const Floorplan& plan, const IfcSettings& settings, const Origin& origin);

  const Floorplan& plan;
  const IfcSettings& settings;
  StepFile step;
  IfcShapes shapes;
  IfcModel model;
  std::vector<IfcStorey> storeys;
  std::vector<IfcRoom> rooms; ///< in the order of the plan
  StepRef body_context;
  StepRef axis_context;

  /** @brief Returns the GlobalId of an object from its name, which is unique in the
   * model. */
  std::string guid(const std::string& name) const;

  /** @brief Adds an element to the storey of a room.
   * @param type such as "IFCCOLUMN"
   * @param more attributes that follow those of all elements
   * @param tag its number on the sheet, if it has one */
  StepRef addElement(const std::string& type,
                     const std::string& name,
                     std::size_t storey,
                     StepRef placement,
                     StepRef shape,
                     const std::vector<StepValue>& more,
                     const std::string& tag = {});

  void addProperties(StepRef object,
                     const std::string& object_name,
                     const std::string& set,
                     const std::vector<Property>& properties);

  void addQuantities(StepRef object,
                     const std::string& object_name,
                     const std::string& set,
                     const std::vector<Quantity>& quantities);

  /** @brief Makes an element one of a type, which is written once.
   * @param type such as "IFCDOORTYPE"
   * @param name of the type
   * @param more attributes that follow those of all types */
  void addToType(const std::string& type,
                 const std::string& name,
                 StepRef element,
                 const std::vector<StepValue>& more);

  /** @brief Adds a relation between two objects; its GlobalId is made from its name. */
  StepRef relate(const std::string& type,
                 const std::string& name,
                 const StepValue& relating,
                 const StepValue& related);

  /** @brief Returns the height of a storey, to which places in it refer. */
  double groundOf(std::size_t storey) const { return storeys[storey].ground; }

  /** @brief Adds a placement at the origin of a storey. */
  StepRef placeIn(std::size_t storey);

  /** @brief Colours a body and returns its representation. */
  StepRef bodyOf(const IfcBody& body, const std::string& colour);

  /** @brief Returns a shape of one body. */
  StepRef shapeOf(const IfcBody& body, const std::string& colour);

  /** @brief Adds the relations of spaces and elements to their storeys and types. */
  void finish();

private:
  struct Type {
    StepRef ref;
    std::vector<StepRef> elements;
  };

  void addProject(const Origin& origin);
  StepRef addUnits();
  void addMapConversion(StepRef context, const Origin& origin);
  void addStoreys(StepRef building, StepRef building_placement);
  void addRooms();

  std::map<std::string, Type> types_; ///< by name
};

/** @brief Returns a size rounded to a millimetre, an area or volume alike. */
inline double
rounded(double size)
{
  return std::round(1000 * size) / 1000;
}

/** @brief Returns a share as the value of a property. */
StepValue shareProperty(double share);

/** @brief Returns the confidence of a surface, 0 to 1: the share of it that was seen,
 * reduced where points lie off it. A residual of up to 2 cm is normal for scanners and
 * plaster; at twice that the confidence is half of the share.
 * @param seen share; below 0 if unknown, which is then the result
 * @param residual root mean square distance of the points, metres */
inline double
confidence(double seen, double residual)
{
  constexpr double tolerance = 0.02;
  return seen * std::min(1.0, tolerance / std::max(residual, tolerance));
}

/** @brief Returns the confidence of a wall face; -1 if nothing is known of it. */
inline double
confidenceOf(const PlanElement& face)
{
  return face.evidence.isKnown() ? confidence(face.evidence.seen, face.residual) : -1;
}

/** @brief Appends the accuracy of a surface to the properties of an element. */
void appendAccuracy(const SurfaceAccuracy& accuracy, std::vector<Property>& properties);

/** @brief A wall in the file. */
struct WrittenWall : WallBody {
  std::string name{};
  std::size_t storey = 0;
  StepRef ref{};
  StepRef placement{};         ///< of the frame, z from the wall's bottom
  std::vector<WallCut> cuts{}; ///< openings and niches in it
  bool is_external = false;
  std::string number{}; ///< on the sheet

  double bottom() const { return heights.bottom; }
  double top() const { return heights.highest(); }
};

/** @brief Adds a space with quantities for each room. */
void writeSpaces(IfcDocument& document);

/** @brief Adds the walls and the space boundaries on them. */
std::vector<WrittenWall> writeWalls(IfcDocument& document);

/** @brief Returns whether nothing of a wall is left: rooms cover its plan, or an
 * opening takes it from bottom to top. */
bool isWhollyOpen(const Floorplan& plan, const WrittenWall& wall);

/** @brief What an opening takes of a wall, with z from the wall's bottom. */
struct OpeningBox {
  /** @brief In the frame of the wall: that frame itself; in a curved wall, the centre
   * of its arc and the way of the opening. */
  WallFrame frame{Eigen::Vector2d::Zero(), Eigen::Vector2d::UnitX()};
  Eigen::AlignedBox2d plan; ///< in `frame`
  double bottom = 0;
  double top = 0;

  /** @brief Returns the outline in the frame of the wall. */
  PlanLoop loop() const
  {
    PlanLoop loop = loopAround(plan);
    for (PlanElement& e : loop.elements)
      e = segment(frame.toPlan(e.start), frame.toPlan(e.end));
    return loop;
  }
};

/** @brief A gap in a wall that was written. */
struct WrittenGap {
  const WrittenWall* wall = nullptr;
  StepRef opening;
  OpeningBox box;
};

/** @brief Adds an opening of a body to a wall. */
StepRef writeOpening(IfcDocument& document,
                     WrittenWall& wall,
                     const std::string& name,
                     const IfcBody& body,
                     const WallCut& cut);

/** @brief Adds openings, what fills them, and recesses for niches. */
void writeOpenings(IfcDocument& document, std::vector<WrittenWall>& walls);

/** @brief Adds quantities and properties of walls, and their schedule. */
void describeWalls(IfcDocument& document, const std::vector<WrittenWall>& walls);

/** @brief Adds slabs for floors, and for ceilings without a room above. */
void writeSlabs(IfcDocument& document);

/** @brief Adds columns, coverings, beams and platforms. */
void writeDetails(IfcDocument& document);

/** @brief Adds the stairs whose flights were seen. */
void writeStairs(IfcDocument& document);

/** @brief Adds a first-level boundary of a space, without geometry.
 * @param side "INTERNAL", or "NOTDEFINED" if the other side was not seen
 * @param kind "PHYSICAL", or "VIRTUAL" where nothing is built */
void writeBoundary(IfcDocument& document,
                   std::size_t room,
                   const std::string& element_name,
                   StepRef element,
                   const char* side = "INTERNAL",
                   const char* kind = "PHYSICAL");

/** @brief Returns the name of a part of a room: "room_1_wall". */
std::string nameIn(const PlanRoom& room, const std::string& part);

} // namespace pcl::sedr::ifc
