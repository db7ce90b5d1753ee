// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rank_mail.h"

#include <pcl/sedr_surface/room_jobs.h>

#include <cstdint>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Does a job; workOn() but for tests. */
using RoomWork = std::function<RoomResult(const RoomJob&)>;

/** @brief Does a job, whatever happens: what is thrown makes it a LostRoom that tells
 * the rank. */
RoomResult workSafely(int rank, const RoomJob& job, const RoomWork& work);

/** @brief What a dealer needs of others. */
struct RoomHooks {
  RoomWork work; ///< on rank 0
  /** The letter that asks another rank for a job; it answers with a packed RoomResult.
   */
  std::function<std::string(const RoomJob&)> order;
  /** Told what a rank begins to work on, in words; empty when it is done. */
  std::function<void(int rank, const std::string& held)> note;
  /** Told what came of a room. */
  std::function<void(std::uint32_t room, const RoomResult&)> finished;
};

/** @brief Deals rooms out to the ranks, this one, rank 0, among them: whoever is free
 * gets the largest room that is left. */
class RoomDealer : public RoomWorkers {
public:
  RoomDealer(RankMail& mail, RoomHooks hooks);

  void work(const std::vector<std::size_t>& sizes,
            const std::function<RoomJob(std::size_t)>& job,
            const std::function<void(std::size_t, RoomResult)>& take) override;

  /** @brief Why rooms were lost so far, a sentence each. */
  const std::vector<std::string>& losses() const { return losses_; }

private:
  using Job = std::function<RoomJob(std::size_t)>;
  using Take = std::function<void(std::size_t, RoomResult)>;

  void dealOut(std::vector<std::size_t> left, const Job& job, const Take& take);

  /** @brief Gives job `number` to a rank. */
  void give(int rank, std::size_t number, RoomJob job);

  /** @brief Takes a result if there is one.
   * @return whether there was */
  bool takeOne(const Take& take);

  RankMail& mail_;
  RoomHooks hooks_;

  /** @brief What a rank works on. */
  struct Task {
    std::size_t number;
    std::uint32_t room;
  };
  std::vector<std::optional<Task>> busy_; ///< of each rank
  std::future<RoomResult> own_;           ///< of this one
  std::vector<std::string> losses_;
};

} // namespace tools
} // namespace sedr
} // namespace pcl
