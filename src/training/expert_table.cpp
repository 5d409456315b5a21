#include "training/expert_table.h"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"
#include "io/data_folder.h"
#include "io/resources.h"
#include "training/score_json.h"

namespace bodkin::training {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_table = std::size_t{64} << 20;  // bytes

struct TableRow {
  std::string digest, fields;  // fields: all but the digest
};

std::string table_head() {
  return "digest," + score_csv_columns();
}

constexpr std::string_view thresholds_mark = "# Measured with thresholds: ";

// "rest_s 1, stop_mm_per_s 3", or "the usual ones".
std::string text_of(const Thresholds& thresholds) {
  std::string text;
  for (const auto& [name, value] : own_thresholds(thresholds))
    text += fmt::format("{}{} {:.17g}", text.empty() ? "" : ", ", name, value);
  return text.empty() ? "the usual ones" : text;
}

// The thresholds stated in a table. An older table without a statement used the usual ones.
std::string thresholds_in(std::string_view table) {
  const std::size_t at = table.find(thresholds_mark);
  if (at == std::string_view::npos) return text_of({});
  const std::size_t from = at + thresholds_mark.size();
  return std::string(table.substr(from, table.find('\n', from) - from));
}

// The rows of one of our tables; none if there is no file.
std::vector<TableRow> rows_of(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return {};
  const std::string text = io::read_text_file(file, largest_table);
  std::vector<TableRow> rows;
  bool has_head = false;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view line = std::string_view(text).substr(from, end - from);
    from = end + 1;
    if (line.empty() || line.front() == '#') continue;
    if (!has_head) {
      has_head = true;
      if (line == table_head()) continue;
      throw InputError(
          fmt::format("{}: its columns are not those of this version; delete the table with 'bodkin experts delete "
                      "{}' and import "
                      "the sessions again",
                      file.string(), file.stem().string()));
    }
    const std::size_t comma = std::min(line.find(','), line.size() - 1);
    rows.push_back({std::string(line.substr(0, comma)), std::string(line.substr(comma + 1))});
  }
  return rows;
}

}  // namespace

fs::path own_expert_file(const std::string& procedure) {
  return io::data_folder() / "experts" / (procedure + ".csv");
}

std::optional<ExpertSet> experts_of(const Procedure& procedure) {
  const fs::path own = own_expert_file(procedure.name);
  std::error_code error;
  if (fs::is_regular_file(own, error)) {
    ExpertSet experts = ExpertSet::read(own);
    const bool alike = thresholds_in(io::read_text_file(own, largest_table)) == text_of(procedure.thresholds);
    return alike ? std::optional(std::move(experts)) : std::nullopt;
  }
  if (procedure.thresholds != Thresholds()) return std::nullopt;
  return ExpertSet::shipped(procedure.name);
}

ExpertsAdded add_experts(const fs::path& file, std::span<const ExpertAttempt> attempts) {
  std::vector<TableRow> rows = rows_of(file);
  ExpertsAdded result;
  std::string before = text_of(attempts.empty() ? Thresholds() : attempts.front().score.thresholds);
  if (!rows.empty()) before = thresholds_in(io::read_text_file(file, largest_table));
  for (const ExpertAttempt& attempt : attempts) {
    const std::string own = text_of(attempt.score.thresholds);
    if (own == before) continue;
    throw InputError(
        fmt::format("{}: its attempts were measured with the thresholds {}, the new ones with {}; delete the table "
                    "with 'bodkin experts delete {}' and import all sessions by one procedure",
                    file.string(), before, own, file.stem().string()));
  }
  for (const ExpertAttempt& attempt : attempts) {
    const auto same =
        std::find_if(rows.begin(), rows.end(), [&](const TableRow& row) { return row.digest == attempt.digest; });
    TableRow row{attempt.digest, score_csv_fields(attempt.score)};
    if (same != rows.end()) {
      *same = std::move(row);
      ++result.known;
    } else {
      rows.push_back(std::move(row));
      ++result.added;
    }
  }
  result.attempts = rows.size();
  std::string text =
      "# Attempts of experts, imported by 'bodkin experts import'. A row is known by the digest of its session.\n";
  text += fmt::format("{}{}\n{}\n", thresholds_mark, before, table_head());
  for (const TableRow& row : rows) text += fmt::format("{},{}\n", row.digest, row.fields);
  if (!rows.empty()) write_file(file, text);
  return result;
}

}  // namespace bodkin::training
