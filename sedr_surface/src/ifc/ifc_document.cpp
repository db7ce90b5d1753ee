// SPDX-License-Identifier: BSD-3-Clause
#include "ifc_parts.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/string_generator.hpp>
#include <boost/uuid/uuid.hpp>

#include <algorithm>
#include <map>

namespace pcl::sedr::ifc {

IfcDocument::IfcDocument(const Floorplan& of_plan,
                         const IfcSettings& with_settings,
                         const Origin& origin)
    : plan(of_plan)
    , settings(with_settings)
    , shapes(step, with_settings.arcs)
{
  addRooms();
  addProject(origin);
}

/** @brief It is the UUID of version 5 (RFC 4122) in the 22 letters of IFC, two for the
 * first byte and four for every three further bytes. */
std::string
IfcDocument::guid(const std::string& name) const
{
  constexpr const char* letters =
      "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";
  // The name space is SEDR's own, a random UUID.
  static const boost::uuids::uuid space =
      boost::uuids::string_generator()("6f1c2a54-3f0b-4c8e-9d27-5b6f0e7a9c31");
  const boost::uuids::uuid uuid = boost::uuids::name_generator_sha1(space)(
      settings.name + "/" + settings.scan + "/" + name);
  std::string text{letters[uuid.data[0] >> 6], letters[uuid.data[0] & 63]};
  for (int i = 1; i < 16; i += 3) {
    const int three = uuid.data[i] << 16 | uuid.data[i + 1] << 8 | uuid.data[i + 2];
    for (int shift = 18; shift >= 0; shift -= 6)
      text += letters[three >> shift & 63];
  }
  return text;
}

void
IfcDocument::addRooms()
{
  for (const PlanRoom& room : plan.rooms) {
    const IfcRoom& added = rooms.emplace_back(room);
    if (added.solid.empty())
      model.warnings.push_back(warningOf(WarningKind::IfcLoss,
                                         "no body in the IFC: " + added.report.problem,
                                         {}, room.id));
  }
}

StepRef
IfcDocument::addUnits()
{
  const auto unit = [&](const char* kind, const char* name) {
    return step.add("IFCSIUNIT", {derived, symbol(kind), none, symbol(name)});
  };
  const std::vector<StepRef> units{
      unit("LENGTHUNIT", "METRE"), unit("AREAUNIT", "SQUARE_METRE"),
      unit("VOLUMEUNIT", "CUBIC_METRE"), unit("PLANEANGLEUNIT", "RADIAN")};
  return step.add("IFCUNITASSIGNMENT", {units});
}

void
IfcDocument::addMapConversion(StepRef context, const Origin& origin)
{
  if (origin.isZero() && settings.crs.empty())
    return;
  const StepRef crs =
      step.add("IFCPROJECTEDCRS", {settings.crs.empty() ? "not told" : settings.crs,
                                   none, none, none, none, none, none});
  step.add("IFCMAPCONVERSION", {context, crs, origin.place.x(), origin.place.y(),
                                origin.place.z(), 1.0, 0.0, 1.0});
}

void
IfcDocument::addProject(const Origin& origin)
{
  const StepRef frame = shapes.axes(Eigen::Vector3d::Zero());
  const StepRef context = step.add("IFCGEOMETRICREPRESENTATIONCONTEXT",
                                   {none, "Model", integer(3), 0.00001, frame, none});
  const auto part = [&](const char* name, const char* view) {
    return step.add("IFCGEOMETRICREPRESENTATIONSUBCONTEXT",
                    {name, "Model", derived, derived, derived, derived, context, none,
                     symbol(view), none});
  };
  body_context = part("Body", "MODEL_VIEW");
  axis_context = part("Axis", "GRAPH_VIEW");
  const StepRef units = addUnits();
  const StepRef project =
      step.add("IFCPROJECT", {guid("project"), none, settings.name, none, none, none,
                              none, std::vector<StepRef>{context}, units});
  addMapConversion(context, origin);
  const StepValue whole = symbol("ELEMENT");
  const StepRef site_place = shapes.placement({}, Eigen::Vector3d::Zero());
  const StepRef site =
      step.add("IFCSITE", {guid("site"), none, "site", none, none, site_place, none,
                           none, whole, none, none, none, none, none});
  const StepRef building_place = shapes.placement(site_place, Eigen::Vector3d::Zero());
  const StepRef building =
      step.add("IFCBUILDING", {guid("building"), none, settings.name, none, none,
                               building_place, none, none, whole, none, none, none});
  relate("IFCRELAGGREGATES", "site of project", project, std::vector<StepRef>{site});
  relate("IFCRELAGGREGATES", "building of site", site, std::vector<StepRef>{building});
  addStoreys(building, building_place);
}

void
IfcDocument::addStoreys(StepRef building, StepRef building_placement)
{
  std::map<std::uint32_t, std::size_t> index_of;
  std::vector<StepRef> refs;
  for (const PlanStorey& storey : storeysOf(plan)) {
    const double ground = rounded(usualFloor(plan, storey));
    const StepRef place = shapes.placement(building_placement, {0, 0, ground});
    const std::string name = "storey_" + std::to_string(storey.number);
    const StepRef ref =
        step.add("IFCBUILDINGSTOREY", {guid(name), none, storey.name, none, none, place,
                                       none, none, symbol("ELEMENT"), ground});
    refs.push_back(ref);
    for (const std::uint32_t room : storey.rooms)
      index_of[room] = storeys.size();
    storeys.push_back({storey, ref, place, ground, {}, {}});
  }
  if (!refs.empty())
    relate("IFCRELAGGREGATES", "storeys of building", building, refs);
  for (IfcRoom& room : rooms)
    room.storey = index_of[room.room.id];
}

StepRef
IfcDocument::addElement(const std::string& type,
                        const std::string& name,
                        std::size_t storey,
                        StepRef placement,
                        StepRef shape,
                        const std::vector<StepValue>& more,
                        const std::string& tag)
{
  std::vector<StepValue> attributes{
      guid(name), none,      name,  none,
      none,       placement, shape, tag.empty() ? none : StepValue(tag)};
  attributes.insert(attributes.end(), more.begin(), more.end());
  const StepRef element = step.add(type, attributes);
  storeys[storey].elements.push_back(element);
  return element;
}

StepRef
IfcDocument::relate(const std::string& type,
                    const std::string& name,
                    const StepValue& relating,
                    const StepValue& related)
{
  return step.add(type, {guid(name), none, none, none, relating, related});
}

void
IfcDocument::addToType(const std::string& type,
                       const std::string& name,
                       StepRef element,
                       const std::vector<StepValue>& more)
{
  Type& known = types_[name];
  if (known.ref.isNone()) {
    std::vector<StepValue> attributes{guid(name), none, name, none, none,
                                      none,       none, none, none};
    attributes.insert(attributes.end(), more.begin(), more.end());
    known.ref = step.add(type, attributes);
  }
  known.elements.push_back(element);
}

void
IfcDocument::addProperties(StepRef object,
                           const std::string& object_name,
                           const std::string& set,
                           const std::vector<Property>& properties)
{
  if (properties.empty())
    return;
  std::vector<StepRef> values;
  for (const auto& [name, value] : properties)
    values.push_back(step.add("IFCPROPERTYSINGLEVALUE", {name, none, value, none}));
  const std::string name = set + " of " + object_name;
  const StepRef definition =
      step.add("IFCPROPERTYSET", {guid(name), none, set, none, values});
  relate("IFCRELDEFINESBYPROPERTIES", name + " defined", std::vector<StepRef>{object},
         definition);
}

void
IfcDocument::addQuantities(StepRef object,
                           const std::string& object_name,
                           const std::string& set,
                           const std::vector<Quantity>& quantities)
{
  std::vector<StepRef> values;
  for (const Quantity& quantity : quantities)
    values.push_back(
        step.add(std::string("IFCQUANTITY") + quantity.kind,
                 {quantity.name, none, none, rounded(quantity.value), none}));
  const std::string name = set + " of " + object_name;
  const StepRef definition =
      step.add("IFCELEMENTQUANTITY", {guid(name), none, set, none, none, values});
  relate("IFCRELDEFINESBYPROPERTIES", name + " defined", std::vector<StepRef>{object},
         definition);
}

StepRef
IfcDocument::placeIn(std::size_t storey)
{
  return shapes.placement(storeys[storey].placement, Eigen::Vector3d::Zero());
}

StepRef
IfcDocument::bodyOf(const IfcBody& body, const std::string& colour)
{
  shapes.colour(body.item, colour);
  return shapes.body(body_context, body.type, {body.item});
}

StepRef
IfcDocument::shapeOf(const IfcBody& body, const std::string& colour)
{
  return shapes.product({bodyOf(body, colour)});
}

void
IfcDocument::finish()
{
  for (const IfcStorey& storey : storeys) {
    const std::string name = "storey_" + std::to_string(storey.storey.number);
    if (!storey.spaces.empty())
      relate("IFCRELAGGREGATES", "spaces of " + name, storey.ref, storey.spaces);
    if (!storey.elements.empty())
      relate("IFCRELCONTAINEDINSPATIALSTRUCTURE", "elements of " + name,
             storey.elements, storey.ref);
  }
  for (const auto& [name, type] : types_)
    relate("IFCRELDEFINESBYTYPE", "elements of " + name, type.elements, type.ref);
}

StepValue
shareProperty(double share)
{
  return typed("IFCNORMALISEDRATIOMEASURE", std::clamp(share, 0.0, 1.0));
}

} // namespace pcl::sedr::ifc

pcl::sedr::IfcModel
pcl::sedr::writeIfc(const Floorplan& plan,
                    const IfcSettings& settings,
                    const Origin& origin)
{
  Floorplan numbered = plan;
  numberOpenings(numbered);
  ifc::IfcDocument document(numbered, settings, origin);
  ifc::writeSpaces(document);
  std::vector<ifc::WrittenWall> walls = ifc::writeWalls(document);
  ifc::writeOpenings(document, walls);
  ifc::describeWalls(document, walls);
  ifc::writeSlabs(document);
  ifc::writeDetails(document);
  ifc::writeStairs(document);
  document.finish();
  document.model.text =
      document.step.text(settings.name + ".ifc", settings.author, settings.date);
  return std::move(document.model);
}
