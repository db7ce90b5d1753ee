// SPDX-License-Identifier: BSD-3-Clause
#include "las_rows.h"

#include "point_reader.h"

#include <algorithm>
#include <cstring>

namespace pcl::sedr::tools {

LasRows::LasRows(const LasHeader& header)
    : scale_(header.scale)
    , shift_(header.shift)
    , has_colour_(header.colour_offset > 0)
    , fields_(decodedFields(has_colour_ ? std::vector<std::string>{"intensity", "rgb"}
                                        : std::vector<std::string>{"intensity"}))
{}

void
LasRows::lookAt(const LasPoint& point)
{
  constexpr unsigned bits_too_many = 8;
  if (*std::max_element(point.colour.begin(), point.colour.end()) > 0xff)
    colour_shift_ = bits_too_many;
}

std::uint8_t*
LasRows::write(const LasPoint& point, std::uint8_t* row) const
{
  const Eigen::Vector3d p =
      Eigen::Vector3d(point.whole[0], point.whole[1], point.whole[2])
          .cwiseProduct(scale_) +
      shift_;
  const auto strength = static_cast<float>(point.intensity);
  std::memcpy(row, p.data(), sizeof p);
  std::memcpy(row + sizeof p, &strength, sizeof strength);
  row += sizeof p + sizeof strength;
  if (!has_colour_)
    return row;
  for (std::size_t k = 0; k < point.colour.size(); ++k)
    row[k] =
        static_cast<std::uint8_t>(std::min(point.colour[2 - k] >> colour_shift_, 0xff));
  row[3] = 0xff;
  return row + sizeof(float);
}

} // namespace pcl::sedr::tools
