#include "io/csv_rows.h"

#include <new>
#include <utility>

#include <csv.h>
#include <fmt/format.h>

#include "core/error.h"
#include "io/text_encoding.h"
#include "io/xml_document.h"

namespace bodkin::io {

namespace {

// The data filled by libcsv's callbacks. They must not throw, because C code lies between.
struct Rows {
  std::vector<CsvRow> rows;
  CsvRow current;
  bool out_of_memory = false;
};

void end_field(void* text, std::size_t length, void* user) {
  Rows& rows = *static_cast<Rows*>(user);
  try {
    rows.current.fields.emplace_back(static_cast<const char*>(text), length);
  } catch (const std::bad_alloc&) {
    rows.out_of_memory = true;
  }
}

void end_row(int, void* user) {
  Rows& rows = *static_cast<Rows*>(user);
  try {
    rows.rows.push_back(std::move(rows.current));
  } catch (const std::bad_alloc&) {
    rows.out_of_memory = true;
  }
  rows.current = CsvRow();
}

struct Parser : csv_parser {
  explicit Parser(char separator) {
    if (csv_init(this, CSV_STRICT | CSV_STRICT_FINI) != 0) throw SystemError("out of memory while reading CSV");
    csv_set_delim(this, static_cast<unsigned char>(separator));
  }
  ~Parser() { csv_free(this); }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;
};

[[noreturn]] void fail_parse(Parser& parser, const Rows& rows, const std::string& origin, int line) {
  if (rows.out_of_memory || csv_error(&parser) != CSV_EPARSE) throw SystemError("out of memory while reading CSV");
  fail_at(
      origin, line,
      fmt::format(
          "column {}: a quote (\") is not allowed here; put the whole field in quotes and double the quotes in it",
          rows.current.fields.size() + 1));
}

}  // namespace

std::vector<CsvRow> read_csv_rows(std::string_view text, const std::string& origin, const CsvForm& form) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // the byte order mark that spreadsheets write
  Rows rows;
  Parser parser(form.separator);
  int line = 1;
  bool comment = false;
  // One character at a time, to record the line on which every row begins.
  for (std::size_t position = 0; position < text.size();) {
    const std::size_t length = character_length(text, position);
    if (length == 0) {
      const auto byte = static_cast<unsigned char>(text[position]);
      fail_at(origin, line,
              fmt::format("column {}: the byte 0x{:02X} is not text, expected UTF-8 without control characters",
                          rows.current.fields.size() + 1, byte));
    }
    const bool line_break = text[position] == '\n' || text[position] == '\r';
    if (form.comments && rows.current.line == 0 && text[position] == '#') comment = true;
    if (rows.current.line == 0 && !line_break && !comment) rows.current.line = line;
    if (!comment && (csv_parse(&parser, text.data() + position, length, end_field, end_row, &rows) != length ||
                     rows.out_of_memory)) {
      fail_parse(parser, rows, origin, line);
    }
    if (line_break) comment = false;
    position += length;
    if (line_break && !(text[position - 1] == '\r' && position < text.size() && text[position] == '\n')) ++line;
  }
  const int begun = rows.current.line;
  if (csv_fini(&parser, end_field, end_row, &rows) != 0) {
    fail_at(origin, begun == 0 ? line : begun, "a field that begins with a quote (\") never ends with one");
  }
  return std::move(rows.rows);
}

}  // namespace bodkin::io
