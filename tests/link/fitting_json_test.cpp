// A score longer than a STRING's limit still arrives as JSON.
#include "link/fitting_json.h"

#include "link/contents.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin::link {
namespace {

using nlohmann::json;

TEST(FittingJson, what_fits_and_what_is_no_object_stay_as_they_are) {
  EXPECT_EQ(fitting_json(R"({"a": 1})"), R"({"a": 1})");
  EXPECT_EQ(fitting_json("no object", 3), "no object");
}

TEST(FittingJson, a_long_score_keeps_its_verdict_and_its_first_findings) {
  json score = {{"verdict", "fail"}, {"headline", "the needle went too far"}, {"depth_mm", 47.5}};
  for (int i = 0; i < 2000; ++i)
    score["findings"].push_back({{"number", i}, {"sentence", "The tip entered a nerve root: paralysis."}});
  score["curve"] = std::string(30000, 'x');
  const std::string whole = score.dump();
  ASSERT_GT(whole.size(), longest_string);
  const std::string sent = read_string(string_content(fitting_json(whole)));
  EXPECT_LE(sent.size(), longest_string);
  EXPECT_GT(sent.size(), longest_string / 4);
  const json read = json::parse(sent);
  EXPECT_EQ(read["verdict"], "fail");
  EXPECT_EQ(read["headline"], score["headline"]);
  EXPECT_EQ(read["depth_mm"], 47.5);
  ASSERT_FALSE(read["findings"].empty());
  EXPECT_EQ(read["findings"][0]["number"], 0);
  EXPECT_EQ(read["findings"].back()["number"], read["findings"].size() - 1) << "the first ones, in their order";
  EXPECT_EQ(read["left_out"].front(), "findings");
}

}  // namespace
}  // namespace bodkin::link
