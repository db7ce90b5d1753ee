// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Parts of a result that can be shown. */
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

/** @brief Meaning of the colours of points and faces. */
enum class Colouring {
  Plain, ///< clouds by height, from dark to light; surfaces by label
  Label,
  Room,
  Distance ///< from the mesh
};

/** @brief Position of the camera. */
enum class ViewPoint { Top, Iso, Inside };

const std::vector<std::string>& layerNames();
const std::vector<std::string>& colouringNames();
const std::vector<std::string>& viewPointNames();

/** @brief Range of clipping heights, metres. */
struct HeightRange {
  double low = 0;
  double high = 0;
};

/** @brief The state of the display, set by keys and options. */
struct ViewState {
  static constexpr double no_clipping = std::numeric_limits<double>::infinity();

  LayerSet layers;
  Colouring colouring = Colouring::Label;
  ViewPoint view_point = ViewPoint::Iso;
  bool ceiling = true;
  double clip_height = no_clipping; ///< metres; higher parts are hidden
  bool edges = true;                ///< of the solid
  bool legend = true;
  bool two_views = false;             ///< scan on the left, model on the right
  double point_size = 2;              ///< pixels
  std::uint32_t storey = 0;           ///< number of the only visible storey; 0: all
  std::vector<std::uint32_t> storeys; ///< numbers of existing storeys

  bool isClipped() const { return clip_height < no_clipping; }

  /** @brief Moves the clipping height by some metres. From above `range` it first jumps
   * down to its top, and from there back to no clipping. It stays above the bottom. */
  void moveClipping(double by, HeightRange range);

  /** @brief Shows one storey alone, or all again if it was alone.
   * @return false if there is no such storey */
  bool toggleStorey(std::uint32_t number);

  /** @brief Returns whether the left of two views shows a layer: clouds of the scan,
   * the raw one if none is selected. */
  bool isShownLeft(Layer layer) const;

  /** @brief Returns whether the only or the right view shows a layer. */
  bool isShownRight(Layer layer) const;
};

/** @brief Parses layers by name, "raw,plan". Throws ToolError for another name. */
LayerSet layersOf(const std::string& names);

Colouring colouringOf(const std::string& name);

ViewPoint viewPointOf(const std::string& name);

} // namespace pcl::sedr::tools
