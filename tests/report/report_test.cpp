#include "report/report.h"

#include <regex>

#include "report/force_plot.h"
#include "report/probe_figures.h"
#include "study/profile.h"
#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "io/probe_library_file.h"
#include "io/run_program.h"
#include "training/procedure_file.h"
#include "training/score.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::report;
using namespace bodkin::session;
using namespace bodkin::study;
namespace {

Session session_of(const Profile& profile) {
  Session session;
  session.ticks = profile.ticks;
  session.events = events_of(profile.ticks);
  session.header.dt = profile.dt;
  session.header.path = profile.path;
  session.header.operator_name = "expert";
  session.header.haptics.resistance = FractureSettings{.width = 0.7};
  session.header.haptics.constraint = NoConstraint{};
  session.header.haptics.parts.shaft_friction = ShaftFrictionSettings{.stribeck_velocity = 6.0};
  session.header.bodkin_version = "0.1.0";
  session.header.seed = 42;
  session.header.started_at = "2026-11-21T02:00:00Z";
  session.finished = true;
  const TissueLibrary library = default_tissue_library();
  for (const TissueProperties& each : library.tissues())
    session.header.tissues.push_back({each.id, each.name, each.title});
  return session;
}

struct Made {
  Case patient = slab_case(lumbar_slabs());
  Session session = session_of(insert_at_constant_speed(patient, {}));

  std::string html(bool changed = false) {
    return report_html(session, patient,
                       training::score(session, patient.description, training::find_procedure("lumbar_puncture"),
                                       {&patient.structures, &patient.tissues}),
                       changed);
  }
};

void expect_well_formed_page(const std::string& html) {
  const ProgramResult result = run_program({"xmllint", "--huge", "--noout", "-"}, html, "libxml2-utils");
  EXPECT_EQ(result.exit_code, 0) << result.errors.substr(0, 500);
}

TEST(Report, is_one_well_formed_page_that_refers_to_nothing_outside) {
  Made made;
  const std::string html = made.html();
  expect_well_formed_page(html);
  EXPECT_LT(html.size(), 5'000'000U);
  for (const char* outside : {"http://", "https://", "<link", "<script", "<iframe", "@import", "url("}) {
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  }
  const std::regex source("src=\"([^\"]{0,30})");
  int pictures = 0;
  for (std::sregex_iterator i(html.begin(), html.end(), source), end; i != end; ++i, ++pictures) {
    EXPECT_EQ((*i)[1].str().substr(0, 25), "data:image/svg+xml;base64");
  }
  EXPECT_EQ(pictures, 5);
}

TEST(Report, tells_tissues_events_measures_and_provenance) {
  Made made;
  const std::string html = made.html();
  for (const auto& [id, thickness] : lumbar_slabs()) {
    EXPECT_NE(html.find(">" + std::string("</i>") + made.patient.library.title(id)), std::string::npos) << int{id};
  }
  for (const char* text :
       {"skin gives way", "loss of resistance", "largest resistance", "<td class=\"long\">42</td>", "0.1.0",
        "2026-11-21T02:00:00Z", "expert", "fracture stiffness_N_per_mm=0.05 ", "width_mm=0.7 ",
        "<td class=\"long\">none</td>", "shaft_friction stribeck_velocity_mm_per_s=6"}) {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
}

TEST(Report, names_from_files_are_text_and_nothing_else) {
  Made made;
  const std::string evil = "<img src=x onerror=alert(1)>\"'&</title><script>";
  made.patient.description.name = evil;
  made.patient.description.procedure.name = evil;
  made.session.header.operator_name = evil;
  made.session.header.case_folder = evil;
  made.session.header.operator_settings = evil;
  const std::string html = made.html();
  expect_well_formed_page(html);
  EXPECT_EQ(html.find("<img src=x"), std::string::npos);
  EXPECT_EQ(html.find("<script"), std::string::npos);
}

TEST(Report, tables_repeat_their_heads_on_paper_and_settings_are_folded_away) {
  Made made;
  made.session.header.operator_settings = R"({"name":"expert","hand":{"mass_kg":0.3}})";
  const std::string html = made.html();
  expect_well_formed_page(html);
  const auto count = [&](const std::string& text) {
    int found = 0;
    for (std::size_t at = html.find(text); at != std::string::npos; at = html.find(text, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("<thead>"), 5);  // steps, tissues, distances, events and measures
  EXPECT_NE(html.find("Distances to what must not be entered"), std::string::npos);
  EXPECT_EQ(count("<details>"), 1);
  EXPECT_NE(html.find("\n  &quot;hand&quot;: {"), std::string::npos) << html.substr(html.find("<details>"), 300);
}

TEST(Report, is_green_for_a_pass_alone) {
  Made made;
  for (simulation::TickRecord& record : made.session.ticks) {
    if (record.output.depth > 44.0) record.output.tissue = tissue::nerve;
  }
  EXPECT_NE(made.html().find("<div class=\"verdict dangerous\"><strong>Dangerous: the tip entered a nerve root"),
            std::string::npos);
  EXPECT_EQ(made.html().find("<div class=\"verdict pass\">"), std::string::npos);
}

TEST(Report, of_a_recording_that_broke_off_says_so) {
  Made made;
  EXPECT_EQ(made.html().find("broke off"), std::string::npos);
  made.session.finished = false;
  made.session.ticks.resize(2000);
  EXPECT_NE(made.html().find("broke off"), std::string::npos);
}

TEST(Report, of_a_needle_that_never_touched_can_be_written) {
  Made made;
  made.session.ticks.resize(50);
  made.session.events.clear();
  const std::string html = made.html(true);
  expect_well_formed_page(html);
  EXPECT_NE(html.find("never touched"), std::string::npos);
  EXPECT_NE(html.find("has changed since the recording"), std::string::npos);
}

// A probe on the screen, whose slice holds the path, tilts by 12 degrees and slides by 10 mm.
TEST(Report, shows_where_the_ultrasound_probe_was) {
  Made made;
  const std::string without = made.html();
  EXPECT_EQ(without.find("Where the ultrasound probe was"), std::string::npos);
  Session& session = made.session;
  session.header.ultrasound = io::find_probe("L12-3");
  const NeedlePath path = session.header.path;
  const Vec3 into = path.direction();
  for (int i = 0; i <= 10; ++i) {
    ScanSample sample;
    sample.time = 0.1 * i;
    const Vec3 side = into.unitOrthogonal();
    sample.probe.linear() << side, into, side.cross(into);
    sample.probe.rotate(Eigen::AngleAxisd(1.2 * i * degree, Vec3::UnitX()));
    sample.probe.translation() = path.entry + (1.0 * i - 5.0) * side;
    sample.settings.depth = 60.0;
    session.scans.push_back(sample);
  }
  const std::string html = made.html();
  expect_well_formed_page(html);
  EXPECT_NE(html.find("The probe moved by 10 mm and turned by up to 12 deg from where it began. It first showed the "
                      "target after 0.0 s. With the needle in the body, the tip was in the slice for "),
            std::string::npos);
  EXPECT_NE(html.find("with the edges of its picture"), std::string::npos);
  const ProbeFigures figures(session);
  const auto panels = figures.panels(made.patient, {{0.0, "at first"}, {1.0, "at last"}}, {path.entry, path.target});
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[0].title, "slice of the probe at first");
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const imaging::SlicePlane& plane = panels[i].slice.plane;
    const Pose& held = session.scans[10 * i].probe;
    EXPECT_NEAR(plane.distance(held.translation()), 0.0, 1e-9);
    EXPECT_NEAR(std::abs(plane.normal().dot(held.linear().col(2))), 1.0, 1e-9);
    EXPECT_NEAR((plane.down - held.linear().col(1)).norm(), 0.0, 1e-9) << "the face is above";
    // The picture of a linear probe is as wide as its face, and as deep as was set.
    double width = 0.0, depth = 0.0;
    for (const Vec3& corner : panels[i].outline) {
      width = std::max(width, 2.0 * std::abs((corner - held.translation()).dot(plane.right)));
      depth = std::max(depth, (corner - held.translation()).dot(plane.down));
      EXPECT_NEAR(plane.distance(corner), 0.0, 1e-9);
    }
    EXPECT_NEAR(width, session.header.ultrasound->aperture(), 1.0);
    EXPECT_NEAR(depth, 60.0, 1e-9);
  }
  EXPECT_NEAR((figures.path(0.5).face.back() - session.scans.back().probe.translation()).norm(), 0.0, 1e-9);
}

TEST(Report, shows_what_the_second_hand_felt) {
  for (const SecondRole role : {SecondRole::plunger, SecondRole::probe}) {
    Made made;
    made.session.header.second = SecondHeader{role, "{}"};
    for (int i = 0; i < 100; ++i) {
      SecondSample sample;
      sample.time = 0.01 * i;
      sample.force = 0.1 * i;
      sample.pressure = 5e-4 * i;
      made.session.second.push_back(sample);
    }
    const std::vector<Plot> plots = second_hand_against_time(made.session);
    const bool is_plunger = role == SecondRole::plunger;
    ASSERT_EQ(plots.size(), is_plunger ? 2u : 1u);
    EXPECT_NEAR(plots.back().series.back().y.back(), 9.9, 1e-12);
    if (is_plunger) {
      EXPECT_NEAR(plots.front().series.back().y.back(), 49.5, 1e-12) << "kPa";
    }
    const std::string html = made.html();
    expect_well_formed_page(html);
    EXPECT_NE(html.find(is_plunger ? "The second hand: the plunger" : "The second hand: the ultrasound probe"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace bodkin
