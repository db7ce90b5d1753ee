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
#include <vector>

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

/** @brief The codes that occur along an axis, numbered in their order. They are kept in
 * pages, so that stray points far away cost a page each and not the emptiness between;
 * where there are more pages than the points are worth, in a list. */
class AxisRanks {
  static constexpr std::uint32_t page_size = 1u << 12;
  using Page = std::array<std::uint32_t, page_size>;

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

public:
  /** @param points how many points there are: pages take up to 16 bytes for each */
  explicit AxisRanks(std::size_t points)
      : most_pages_(64 + points / 1024)
  {}

  void mark(std::int32_t code)
  {
    if (!is_list_) {
      const std::uint32_t lifted = lift(code);
      Page* const page = recent_.find(
          lifted / page_size, [&](std::uint32_t number) { return pageOf(number); });
      if (page) {
        (*page)[lifted % page_size] = 1;
        return;
      }
      becomeList();
    }
    if (list_.empty() || list_.back() != code)
      list_.push_back(code);
  }

  void merge(AxisRanks& other)
  {
    for (auto it = other.pages_.begin(); it != other.pages_.end() && !is_list_; ++it)
      if (Page* const page = pageOf(it->first))
        std::transform(it->second->begin(), it->second->end(), page->begin(),
                       page->begin(), std::bit_or<>());
      else
        becomeList();
    if (!is_list_ && !other.is_list_)
      return;
    becomeList();
    other.becomeList();
    list_.insert(list_.end(), other.list_.begin(), other.list_.end());
  }

  /** @brief Turns the marks into ranks from 0. */
  void number()
  {
    for (const auto& entry : pages_)
      for (auto& mark : *entry.second)
        if (mark != 0)
          mark = count_++;
    if (!is_list_)
      return;
    std::sort(list_.begin(), list_.end());
    list_.erase(std::unique(list_.begin(), list_.end()), list_.end());
    count_ = static_cast<std::uint32_t>(list_.size());
  }

  /** @brief Bits that a rank takes. */
  unsigned bits() const
  {
    unsigned bits = 0;
    while (count_ > 1 && ((count_ - 1) >> bits) != 0)
      ++bits;
    return bits;
  }

  /** @brief Looks up ranks of marked codes; one a thread. */
  class Cursor {
  public:
    explicit Cursor(const AxisRanks& ranks)
        : ranks_(ranks)
    {}

    std::uint32_t operator()(std::int32_t code)
    {
      if (ranks_.is_list_)
        return static_cast<std::uint32_t>(
            std::lower_bound(ranks_.list_.begin(), ranks_.list_.end(), code) -
            ranks_.list_.begin());
      const std::uint32_t lifted = lift(code);
      return (*recent_.find(lifted / page_size, [&](std::uint32_t number) {
        return ranks_.pages_.at(number).get();
      }))[lifted % page_size];
    }

  private:
    const AxisRanks& ranks_;
    Recent<const Page*> recent_;
  };

private:
  static std::uint32_t lift(std::int32_t code)
  {
    return static_cast<std::uint32_t>(code) ^ 0x80000000u;
  }

  /** @brief The page of this number, made if need be; null if that were one too many.
   */
  Page* pageOf(std::uint32_t number)
  {
    const auto it = pages_.find(number);
    if (it != pages_.end())
      return it->second.get();
    if (pages_.size() >= most_pages_)
      return nullptr;
    return (pages_[number] = std::make_unique<Page>(Page{})).get();
  }

  void becomeList()
  {
    is_list_ = true;
    recent_ = {};
    for (const auto& entry : pages_)
      for (std::uint32_t i = 0; i < page_size; ++i)
        if ((*entry.second)[i] != 0)
          list_.push_back(
              static_cast<std::int32_t>((entry.first * page_size + i) ^ 0x80000000u));
    pages_.clear();
  }

  std::size_t most_pages_;
  std::map<std::uint32_t, std::unique_ptr<Page>> pages_;
  Recent<Page*> recent_;
  bool is_list_ = false;
  std::vector<std::int32_t> list_;
  std::uint32_t count_ = 0;
};

} // namespace sedr
} // namespace pcl
