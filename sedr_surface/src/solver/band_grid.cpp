// SPDX-License-Identifier: BSD-3-Clause
#include "band_grid.h"

#include <algorithm>
#include <cstring>

namespace pcl::sedr {

BandGrid::BandGrid(std::vector<Key> keys)
    : keys_(std::move(keys))
{
  std::sort(keys_.begin(), keys_.end());
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  neighbours_.resize(keys_.size());
  at_rim_.assign(keys_.size(), false);
  for (std::size_t b = 0; b < keys_.size(); ++b) {
    const Block block = at(b);
    std::size_t i = 0;
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const std::size_t other = find({block[0] + dx, block[1] + dy, block[2] + dz});
          neighbours_[b][i++] = static_cast<std::uint32_t>(other);
          if (other == keys_.size())
            at_rim_[b] = true;
        }
  }
}

BandGrid::Key
BandGrid::keyOf(const Block& block)
{
  const auto part = [](std::int64_t c) { return static_cast<Key>(c + reach); };
  return part(block[2]) << 42 | part(block[1]) << 21 | part(block[0]);
}

BandGrid::Block
BandGrid::blockOf(Key key)
{
  const auto part = [key](int shift) {
    return static_cast<std::int64_t>((key >> shift) & 0x1fffff) - reach;
  };
  return {part(0), part(21), part(42)};
}

std::size_t
BandGrid::find(const Block& block) const
{
  const Key key = keyOf(block);
  const auto found = std::lower_bound(keys_.begin(), keys_.end(), key);
  return found != keys_.end() && *found == key
             ? static_cast<std::size_t>(found - keys_.begin())
             : keys_.size();
}

bool
BandGrid::holdsCell(std::size_t b, int x, int y, int z) const
{
  for (int c = 0; at_rim_[b] && c < 8; ++c)
    if (blockAt(b, x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)) == size())
      return false;
  return true;
}

void
BandGrid::gatherHalo(const std::vector<float>& values, std::size_t b, float* halo) const
{
  const auto place = [](int i) { return i < 0 ? 0 : i > 7 ? 2 : 1; };
  for (int z = -1; z <= 8; ++z)
    for (int y = -1; y <= 8; ++y) {
      const std::size_t row = static_cast<std::size_t>(place(z) * 9 + place(y) * 3);
      const std::size_t offset = nodeIndex(0, y & 7, z & 7);
      const auto* blocks = &neighbours_[b][row];
      *halo++ = values[blocks[0] * nodes + offset + 7];
      std::memcpy(halo, &values[blocks[1] * nodes + offset], 8 * sizeof(float));
      halo += 8;
      *halo++ = values[blocks[2] * nodes + offset];
    }
}

} // namespace pcl::sedr
