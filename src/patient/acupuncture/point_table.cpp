#include "patient/acupuncture/point_table.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "core/error.h"
#include "io/csv_rows.h"
#include "io/resources.h"

namespace bodkin::patient {
namespace {

constexpr std::size_t largest_table = 1 << 20;

// A table whose first row names its columns.
class Table {
 public:
  explicit Table(const std::string& name) : file_(io::shared_file("acupuncture/" + name).string()) {
    rows_ = io::read_csv_rows(io::read_text_file(file_, largest_table), file_, {.separator = ',', .comments = true});
    if (rows_.empty())
      throw InputError(fmt::format("{} is empty, expected a row with the names of its columns", file_));
  }

  template <typename Take>
  void each(const Take& take) const {
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      if (rows_[i].fields.size() != rows_[0].fields.size())
        throw InputError(fmt::format("{}, line {}: there are {} fields, expected {}", file_, rows_[i].line,
                                     rows_[i].fields.size(), rows_[0].fields.size()));
      take(rows_[i]);
    }
  }
  const std::string& text(const io::CsvRow& row, std::string_view column) const {
    const auto& names = rows_[0].fields;
    const auto at = std::find(names.begin(), names.end(), column);
    if (at == names.end()) throw InputError(fmt::format("{} has no column {}", file_, column));
    return row.fields[static_cast<std::size_t>(at - names.begin())];
  }
  double number(const io::CsvRow& row, std::string_view column, std::string_view text_of_number) const {
    double value = 0.0;
    const char* end = text_of_number.data() + text_of_number.size();
    const auto result = std::from_chars(text_of_number.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end)
      throw InputError(
          fmt::format("{}, line {}, {}: found '{}', expected a number", file_, row.line, column, text_of_number));
    return value;
  }
  double number(const io::CsvRow& row, std::string_view column) const {
    return number(row, column, text(row, column));
  }

 private:
  std::string file_;
  std::vector<io::CsvRow> rows_;
};

Cun read_cun(const Table& table, const io::CsvRow& row, std::string_view column) {
  std::string_view text = table.text(row, column);
  if (text.empty()) return {};
  Cun cun{Cun::Kind::body, 0.0};
  if (text.back() == '*') cun.kind = Cun::Kind::fraction;
  if (text.back() == 'f') cun.kind = Cun::Kind::finger;
  if (cun.kind != Cun::Kind::body) text.remove_suffix(1);
  cun.amount = table.number(row, column, text);
  return cun;
}

}  // namespace

const PointRow* PointTable::find(std::string_view code) const {
  const auto at = std::find_if(points.begin(), points.end(), [&](const PointRow& row) { return row.code == code; });
  return at == points.end() ? nullptr : &*at;
}

std::string_view meridian_code(std::string_view point) {
  return point.substr(0, std::min(point.size(), point.find_first_of("0123456789")));
}

PointTable read_point_table() {
  PointTable result;
  const Table points("points.csv");
  points.each([&](const io::CsvRow& row) {
    const auto text = [&](std::string_view column) { return points.text(row, column); };
    PointRow point;
    point.code = text("code");
    point.pinyin = text("pinyin");
    point.hanzi = text("hanzi");
    point.meridian = text("meridian");
    point.bilateral = text("side") == "bilateral";
    point.region = text("region");
    point.surface = text("surface");
    point.from = text("from");
    point.toward = text("toward");
    point.along = read_cun(points, row, "along_cun");
    if (!text("across_cun").empty()) point.across = points.number(row, "across_cun");
    point.across_direction = text("across_direction");
    point.level_of = text("level_of");
    if (!text("bow_cun").empty()) point.bow = points.number(row, "bow_cun");
    result.points.push_back(std::move(point));
  });
  const Table needling("needling.csv");
  needling.each([&](const io::CsvRow& row) {
    result.needling[needling.text(row, "code")] = {needling.number(row, "depth_mm_min"),
                                                   needling.number(row, "depth_mm_max"),
                                                   needling.number(row, "angle_deg_to_skin"),
                                                   needling.text(row, "direction"),
                                                   needling.text(row, "caution"),
                                                   needling.text(row, "depth_source")};
  });
  const Table measures("cun.csv");
  measures.each([&](const io::CsvRow& row) {
    result.measures[measures.text(row, "name")] = {measures.text(row, "from_landmark"),
                                                   measures.text(row, "to_landmark"),
                                                   read_cun(measures, row, "cun").amount};
  });
  return result;
}

}  // namespace bodkin::patient
