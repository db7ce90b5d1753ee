// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace programs {

/** @brief An X server without a screen that ends with this object.
 *
 * It selects a free display and reports its number once it answers. xvfb-run instead
 * checks for a lock file first, which fails when other servers start or end meanwhile.
 */
class VirtualScreen {
public:
  static bool isInstalled() { return std::system("command -v Xvfb >/dev/null") == 0; }

  VirtualScreen()
      : output_(popen("echo $$; exec Xvfb -displayfd 1 -screen 0 1280x1024x24 "
                      "-nolisten tcp -noreset 2>/dev/null",
                      "r"))
  {
    int display = -1;
    if (output_ == nullptr || std::fscanf(output_, "%d %d", &process_, &display) != 2) {
      end();
      throw std::runtime_error("Xvfb did not start");
    }
    name_ = ":" + std::to_string(display);
  }

  VirtualScreen(const VirtualScreen&) = delete;
  VirtualScreen& operator=(const VirtualScreen&) = delete;

  ~VirtualScreen() { end(); }

  /** Returns the value of DISPLAY for programs. */
  const std::string& name() const { return name_; }

private:
  void end()
  {
    if (process_ > 0)
      kill(process_, SIGTERM);
    if (output_ != nullptr)
      pclose(output_); // waits until the server has ended
    output_ = nullptr;
  }

  std::FILE* output_;
  int process_ = 0;
  std::string name_;
};

} // namespace programs
