// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/in_folder.h"
#include "tools/sample_result.h"
#include "viewer/shapes.h"

#include <gtest/gtest.h>

namespace programs {

/** The sample after writing and reading. */
class ViewedSample : public InFolder<> {
protected:
  void SetUp() override
  {
    sample_.writeTo(folder_.path() / "model");
    result_ = pcl::sedr::tools::readResult((folder_.path() / "model").string(), {});
  }

  SampleResult sample_;
  pcl::sedr::tools::ViewedResult result_;
};

} // namespace programs
