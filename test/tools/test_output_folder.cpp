// SPDX-License-Identifier: BSD-3-Clause
#include "in_folder.h"
#include "killed_at_call.h"
#include "model/output_folder.h"
#include "result_exchange.h"
#include "sample_files.h"
#include "says.h"
#include "tool_error.h"

#include <nlohmann/json.hpp>

#include <sys/types.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <set>
#include <thread>

namespace {

namespace fs = std::filesystem;
using namespace programs;
using pcl::sedr::tools::finishExchanges;
using pcl::sedr::tools::isExchangeBegun;
using pcl::sedr::tools::OutputFolder;
using pcl::sedr::tools::ToolError;
using Strings = std::vector<std::string>;

class ResultSet : public InFolder<> {
protected:
  /** Writes set number k: eleven files with that number in them, and one named by it;
   * is killed at a call of the exchange if that is not 0. */
  void write(int k, int killed_at = 0) const
  {
    OutputFolder folder(in("model"), {});
    for (int file = 0; file < 10; ++file)
      writeFile(folder.file("file" + std::to_string(file)), std::to_string(k));
    writeFile(folder.file("floorplan.json"), std::to_string(k));
    writeFile(folder.file("pictures/of_" + std::to_string(k)), std::to_string(k));
    nlohmann::json report{{"format", "sedr-report"}, {"files", folder.written()}};
    report["files"].push_back("report.json");
    writeFile(folder.file("report.json"), report.dump());
    killAtCall(killed_at);
    folder.exchange();
    killAtCall(0);
  }

  /** Returns the number of the set in the folder; -1 if it is mixed. */
  int set() const
  {
    const std::string number = bytesOf(in("model/file0"));
    std::set<std::string> expected{"pictures", "pictures/of_" + number,
                                   "floorplan.json", "report.json"};
    for (int file = 0; file < 10; ++file) {
      expected.insert("file" + std::to_string(file));
      if (bytesOf(in("model/file" + std::to_string(file))) != number)
        return -1;
    }
    return files() == expected ? std::stoi(number) : -1;
  }

  /** Returns the files of the folder, hidden ones too. */
  std::set<std::string> files() const
  {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(in("model")))
      names.insert(entry.path().lexically_relative(in("model")));
    return names;
  }
};

TEST_F(ResultSet, ReplacesTheOneOfAnEarlierRunAndNothingElse)
{
  write(1);
  for (const char* mine :
       {"model/notes.html", "model/floorplan_1.svg", "outside", "model/floorplan.json"})
    writeFile(in(mine), "mine");
  write(2);
  EXPECT_EQ(bytesOf(in("model/floorplan.json~")), "mine") << "edited by hand";
  writeFile(in("model/floorplan.json"), "mine too");
  write(2);
  EXPECT_EQ(bytesOf(in("model/floorplan.json~")), "mine");
  EXPECT_EQ(bytesOf(in("model/floorplan.json~~")), "mine too");
  EXPECT_EQ(files().count("pictures/of_1"), 0u);
  EXPECT_EQ(files().count("pictures/of_2"), 1u);
  EXPECT_EQ(bytesOf(in("model/file7")), "2");
  writeFile(in("model/report.json"), R"({"format": "sedr-report", "files":
      ["file3", "../outside", "x/../../outside", 7, "", ")" +
                                         in("outside") + R"(", "floorplan_1.svg"]})");
  OutputFolder(in("model"), {in("model/file3")}).exchange();
  EXPECT_EQ(bytesOf(in("model/file3")), "2") << "an input";
  EXPECT_EQ(bytesOf(in("outside")), "mine");
  EXPECT_EQ(bytesOf(in("model/notes.html")), "mine");
  EXPECT_FALSE(fs::exists(in("model/floorplan_1.svg"))) << "listed as written";
}

TEST_F(ResultSet, IsTheOldOneOrTheNewOneWheneverTheRunIsInterrupted)
{
  using Clock = std::chrono::steady_clock;
  auto whole = Clock::duration::max();
  for (int k = 0; k < 5; ++k) { // the first one fills the caches
    const auto start = Clock::now();
    write(0);
    whole = std::min<Clock::duration>(whole, Clock::now() - start);
  }
  writeFile(in("model/mine"), "mine");
  std::set<int> met{0};
  for (int k = 1; k <= 100; ++k) {
    const pid_t runner = fork();
    if (runner == 0) {
      write(k);
      _exit(0);
    }
    // Most of the time goes into moving the files, which interrupts wait for.
    std::this_thread::sleep_for((k % 4 < 2 ? whole : whole / 20) * k / 80);
    kill(runner, k % 2 == 0 ? SIGINT : SIGTERM);
    waitpid(runner, nullptr, 0);
    ASSERT_FALSE(fs::exists(in("model/.pcl_sedr.part"))) << k;
    const std::string number = bytesOf(in("model/file0"));
    for (int file = 1; file < 10; ++file)
      ASSERT_EQ(bytesOf(in("model/file" + std::to_string(file))), number) << k;
    ASSERT_EQ(files().size(), 15u) << "eleven files, report, picture in a folder, mine";
    ASSERT_EQ(files().count("pictures/of_" + number), 1u);
    met.insert(std::stoi(number));
  }
  EXPECT_GT(met.size(), 5u) << "some runs were done before they were killed";
  EXPECT_LT(met.size(), 96u) << "others were not";
}

TEST_F(ResultSet, IsTheOldOneOrTheNewOneWhereverTheExchangeIsKilled)
{
  const std::function<void()> nexts[] = {
      [&] {
        finishExchanges({"--origin", in("model/file3")});
      },
      [&] { OutputFolder(in("model"), {}); }, // a run that finds nothing
      [&] {
        expectSentence(run(SEDR, {in("missing.pcd"), in("model")}), 1);
      },
      [&] { run(SEDR_REPORT, {in("model")}); }};
  write(0);
  int last = 0;
  std::set<int> met;
  for (int call = 1;; ++call) {
    const pid_t runner = fork();
    if (runner == 0) {
      write(call, call);
      _exit(0);
    }
    int status = 0;
    waitpid(runner, &status, 0);
    const bool is_done = WIFEXITED(status);
    const bool is_begun = isExchangeBegun(in("model"));
    nexts[call % 4]();
    fs::remove(in("model/report.html"));
    if (!is_begun) // a hidden folder may be left, but no other file
      fs::remove_all(in("model/.pcl_sedr.part"));
    const int now = set();
    ASSERT_TRUE(now == last || now == call) << now << " at call " << call;
    ASSERT_FALSE(is_begun && now != call) << "at call " << call;
    met.insert(now == call);
    last = now;
    if (is_done) {
      EXPECT_GT(call, 50) << "files are synced and moved";
      break;
    }
  }
  EXPECT_EQ(met.size(), 2U);
  fs::create_directories(in("model/.pcl_sedr.part"));
  writeFile(in("model/.pcl_sedr.part/exchange.json"),
            R"({"moved": [], "removed": ["../outside"]})");
  writeFile(in("outside"), "mine");
  EXPECT_THROW(finishExchanges({in("model")}), ToolError);
  expectSentence(run(SEDR_REPORT, {in("model")}), 1, "names a file elsewhere");
  EXPECT_EQ(bytesOf(in("outside")), "mine");
}

TEST_F(ResultSet, IsWrittenByOneRunAtATime)
{
  {
    const OutputFolder first(in("a/b"), {});
    try {
      const OutputFolder second(in("a/b"), {});
      ADD_FAILURE() << "two at once";
    }
    catch (const ToolError& error) {
      EXPECT_TRUE(says(std::string(error.what()), "another run"));
    }
    EXPECT_TRUE(fs::exists(first.file("x/y").substr(0, in("a/b").size())));
  }
  EXPECT_FALSE(fs::exists(in("a"))) << "nothing was written";
  fs::create_directories(in("a/b/.pcl_sedr.part/x")); // of a run that was killed
  OutputFolder(in("a/b"), {}).exchange();
  EXPECT_FALSE(fs::exists(in("a/b/.pcl_sedr.part")));
}

} // namespace
