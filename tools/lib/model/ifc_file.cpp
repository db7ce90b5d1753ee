// SPDX-License-Identifier: BSD-3-Clause
#include "ifc_file.h"

#include "bytes/whole_file.h"

namespace pcl::sedr::tools {

void
addIfcOptions(Options& options, IfcOptions& ifc)
{
  options.text("ifc-arcs", ifc.arcs,
               "arcs of the IFC: exact, or faceted for programs that misread them",
               {"exact", "faceted"});
  options.text("ifc-name", ifc.settings.name,
               "name of the building in the IFC; its GUIDs are made of it");
  options.text("crs", ifc.settings.crs,
               "name of the grid that the coordinates are in, for the IFC: EPSG:25832");
  options.number("assumed-thickness", ifc.settings.assumed_thickness, "m",
                 "of walls and slabs of the IFC of which one face was seen",
                 Range::between(0.02, 2));
}

IfcSettings
settingsOf(const IfcOptions& ifc)
{
  IfcSettings settings = ifc.settings;
  settings.arcs = ifc.arcs == "faceted" ? IfcArcs::Facets : IfcArcs::Exact;
  return settings;
}

IfcModel
saveIfc(const std::string& path,
        const Floorplan& plan,
        const IfcSettings& settings,
        const Origin& origin)
{
  IfcModel model = writeIfc(plan, settings, origin);
  writeWhole(path, [&](std::ostream& stream) { stream << model.text; });
  return model;
}

} // namespace pcl::sedr::tools
