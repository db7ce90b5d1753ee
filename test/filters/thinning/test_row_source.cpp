// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/field_access.h"
#include <pcl/sedr_filters/point_view.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using Field = pcl::PCLPointField;

Field
field(const std::string& name, std::uint8_t type, unsigned offset)
{
  Field f;
  f.name = name;
  f.datatype = type;
  f.offset = offset;
  f.count = 1;
  return f;
}

/** Returns rows of 40 bytes; x, y and z of row i are i, i + 0.25 and -i. */
std::vector<std::uint8_t>
rowsOf(const std::vector<Field>& fields, std::size_t size)
{
  std::vector<std::uint8_t> rows(40 * size, 0xee);
  for (std::size_t i = 0; i < size; ++i) {
    const auto value = static_cast<double>(i);
    for (const auto& [name, v] : {std::pair<const char*, double>{"x", value},
                                  {"y", value + 0.25},
                                  {"z", -value}}) {
      const Field& f = *findField(fields, name);
      writeField(&rows[40 * i + f.offset], f.datatype, v);
    }
  }
  return rows;
}

void
expectCoordinates(const PointView& points, std::size_t size)
{
  ASSERT_EQ(points.size(), size);
  for (std::size_t i = 0; i < size; ++i) {
    const auto value = static_cast<float>(i);
    ASSERT_EQ(points[i], Eigen::Vector3f(value, value + 0.25f, -value));
  }
}

TEST(RowCoordinates, StandWhereTheyAreIfTheyAreThreeFloatsInARow)
{
  const std::vector<Field> fields{
      field("label", Field::UINT32, 0), field("x", Field::FLOAT32, 5), // unaligned
      field("y", Field::FLOAT32, 9), field("z", Field::FLOAT32, 13)};
  std::vector<std::uint8_t> rows = rowsOf(fields, 10);
  RowCoordinates coordinates(fields, 40);
  const PointView points = coordinates.of(rows.data(), 10);
  expectCoordinates(points, 10);
  writeField(&rows[40 * 3 + 5], Field::FLOAT32, 77);
  EXPECT_EQ(points[3].x(), 77.f) << "no copy";
}

TEST(RowCoordinates, OfAnyOrderTypeAndGapAreCopied)
{
  const std::vector<std::vector<Field>> layouts{
      {field("z", Field::FLOAT32, 0), field("y", Field::FLOAT32, 4),
       field("x", Field::FLOAT32, 8)},
      {field("x", Field::FLOAT32, 0), field("y", Field::FLOAT32, 4),
       field("z", Field::FLOAT32, 12)},
      {field("x", Field::FLOAT64, 0), field("y", Field::FLOAT64, 8),
       field("z", Field::FLOAT64, 16)},
      {field("x", Field::FLOAT32, 0), field("y", Field::FLOAT32, 4),
       field("z", Field::INT32, 8)},
      {field("x", Field::INT32, 30), field("y", Field::FLOAT64, 1),
       field("z", Field::FLOAT32, 11)}};
  for (const auto& fields : layouts)
    for (const unsigned threads : {1u, 4u}) {
      const std::vector<std::uint8_t> rows = rowsOf(fields, 10000);
      RowCoordinates coordinates(fields, 40);
      expectCoordinates(coordinates.of(rows.data(), 10000, threads), 10000);
      expectCoordinates(coordinates.of(rows.data(), 7, threads), 7);
      EXPECT_EQ(coordinates.of(rows.data(), 0, threads).size(), 0u);
    }
}

} // namespace
