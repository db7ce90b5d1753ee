// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>

/** Returns whether a text has all these words, and which not, or what it says. */
template <typename... WordsT>
::testing::AssertionResult
says(const std::string& text, const WordsT&... words)
{
  for (const std::string& word : {std::string(words)...})
    if (text.find(word) == std::string::npos)
      return ::testing::AssertionFailure()
             << "not '" << word << "', but: " << text.substr(0, 2000);
  return ::testing::AssertionSuccess() << "it says: " << text.substr(0, 2000);
}
