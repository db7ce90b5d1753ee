// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../formats/decimal_text.h"

#include <Eigen/Core>

#include <string>

namespace pcl::sedr {

/** @brief Text of a DXF file: pairs of a group code and a value, one per line. */
class DxfText {
public:
  DxfText& group(int code, const std::string& value)
  {
    text_ += std::to_string(code) + "\n" + value + "\n";
    return *this;
  }

  DxfText& group(int code, double value) { return group(code, decimalText(value, 7)); }

  DxfText& group(int code, int value) { return group(code, std::to_string(value)); }

  DxfText& place(const Eigen::Vector2d& p, int x_code = 10)
  {
    return group(x_code, p.x()).group(x_code + 10, p.y()).group(x_code + 20, 0.0);
  }

  DxfText&
  line(const std::string& layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    return group(0, "LINE").group(8, layer).place(from).place(to, 11);
  }

  /** @brief Appends a line of text centred at a place, `height` metres high. */
  DxfText& label(const std::string& layer,
                 const Eigen::Vector2d& at,
                 double height,
                 const std::string& text,
                 double degrees = 0)
  {
    group(0, "TEXT").group(8, layer).place(at).group(40, height).group(1, text);
    return group(50, degrees).group(72, 1).place(at, 11).group(73, 2);
  }

  DxfText& section(const std::string& name, const DxfText& content)
  {
    group(0, "SECTION").group(2, name);
    text_ += content.text_;
    return group(0, "ENDSEC");
  }

  DxfText& table(const std::string& name, int entries, const DxfText& content)
  {
    group(0, "TABLE").group(2, name).group(70, entries);
    text_ += content.text_;
    return group(0, "ENDTAB");
  }

  const std::string& text() const { return text_; }

private:
  std::string text_;
};

} // namespace pcl::sedr
