// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {
namespace ifc {

/** @brief An instance of a STEP file, #1, #2, ...; 0 is none. */
struct StepRef {
  std::size_t id = 0;

  bool isNone() const { return id == 0; }
};

/** @brief A text as STEP writes it (ISO 10303-21), in quotes: quotes and backslashes
 * doubled, what is not ASCII as \\X2\\00FC\\X0\\.
 * @param utf8 bytes that are no UTF-8 become "?" */
std::string stepText(const std::string& utf8);

/** @brief A number as STEP writes it, with a point: "1.", "0.25"; ten decimals. */
std::string stepReal(double value);

/** @brief The value of an attribute, as it stands in the file. */
class StepValue {
public:
  StepValue(StepRef ref)
      : text_(ref.isNone() ? "$" : "#" + std::to_string(ref.id))
  {}
  StepValue(double value)
      : text_(stepReal(value))
  {}
  StepValue(const char* text)
      : text_(stepText(text))
  {}
  StepValue(const std::string& text)
      : text_(stepText(text))
  {}
  StepValue(const std::vector<StepRef>& refs);
  StepValue(const std::vector<double>& values);
  StepValue(bool) = delete; ///< see logical()

  /** @brief $: an optional attribute that has no value. */
  static StepValue none() { return StepValue(Written{"$"}); }
  /** @brief *: an attribute that a subtype derives. */
  static StepValue derived() { return StepValue(Written{"*"}); }
  static StepValue logical(bool value) { return enumerated(value ? "T" : "F"); }
  static StepValue enumerated(const std::string& name)
  {
    return StepValue(Written{"." + name + "."});
  }
  static StepValue integer(std::int64_t value)
  {
    return StepValue(Written{std::to_string(value)});
  }
  /** @brief A value whose type must be told: IFCLENGTHMEASURE(0.2). */
  static StepValue typed(const std::string& type, const StepValue& value)
  {
    return StepValue(Written{type + "(" + value.text_ + ")"});
  }
  static StepValue list(const std::vector<StepValue>& values);

  const std::string& text() const { return text_; }

private:
  struct Written {
    std::string text;
  };
  explicit StepValue(Written written)
      : text_(std::move(written.text))
  {}

  std::string text_;
};

/** @brief The instances of a STEP file, in the order in which they were added. */
class StepFile {
public:
  /** @param type such as "IFCWALL" */
  StepRef add(const std::string& type, const std::vector<StepValue>& attributes);

  std::size_t size() const { return count_; }

  /** @brief The whole file.
   * @param description of the header, such as the view definition
   * @param name of the file, for the header
   * @param schema such as "IFC4" */
  std::string text(const std::string& description,
                   const std::string& name,
                   const std::string& schema) const;

private:
  std::size_t count_ = 0;
  std::string data_;
};

} // namespace ifc
} // namespace sedr
} // namespace pcl
