#pragma once

#include <string_view>

namespace bodkin::cli {

// Standard output has no reader any more: a pipe was closed (`bodkin ... | head -1`) or a terminal was hung up. This
// is not an error and needs no message.
struct OutputClosed {};

// Exit code that shells report for a command ended by a closed output: 128 + SIGPIPE.
inline constexpr int exit_output_closed = 141;

// To be called once, before anything is written: writing without a reader is then an error instead of the end of the
// process, so that a session in progress ends properly.
void ignore_broken_pipes() noexcept;

// To standard output, immediately. Throws OutputClosed, and SystemError if the disk is full or the file is closed.
void write_output(std::string_view text);

// To standard error, immediately. Ignores errors: a lost remark is no reason to end a session.
void write_remark(std::string_view text) noexcept;

}  // namespace bodkin::cli
