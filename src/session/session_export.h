#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "session/session_file.h"

namespace bodkin::session {

// Receives the text of a file piece by piece.
using TextSink = std::function<void(std::string_view)>;

// The ticks of a session as CSV (RFC 4180 quoting, lines end in LF, '.' decimals): a line of column names with their
// units, then one row per tick. Numbers have as many digits as are needed to read the same bits back; other values
// are nan, inf or -inf. docs/running.md lists the columns. The diagnostics of the force models follow, each under its
// own name.
void export_ticks(const Session& session, const TextSink& sink);

// The events of a session as CSV: time, depth, kind, tissue, value.
void export_events(const Session& session, const TextSink& sink);

// The samples of the second hand as CSV; columns without a value for a probe stay empty. Only the line of names
// without a second hand.
void export_second(const Session& session, const TextSink& sink);

}  // namespace bodkin::session
