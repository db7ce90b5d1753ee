// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointField.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace pcl::sedr {

/** @brief Averages fields of any type over the rows of each voxel: numbers in double,
 * `rgb` and `rgba` by channel, `label` and `room` by majority; normals have unit
 * length.
 */
class FieldMeans {
public:
  /** @param fields the fields to average; the others of a row are not changed */
  FieldMeans(const std::vector<pcl::PCLPointField>& fields, std::size_t voxels);

  void add(std::size_t voxel, const std::uint8_t* row);

  /** @brief Writes the means of the `count` rows added to a voxel. */
  void write(std::size_t voxel, std::size_t count, std::uint8_t* row) const;

private:
  void normalise(std::uint8_t* row) const;

  enum class Kind { Number, Colour, Label };

  /** @brief One value of a row. */
  struct Value {
    Kind kind;
    std::size_t offset; ///< offset in the row, bytes
    std::uint8_t datatype;
    std::size_t place; ///< position among the sums or votes of a voxel
  };

  std::vector<Value> values_;
  std::vector<pcl::PCLPointField> normal_;
  std::size_t sums_a_voxel_ = 0;
  std::size_t votes_a_voxel_ = 0;
  std::vector<double> sums_;
  std::vector<std::map<double, std::size_t>> votes_;
};

} // namespace pcl::sedr
