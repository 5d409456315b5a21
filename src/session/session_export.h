#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "session/session_file.h"

namespace bodkin::session {

// Takes the text of a file piece by piece.
using TextSink = std::function<void(std::string_view)>;

// The ticks of a session as CSV (RFC 4180 quoting, lines end in LF, '.' decimals): a line of column names with their
// units, then one row per tick. Numbers have as many digits as it takes to read the same bits back; what is not a
// number or not finite stands as nan, inf or -inf. docs/running.md lists the columns. The
// diagnostics that the force models published follow, each under its own name.
void export_ticks(const Session& session, const TextSink& sink);

// The events of a session as CSV: time, depth, kind, tissue, value.
void export_events(const Session& session, const TextSink& sink);

// The samples of the second hand as CSV; columns that a probe has no value for stay empty. Only the line of names
// where there was no second hand.
void export_second(const Session& session, const TextSink& sink);

}  // namespace bodkin::session
