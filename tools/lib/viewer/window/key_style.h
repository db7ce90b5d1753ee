// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/visualization/interactor_style.h>

#include <functional>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The mouse of PCL's visualizer, and keys of our own in the place of its: they
 * are handed on by their symbol. */
class KeyStyle : public pcl::visualization::PCLVisualizerInteractorStyle {
public:
  static KeyStyle* New();

  std::function<void(const std::string&)> on_key;

protected:
  void OnKeyDown() override;
  void OnKeyUp() override {}
  void OnChar() override {} // VTK's own: w for wireframe and so on
};

} // namespace tools
} // namespace sedr
} // namespace pcl
