#include "training/score_json.h"

#include <fstream>

#include "tests/training/written_session.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/resources.h"
#include "training/procedure_file.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

using nlohmann::json;

// The keywords of JSON schema used by score.schema.json: type, const, enum, required, additionalProperties,
// properties, items.
void expect_valid(const json& value, const json& schema, const std::string& where) {
  static const std::map<std::string, bool (*)(const json&)> types = {
      {"object", [](const json& v) { return v.is_object(); }},
      {"array", [](const json& v) { return v.is_array(); }},
      {"string", [](const json& v) { return v.is_string(); }},
      {"number", [](const json& v) { return v.is_number(); }},
      {"integer", [](const json& v) { return v.is_number_integer(); }},
      {"boolean", [](const json& v) { return v.is_boolean(); }},
      {"null", [](const json& v) { return v.is_null(); }}};
  if (schema.contains("const")) {
    EXPECT_EQ(value, schema["const"]) << where;
  }
  if (schema.contains("enum")) {
    EXPECT_NE(std::find(schema["enum"].begin(), schema["enum"].end(), value), schema["enum"].end()) << where;
  }
  if (schema.contains("type")) {
    const json names = schema["type"].is_array() ? schema["type"] : json::array({schema["type"]});
    EXPECT_TRUE(std::any_of(names.begin(), names.end(), [&](const json& name) { return types.at(name)(value); }))
        << where << " is " << value.dump();
  }
  if (value.is_object()) {
    for (const auto& name : schema.at("required")) EXPECT_TRUE(value.contains(name)) << where << '.' << name;
    for (const auto& [name, member] : value.items()) {
      ASSERT_TRUE(schema.at("properties").contains(name)) << where << '.' << name;
      expect_valid(member, schema["properties"][name], where + "." + name);
    }
  }
  if (value.is_array()) {
    for (const json& item : value) expect_valid(item, schema.at("items"), where + "[]");
  }
}

json json_of(WrittenSession& written) {
  const Attempt attempt(written.session(), written_description());
  const Score result = score(written.session(), written_description(), find_procedure("lumbar_puncture"));
  return json::parse(score_json(result, attempt, "a.bodkin"));
}

TEST(ScoreJson, has_the_published_form_whatever_happened) {
  std::ifstream stream(io::shared_file("score.schema.json"));
  const json schema = json::parse(stream);
  WrittenSession good = good_puncture(), never, harmful = good_puncture();
  never.rest(1000, WrittenSession::air);
  harmful.session().ticks[5000].output.tissue = tissue::nerve;
  harmful.session().ticks[5100].output.resistance = std::numeric_limits<double>::quiet_NaN();
  for (WrittenSession* written : {&good, &never, &harmful}) expect_valid(json_of(*written), schema, "score");
  EXPECT_EQ(json_of(good).at("verdict"), "pass");
  EXPECT_EQ(json_of(harmful).at("verdict"), "dangerous");
  EXPECT_TRUE(json_of(never).at("final_position").is_null());
}

TEST(ScoreJson, a_row_of_the_table_has_a_field_for_every_column) {
  WrittenSession written = good_puncture();
  const Score result = score(written.session(), written_description(), find_procedure("lumbar_puncture"));
  const std::string head = score_csv_columns(), row = score_csv_fields(result);
  EXPECT_EQ(std::count(head.begin(), head.end(), ','), std::count(row.begin(), row.end(), ','));
  EXPECT_TRUE(row.starts_with("pass,1,"));
  std::string table = head + "\n";
  for (int i = 0; i < 5; ++i) table += row + "\n";
  const auto place = ExpertSet::parse(table, "own").place("path_length_mm", result.find("path_length_mm")->value);
  EXPECT_EQ(place->percentile, 50.0);  // read back bit for bit
}

TEST(ScoreJson, tells_thresholds_that_are_not_the_default) {
  WrittenSession written = good_puncture();
  EXPECT_FALSE(json_of(written).contains("thresholds"));
  training::Procedure procedure = find_procedure("lumbar_puncture");
  procedure.thresholds.retreat = 7.5;
  const Attempt attempt(written.session(), written_description(), procedure.thresholds);
  const Score result = score(written.session(), written_description(), procedure);
  const json told = json::parse(score_json(result, attempt, "a.bodkin"));
  EXPECT_EQ(told.at("thresholds"), json({{"retreat_mm", 7.5}}));
  std::ifstream stream(io::shared_file("score.schema.json"));
  const json schema = json::parse(stream).at("properties").at("thresholds");
  EXPECT_EQ(schema.at("additionalProperties"), json({{"type", "number"}}));
}

}  // namespace
}  // namespace bodkin
