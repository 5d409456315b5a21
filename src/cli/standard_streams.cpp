#include "cli/standard_streams.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::cli {

namespace {

bool write_now(std::FILE* stream, std::string_view text) noexcept {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  return std::fflush(stream) == 0 && written;
}

}  // namespace

void ignore_broken_pipes() noexcept {
  std::signal(SIGPIPE, SIG_IGN);
}

void write_output(std::string_view text) {
  if (write_now(stdout, text)) return;
  const int reason = errno;
  if (reason == EPIPE || reason == EIO) throw OutputClosed();
  throw SystemError(fmt::format("the result cannot be written to standard output: {}", std::strerror(reason)));
}

void write_remark(std::string_view text) noexcept {
  if (!write_now(stderr, text)) std::clearerr(stderr);
}

}  // namespace bodkin::cli
