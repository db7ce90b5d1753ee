// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What of a result can be shown. */
enum class Layer { Raw, Thinned, Structure, Plan, Mesh, Solid };

constexpr std::array<Layer, 6> all_layers{Layer::Raw,  Layer::Thinned, Layer::Structure,
                                          Layer::Plan, Layer::Mesh,    Layer::Solid};

const char* toString(Layer layer);

/** @brief A set of layers. */
class LayerSet {
public:
  LayerSet() = default;
  LayerSet(std::initializer_list<Layer> layers)
  {
    for (const auto layer : layers)
      flip(layer);
  }

  bool has(Layer layer) const { return bits_[static_cast<std::size_t>(layer)]; }
  void flip(Layer layer) { bits_.flip(static_cast<std::size_t>(layer)); }
  bool empty() const { return bits_.none(); }
  bool operator==(const LayerSet& other) const { return bits_ == other.bits_; }

private:
  std::bitset<all_layers.size()> bits_;
};

/** @brief What the colours of points and faces mean. */
enum class Colouring {
  Plain, ///< clouds by height, from dark to light; surfaces by label
  Label,
  Room,
  Distance ///< from the mesh
};

/** @brief Where the camera stands. */
enum class ViewPoint { Top, Iso, Inside };

const std::vector<std::string>& layerNames();
const std::vector<std::string>& colouringNames();
const std::vector<std::string>& viewPointNames();

/** @brief The lowest and the highest that can be clipped, metres. */
struct HeightRange {
  double low = 0;
  double high = 0;
};

/** @brief All that keys and options change of what is seen. */
struct ViewState {
  static constexpr double no_clipping = std::numeric_limits<double>::infinity();

  LayerSet layers;
  Colouring colouring = Colouring::Label;
  ViewPoint view_point = ViewPoint::Iso;
  bool ceiling = true;
  double clip_height = no_clipping; ///< what is higher is not shown, metres
  bool edges = true;                ///< of the solid
  bool legend = true;
  bool two_views = false;             ///< the scan at the left, the model at the right
  double point_size = 2;              ///< pixels
  std::uint32_t storey = 0;           ///< number of the only one that is shown; 0: all
  std::vector<std::uint32_t> storeys; ///< numbers of those that there are

  bool isClipped() const { return clip_height < no_clipping; }

  /** @brief Moves the clipping height by some metres. From above `range` it comes down
   * to its top first, and goes back to no clipping from there; it stays above the
   * bottom. */
  void moveClipping(double by, HeightRange range);

  /** @brief Shows one storey alone, or all again where it was alone already.
   * @return false where there is no such storey */
  bool toggleStorey(std::uint32_t number);

  /** @brief The layers of the left of two views: clouds of the scan. Of them the raw
   * one if neither is asked for. */
  bool isShownLeft(Layer layer) const;

  /** @brief The layers of the only view, or of the right one. */
  bool isShownRight(Layer layer) const;
};

/** @brief Layers by their names, "raw,plan". Throws a ToolError for another name. */
LayerSet layersOf(const std::string& names);

Colouring colouringOf(const std::string& name);

ViewPoint viewPointOf(const std::string& name);

} // namespace tools
} // namespace sedr
} // namespace pcl
