// SPDX-License-Identifier: BSD-3-Clause
#include "las_reader.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

constexpr std::size_t intensity_offset = 12; // in a record, after three whole numbers

using Colour = std::array<std::uint16_t, 3>; // red, green, blue

} // namespace

LasReader::LasReader(const MappedFile& file, const std::string& path)
    : file_(file)
    , header_(readLasHeader(file, path))
    , fields_(decodedFields(header_.colour_offset > 0
                                ? std::vector<std::string>{"intensity", "rgb"}
                                : std::vector<std::string>{"intensity"}))
{
  constexpr unsigned bits_too_many = 8;
  if (header_.colour_offset > 0 && hasWideColours())
    colour_shift_ = bits_too_many;
}

bool
LasReader::hasWideColours() const
{
  constexpr std::size_t most_looked_at = 10000;
  const std::size_t step = std::max<std::size_t>(1, size() / most_looked_at);
  for (std::size_t i = 0; i < size(); i += step) {
    Colour colour{};
    std::memcpy(colour.data(), file_.data() + placeOf(i) + header_.colour_offset,
                sizeof colour);
    if (*std::max_element(colour.begin(), colour.end()) > 0xff)
      return true;
  }
  return false;
}

void
LasReader::read(std::size_t first, std::size_t size, std::uint8_t* rows) const
{
  const auto* record = file_.data() + placeOf(first);
  for (std::size_t i = 0; i < size; ++i, record += header_.record) {
    std::array<std::int32_t, 3> whole{};
    std::memcpy(whole.data(), record, sizeof whole);
    const Eigen::Vector3d p =
        Eigen::Vector3d(whole[0], whole[1], whole[2]).cwiseProduct(header_.scale) +
        header_.shift;
    std::uint16_t intensity = 0;
    std::memcpy(&intensity, record + intensity_offset, sizeof intensity);
    const auto strength = static_cast<float>(intensity);
    std::memcpy(rows, p.data(), sizeof p);
    std::memcpy(rows + sizeof p, &strength, sizeof strength);
    rows += sizeof p + sizeof strength;
    if (header_.colour_offset == 0)
      continue;
    Colour colour{};
    std::memcpy(colour.data(), record + header_.colour_offset, sizeof colour);
    for (std::size_t k = 0; k < colour.size(); ++k)
      rows[k] = static_cast<std::uint8_t>(colour[2 - k] >> colour_shift_);
    rows[3] = 0xff;
    rows += sizeof(float);
  }
}

} // namespace tools
} // namespace sedr
} // namespace pcl
