// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../walls/wall_band.h"
#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Text of a DXF file: pairs of a group code and a value, one per line. */
class DxfText {
public:
  DxfText& group(int code, const std::string& value)
  {
    text_ += std::to_string(code) + "\n" + value + "\n";
    return *this;
  }
  DxfText& group(int code, const char* value)
  {
    return group(code, std::string(value));
  }
  DxfText& group(int code, double value) { return group(code, decimalText(value, 7)); }
  DxfText& group(int code, int value)
  {
    // The code tells the type of the value: these have reals, which need a point.
    const bool is_real = (code >= 10 && code < 60) || (code >= 110 && code < 150) ||
                         (code >= 210 && code < 240) || (code >= 460 && code < 470);
    return is_real ? group(code, 1. * value) : group(code, std::to_string(value));
  }

  /** @brief Adds several pairs. */
  template <typename Value, typename... Rest>
  DxfText& group(int code, const Value& value, int next, const Rest&... rest)
  {
    return group(code, value).group(next, rest...);
  }

  DxfText& place(const Eigen::Vector2d& p, int x_code = 10)
  {
    return group(x_code, p.x()).group(x_code + 10, p.y()).group(x_code + 20, 0.0);
  }
  DxfText& append(const DxfText& other)
  {
    text_ += other.text_;
    return *this;
  }
  const std::string& text() const { return text_; }

private:
  std::string text_;
};

constexpr const char* paper_space = "*Paper_Space"; ///< block of the layout

/** @brief Numbers of the objects of a file, hexadecimal. */
struct DxfHandles {
  unsigned last = 0;
  std::string next() { return formatText("%X", ++last); }
};

/** @brief The entities of a block: of the model, or of one that is inserted. */
class DxfBlock {
public:
  using Attribute = std::pair<std::string, std::string>; ///< its tag and its value

  DxfBlock(DxfHandles& handles, std::string name, int flags = 0)
      : handles_(handles)
      , name_(std::move(name))
      , flags_(flags)
      , record_(handles.next())
  {}

  void line(const char* layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

  /** @brief Adds a segment, arc or circle. */
  void element(const char* layer, const PlanElement& e);

  /** @brief Adds a loop as one closed polyline, arcs as bulges. */
  void outline(const char* layer, const PlanLoop& loop);

  /** @brief Adds a filled area; arcs become chords within 0.1 mm. */
  void hatch(const char* layer, const PlanArea& area);

  /** @brief Adds a line of text about a place, `height` units high.
   * @param text UTF-8 */
  void label(const char* layer,
             const Eigen::Vector2d& at,
             double height,
             const std::string& text,
             double degrees = 0,
             bool begins_there = false);

  /** @brief What a viewport on paper shows: a box of the paper, and the model there. */
  struct View {
    Eigen::AlignedBox2d box;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero(); ///< of it, in the turned model
    double height = 1;                                ///< of it, in the model
    double degrees = 0; ///< that the model is turned by, counter-clockwise
  };

  /** @param number 1: of the paper itself */
  void viewport(const char* layer, const View& view, int number);

  /** @brief A dimension that programs measure again, metres. */
  struct Dimension {
    Eigen::Vector2d from; ///< what it measures
    Eigen::Vector2d to;
    Eigen::Vector2d end;  ///< of its line
    Eigen::Vector2d text; ///< place of its text
    double degrees = 0;   ///< of its line
  };

  /** @param shown block that displays it */
  void
  dimension(const char* layer, const Dimension& dimension, const std::string& shown);

  /** @brief Declares invisible attributes that insertions of this block have. */
  void declare(const char* layer, const std::vector<Attribute>& attributes);

  /** @brief Adds an insertion of a block with values of its attributes. */
  void insert(const char* layer,
              const std::string& block,
              const Eigen::Vector2d& at,
              double degrees,
              const std::vector<Attribute>& attributes);

  const std::string& name() const { return name_; }
  const std::string& record() const { return record_; }
  const DxfText& entities() const { return entities_; }

  /** @brief Returns the block for the section of blocks. */
  DxfText definition(bool has_entities) const;

private:
  DxfText& begin(const char* type, const char* layer, const char* kind);
  void attribute(const char* type,
                 const char* layer,
                 const Eigen::Vector2d& at,
                 const Attribute& attribute);

  DxfHandles& handles_;
  std::string name_;
  int flags_;
  std::string record_; ///< handle of its record
  DxfText entities_;
};

/** @brief A layer of a DXF. */
struct DxfLayer {
  const char* name;
  int colour; ///< index of AutoCAD's palette
  bool is_dashed;
  double width; ///< millimetres; 0: the default
  bool is_plotted = true;
};

/** @brief A DXF of release 2013 (AC1027), texts in UTF-8, one unit a metre. */
class DxfFile {
public:
  /** @param text_height of dimensions, metres */
  DxfFile(std::vector<DxfLayer> layers, double text_height)
      : layers_(std::move(layers))
      , text_height_(text_height)
  {}

  DxfBlock& model() { return model_; }

  /** @brief Returns the layout for printing, in millimetres. */
  DxfBlock& paper() { return paper_; }

  /** @brief Sets its name and size. */
  void setPaper(const std::string& name, const Eigen::Vector2d& size)
  {
    paper_name_ = name;
    paper_size_ = size;
  }

  /** @brief Adds a block; references to it remain valid.
   * @param flags 1: of a dimension, 2: it has attributes */
  DxfBlock& addBlock(const std::string& name, int flags);

  /** @param comments before the header */
  std::string text(const Eigen::AlignedBox2d& bounds,
                   const std::vector<std::string>& comments);

private:
  DxfText tables(const Eigen::AlignedBox2d& bounds);
  DxfText table(const char* name, const std::vector<DxfText>& records);
  DxfText record(const char* type, const char* kind, const std::string& name);
  DxfText objects();

  /** @param layout handle of it */
  DxfText layout(const std::string& layout,
                 const std::string& owner,
                 const std::string& name,
                 const DxfBlock& block) const;

  std::vector<DxfLayer> layers_;
  double text_height_;
  DxfHandles handles_;
  DxfBlock model_{handles_, "*Model_Space"};
  DxfBlock paper_{handles_, paper_space};
  std::string model_layout_ = handles_.next();
  std::string paper_layout_ = handles_.next();
  std::string paper_name_;
  Eigen::Vector2d paper_size_ = Eigen::Vector2d::Zero();
  std::deque<DxfBlock> blocks_;
};

} // namespace pcl::sedr
