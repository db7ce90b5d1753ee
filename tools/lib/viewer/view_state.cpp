// SPDX-License-Identifier: BSD-3-Clause
#include "view_state.h"

#include "tool_error.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <sstream>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the index of a name in a list; throws ToolError if it is unknown. */
std::size_t
placeOf(const std::string& name,
        const std::vector<std::string>& names,
        const char* kind)
{
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw ToolError("there is no " + std::string(kind) + " '" + name +
                    "'; there are: " + boost::join(names, ", "));
  return static_cast<std::size_t>(found - names.begin());
}

bool
isScan(Layer layer)
{
  return layer == Layer::Raw || layer == Layer::Thinned;
}

} // namespace

const std::vector<std::string>&
layerNames()
{
  static const std::vector<std::string> names{"raw",  "thinned", "structure",
                                              "plan", "mesh",    "solid"};
  return names;
}

const std::vector<std::string>&
colouringNames()
{
  static const std::vector<std::string> names{"plain", "label", "room", "distance"};
  return names;
}

const std::vector<std::string>&
viewPointNames()
{
  static const std::vector<std::string> names{"top", "iso", "inside"};
  return names;
}

const char*
toString(Layer layer)
{
  return layerNames()[static_cast<std::size_t>(layer)].c_str();
}

LayerSet
layersOf(const std::string& names)
{
  LayerSet layers;
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');) {
    const auto layer = static_cast<Layer>(placeOf(name, layerNames(), "layer"));
    if (!layers.has(layer))
      layers.flip(layer);
  }
  return layers;
}

Colouring
colouringOf(const std::string& name)
{
  return static_cast<Colouring>(placeOf(name, colouringNames(), "colouring"));
}

ViewPoint
viewPointOf(const std::string& name)
{
  return static_cast<ViewPoint>(placeOf(name, viewPointNames(), "view"));
}

void
ViewState::moveClipping(double by, HeightRange range)
{
  if (!isClipped()) {
    if (by < 0)
      clip_height = range.high;
    return;
  }
  constexpr double least = 0.01; // metres above the bottom, to leave something visible
  clip_height += by;
  if (clip_height > range.high)
    clip_height = no_clipping;
  else
    clip_height = std::max(clip_height, range.low + least);
}

bool
ViewState::toggleStorey(std::uint32_t number)
{
  if (std::find(storeys.begin(), storeys.end(), number) == storeys.end())
    return false;
  storey = storey == number ? 0 : number;
  return true;
}

bool
ViewState::isShownLeft(Layer layer) const
{
  if (!two_views || !isScan(layer))
    return false;
  const bool none_asked_for = !layers.has(Layer::Raw) && !layers.has(Layer::Thinned);
  return layers.has(layer) || (none_asked_for && layer == Layer::Raw);
}

bool
ViewState::isShownRight(Layer layer) const
{
  return layers.has(layer) && !(two_views && isScan(layer));
}

} // namespace pcl::sedr::tools
