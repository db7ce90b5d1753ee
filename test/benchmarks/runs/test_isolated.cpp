// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/runs/isolated.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace {

using pcl::sedr::benchmark::runIsolated;

std::string
reasonOf(const std::function<void()>& work)
{
  try {
    runIsolated(work);
  }
  catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Isolated, leaves_the_caller_as_it_was)
{
  int value = 1;
  runIsolated([&value] { value = 2; });
  EXPECT_EQ(value, 1);
}

TEST(Isolated, tells_what_was_thrown)
{
  EXPECT_EQ(reasonOf([] { throw std::runtime_error("no floor"); }), "no floor");
  EXPECT_NE(reasonOf([] { throw 1; }), "");
  const std::string large(1'000'000, 'x'); // more than a pipe holds
  EXPECT_EQ(reasonOf([&large] { throw std::runtime_error(large); }), large);
}

TEST(Isolated, survives_a_crash)
{
  const std::string reason = reasonOf([] { std::raise(SIGKILL); });
  EXPECT_NE(reason.find("signal 9"), std::string::npos) << reason;
}

} // namespace
