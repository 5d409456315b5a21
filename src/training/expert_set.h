#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bodkin::training {

// Attempts of experts at one procedure, one row each, as a reference for an attempt.
class ExpertSet {
 public:
  // A table in CSV in the format of `bodkin cohort`: one row for each attempt, one column for each metric under its
  // name; other columns are ignored, an empty field means an attempt without that metric. `origin` names it in
  // messages. Throws InputError for a table without rows, or a field of a metric that is not a number.
  static ExpertSet parse(std::string_view text, const std::string& origin);
  static ExpertSet read(const std::filesystem::path& file);
  // The table that comes with Bodkin for a procedure (share/bodkin/experts), if there is one.
  static std::optional<ExpertSet> shipped(const std::string& procedure);

  std::size_t size() const { return attempts_; }
  const std::string& origin() const { return origin_; }

  struct Place {
    double percentile = 0.0;  // fraction of the experts with a smaller value, plus half of those with the same, %
    double z = 0.0;           // distance from their mean in standard deviations; 0 if all have the same value
    double low = 0.0;         // their 5 % and 95 % quantiles
    double high = 0.0;
  };
  // Empty for a metric that fewer than 5 experts have.
  std::optional<Place> place(std::string_view metric, double value) const;

 private:
  struct Column {
    std::string metric;
    std::vector<double> values;  // sorted
  };
  std::vector<Column> columns_;
  std::size_t attempts_ = 0;
  std::string origin_;
};

}  // namespace bodkin::training
