// SPDX-License-Identifier: BSD-3-Clause
#include "las_reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::sedr::tools {

namespace {

constexpr std::size_t intensity_offset = 12; // in a record, after three integers

} // namespace

LasReader::LasReader(const MappedFile& file, const LasHeader& header)
    : file_(file)
    , header_(header)
    , rows_(header)
{
  if (header_.colour_offset == 0)
    return;
  // Multiples of the golden ratio: in no step with what repeats in a file.
  constexpr std::size_t max_looked_at = 10000;
  constexpr double golden = 0.6180339887498949;
  const std::size_t looked_at = std::min(size(), max_looked_at);
  for (std::size_t k = 0; k < looked_at; ++k) {
    const double share = static_cast<double>(k) * golden;
    const auto row = static_cast<std::size_t>((share - std::floor(share)) *
                                              static_cast<double>(size()));
    rows_.lookAt(pointIn(file_.data() + placeOf(std::min(row, size() - 1))));
  }
}

LasPoint
LasReader::pointIn(const std::uint8_t* record) const
{
  LasPoint point;
  std::memcpy(point.whole.data(), record, sizeof point.whole);
  std::memcpy(&point.intensity, record + intensity_offset, sizeof point.intensity);
  if (header_.colour_offset > 0)
    std::memcpy(point.colour.data(), record + header_.colour_offset,
                sizeof point.colour);
  return point;
}

void
LasReader::read(std::size_t first, std::size_t size, std::uint8_t* rows) const
{
  const auto* record = file_.data() + placeOf(first);
  for (std::size_t i = 0; i < size; ++i, record += header_.record)
    rows = rows_.write(pointIn(record), rows);
}

std::shared_ptr<const PointReader>
openLas(const MappedFile& file, const std::string& path)
{
  const LasHeader header = readLasHeader(file, path);
  if (header.is_compressed)
    return openLaz(file, path, header);
  return std::make_shared<LasReader>(file, header);
}

} // namespace pcl::sedr::tools
