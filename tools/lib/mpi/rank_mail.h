// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/mpi/communicator.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Subject of a message between ranks. */
enum class Subject : int {
  Step,   ///< part of a joint step
  Order,  ///< from rank 0 to another
  Result, ///< from another rank to rank 0
};

/** @brief Sends bytes of any size between ranks. Waiting ranks sleep, so that idle
 * ranks on one machine leave the processors to the others. */
class RankMail {
public:
  explicit RankMail(const boost::mpi::communicator& ranks);

  int rank() const { return ranks_.rank(); }
  int size() const { return ranks_.size(); }
  bool isFirst() const { return rank() == 0; }

  void send(int to, Subject subject, const std::string& bytes)
  {
    send(to, subject, bytes.data(), bytes.size());
  }
  void send(int to, Subject subject, const void* bytes, std::size_t size);

  std::string receive(int from, Subject subject);

  /** @brief Returns a rank with a pending message; -1 if there is none. */
  int pending(Subject subject) const;

  /** @brief Waits until a rank has sent a message. */
  int waitFor(Subject subject) const;

  /** @brief Collects the bytes of every rank, in order, on rank 0; empty on the
   * others. */
  std::vector<std::string> gather(const std::string& mine);

  /** @brief Distributes the bytes of rank 0 to every rank. */
  std::string fromFirst(const std::string& bytes);

  /** @brief Bytes for a rank. */
  struct Parcel {
    const void* bytes = nullptr;
    std::size_t size = 0;
  };

  /** @brief Sends every other rank its parcel.
   * @param parcels for every rank; that of this rank is not sent
   * @return the parcels of the other ranks for this one */
  std::vector<std::string> exchange(const std::vector<Parcel>& parcels);

  /** @brief Marks a failure while other ranks wait for an answer, so that they can only
   * be aborted. */
  void leave() { has_left_ = true; }
  bool hasLeft() const { return has_left_; }

  /** @brief Returns the number of bytes sent by this rank. */
  std::uint64_t sent() const { return sent_; }

private:
  boost::mpi::communicator ranks_;
  std::uint64_t sent_ = 0;
  bool has_left_ = false;
};

/** @brief Sleeps briefly between two polls. */
void rest();

} // namespace pcl::sedr::tools
