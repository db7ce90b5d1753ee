// SPDX-License-Identifier: BSD-3-Clause
#include "band_grid.h"

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
    for (std::size_t n = 0; n < 27; ++n) {
      const std::size_t other = find(around(block, n));
      neighbours_[b][n] = static_cast<std::uint32_t>(other);
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
BandGrid::around(const Block& block, std::size_t n)
{
  const auto step = static_cast<std::int64_t>(n);
  return {block[0] + step % 3 - 1, block[1] + step / 3 % 3 - 1,
          block[2] + step / 9 - 1};
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
