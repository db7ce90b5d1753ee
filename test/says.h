// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>

/** Returns whether a text has some words, and what it says if not. */
inline ::testing::AssertionResult
says(const std::string& text, const std::string& words)
{
  if (text.find(words) != std::string::npos)
    return ::testing::AssertionSuccess() << "it says: " << text.substr(0, 2000);
  return ::testing::AssertionFailure()
         << "not '" << words << "', but: " << text.substr(0, 2000);
}
