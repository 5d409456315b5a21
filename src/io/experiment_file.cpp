#include "io/experiment_file.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/error.h"
#include "io/case_folder.h"
#include "io/case_xml.h"
#include "io/haptics_xml.h"
#include "io/resources.h"
#include "io/tissue_library_file.h"
#include "io/xml_document.h"

namespace bodkin::io {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_experiment_file = 1 << 20;  // bytes
constexpr double longest = 600.0;                         // s
constexpr anatomy::TissueId first_new_id = 32;            // below are Bodkin's own
constexpr anatomy::TissueId last_new_id = 254;
constexpr double multiple_tolerance = 1e-6;
constexpr double shortest_direction = 1e-6;

Quantity quantity_of(const XmlElement& element, const char* attribute, Quantity fallback) {
  const std::string name = element.string(attribute);
  const auto found = std::find_if(quantity_names.begin(), quantity_names.end(),
                                  [&name](const QuantityName& entry) { return entry.name == name; });
  return found == quantity_names.end() ? fallback : static_cast<Quantity>(found - quantity_names.begin());
}

std::optional<double> given(const XmlElement& element, const char* attribute) {
  return element.find(attribute) == nullptr ? std::nullopt : std::optional(element.number(attribute, 0.0));
}

std::string text_of(const XmlElement& parent, const char* child) {
  const XmlElement* element = parent.child(child);
  return element == nullptr ? std::string() : one_line(element->text);
}

ExperimentWindow window_from(const XmlElement& element, const std::string& origin) {
  const ExperimentWindow window = {given(element, "from_s"), given(element, "to_s"), given(element, "depth_from_mm"),
                                   given(element, "depth_to_mm")};
  const auto check = [&](const std::optional<double>& from, const std::optional<double>& to, const char* what) {
    if (from && to && !(*from < *to)) {
      fail_at(origin, element.line,
              fmt::format("{} goes from {} {} to {}, expected an end after the beginning", element.name, *from, what,
                          *to));
    }
  };
  check(window.time_from, window.time_to, "s");
  check(window.depth_from, window.depth_to, "mm");
  return window;
}

anatomy::TissueLibrary library_from(std::vector<anatomy::TissueProperties> tissues, const XmlElement* changes,
                                    const std::string& origin) {
  if (changes == nullptr) return anatomy::TissueLibrary(std::move(tissues));
  const auto find = [&tissues](const std::string& name) {
    return std::find_if(tissues.begin(), tissues.end(),
                        [&](const anatomy::TissueProperties& t) { return t.name == name; });
  };
  for (const XmlElement& element : changes->children) {
    const std::string name = element.string("name"), like = element.string("like", name);
    const auto model = find(like);
    if (model == tissues.end()) {
      fail_at(
          origin, element.line,
          fmt::format("the tissue library has no tissue {}; to add one, let 'like' name the tissue that it starts "
                      "from",
                      in_quotes(like)));
    }
    auto entry = model;
    if (element.find("like") != nullptr) {
      if (find(name) != tissues.end()) {
        fail_at(
            origin, element.line,
            fmt::format("a tissue {} exists already, so it cannot be 'like' another; leave 'like' out to change it",
                        in_quotes(name)));
      }
      int id = first_new_id;
      for (const anatomy::TissueProperties& tissue : tissues) id = std::max(id, tissue.id + 1);
      if (id > last_new_id) fail_at(origin, element.line, "there are too many tissues, expected ids up to 254");
      anatomy::TissueProperties added = *model;
      added.name = added.title = name;
      added.id = static_cast<anatomy::TissueId>(id);
      entry = tissues.insert(tissues.end(), std::move(added));
    }
    entry->title = element.string("title", entry->title);
    if (const std::string* colour = element.find("colour"); colour != nullptr)
      entry->colour = static_cast<std::uint32_t>(std::stoul(colour->substr(1), nullptr, 16));
    read_tissue_forces(element, origin, *entry);
    // The description of the original tissue does not apply to one with changed forces.
    const bool has_forces = std::any_of(element.children.begin(), element.children.end(),
                                        [](const XmlElement& child) { return child.name != "syringe"; });
    if (has_forces && element.child("physical") == nullptr) entry->physical = {};
  }
  return anatomy::TissueLibrary(std::move(tissues));
}

ExperimentBody body_from(const XmlElement& element, const anatomy::TissueLibrary& library,
                         const std::string& origin) {
  const XmlElement& shape = element.children.front();
  ExperimentBody body;
  if (shape.name == "patient") {
    body.patient = fs::path(origin).parent_path() / shape.string("folder");
    const auto point = [](const XmlElement* at) {
      return at == nullptr
                 ? std::nullopt
                 : std::optional(Vec3(at->number("x_mm", 0.0), at->number("y_mm", 0.0), at->number("z_mm", 0.0)));
    };
    body.entry = point(shape.child("entry"));
    body.target = point(shape.child("target"));
    return body;
  }
  body.hemisphere = shape.name == "hemisphere";
  body.radius = shape.number("radius_mm", 0.0);
  body.width = shape.number("width_mm", body.width);
  body.voxel = shape.number("voxel_mm", body.hemisphere ? 1.0 : body.voxel);
  body.mesh = shape.number("mesh_mm", body.mesh);
  for (const XmlElement& layer : shape.children) {
    const ExperimentLayer read = {layer.string("tissue"), layer.number("thickness_mm", 0.0)};
    if (library.find(read.tissue) == nullptr) {
      fail_at(origin, layer.line,
              fmt::format("tissue_layer tissue is {}, which neither the tissue library nor <changed_tissues> has",
                          in_quotes(read.tissue)));
    }
    const double voxels = read.thickness / body.voxel;
    if (!body.hemisphere && std::abs(voxels - std::round(voxels)) > multiple_tolerance) {
      fail_at(origin, layer.line,
              fmt::format("tissue_layer thickness_mm is {}, expected a multiple of the voxel_mm of {}",
                          read.thickness, body.voxel));
    }
    body.layers.push_back(read);
  }
  return body;
}

ExperimentMotion motion_from(const XmlElement& element, const std::string& origin) {
  ExperimentMotion motion;
  motion.entry = {element.number("entry_x_mm", 0.0), element.number("entry_y_mm", 0.0),
                  element.number("entry_z_mm", 0.0)};
  const Vec3 direction = {element.number("direction_x", 0.0), element.number("direction_y", 0.0),
                          element.number("direction_z", 1.0)};
  if (direction.norm() < shortest_direction)
    fail_at(origin, element.line, "motion has a direction of no length, expected one that points into the body");
  motion.lay_along(motion.entry, direction);
  motion.tilt_about_tip = element.string("tilt_about") == "tip";
  ExperimentPlace place;
  place.depth = element.number("from_mm", -10.0);
  motion.places.push_back(place);
  for (const XmlElement& step : element.children) {
    const ExperimentPlace before = place;
    place.depth = step.number("depth_mm", place.depth);
    place.aside = step.number("aside_mm", place.aside);
    place.tilt = given(step, "tilt_deg") ? step.number("tilt_deg", 0.0) * degree : place.tilt;
    const std::optional<double> speed = given(step, "speed_mm_per_s"), time = given(step, "time_s");
    if (step.name == "move" && speed.has_value() == time.has_value()) {
      fail_at(origin, step.line, "move has both or neither of speed_mm_per_s and time_s, expected one of them");
    }
    const double distance = std::hypot(place.depth - before.depth, place.aside - before.aside);
    if (speed && distance == 0.0)
      fail_at(origin, step.line, "move has a speed_mm_per_s but the tip does not move, expected time_s instead");
    place.time += speed ? distance / *speed : time.value_or(0.0);
    if (place.time > longest) {
      fail_at(origin, step.line,
              fmt::format("the motion takes {:.0f} s up to here, expected at most {} s", place.time, longest));
    }
    if (place.time > before.time) {
      motion.places.push_back(place);
    } else if (distance > 0.0 || place.tilt != before.tilt) {
      fail_at(origin, step.line, "move takes no time, expected a time_s above 0");
    }
  }
  if (motion.places.size() < 2) fail_at(origin, element.line, "the motion takes no time, expected a move");
  return motion;
}

ExperimentPanel panel_from(const XmlElement& element, const std::string& origin) {
  ExperimentPanel panel;
  panel.title = element.string("title");
  panel.x = quantity_of(element, "x", Quantity::time);
  panel.x_label = element.string("x_label");
  panel.y_label = element.string("y_label");
  panel.right_label = element.string("right_label");
  panel.window = window_from(element, origin);
  panel.height = element.number("height_px", panel.height);
  panel.down = element.boolean("down", false);
  panel.tissues = element.boolean("tissues", false);
  for (const XmlElement& curve : element.children) {
    ExperimentCurve read;
    read.quantity = quantity_of(curve, "quantity", read.quantity);
    if (curve.find("x") != nullptr) read.x = quantity_of(curve, "x", panel.x);
    read.name = curve.string("name");
    read.right = curve.string("axis") == "right";
    panel.curves.push_back(std::move(read));
  }
  return panel;
}

PublishedValue value_from(const XmlElement& element, const std::string& origin) {
  PublishedValue value;
  value.what = element.string("what");
  value.source = element.string("source");
  value.quantity = quantity_of(element, "quantity", Quantity::resistance);
  const std::string take = element.string("take", "mean");
  value.aggregation = take == "highest"  ? Aggregation::highest
                      : take == "lowest" ? Aggregation::lowest
                      : take == "first"  ? Aggregation::first
                      : take == "last"   ? Aggregation::last
                                         : Aggregation::mean;
  value.window = window_from(element, origin);
  value.value = element.number("is", 0.0);
  value.tolerance = element.number("tolerance", 0.0);
  return value;
}

// Positions of walls and proxies are known only for the models that have them.
void check_quantities(const Experiment& experiment, const std::string& origin) {
  const auto check = [&](Quantity quantity) {
    const bool wall = quantity >= Quantity::wall && quantity <= Quantity::wall_z;
    const bool proxy = quantity >= Quantity::proxy_x;
    const auto needs = [&](const char* model) {
      throw InputError(fmt::format("{}: the quantity {} needs the resistance {}, found {}", origin,
                                   quantity_names[static_cast<std::size_t>(quantity)].name, model,
                                   anatomy::name_of(experiment.haptics.resistance)));
    };
    if (wall && !std::holds_alternative<anatomy::TrackingWallSettings>(experiment.haptics.resistance))
      needs("tracking_wall");
    if (proxy && !std::holds_alternative<anatomy::VolumeProxySettings>(experiment.haptics.resistance))
      needs("volume_proxy");
  };
  for (const ExperimentPanel& panel : experiment.panels) {
    check(panel.x);
    for (const ExperimentCurve& curve : panel.curves) {
      check(curve.quantity);
      check(curve.x.value_or(panel.x));
    }
  }
  for (const PublishedValue& value : experiment.values) check(value.quantity);
}

}  // namespace

void ExperimentMotion::lay_along(const Vec3& from, const Vec3& towards) {
  entry = from;
  direction = towards.normalized();
  // Along x, projected perpendicular to the line.
  const Vec3 side = std::abs(direction.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  across = (side - side.dot(direction) * direction).normalized();
}

Experiment parse_experiment(std::string_view document, const std::string& origin) {
  static const XmlSchema schema("experiment.xsd");
  const XmlElement root = schema.read(document, origin, {.root = "experiment"});
  Experiment experiment;
  experiment.name = root.string("name");
  experiment.title = root.string("title");
  experiment.paper = text_of(root, "paper");
  const XmlElement& caption = *root.child("caption");
  experiment.caption = {text_of(caption, "reproduces"), text_of(caption, "parameters"), text_of(caption, "agrees"),
                        text_of(caption, "differs")};
  const XmlElement& body = *root.child("body");
  const bool in_patient = body.children.front().name == "patient";
  std::vector<anatomy::TissueProperties> tissues = default_tissue_library().tissues();
  if (in_patient) {
    const fs::path folder = fs::path(origin).parent_path() / body.children.front().string("folder");
    const anatomy::CaseDescription description = read_case_description(folder);
    tissues = read_case_library(folder, description).tissues();
    experiment.needle = description.needle;
    experiment.device = description.device;
    experiment.haptics = description.haptics;
  }
  experiment.library = library_from(std::move(tissues), root.child("changed_tissues"), origin);
  experiment.body = body_from(body, experiment.library, origin);
  if (const XmlElement* needle = root.child("needle"); needle != nullptr)
    experiment.needle = read_needle(*needle, origin);
  if (const XmlElement* device = root.child("device"); device != nullptr)
    experiment.device = read_device(*device, origin);
  if (const XmlElement* haptics = root.child("haptics"); haptics != nullptr)
    experiment.haptics = read_haptics(*haptics, origin);
  else if (!in_patient)
    fail_at(origin, root.line,
            "the experiment has no haptics, expected them with the resistance; only a patient has its own");
  const XmlElement& motion = *root.child("motion");
  for (const char* place : {"entry_x_mm", "entry_y_mm", "entry_z_mm", "direction_x", "direction_y", "direction_z"}) {
    if (in_patient && motion.find(place) != nullptr)
      fail_at(origin, motion.line,
              fmt::format("motion has {}, but in a patient it runs along the path; expected entry "
                          "and target in <patient>",
                          place));
  }
  experiment.motion = motion_from(motion, origin);
  if (root.child("needle") == nullptr && !in_patient) {  // a needle without a stated length has no hub stop
    for (const ExperimentPlace& place : experiment.motion.places)
      experiment.needle.length = std::max(experiment.needle.length, place.depth + 1.0);
  }
  for (const XmlElement& panel : root.child("plot")->children) experiment.panels.push_back(panel_from(panel, origin));
  if (const XmlElement* published = root.child("published"); published != nullptr) {
    for (const XmlElement& value : published->children) experiment.values.push_back(value_from(value, origin));
  }
  check_quantities(experiment, origin);
  return experiment;
}

Experiment read_experiment(const fs::path& file) {
  return parse_experiment(read_text_file(file, largest_experiment_file), file.string());
}

std::vector<fs::path> shipped_experiments() {
  const fs::path folder = shared_file("experiments/alamilla_2018_fig_5.xml").parent_path();
  std::vector<fs::path> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    if (entry.path().extension() == ".xml") files.push_back(entry.path());
  }
  if (failed) throw SystemError(fmt::format("{} cannot be read: {}", folder.string(), failed.message()));
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace bodkin::io
