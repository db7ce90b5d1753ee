// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../overhead/ceiling_faces.h"
#include "ifc_shapes.h"
#include "step_file.h"

#include <pcl/sedr_surface/floorplan_ifc.h>

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
struct IfcRoom : CeilingFaces {
  using CeilingFaces::CeilingFaces;
  std::size_t storey = 0; ///< index
  StepRef space;
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

} // namespace pcl::sedr::ifc
