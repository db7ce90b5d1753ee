// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/visualization/interactor_style.h>

#include <functional>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The mouse actions of PCL's visualizer with our own keys, which are passed on
 * by symbol. */
class KeyStyle : public pcl::visualization::PCLVisualizerInteractorStyle {
public:
  static KeyStyle* New();

  std::function<void(const std::string&)> on_key;

protected:
  void OnKeyDown() override;
  void OnKeyUp() override {}
  void OnChar() override {} // disables VTK's keys, such as w for wireframe
};

} // namespace tools
} // namespace sedr
} // namespace pcl
