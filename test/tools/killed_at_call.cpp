// SPDX-License-Identifier: BSD-3-Clause
#include "killed_at_call.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <csignal>
#include <cstdarg>
#include <cstdio>

namespace {

int calls_left = 0; // 0: not counted

/** Returns the function of the system, unless this is the call to be killed at. */
template <typename FunctionT>
FunctionT*
systemCall(FunctionT*, const char* name)
{
  if (calls_left > 0 && --calls_left == 0)
    kill(getpid(), SIGKILL);
  return reinterpret_cast<FunctionT*>(dlsym(RTLD_NEXT, name));
}

} // namespace

void
programs::killAtCall(int n)
{
  calls_left = n;
}

extern "C" {

int
rename(const char* from, const char* to) noexcept
{
  return systemCall(rename, "rename")(from, to);
}

int
unlink(const char* path) noexcept
{
  return systemCall(unlink, "unlink")(path);
}

int
unlinkat(int folder, const char* path, int flags) noexcept
{
  return systemCall(unlinkat, "unlinkat")(folder, path, flags);
}

int
rmdir(const char* path) noexcept
{
  return systemCall(rmdir, "rmdir")(path);
}

int
mkdir(const char* path, mode_t mode) noexcept
{
  return systemCall(mkdir, "mkdir")(path, mode);
}

int
open(const char* path, int flags, ...)
{
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return systemCall(open, "open")(path, flags, mode);
}

FILE*
fopen(const char* path, const char* mode)
{
  return systemCall(fopen, "fopen")(path, mode);
}

FILE*
fopen64(const char* path, const char* mode)
{
  return systemCall(fopen64, "fopen64")(path, mode);
}

ssize_t
write(int file, const void* bytes, size_t size)
{
  return systemCall(write, "write")(file, bytes, size);
}

ssize_t
writev(int file, const iovec* parts, int count)
{
  return systemCall(writev, "writev")(file, parts, count);
}

int
fsync(int file)
{
  return systemCall(fsync, "fsync")(file);
}

int
close(int file)
{
  return systemCall(close, "close")(file);
}

} // extern "C"
