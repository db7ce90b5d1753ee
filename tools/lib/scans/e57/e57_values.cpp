// SPDX-License-Identifier: BSD-3-Clause
#include "e57_values.h"

#include <algorithm>
#include <cstring>

namespace pcl::sedr::tools {

namespace {

template <typename T>
void
readReals(const std::uint8_t* bytes, std::size_t size, double* values)
{
  for (std::size_t i = 0; i < size; ++i) {
    T value{};
    std::memcpy(&value, bytes + i * sizeof value, sizeof value);
    values[i] = static_cast<double>(value);
  }
}

/** @brief Returns the number stored in `bits` bits from bit `at` on. */
std::uint64_t
bitsAt(const std::uint8_t* bytes, std::uint64_t at, unsigned bits)
{
  const auto* first = bytes + at / 8;
  const auto skipped = static_cast<unsigned>(at % 8);
  std::uint64_t word = 0;
  std::memcpy(&word, first, sizeof word);
  word >>= skipped;
  if (skipped + bits > 64) // the remainder is in a ninth byte
    word |= std::uint64_t{first[8]} << (64 - skipped);
  return bits < 64 ? word & ((std::uint64_t{1} << bits) - 1) : word;
}

double
valueOf(const E57Field& field, std::uint64_t stored)
{
  // Unsigned, as the sum may exceed a signed integer.
  const auto raw =
      static_cast<std::int64_t>(static_cast<std::uint64_t>(field.minimum) + stored);
  return static_cast<double>(raw) * field.scale + field.offset;
}

} // namespace

void
readE57Values(const E57Field& field,
              const E57Bytes& list,
              std::size_t first,
              std::size_t size,
              double* values)
{
  if (field.bits == 0) {
    std::fill_n(values, size, valueOf(field, 0));
    return;
  }
  const auto* bytes = list.bytes.data();
  if (field.kind == E57Field::Kind::Float)
    return readReals<float>(bytes + first * sizeof(float), size, values);
  if (field.kind == E57Field::Kind::Double)
    return readReals<double>(bytes + first * sizeof(double), size, values);
  const std::uint64_t begin = list.first_bit + std::uint64_t{first} * field.bits;
  for (std::size_t i = 0; i < size; ++i)
    values[i] = valueOf(field, bitsAt(bytes, begin + i * field.bits, field.bits));
}

} // namespace pcl::sedr::tools
