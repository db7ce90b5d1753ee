// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "box_room.h"
#include "in_folder.h"

namespace programs {

using Strings = std::vector<std::string>;

/** Runs pcl_sedr in a folder of its own. */
class SedrTool : public InFolder<> {
protected:
  ProgramRun onFile(const std::string& bytes, const Strings& options = {})
  {
    writeFile(in("input.pcd"), bytes);
    return run(SEDR, {in("input.pcd"), in("model")}, options);
  }

  /** Expects the exit code, a sentence with `words`, and no new file. */
  void expectFailure(const ProgramRun& result, int exit_code, const std::string& words)
  {
    expectSentence(result, exit_code, words);
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(folder_.path()))
      EXPECT_TRUE(entry.is_directory() || entry.path().filename() == "input.pcd")
          << entry.path() << " was left behind";
  }
};

} // namespace programs
