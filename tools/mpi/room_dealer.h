// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpi/rank_mail.h"

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

/** @brief Deals rooms out to the ranks, this one, rank 0, among them: whoever is free
 * gets the largest room that is left. */
class RoomDealer : public RoomWorkers {
public:
  /** @param order makes the letter that asks another rank for a job; it answers with a
   * packed RoomResult */
  RoomDealer(RankMail& mail,
             RoomWork work,
             std::function<std::string(const RoomJob&)> order);

  void work(const std::vector<std::size_t>& sizes,
            const std::function<RoomJob(std::size_t)>& job,
            const std::function<void(std::size_t, RoomResult)>& take) override;

  /** @brief Why rooms were lost so far, a sentence each. */
  const std::vector<std::string>& losses() const { return losses_; }

private:
  using Job = std::function<RoomJob(std::size_t)>;
  using Take = std::function<void(std::size_t, RoomResult)>;

  /** @brief Gives `number` to a rank. */
  void give(int rank, std::size_t number, const RoomJob& job);

  /** @brief Takes a result if there is one.
   * @return whether there was */
  bool takeOne(const Take& take);

  RankMail& mail_;
  RoomWork work_;
  std::function<std::string(const RoomJob&)> order_;
  std::vector<std::optional<std::size_t>> busy_; ///< what each rank works on
  std::future<RoomResult> own_;                  ///< what this one does
  std::vector<std::string> losses_;
};

} // namespace tools
} // namespace sedr
} // namespace pcl
