// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/floorplan_ifc.h>

#include "ifc_document.h"
#include "ifc_parts.h"

#include <utility>

namespace pcl::sedr {

IfcModel
writeIfc(const Floorplan& plan, const IfcSettings& settings, const Origin& origin)
{
  ifc::IfcDocument document(plan, settings, origin);
  ifc::writeSpaces(document);
  ifc::writeOpenings(document, ifc::writeWalls(document));
  ifc::writeSlabs(document);
  ifc::writeDetails(document);
  document.finish();
  document.model.text = document.step.text("ViewDefinition [ReferenceView_V1.2]",
                                           settings.name + ".ifc", "IFC4");
  return std::move(document.model);
}

} // namespace pcl::sedr
