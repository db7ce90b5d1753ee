// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace pcl {
namespace sedr {

constexpr float code_limit = 1073741824.f; // 2^30

inline std::uint32_t
bitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/** @brief A number that orders floor(scaled) among all others, whatever its size: the
 * integer itself up to 2^30, beyond that the floats there are, counted. */
inline std::int32_t
codeOf(float scaled)
{
  if (std::abs(scaled) < code_limit) {
    const auto cell = static_cast<std::int32_t>(scaled);
    return cell - (scaled < static_cast<float>(cell) ? 1 : 0);
  }
  const auto beyond =
      static_cast<std::int32_t>(bitsOf(std::abs(scaled)) - bitsOf(code_limit));
  const auto code = static_cast<std::int32_t>(code_limit) + beyond;
  return scaled < 0 ? -code : code;
}

/** @brief The codes that occur along an axis, numbered in their order: stray points far
 * away cost a page each, not the emptiness between. */
class AxisRanks {
  static constexpr std::uint32_t page_bits = 12;
  static constexpr std::uint32_t page_size = 1u << page_bits;
  using Page = std::array<std::uint32_t, page_size>;

public:
  void mark(std::int32_t code)
  {
    const std::uint32_t lifted = lift(code);
    (*recent_.find(lifted >> page_bits, [&](std::uint32_t number) {
      return page(number);
    }))[lifted % page_size] = 1;
  }

  void merge(const AxisRanks& other)
  {
    for (const auto& entry : other.pages_)
      std::transform(entry.second->begin(), entry.second->end(),
                     page(entry.first)->begin(), page(entry.first)->begin(),
                     std::bit_or<>());
  }

  /** @brief Turns the marks into ranks from 0. */
  void number()
  {
    for (const auto& entry : pages_)
      for (auto& mark : *entry.second)
        if (mark != 0)
          mark = count_++;
  }

  /** @brief Bits that a rank takes. */
  unsigned bits() const
  {
    unsigned bits = 0;
    while (count_ > 1 && ((count_ - 1) >> bits) != 0)
      ++bits;
    return bits;
  }

private:
  /** @brief The pages used lately, by the end of their numbers. */
  template <typename PagePtr>
  class Recent {
  public:
    template <typename FindT>
    PagePtr find(std::uint32_t number, const FindT& find_page)
    {
      auto& slot = slots_[number % slots_.size()];
      if (!slot.second || slot.first != number)
        slot = {number, find_page(number)};
      return slot.second;
    }

  private:
    std::array<std::pair<std::uint32_t, PagePtr>, 16> slots_{};
  };

  static std::uint32_t lift(std::int32_t code)
  {
    return static_cast<std::uint32_t>(code) ^ 0x80000000u;
  }

  Page* page(std::uint32_t number)
  {
    auto& page = pages_[number];
    if (!page)
      page = std::make_unique<Page>(Page{});
    return page.get();
  }

  std::map<std::uint32_t, std::unique_ptr<Page>> pages_;
  Recent<Page*> recent_;
  std::uint32_t count_ = 0;

public:
  /** @brief Looks up ranks of marked codes; one a thread. */
  class Cursor {
  public:
    explicit Cursor(const AxisRanks& ranks)
        : ranks_(ranks)
    {}

    std::uint32_t operator()(std::int32_t code)
    {
      const std::uint32_t lifted = lift(code);
      return (*recent_.find(lifted >> page_bits, [&](std::uint32_t number) {
        return ranks_.pages_.at(number).get();
      }))[lifted % page_size];
    }

  private:
    const AxisRanks& ranks_;
    Recent<const Page*> recent_;
  };
};

} // namespace sedr
} // namespace pcl
