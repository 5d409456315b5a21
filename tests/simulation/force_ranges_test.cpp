// The engine accepts everything that the case schema allows: no case is refused later only for a number.
#include <regex>
#include <string>
#include <vector>

#include "tests/fem/dense_body.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/haptics_xml.h"
#include "io/resources.h"
#include "io/tissue_library_file.h"
#include "io/xml_document.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::simulation;
namespace {

// A few voxels of muscle and a device without limits.
Case strong_patient() {
  Case patient;
  patient.library = default_tissue_library();
  Grid grid;
  grid.size = {20, 20, 20};  // room for a smooth surface
  patient.tissues = TissueVolume(grid, tissue::muscle);
  patient.ct = CtVolume(grid, 45);
  patient.description.device = {"strong", 1e3, 1e3, 1e6, 1e9, 0.0};
  patient.description.procedure.path = NeedlePath{Vec3::Zero(), Vec3(0.0, 0.0, 4.0)};
  return patient;
}

struct ForceRange {
  std::string attribute, low, high;
};

// The numbers that an element's type may hold.
std::vector<ForceRange> ranges_of(const std::string& schema, const std::string& type) {
  const auto piece = [&schema](const std::string& from, const std::string& to) {
    const auto begin = schema.find(from);
    EXPECT_NE(begin, std::string::npos) << from;
    return schema.substr(begin, schema.find(to, begin) - begin);
  };
  const std::string text = piece("<xs:complexType name=\"" + type + "\">", "\n  </xs:complexType>");
  static const std::regex attribute("\n    <xs:attribute name=\"(\\w+)\" default=\"[^\"]*\" type=\"(\\w+)\"/>");
  static const std::regex low("minInclusive value=\"([^\"]+)\""), high("maxInclusive value=\"([^\"]+)\"");
  std::vector<ForceRange> ranges;
  for (std::sregex_iterator match(text.begin(), text.end(), attribute), last; match != last; ++match) {
    const std::string bounds = piece("<xs:simpleType name=\"" + (*match)[2].str() + "\">", "</xs:simpleType>");
    std::smatch from, to;
    if (!std::regex_search(bounds, to, high)) continue;  // a word
    const bool closed = std::regex_search(bounds, from, low);
    ranges.push_back({(*match)[1], closed ? from[1].str() : "1e-9", to[1]});
  }
  return ranges;
}

// Values required with an end of a range because one value bounds another.
std::string beside(const std::string& model, const ForceRange& range, bool at_low) {
  const auto pair = [](const char* name, const char* value) {
    return std::string(" ").append(name).append("='").append(value).append("'");
  };
  if (model == "depth_profile" && range.attribute == "trailing_mm" && !at_low) return pair("puncture_depth_mm", "50");
  if (model == "depth_profile" && range.attribute == "puncture_depth_mm" && at_low) return pair("trailing_mm", "0.1");
  if (range.attribute == "gradient_least_per_mm" && !at_low) return pair("gradient_reference_per_mm", "1000");
  if (range.attribute == "gradient_reference_per_mm" && at_low) return pair("gradient_least_per_mm", "0");
  if (range.attribute == "field_lowest_HU" && !at_low) return pair("field_highest_HU", "4000");
  if (range.attribute == "cutting_force_N" && !at_low) return pair("puncture_force_N", "50");
  if (range.attribute == "puncture_force_N" && at_low) return pair("cutting_force_N", "0.01");
  if (range.attribute == "cut_offset_mm" && !at_low) return pair("flexible", "true");
  if (range.attribute == "dynamic_friction" && !at_low) return pair("static_friction", "10");
  if (range.attribute == "static_friction" && at_low) return pair("dynamic_friction", "0");
  if (range.attribute == "two_way" && !at_low) return pair("one_way", "10");
  if (range.attribute == "one_way" && at_low) return pair("two_way", "0");
  return {};
}

TEST(ForceRanges, both_ends_of_every_range_of_the_schema_can_be_simulated) {
  const XmlSchema schema("case.xsd");
  const std::string text = read_text_file(shared_file("case.xsd"), 1 << 20);
  Case patient = strong_patient();
  int tried = 0;
  const auto attempt = [&](const std::string& model, const std::string& before, const std::string& after) {
    const CondensedBody body = checks::kelvin_body(1, 4, 1.5);
    patient.prepared = {std::make_shared<CondensedBody>(model == "closest_node" ? body : checks::as_points(body)),
                        NeedlePath{Vec3::Zero(), Vec3(0.0, 0.0, 5.0)}};
    for (const ForceRange& range : ranges_of(text, model)) {
      for (const bool at_low : {true, false}) {
        if (range.attribute == "field_highest_HU" && at_low) continue;  // nothing lower is allowed for the lowest
        const std::string element = std::string("<").append(model).append(" ") + range.attribute + "='" +
                                    (at_low ? range.low : range.high) + "'" + beside(model, range, at_low) + "/>";
        const std::string document = "<haptics>" + before + element + after + "</haptics>";
        try {
          patient.description.haptics = parse_haptics_xml(document, "ranges", schema);
          const HapticTick tick(patient);
          ++tried;
        } catch (const InputError& error) {
          ADD_FAILURE() << document << ": " << error.what();
        }
      }
    }
  };
  for (const std::string_view name : resistance_names) attempt(std::string(name), "<resistance>", "</resistance>");
  for (const std::string_view name : constraint_names) {
    if (name != "none") attempt(std::string(name), "<constraint>", "</constraint>");
  }
  attempt("relaxation", "<resistance><tracking_wall/></resistance><parts>", "</parts>");
  attempt("needle_grasp", "<parts>", "</parts>");
  for (const char* name : {"bevel_tip", "csf_flow", "syringe", "fingertip"}) attempt(name, "<parts>", "</parts>");
  attempt("compensation", "", "");
  EXPECT_GT(tried, 140);
}

}  // namespace
}  // namespace bodkin
