#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "io/case_folder.h"

// `bodkin register` as a user runs it.

#ifdef BODKIN_HAS_TRACKING

namespace bodkin_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

class Register : public BodkinCommand {
 protected:
  void SetUp() override {
    write("fixed.csv", "name,x,y,z\na,10,0,5\nb,110,0,5\nc,10,80,5\nd,10,0,65\ne,70,50,25\n");
    write("moving.csv", "e,60,50,20\nd,0,0,60\na,0,0,0\nb,100,0,0\nc,0,80,0\n");
  }
};

TEST_F(Register, pairs_by_name_and_says_what_it_is_worth) {
  const Outcome done = bodkin("--json register fixed.csv moving.csv --target 30,30,40 -o placed.json");
  ASSERT_EQ(done.exit_code, 0) << done.text();
  const nlohmann::json json = nlohmann::json::parse(done.output);
  EXPECT_LT(json["fre_rms_mm"], 1e-6);
  EXPECT_EQ(json["residuals_mm"].size(), 5U);
  EXPECT_TRUE(json.contains("tre_mm"));
  const nlohmann::json placed = nlohmann::json::parse(text_of("placed.json"));
  EXPECT_NEAR(placed["fixed_from_moving"][3], 10.0, 1e-6);
  EXPECT_EQ(placed["tre_mm"], json["tre_mm"]);
  EXPECT_EQ(placed["target_mm"], nlohmann::json::parse("[30, 30, 40]"));
}

TEST_F(Register, says_what_the_interval_of_the_error_holds) {
  const Outcome done = bodkin("register fixed.csv moving.csv --target 30,30,40");
  EXPECT_THAT(done.output, MatchesRegex("(.|\n)*TRE at the target: [0-9.]+ mm RMS; its RMS lies between [0-9.]+ and "
                                        "[0-9.]+ mm in 9 of 10 registrations\n"));
}

// Patient to mannequin to board.
TEST_F(Register, is_followed_by_an_earlier_one) {
  write("board.csv", "a,-5,10.3,0\nb,-5,110,0\nc,-85.2,10,0\nd,-5,10,60.4\ne,-55,70,20.1\n");
  write("mannequin.csv", "a,10,0,5\nb,110,0.3,5\nc,10,80,5.2\nd,10.1,0,65\ne,70,50,25\n");
  ASSERT_EQ(bodkin("-q register board.csv fixed.csv --target 40,30,45 -o board.json").exit_code, 0);
  ASSERT_EQ(bodkin("-q register mannequin.csv moving.csv --target 30,30,40 -o alone.json").exit_code, 0);
  const Outcome done =
      bodkin("register mannequin.csv moving.csv --target 30,30,40 --then board.json -o chained.json");
  ASSERT_EQ(done.exit_code, 0) << done.text();
  EXPECT_THAT(done.output, HasSubstr("through board.json: scale 1.00000; TRE at the target"));
  const auto estimate = [&](const char* file) {
    return nlohmann::json::parse(text_of(file))["tre_mm"]["estimate"].get<double>();
  };
  // Both targets have the same place.
  EXPECT_NEAR(estimate("chained.json"), std::hypot(estimate("alone.json"), estimate("board.json")), 0.01);
  const nlohmann::json chained = nlohmann::json::parse(text_of("chained.json"));
  EXPECT_EQ(chained["target_mm"], nlohmann::json::parse("[30, 30, 40]"));
  EXPECT_NEAR(chained["fixed_from_moving"][1].get<double>(), -1.0, 0.02);
  EXPECT_NEAR(chained["fixed_from_moving"][3].get<double>(), -5.0, 0.5);
  // Its result can be chained again.
  EXPECT_EQ(bodkin("register mannequin.csv moving.csv --then chained.json").exit_code, 0);
}

// The same chain, whichever of the two is computed last.
TEST_F(Register, follows_an_earlier_one_as_well) {
  write("plate.csv", "a,-5,10.3,0\nb,-5,110,0\nc,-85.2,10,0\nd,-5,10,60.4\ne,-55,70,20.1\n");
  write("dummy.csv", "a,10,0,5\nb,110,0.3,5\nc,10,80,5.2\nd,10.1,0,65\ne,70,50,25\n");
  ASSERT_EQ(bodkin("-q register plate.csv fixed.csv -o outer.json").exit_code, 0);
  ASSERT_EQ(bodkin("-q register dummy.csv moving.csv -o inner.json").exit_code, 0);
  ASSERT_EQ(bodkin("-q register dummy.csv moving.csv --target 30,30,40 --then outer.json -o then.json").exit_code, 0);
  const Outcome done = bodkin("register plate.csv fixed.csv --target 30,30,40 --first inner.json -o first.json");
  ASSERT_EQ(done.exit_code, 0) << done.text();
  EXPECT_THAT(done.output, HasSubstr("through inner.json: scale 1.00000; TRE at the target"));
  const nlohmann::json then = nlohmann::json::parse(text_of("then.json")),
                       first = nlohmann::json::parse(text_of("first.json"));
  for (std::size_t i = 0; i < 16; ++i)
    EXPECT_NEAR(then["fixed_from_moving"][i].get<double>(), first["fixed_from_moving"][i].get<double>(), 1e-9);
  for (const char* part : {"low", "estimate", "high"})
    EXPECT_NEAR(then["tre_mm"][part].get<double>(), first["tre_mm"][part].get<double>(), 1e-6) << part;
  EXPECT_EQ(first["target_mm"], nlohmann::json::parse("[30, 30, 40]"));
  // Each has the residuals of its own points.
  EXPECT_NE(then["fre_rms_mm"], first["fre_rms_mm"]);
}

TEST_F(Register, a_registration_that_tells_no_errors_is_followed_without_a_prediction) {
  write("silent.json", "{\"fixed_from_moving\": [1,0,0,7, 0,1,0,0, 0,0,1,0, 0,0,0,1]}");
  const Outcome done = bodkin("--json register fixed.csv moving.csv --target 30,30,40 --then silent.json");
  ASSERT_EQ(done.exit_code, 0) << done.text();
  EXPECT_THAT(done.errors, HasSubstr("silent.json does not contain its errors"));
  const nlohmann::json json = nlohmann::json::parse(done.output);
  EXPECT_FALSE(json.contains("tre_mm"));
  EXPECT_NEAR(json["fixed_from_moving"][3].get<double>(), 17.0, 1e-6);
  write("broken.json",
        "{\"fixed_from_moving\": [1,0,0,7, 0,1,0,0, 0,0,1,0, 0,0,0,1], \"errors\": {\"middle_mm\": [0,0,0], "
        "\"freedom\": 6, \"covariance\": [1, 2]}}");
  const Outcome broken = bodkin("register fixed.csv moving.csv --then broken.json");
  EXPECT_EQ(broken.exit_code, 2);
  EXPECT_THAT(broken.errors, HasSubstr("broken.json: \"errors\": \"covariance\" is not valid, expected 49 numbers"));
}

TEST_F(Register, draws_points_residuals_and_the_target) {
  write("pushed.csv", "name,x,y,z\na,10.4,0,5\nb,110,0.3,5\nc,10,80,5.5\nd,10,0,65\ne,70,50,25\n");
  const std::string command = "--quiet register pushed.csv moving.csv --target 30,30,40 --picture ";
  ASSERT_EQ(bodkin(command + "placed.svg").exit_code, 0);
  const std::string drawing = text_of("placed.svg");
  for (const char* words :
       {"from the front", "from the side", "fixed point", "moving point after registration",
        "residual, drawn 20 times as long", "target; circle: its TRE", ">a<", ">b<", ">c<", ">d<", ">e<"}) {
    EXPECT_THAT(drawing, HasSubstr(words));
  }
  ASSERT_EQ(bodkin(command + "placed.png").exit_code, 0);
  EXPECT_THAT(text_of("placed.png"), HasSubstr("PNG"));
  const Outcome refused = bodkin(command + "placed.pdf");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("expected a file that ends in .svg or .png"));
}

TEST_F(Register, pairs_points_without_names) {
  write("bare.csv", "60,50,20\n0,0,60\n0,0,0\n100,0,0\n0,80,0\n");
  const Outcome done = bodkin("--json register fixed.csv bare.csv --match");
  ASSERT_EQ(done.exit_code, 0) << done.text();
  EXPECT_LT(nlohmann::json::parse(done.output)["fre_rms_mm"], 1e-6);
}

TEST_F(Register, refuses_what_leaves_the_place_open) {
  write("line.csv", "0,0,0\n10,0,0\n20,0,0\n");
  const Outcome line = bodkin("register line.csv line.csv");
  EXPECT_EQ(line.exit_code, 2);
  EXPECT_THAT(line.errors, HasSubstr("on a line"));
  write("square.csv", "0,0,0\n50,0,0\n50,50,0\n0,50,0\n");
  EXPECT_THAT(bodkin("register square.csv square.csv --match").errors, HasSubstr("more than one way"));
  write("two.csv", "0,0,0\n50,0,0\n");
  EXPECT_THAT(bodkin("register two.csv two.csv").errors, HasSubstr("at least 3"));
}

TEST_F(Register, points_to_be_matched_are_counted_first) {
  write("couple.csv", "0,0,0\n50,0,0\n");
  const Outcome few = bodkin("register couple.csv fixed.csv --match");
  EXPECT_EQ(few.exit_code, 2);
  EXPECT_THAT(few.errors, HasSubstr("the number of fixed points is 2, expected at least 3"));
  EXPECT_THAT(bodkin("register fixed.csv couple.csv --match").errors, HasSubstr("the number of moving points is 2"));
}

TEST_F(Register, points_to_be_matched_must_not_lie_on_a_line) {
  write("straight.csv", "0,0,0\n10,0,0\n25,0,0\n60,0.1,0\n");
  const Outcome straight = bodkin("register fixed.csv straight.csv --match");
  EXPECT_EQ(straight.exit_code, 2);
  EXPECT_THAT(straight.errors, HasSubstr("the moving points lie on a line"));
  // One point off the line in each set, but a different one.
  write("off_left.csv", "0,0,0\n10,0,0\n25,0,0\n60,0,0\n20,90,0\n");
  write("off_right.csv", "0,0,0\n10,0,0\n25,0,0\n60,0,0\n20,0,40\n");
  const Outcome apart = bodkin("register off_left.csv off_right.csv --match");
  EXPECT_EQ(apart.exit_code, 2);
  EXPECT_THAT(apart.errors, HasSubstr("match in both sets are on a line"));
}

// Beads are found from the largest to the smallest, which is not an order for pairing.
TEST_F(Register, beads_of_a_ct_are_never_paired_by_their_order) {
  std::filesystem::create_directory(folder_ / "scanned");
  for (const char* points : {"fixed.csv scanned", "scanned fixed.csv"}) {
    const Outcome refused = bodkin("register " + std::string(points));
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors,
                HasSubstr("scanned: the beads of a CT have neither names nor an order; give --match"));
  }
  // With --match the folder itself is read.
  EXPECT_THAT(bodkin("register fixed.csv scanned --match").errors, Not(HasSubstr("--match")));
}

TEST_F(Register, points_without_a_partner_are_said) {
  write("others.csv", "a,0,0,0\nb,100,0,0\nc,0,80,0\nd,0,0,60\nmole,60,50,20\n");
  const Outcome done = bodkin("--json register fixed.csv others.csv");
  ASSERT_EQ(done.exit_code, 0) << done.text();
  EXPECT_EQ(nlohmann::json::parse(done.output)["residuals_mm"].size(), 4U);
  EXPECT_THAT(done.errors, HasSubstr("fixed.csv: no point of others.csv belongs to 'e'; left out"));
  EXPECT_THAT(done.errors, HasSubstr("others.csv: no point of fixed.csv belongs to 'mole'; left out"));
  write("bare_more.csv", "60,50,20\n0,0,60\n0,0,0\n100,0,0\n0,80,0\n-31,7,93\n");
  const Outcome matched = bodkin("register fixed.csv bare_more.csv --match");
  EXPECT_EQ(matched.exit_code, 0) << matched.text();
  EXPECT_THAT(matched.errors, HasSubstr("bare_more.csv: no point of fixed.csv belongs to '6'; left out"));
  EXPECT_THAT(matched.output, HasSubstr("a - 3"));
}

TEST_F(Register, what_is_paired_by_order_is_said_and_needs_as_many_of_both) {
  write("in_order.csv", "0,0,0\n100,0,0\n0,80,0\n0,0,60\n60,50,20\n");
  const Outcome done = bodkin("register fixed.csv in_order.csv");
  EXPECT_EQ(done.exit_code, 0) << done.text();
  EXPECT_THAT(done.errors,
              HasSubstr("in_order.csv has no names: its points are taken in the order of those of fixed.csv"));
  write("fewer.csv", "0,0,0\n100,0,0\n0,80,0\n");
  const Outcome fewer = bodkin("register fixed.csv fewer.csv");
  EXPECT_EQ(fewer.exit_code, 2);
  EXPECT_THAT(fewer.errors, HasSubstr("5 fixed and 3 moving points"));
}

TEST_F(Register, a_name_that_stands_twice_is_refused) {
  write("twice.csv", "a,0,0,0\nb,100,0,0\na,0,80,0\nd,0,0,60\n");
  const Outcome twice = bodkin("register fixed.csv twice.csv");
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_THAT(twice.errors, HasSubstr("twice.csv, line 3: there is a point called 'a' already"));
}

TEST_F(Register, exchanged_names_are_said) {
  write("exchanged.csv", "e,60,50,20\nc,0,0,60\na,0,0,0\nb,100,0,0\nd,0,80,0\n");
  const Outcome done = bodkin("register fixed.csv exchanged.csv");
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_THAT(done.errors, HasSubstr("points c and d fit far better when they are exchanged"));
  // The same with inexact points.
  write("noisy.csv", "e,60.4,49.7,20.2\nc,0.3,-0.4,60.1\na,-0.2,0.5,0.3\nb,99.6,0.2,-0.4\nd,0.1,80.3,0.5\n");
  EXPECT_THAT(bodkin("register fixed.csv noisy.csv").errors, HasSubstr("points c and d fit far better"));
}

// The exchanged two of a rectangle's corners cannot be identified: the other two fit as well.
TEST_F(Register, every_exchange_that_fits_is_named) {
  write("rectangle.csv", "k,0,0,0\nl,120,0,0\nm,120,70,0\nn,0,70,0\n");
  write("mistaken.csv", "l,0,0,0\nk,120,0,0\nm,120,70,0\nn,0,70,0\n");
  EXPECT_THAT(bodkin("register rectangle.csv mistaken.csv").errors,
              AllOf(HasSubstr("k and l"), HasSubstr(", or "), HasSubstr("m and n")));
}

TEST_F(Register, a_scale_that_would_fit_is_said) {
  write("larger.csv", "e,60.6,50.5,20.2\nd,0,0,60.6\na,0,0,0\nb,101,0,0\nc,0,80.8,0\n");
  EXPECT_THAT(bodkin("register fixed.csv larger.csv").errors, HasSubstr("a scale of 0.9901"));
  EXPECT_EQ(bodkin("register fixed.csv larger.csv --scale").errors, "");
  EXPECT_EQ(bodkin("register fixed.csv moving.csv").errors, "");
}

class RegisterCase : public PatientCommand {};

// Balls of 3 mm radius in foam within a patient's CT, some of a list of points and one more.
TEST_F(RegisterCase, beads_of_a_ct_are_matched_with_points) {
  bodkin::anatomy::Case beaded = bodkin::io::load_case(patient());
  const bodkin::anatomy::Grid& grid = beaded.ct.grid;
  const std::vector<bodkin::Vec3> shares = {
      {0.2, 0.2, 0.2}, {0.8, 0.25, 0.3}, {0.3, 0.75, 0.25}, {0.7, 0.6, 0.8}, {0.25, 0.3, 0.7}};
  const bodkin::Vec3 shift(7.0, -20.0, 300.0);
  std::string points = "1000,0,0\n";  // belongs to no bead
  for (const bodkin::Vec3& share : shares) {
    std::array<int, 3> middle{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      middle[axis] = static_cast<int>(share[static_cast<int>(axis)] * grid.size[axis]);
    const bodkin::Vec3 centre = grid.to_patient(bodkin::Vec3(middle[0], middle[1], middle[2]));
    constexpr int around = 6;  // voxels
    for (int k = -around; k <= around; ++k) {
      for (int j = -around; j <= around; ++j) {
        for (int i = -around; i <= around; ++i) {
          const double away = bodkin::Vec3(i, j, k).cwiseProduct(grid.spacing).norm();
          beaded.ct.at(middle[0] + i, middle[1] + j, middle[2] + k) = away < 3.0 ? 2500 : -900;
        }
      }
    }
    const bodkin::Vec3 seen = centre + shift;
    points += std::to_string(seen.x()) + "," + std::to_string(seen.y()) + "," + std::to_string(seen.z()) + "\n";
  }
  write("seen.csv", points);
  std::filesystem::create_directory(folder_ / "beaded");
  bodkin::io::write_case(beaded.description, beaded.ct, beaded.tissues, beaded.structures, &beaded.library,
                         folder_ / "beaded");
  const Outcome done = bodkin("--json register seen.csv beaded --match -o seen.json");
  ASSERT_EQ(done.exit_code, 0) << done.text();
  const nlohmann::json json = nlohmann::json::parse(done.output);
  EXPECT_EQ(json["residuals_mm"].size(), shares.size());
  EXPECT_LT(json["fre_rms_mm"].get<double>(), 0.05);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(json["fixed_from_moving"][4 * axis + 3].get<double>(), shift[static_cast<int>(axis)], 0.2);
  EXPECT_THAT(done.errors, HasSubstr("seen.csv: no point of beaded belongs to '1'; left out"));
}

}  // namespace
}  // namespace bodkin_test

#endif
