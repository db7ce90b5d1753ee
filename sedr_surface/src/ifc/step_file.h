// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/walls/plan_walls.h"

#include <pcl/sedr_surface/floorplan_ifc.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::ifc {

/** @brief The number of an instance in a STEP file: #1, #2, ...; 0 is none. */
struct StepRef {
  std::size_t id = 0;

  bool isNone() const { return id == 0; }
};

/** @brief Returns a text as a STEP string (ISO 10303-21): in quotes, with quotes and
 * backslashes doubled and characters beyond ASCII as \\X2\\00FC\\X0\\.
 * @param utf8 bytes that are no valid UTF-8 are left out */
std::string stepText(const std::string& utf8);

/** @brief Returns a number as in STEP, with a point and up to ten decimals: "1.",
 * "0.25". */
std::string stepReal(double value);

/** @brief The value of an attribute, as written to the file. */
class StepValue {
public:
  StepValue(StepRef ref)
      : text_(ref.isNone() ? "$" : "#" + std::to_string(ref.id))
  {}
  StepValue(double value)
      : text_(stepReal(value))
  {}
  StepValue(const char* text)
      : text_(stepText(text))
  {}
  StepValue(const std::string& text)
      : text_(stepText(text))
  {}
  StepValue(const std::vector<StepRef>& refs);
  StepValue(const std::vector<double>& values);
  StepValue(bool) = delete; ///< use logical()

  /** @brief Returns a value that is written as it is. */
  static StepValue written(std::string text)
  {
    StepValue value;
    value.text_ = std::move(text);
    return value;
  }

  const std::string& text() const { return text_; }

private:
  StepValue() = default;

  std::string text_;
};

/** @brief The value of an optional attribute without one; derived, of an attribute that
 * a subtype derives. */
inline const StepValue none = StepValue::written("$");
inline const StepValue derived = StepValue::written("*");

inline StepValue
symbol(const std::string& name)
{
  return StepValue::written("." + name + ".");
}

inline StepValue
logical(bool value)
{
  return symbol(value ? "T" : "F");
}

inline StepValue
integer(std::size_t value)
{
  return StepValue::written(std::to_string(value));
}

/** @brief Returns a value with its type: IFCLENGTHMEASURE(0.2). */
inline StepValue
typed(const std::string& type, const StepValue& value)
{
  return StepValue::written(type + "(" + value.text() + ")");
}

StepValue listOf(const std::vector<StepValue>& values);

/** @brief The instances of a STEP file, in the order of addition. */
class StepFile {
public:
  /** @param type such as "IFCWALL" */
  StepRef add(const std::string& type, const std::vector<StepValue>& attributes);

  /** @brief Returns the complete file.
   * @param name of the file, for the header, as are the next ones
   * @param date such as 2024-05-31; any other text is a fixed date, so that the same
   * plan gives the same bytes */
  std::string text(const std::string& name,
                   const std::string& author,
                   const std::string& date) const;

private:
  std::size_t count_ = 0;
  std::string data_;
};

/** @brief A body, and the type of the shapes that it is an item of. */
struct IfcBody {
  StepRef item{};
  const char* type = "SweptSolid"; ///< or "Tessellation"
};

/** @brief Writes geometry to an IFC file: placements, profiles and bodies. */
class IfcShapes {
public:
  IfcShapes(StepFile& step, IfcArcs arcs)
      : step_(step)
      , arcs_(arcs)
  {}

  /** @param p in space or in plan */
  StepRef point(const Eigen::VectorXd& p);
  StepRef direction(const Eigen::Vector3d& way);

  /** @brief Adds an IfcAxis2Placement3D. */
  StepRef axes(const Eigen::Vector3d& origin,
               const Eigen::Vector3d& z = Eigen::Vector3d::UnitZ(),
               const Eigen::Vector3d& x = Eigen::Vector3d::UnitX());

  /** @brief Adds an IfcLocalPlacement with z up, relative to `parent`. */
  StepRef placement(StepRef parent,
                    const Eigen::Vector3d& origin,
                    const Eigen::Vector2d& x = Eigen::Vector2d::UnitX());

  /** @brief Adds a closed loop as a curve: a polyline, or one with arcs. */
  StepRef closedCurve(const PlanLoop& loop);

  /** @brief Adds the area inside a loop and outside its holes, swept upwards.
   * @param run of a tilted wall: metres along y for each metre up; the loops are where
   * z is 0 */
  IfcBody extrusion(const PlanLoop& boundary,
                    const std::vector<PlanLoop>& holes,
                    double bottom,
                    double height,
                    double run = 0);

  /** @brief Adds a closed mesh as IfcTriangulatedFaceSet. */
  IfcBody faceSet(const TriangleMesh& mesh);

  /** @brief Gives a body the colour of a kind: "space", "wall", "slab", ... */
  void colour(StepRef body, const std::string& kind);

  /** @brief Adds an IfcProductDefinitionShape of shapes such as body() and line(). */
  StepRef product(const std::vector<StepRef>& shapes);

  /** @param type see IfcBody */
  StepRef
  body(StepRef context, const std::string& type, const std::vector<StepRef>& items);

  /** @brief Adds the axis of a wall between two places in plan. */
  StepRef line(StepRef context, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

private:
  StepRef polyline(const std::vector<Eigen::Vector2d>& corners, bool is_closed);
  StepRef indexedCurve(const PlanLoop& loop);
  StepRef styleOf(const std::string& kind);

  StepFile& step_;
  IfcArcs arcs_;
  std::map<std::string, StepRef> styles_;
};

/** @brief Returns a loop in the frame of a wall. */
PlanLoop inFrame(PlanLoop loop, const WallFrame& frame);

} // namespace pcl::sedr::ifc
