#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bodkin::io {

// One row of a table in CSV.
struct CsvRow {
  int line = 0;                     // first line of the row, from 1
  std::vector<std::string> fields;  // without quotes and the blanks around them
};

// The format of a table.
struct CsvForm {
  char separator = ',';
  bool comments = false;  // lines that begin with # are ignored
};

// The rows of a table, empty lines left out; a byte order mark at the beginning is skipped. `origin` names the table
// in messages. Throws InputError naming line and column for bytes that are not text and for quotes that do not match.
std::vector<CsvRow> read_csv_rows(std::string_view text, const std::string& origin, const CsvForm& form = {});

}  // namespace bodkin::io
