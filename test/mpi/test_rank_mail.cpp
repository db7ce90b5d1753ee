// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/joint_step.h"
#include "mpi/rank_mail.h"
#include "tool_error.h"

#include <gtest/gtest.h>

#include <new>
#include <numeric>

namespace {

using namespace pcl::sedr::tools;

/** Returns the message of rank `from` for rank `to`; one exceeds 64 MiB. */
std::string
letter(int from, int to)
{
  const std::size_t size = from == 0 && to == 1 ? (std::size_t{1} << 26) + 17
                                                : static_cast<std::size_t>(from * to);
  std::string text(size, '\0');
  for (std::size_t i = 0; i < size; i += 997)
    text[i] = static_cast<char>(from + 3 * to + static_cast<int>(i % 64));
  return text;
}

TEST(RankMail, ExchangesLettersOfAnySize)
{
  RankMail mail{boost::mpi::communicator()};
  std::vector<std::string> letters;
  std::vector<RankMail::Parcel> parcels;
  for (int to = 0; to < mail.size(); ++to)
    letters.push_back(letter(mail.rank(), to));
  for (const std::string& one : letters)
    parcels.push_back({one.data(), one.size()});
  const std::vector<std::string> received = mail.exchange(parcels);
  ASSERT_EQ(received.size(), parcels.size());
  for (int from = 0; from < mail.size(); ++from)
    if (from != mail.rank()) {
      EXPECT_TRUE(received[static_cast<std::size_t>(from)] == letter(from, mail.rank()))
          << "from " << from;
    }
  std::uint64_t sent = 0;
  for (int to = 0; to < mail.size(); ++to)
    sent += to == mail.rank() ? 0 : letters[static_cast<std::size_t>(to)].size();
  EXPECT_EQ(mail.sent(), sent);
}

TEST(RankMail, GathersInTheOrderOfTheRanksAndTellsAll)
{
  RankMail mail{boost::mpi::communicator()};
  const auto all = mail.gather("rank " + std::to_string(mail.rank()));
  ASSERT_EQ(all.size(), mail.isFirst() ? static_cast<std::size_t>(mail.size()) : 0u);
  for (std::size_t r = 0; r < all.size(); ++r)
    EXPECT_EQ(all[r], "rank " + std::to_string(r));
  EXPECT_EQ(mail.fromFirst(mail.isFirst() ? "all of you" : "not me"), "all of you");
}

TEST(JointStep, FailsOnAllRanksWithTheNameOfThoseThatFailedAndWhatTheyHeld)
{
  RankMail mail{boost::mpi::communicator()};
  const int last = mail.size() - 1;
  const std::string held = "book " + std::to_string(mail.rank());
  for (const bool is_memory : {false, true}) {
    try {
      together(mail, held, [&] {
        if (mail.rank() != last)
          return;
        if (is_memory)
          throw std::bad_alloc();
        throw ToolError("its pages are stuck");
      });
      ADD_FAILURE() << "nothing was thrown";
    }
    catch (const ToolError& error) {
      EXPECT_TRUE(mail.isFirst());
      const std::string sentence = error.what();
      EXPECT_EQ(sentence.find("rank " + std::to_string(last) + " on '"), 0u)
          << sentence;
      const std::string end =
          "' failed at book " + std::to_string(last) + ": " +
          (is_memory ? "the memory does not suffice" : "its pages are stuck");
      EXPECT_NE(sentence.find(end), std::string::npos) << sentence;
    }
    catch (const StepFailed&) {
      EXPECT_FALSE(mail.isFirst());
    }
  }
  int done = 0;
  together(mail, held, [&] { ++done; });
  EXPECT_EQ(done, 1) << "and goes well the next time";
}

} // namespace
