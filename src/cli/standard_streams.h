#pragma once

#include <string_view>

namespace bodkin::cli {

// Nobody reads standard output any more: a pipe was closed (`bodkin ... | head -1`) or a terminal was hung up. That
// is nobody's mistake and needs no message.
struct OutputClosed {};

// What shells report for a command that ended because nobody read its output: 128 + SIGPIPE.
inline constexpr int exit_output_closed = 141;

// To be called once, before anything is written: writing where nobody reads is then an error instead of the end of
// the process, so that a session in progress is ended as it should be.
void survive_closed_pipes() noexcept;

// To standard output, at once. Throws OutputClosed, and SystemError when the disk is full or the file is closed.
void write_output(std::string_view text);

// To standard error, at once. What cannot be written is lost: a remark is no reason to end a session.
void write_remark(std::string_view text) noexcept;

}  // namespace bodkin::cli
