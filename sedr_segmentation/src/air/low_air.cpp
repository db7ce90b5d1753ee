// SPDX-License-Identifier: BSD-3-Clause
#include "low_air.h"

#include <cstddef>
#include <cstdlib>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Low gaps that hang together, and what is along their rim. */
struct Patch {
  std::vector<std::uint32_t> gaps;
  std::size_t rim = 0;        ///< sides of its columns
  std::size_t beside_air = 0; ///< of its rim: air with the same ceiling
  bool is_air = false;
};

class LowAir {
public:
  explicit LowAir(const AirGaps& gaps)
      : gaps_(gaps)
      , tall_(gaps.voxels(gaps.parameters().headroom))
      , step_(gaps.voxels(gaps.parameters().same_ceiling))
      , patch_of_(gaps.size(), AirGaps::none)
  {
    for (std::uint32_t g = 0; g < gaps.size(); ++g)
      if (!isTall(g) && patch_of_[g] == AirGaps::none)
        collect(g);
  }

  std::vector<std::uint8_t> run()
  {
    for (std::uint32_t p = 0; p < patches_.size(); ++p)
      decide(p);
    while (!front_.empty()) {
      const std::uint32_t p = front_.back();
      front_.pop_back();
      tellNeighbours(p);
    }
    std::vector<std::uint8_t> is_air(gaps_.size(), 0);
    for (std::uint32_t g = 0; g < gaps_.size(); ++g)
      is_air[g] = isTall(g) || patches_[patch_of_[g]].is_air ? 1 : 0;
    return is_air;
  }

private:
  bool isTall(std::uint32_t g) const { return gaps_[g].high - gaps_[g].low >= tall_; }

  bool ceilingGoesOn(std::uint32_t g, std::uint32_t o) const
  {
    return o != AirGaps::none && std::abs(gaps_[o].high - gaps_[g].high) <= step_;
  }

  void collect(std::uint32_t start)
  {
    const auto number = static_cast<std::uint32_t>(patches_.size());
    Patch patch;
    patch.gaps.push_back(start);
    patch_of_[start] = number;
    for (std::size_t k = 0; k < patch.gaps.size(); ++k) {
      const std::uint32_t g = patch.gaps[k];
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = gaps_.link(g, d);
        const bool has_ceiling = ceilingGoesOn(g, o);
        if (has_ceiling && !isTall(o) &&
            std::abs(gaps_[o].low - gaps_[g].low) <= step_) {
          if (patch_of_[o] == AirGaps::none) {
            patch_of_[o] = number;
            patch.gaps.push_back(o);
          }
          continue;
        }
        ++patch.rim;
        patch.beside_air += has_ceiling && isTall(o) ? 1 : 0;
      }
    }
    patches_.push_back(std::move(patch));
  }

  void decide(std::uint32_t p)
  {
    Patch& patch = patches_[p];
    const double share =
        static_cast<double>(patch.beside_air) / static_cast<double>(patch.rim);
    if (patch.is_air || share < gaps_.parameters().min_air)
      return;
    patch.is_air = true;
    front_.push_back(p);
  }

  /** @brief A patch that has become air is so along the rims of those beside it. */
  void tellNeighbours(std::uint32_t p)
  {
    for (const std::uint32_t g : patches_[p].gaps)
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = gaps_.link(g, d);
        if (!ceilingGoesOn(g, o) || isTall(o) || patch_of_[o] == p)
          continue;
        ++patches_[patch_of_[o]].beside_air;
        decide(patch_of_[o]);
      }
  }

  const AirGaps& gaps_;
  std::int32_t tall_;
  std::int32_t step_;
  std::vector<std::uint32_t> patch_of_; ///< of each low gap
  std::vector<Patch> patches_;
  std::vector<std::uint32_t> front_; ///< patches that have just become air
};

} // namespace

std::vector<std::uint8_t>
airOf(const AirGaps& gaps)
{
  return LowAir(gaps).run();
}

} // namespace pcl::sedr
