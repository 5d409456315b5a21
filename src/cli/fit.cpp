#include "study/fitting/fit.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>

#include "report/plot.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/error.h"
#include "core/files.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

struct FitArguments {
  std::string model, curve, output;
  std::vector<std::string> fix, start, bounds;
  study::FitRequest request;
  double speed = std::numeric_limits<double>::quiet_NaN();  // not given
};

constexpr const char* fit_footer = R"(Examples:
  bodkin fit tracking_wall liver.csv                         stiffness, force and catch-up time of the wall
  bodkin fit layered skin.csv --fix viscosity=0 -o out/skin  the rest, without viscosity
  bodkin fit depth_profile gel.csv --from 0 --to 20          only samples between 0 and 20 mm count
  bodkin fit three_component phantom.csv --speed 5           a curve without times, measured at 5 mm/s
  bodkin fit fracture gel.csv --start contact=12.3           depth counts from 12.3 mm
  bodkin fit layered skin.csv --bounds break_force=0.5:3 --free element_spacing

Models: spring_damper_wall, tracking_wall, depth_profile, layered, three_component, fracture, shaft_friction.
The table has the columns time_s (may be missing), depth_mm, force_N; # begins a comment.
Writes BASE.svg (data and fit) and BASE.xml (elements for a tissue library and a case).)";

double number_in(std::string_view text, const char* option, const std::string& whole) {
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    throw InputError(fmt::format("{} is '{}', expected {}", option, whole,
                                 std::string_view(option) == "--bounds" ? "name=low:high" : "name=value"));
  }
  return value;
}

// "name=value" as a name and the rest.
std::pair<std::string, std::string> split(const std::string& text, const char* option) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) number_in("", option, text);
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<study::NamedValue> named_values(const std::vector<std::string>& texts, const char* option) {
  std::vector<study::NamedValue> values;
  for (const std::string& text : texts) {
    const auto [name, value] = split(text, option);
    values.emplace_back(name, number_in(value, option, text));
  }
  return values;
}

std::vector<study::ParameterBounds> bounds_of(const std::vector<std::string>& texts) {
  constexpr const char* option = "--bounds";
  std::vector<study::ParameterBounds> bounds;
  for (const std::string& text : texts) {
    const auto [name, range] = split(text, option);
    const std::size_t colon = std::min(range.find(':'), range.size());
    const std::string high = colon < range.size() ? range.substr(colon + 1) : "";
    bounds.push_back({name, number_in(range.substr(0, colon), option, text), number_in(high, option, text)});
  }
  return bounds;
}

const char* status_text(study::ParameterStatus status) {
  switch (status) {
    case study::ParameterStatus::estimated:
      return "estimated";
    case study::ParameterStatus::at_bound:
      return "at_bound";
    case study::ParameterStatus::not_identified:
      return "not_identified";
    case study::ParameterStatus::kept:
      break;
  }
  return "kept";
}

report::Plot plot_of(const study::MeasuredCurve& curve, const study::CurveFit& fit) {
  report::Plot plot;
  plot.title = fmt::format("{}, {}: R\u00b2 = {:.4f}, RMSE = {:.3g} N", fs::path(curve.name).filename().string(),
                           fit.model, fit.r_squared, fit.rmse);
  plot.x_label = "depth, mm";
  plot.y_label = "force, N";
  plot.series = {{"measured", curve.depth, curve.force, 0xD9722B, 2.2, false},
                 {"fitted", curve.depth, fit.force, 0x12385C, 1.6, false}};
  return plot;
}

nlohmann::json json_of(const study::CurveFit& fit) {
  nlohmann::json result;
  result["model"] = fit.model;
  result["samples"] = fit.samples;
  result["r_squared"] = fit.r_squared;
  result["rmse_N"] = fit.rmse;
  result["confidence"] = 0.95;
  result["yields_at_mm"] = fit.yields_at ? nlohmann::json(*fit.yields_at) : nlohmann::json(nullptr);
  result["parameters"] = nlohmann::json::array();
  for (const study::FittedParameter& one : fit.parameters) {
    nlohmann::json entry = {
        {"name", one.name}, {"unit", one.unit}, {"value", one.value}, {"status", status_text(one.status)}};
    if (one.status == study::ParameterStatus::estimated) {
      entry["standard_error"] = one.standard_error;
      entry["low"] = one.low;
      entry["high"] = one.high;
    }
    if (!one.remark.empty()) entry["remark"] = one.remark;
    result["parameters"].push_back(std::move(entry));
  }
  result["notes"] = fit.notes;
  return result;
}

std::string certainty_text(const study::FittedParameter& one) {
  switch (one.status) {
    case study::ParameterStatus::estimated:
      return fmt::format("{:>10.3g}   {:.5g} to {:.5g}{}{}", one.standard_error, one.low, one.high,
                         one.remark.empty() ? "" : "; ", one.remark);
    case study::ParameterStatus::at_bound:
      return fmt::format("{:>10}   {}", "", one.remark);
    case study::ParameterStatus::not_identified:
      return fmt::format("{:>10}   kept: {}", "", one.remark);
    case study::ParameterStatus::kept:
      break;
  }
  return fmt::format("{:>10}   kept", "");
}

void print(const Console& console, const study::CurveFit& fit) {
  console.line(fmt::format("{:<18} {:>11} {:<10} {:>10}   {}", "parameter", "value", "unit", "std. error",
                           "joint 95 % confidence"));
  for (const study::FittedParameter& one : fit.parameters)
    console.line(fmt::format("{:<18} {:>11.5g} {:<10} {}", one.name, one.value, one.unit, certainty_text(one)));
  console.line(fmt::format("\nR^2 {:.4f}, RMSE {:.4g} N, {} samples{}", fit.r_squared, fit.rmse, fit.samples,
                           fit.yields_at ? fmt::format(", gives way at {:.2f} mm", *fit.yields_at) : ""));
}

void run_fit(const FitArguments& arguments, const CommandContext& context) {
  Console console(context);
  study::FitRequest request = arguments.request;
  request.model = arguments.model;
  request.fix = named_values(arguments.fix, "--fix");
  request.start = named_values(arguments.start, "--start");
  request.bounds = bounds_of(arguments.bounds);
  if (!std::isnan(arguments.speed)) request.speed = arguments.speed;
  study::fit_model(request.model);  // a wrong name before a long file
  const study::MeasuredCurve curve = study::read_measured_curve(arguments.curve);
  const study::CurveFit fit = study::fit_curve(curve, request);
  const std::string picture = report::draw_plot(plot_of(curve, fit)).svg();  // before any file is written

  const std::string base = arguments.output.empty() ? "fit" : arguments.output;
  write_file(base + ".svg", picture);
  write_file(base + ".xml", study::fitted_xml(fit, curve));
  for (const std::string& note : fit.notes) console.note(note);
  print(console, fit);
  console.line(fmt::format("\n{}\n{}", fs::absolute(base + ".svg").string(), fs::absolute(base + ".xml").string()));
  nlohmann::json result = json_of(fit);
  result["svg"] = fs::absolute(base + ".svg").string();
  result["xml"] = fs::absolute(base + ".xml").string();
  console.json(result.dump(2));
}

}  // namespace

void add_fit_command(CLI::App& app, CommandContext& context) {
  auto arguments = std::make_shared<FitArguments>();
  CLI::App* command =
      add_command(app, "fit", "Parameters of a force model from a measured force-depth curve", fit_footer);
  study::FitRequest& request = arguments->request;
  add_text(*command, "MODEL", arguments->model, "Name of the force model").required();
  add_text(*command, "CURVE", arguments->curve, "CSV table of the measurement").required();
  add_number(*command, "--from", request.from, -1000.0, 1000.0, "Only samples from this depth count, mm")
      .without_default();
  add_number(*command, "--to", request.to, -1000.0, 1000.0, "Only samples to this depth count, mm").without_default();
  add_number(*command, "--speed", arguments->speed, 0.01, 1000.0, "mm/s of a curve without times, 0.01 to 1000")
      .without_default();
  add_number(*command, "--resolution", request.resolution, 0.0, 1.0, "Step of the measured depth, mm, 0 to 1");
  add_texts(*command, "--fix", arguments->fix, "Keep a parameter at a value, name=value");
  add_texts(*command, "--start", arguments->start, "Begin with a value, name=value");
  add_texts(*command, "--bounds", arguments->bounds, "Keep a parameter within name=low:high");
  add_texts(*command, "--free", request.free, "Fit a parameter that the model usually keeps");
  add_text(*command, "-o,--output", arguments->output, "BASE of BASE.svg and BASE.xml (default: fit)");
  on_run(*command, [arguments, &context] { run_fit(*arguments, context); });
}

}  // namespace bodkin::cli
