#include "io/label_scheme.h"

#include <array>
#include <charconv>
#include <map>

#include <fmt/format.h>

#include "core/error.h"
#include "io/csv_rows.h"
#include "io/resources.h"
#include "io/tissue_library_file.h"
#include "io/xml_document.h"

namespace bodkin::io {

namespace {

constexpr std::size_t scheme_limit = 8 << 20;  // bytes
constexpr std::size_t longest_name = 200;      // bytes, as case.xml has it
constexpr std::array<const char*, 4> scheme_columns = {"label", "name", "tissue", "critical"};
constexpr const char* scheme_header = "label,name,tissue,critical";

// One row as a structure.
class RowReader {
 public:
  RowReader(const CsvRow& row, const std::string& origin) : row_(row), origin_(origin) {
    if (row.fields.size() != scheme_columns.size()) {
      fail_at(origin, row.line,
              fmt::format("there are {} columns, expected {} ({})", row.fields.size(), scheme_columns.size(),
                          scheme_header));
    }
  }

  anatomy::Structure structure(const anatomy::TissueLibrary& library) const {
    anatomy::Structure entry;
    entry.label = label();
    entry.name = row_.fields[1];
    if (entry.name.empty() || entry.name.size() > longest_name ||
        entry.name.find_first_of("\r\n\t") != std::string::npos) {
      fail(1, fmt::format("a name on one line, at most {} bytes long", longest_name));
    }
    entry.tissue = row_.fields[2];
    if (!is_resolved_by_construction(entry.tissue) && library.find(entry.tissue) == nullptr) {
      fail(2, "the name of a tissue of the library, bone, spinal_canal or nothing");
    }
    entry.critical = critical();
    return entry;
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& expected) const {
    fail_at(origin_, row_.line,
            fmt::format("column {}: {} is {}, expected {}", column + 1, scheme_columns[column],
                        in_quotes(row_.fields[column]), expected));
  }

  std::uint16_t label() const {
    const std::string& text = row_.fields[0];
    std::uint16_t value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || value == 0)
      fail(0, "a whole number from 1 to 65535");
    return value;
  }

  bool critical() const {
    const std::string& text = row_.fields[3];
    if (text == "yes" || text == "true" || text == "1") return true;
    if (text == "no" || text == "false" || text == "0" || text.empty()) return false;
    fail(3, "yes or no");
  }

  const CsvRow& row_;
  const std::string& origin_;
};

constexpr const char* named_header = "id,name";

std::string joined(const std::vector<std::string>& fields) {
  std::string text;
  for (const std::string& field : fields) text += (text.empty() ? "" : ",") + field;
  return text;
}

// A table with only ids and names, as written by TotalSegmentator: the name implies the tissue. Tissues of other
// names are decided by HU.
std::vector<anatomy::Structure> parse_named_labels(const std::vector<CsvRow>& rows, const std::string& origin,
                                                   const anatomy::TissueLibrary& library) {
  std::string text = scheme_header;
  std::map<std::string, anatomy::Structure> known;
  for (const char* scheme : {"totalsegmentator_v1", "totalsegmentator"}) {
    for (anatomy::Structure& entry : read_label_scheme(scheme, library)) known[entry.name] = entry;
  }
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    if (row->fields.size() != 2)
      fail_at(origin, row->line,
              fmt::format("there are {} columns, expected 2 ({})", row->fields.size(), named_header));
    const auto entry = known.find(row->fields[1]);
    const bool found = entry != known.end();
    text += fmt::format("\n{},{},{},{}", row->fields[0], row->fields[1], found ? entry->second.tissue : "",
                        found && entry->second.critical ? "yes" : "no");
  }
  return parse_label_scheme(text, origin, library);
}

}  // namespace

bool is_resolved_by_construction(std::string_view tissue) noexcept {
  return tissue.empty() || tissue == "bone" || tissue == "spinal_canal";
}

std::vector<anatomy::Structure> parse_label_scheme(const std::string& text, const std::string& origin,
                                                   const anatomy::TissueLibrary& library) {
  const std::vector<CsvRow> rows = read_csv_rows(text, origin);
  if (rows.empty()) fail_at(origin, 1, fmt::format("the file is empty, expected the header {}", scheme_header));
  const std::string first = joined(rows.front().fields);
  if (first == named_header) return parse_named_labels(rows, origin, library);
  if (first != scheme_header)
    fail_at(origin, rows.front().line, fmt::format("the header is {}, expected {}", in_quotes(first), scheme_header));
  std::vector<anatomy::Structure> structures;
  std::map<int, int> line_of_label;
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    anatomy::Structure entry = RowReader(*row, origin).structure(library);
    if (const auto [earlier, fresh] = line_of_label.emplace(entry.label, row->line); !fresh) {
      fail_at(origin, row->line,
              fmt::format("column 1: label is {}, which line {} uses already", entry.label, earlier->second));
    }
    structures.push_back(std::move(entry));
  }
  if (structures.empty()) fail_at(origin, rows.front().line, "there are no labels under the header");
  return structures;
}

std::vector<anatomy::Structure> parse_label_scheme(const std::string& text, const std::string& origin) {
  return parse_label_scheme(text, origin, default_tissue_library());
}

std::vector<anatomy::Structure> read_label_scheme(const std::string& scheme, const anatomy::TissueLibrary& library) {
  if (scheme == "totalsegmentator" || scheme == "totalsegmentator_v1" || scheme == "tptbox") {
    const auto file = shared_file("label_schemes/" + scheme + ".csv");
    return parse_label_scheme(read_text_file(file, scheme_limit), file.string(), library);
  }
  std::error_code ignored;
  if (!std::filesystem::exists(scheme, ignored)) {
    throw InputError(
        fmt::format("label scheme is {}, expected totalsegmentator, totalsegmentator_v1, tptbox or the path of a CSV "
                    "file with the "
                    "columns {}",
                    in_quotes(scheme), scheme_header));
  }
  return parse_label_scheme(read_text_file(scheme, scheme_limit), scheme, library);
}

std::vector<anatomy::Structure> read_label_scheme(const std::string& scheme) {
  return read_label_scheme(scheme, default_tissue_library());
}

}  // namespace bodkin::io
