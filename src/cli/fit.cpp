#include "study/fitting/fit.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>

#include "report/plot.h"
#include "study/fitting/gauge_law.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "anatomy/needle.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/error.h"
#include "core/files.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

struct FitArguments {
  std::string model, output;
  std::vector<std::string> curves, fix, start, bounds, needles, layers;
  study::FitRequest request;
  double speed = std::numeric_limits<double>::quiet_NaN();  // not given
};

// The names of the models that can be fitted, or only of those with layers.
std::string model_list(bool with_layers) {
  std::vector<std::string_view> names;
  for (const study::FitModel& model : study::fit_models())
    if (!with_layers || model.stack != nullptr) names.push_back(model.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string fit_footer() {
  return fmt::format(R"(Examples:
  bodkin fit tracking_wall liver.csv                         stiffness, force and catch-up time of the wall
  bodkin fit layered skin.csv --fix viscosity=0 -o out/skin  the rest, without viscosity
  bodkin fit depth_profile gel.csv --from 0 --to 20          only samples between 0 and 20 mm count
  bodkin fit three_component phantom.csv --speed 5           a curve without times, measured at 5 mm/s
  bodkin fit fracture gel.csv --start contact=12.3           depth counts from 12.3 mm
  bodkin fit layered skin.csv --bounds break_force=0.5:3 --free element_spacing
  bodkin fit layered slow.csv fast.csv                       one set of values for both curves
  bodkin fit tracking_wall back.csv --layers 0,2,15          a force for each layer of known depth
  bodkin fit layered slow.csv fast.csv --layers 0,2,15       stiffness, break force and friction for each
  bodkin fit all liver.csv                                   which model describes it best (AIC)
  bodkin fit layered a.csv b.csv c.csv --needles 16G,18G,22G puncture force as a function of the gauge

Models: {}.
The table has the columns time_s (may be missing), depth_mm, force_N; # begins a comment.
A table without depth_mm needs --speed and is taken as one insertion at that speed.
Writes BASE.svg (data and fit) and BASE.xml (elements for a tissue library and a case).)",
                     model_list(false));
}

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

std::string r_squared_text(double r_squared) {
  return std::isnan(r_squared) ? "undefined, the force is constant" : fmt::format("{:.4f}", r_squared);
}

// Measured and fitted force over depth; several curves have a line each.
report::Plot plot_of(std::span<const study::MeasuredCurve> curves, const study::CurveFit& fit) {
  report::Plot plot;
  plot.title = fmt::format("{}{}, {}: R\u00b2 = {}, RMSE = {:.3g} N", fs::path(curves[0].name).filename().string(),
                           curves.size() > 1 ? fmt::format(" and {} more", curves.size() - 1) : "", fit.model,
                           std::isnan(fit.r_squared) ? "undefined" : fmt::format("{:.4f}", fit.r_squared), fit.rmse);
  plot.x_label = "depth, mm";
  plot.y_label = "force, N";
  for (const study::MeasuredCurve& curve : curves)
    plot.series.push_back({plot.series.empty() ? "measured" : "", curve.depth, curve.force, 0xD9722B, 2.2, false});
  auto from = fit.force.begin();
  for (const study::MeasuredCurve& curve : curves) {
    const auto to = from + static_cast<std::ptrdiff_t>(curve.size());
    plot.series.push_back({from == fit.force.begin() ? "fitted" : "", curve.depth, std::vector<double>(from, to),
                           0x12385C, 1.6, false});
    from = to;
  }
  return plot;
}

// NaN has no place in JSON.
nlohmann::json json_number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

nlohmann::json json_of(const study::CurveFit& fit) {
  nlohmann::json result;
  result["model"] = fit.model;
  result["samples"] = fit.samples;
  result["r_squared"] = json_number(fit.r_squared);
  result["aic"] = fit.aic;
  result["rmse_N"] = fit.rmse;
  result["confidence"] = 0.95;
  result["yields_at_mm"] = nullptr;  // a number for one tissue, of a stack an array
  if (fit.yields_at.size() == 1) result["yields_at_mm"] = fit.yields_at.front();
  if (fit.yields_at.size() > 1) result["yields_at_mm"] = fit.yields_at;
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
  console.line(fmt::format(
      "\nR^2 {}, RMSE {:.4g} N, {} samples{}", r_squared_text(fit.r_squared), fit.rmse, fit.samples,
      fit.yields_at.empty() ? "" : fmt::format(", gives way at {:.2f} mm", fmt::join(fit.yields_at, ", "))));
}

std::vector<double> layers_of(const std::vector<std::string>& texts) {
  std::vector<double> tops;
  for (const std::string& text : texts) {
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      throw InputError(fmt::format("--layers holds '{}', expected depths in mm with commas between them", text));
    tops.push_back(value);
  }
  return tops;
}

// mm, outer, of "16G".
double diameter_of(const std::string& text) {
  int gauge = 0;
  const char* const last = text.data() + text.size();
  const auto [end, problem] = std::from_chars(text.data(), last, gauge);
  const bool is_gauge = problem == std::errc() && last - end == 1 && (*end == 'G' || *end == 'g');
  const std::optional<anatomy::GaugeSize> size = is_gauge ? anatomy::gauge_size(gauge) : std::nullopt;
  if (!size)
    throw InputError(fmt::format("--needles holds '{}', expected a gauge from 10G to 34G for each curve", text));
  return size->outer_diameter;
}

// Quality of each model's fit; `layers`: models with layers were fitted as stacks.
void print(const Console& console, const study::ModelChoice& choice, bool layers) {
  console.line(fmt::format("{:<20} {:>11} {:>10} {:>10} {:>12} {:>9} {:>8}", "model", "parameters", "R^2", "RMSE, N",
                           "AIC", "less best", "weight"));
  double all = 0.0;
  for (const study::CurveFit& fit : choice.fits) all += std::exp(-0.5 * (fit.aic - choice.fits.front().aic));
  for (const study::CurveFit& fit : choice.fits) {
    const double behind = fit.aic - choice.fits.front().aic;
    const auto found = std::count_if(fit.parameters.begin(), fit.parameters.end(), [](const auto& one) {
      return one.status == study::ParameterStatus::estimated || one.status == study::ParameterStatus::at_bound;
    });
    console.line(fmt::format("{:<20} {:>11} {:>10} {:>10.4g} {:>12.1f} {:>9.1f} {:>8.3f}", fit.model, found,
                             std::isnan(fit.r_squared) ? "undefined" : fmt::format("{:.4f}", fit.r_squared), fit.rmse,
                             fit.aic, behind, std::exp(-0.5 * behind) / all));
  }
  std::vector<std::string> of_one;
  for (const study::CurveFit& fit : choice.fits)
    if (layers && study::fit_model(fit.model).stack == nullptr) of_one.push_back(fit.model);
  if (!of_one.empty()) console.line(fmt::format("fitted as one tissue, without layers: {}", fmt::join(of_one, ", ")));
  console.line("");
}

// Puncture force over the needle's diameter, from fits of one curve each.
void run_gauge_law(const FitArguments& arguments, const study::FitRequest& request,
                   std::span<const study::MeasuredCurve> curves, Console& console) {
  if (arguments.needles.size() != curves.size()) {
    throw InputError(fmt::format("--needles names {} needles for {} curves, expected one for each",
                                 arguments.needles.size(), curves.size()));
  }
  std::vector<study::PunctureOfNeedle> points;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const study::CurveFit fit = study::fit_curve(curves[i], request);
    for (const std::string& note : fit.notes) console.note(note);
    points.push_back(
        {curves[i].name, diameter_of(arguments.needles[i]), study::puncture_force_of(fit, curves[i].name)});
  }
  const study::GaugeLaw law = study::fit_gauge_law(points);
  report::Plot plot;
  plot.title = fmt::format("{}: force of puncture = {:.3g} N (d / {:.3g} mm)^{:.2f}", request.model, law.force,
                           law.reference, law.exponent);
  plot.x_label = "outer diameter d, mm";
  plot.y_label = "force of puncture, N";
  report::PlotSeries line{.name = "law"};
  const double thin = law.points.front().diameter, thick = law.points.back().diameter;
  for (int i = 0; i <= 50; ++i) {
    line.x.push_back(thin + (thick - thin) * i / 50.0);
    line.y.push_back(law.at(line.x.back()));
  }
  plot.series.push_back(std::move(line));
  for (const study::PunctureOfNeedle& one : law.points)
    plot.marks.push_back(
        {one.diameter, one.force,
         fmt::format("{}: {:.3g} mm, {:.3g} N", fs::path(one.curve).filename().string(), one.diameter, one.force)});
  const std::string picture = report::draw_plot(plot).svg();
  const std::string file = (arguments.output.empty() ? "fit" : arguments.output) + ".svg";
  write_file(file, picture);
  nlohmann::json result = {
      {"model", request.model},   {"reference_mm", law.reference},     {"force_N", law.force},
      {"exponent", law.exponent}, {"points", nlohmann::json::array()}, {"svg", fs::absolute(file).string()}};
  console.line(fmt::format("{:<32} {:>12} {:>12}", "curve", "diameter, mm", "puncture, N"));
  for (const study::PunctureOfNeedle& one : law.points) {
    console.line(
        fmt::format("{:<32} {:>12.3f} {:>12.4g}", fs::path(one.curve).filename().string(), one.diameter, one.force));
    result["points"].push_back({{"curve", one.curve}, {"diameter_mm", one.diameter}, {"force_N", one.force}});
  }
  console.line(fmt::format("\nforce of puncture = {:.4g} N (d / {:.4g} mm)^n, n = {:.3f}", law.force, law.reference,
                           law.exponent));
  if (law.has_intervals) {
    console.line(fmt::format("95 % confidence: force {:.4g} to {:.4g} N, n {:.3f} to {:.3f}", law.force_low,
                             law.force_high, law.exponent_low, law.exponent_high));
    result["force_low_N"] = law.force_low;
    result["force_high_N"] = law.force_high;
    result["exponent_low"] = law.exponent_low;
    result["exponent_high"] = law.exponent_high;
  } else {
    console.line("two curves give no confidence interval; add a third");
  }
  console.line("n = 1: with the perimeter of the cut; n = 2: with the needle's cross-section");
  console.line("\n" + fs::absolute(file).string());
  console.json(result.dump(2));
}

void refuse_for_all(const FitArguments& arguments) {
  const char* const given = !arguments.fix.empty()            ? "--fix"
                            : !arguments.start.empty()        ? "--start"
                            : !arguments.bounds.empty()       ? "--bounds"
                            : !arguments.request.free.empty() ? "--free"
                            : !arguments.needles.empty()      ? "--needles"
                                                              : nullptr;
  if (given != nullptr) throw InputError(fmt::format("{} is for one model, expected its name instead of all", given));
}

void run_fit(const FitArguments& arguments, const CommandContext& context) {
  Console console(context);
  study::FitRequest request = arguments.request;
  const bool all = arguments.model == "all";
  if (all) refuse_for_all(arguments);
  request.model = arguments.model;
  request.fix = named_values(arguments.fix, "--fix");
  request.start = named_values(arguments.start, "--start");
  request.bounds = bounds_of(arguments.bounds);
  request.layers = layers_of(arguments.layers);
  if (!std::isnan(arguments.speed)) request.speed = arguments.speed;
  if (!all) study::fit_model(request.model);  // reject a wrong name before reading a long file
  std::vector<study::MeasuredCurve> curves;
  for (const std::string& file : arguments.curves) curves.push_back(study::read_measured_curve(file, request.speed));
  if (!arguments.needles.empty()) return run_gauge_law(arguments, request, curves, console);

  study::ModelChoice choice;
  if (all)
    choice = study::choose_model(curves, request);
  else
    choice.fits.push_back(study::fit_curves(curves, request));
  const study::CurveFit& fit = choice.fits.front();
  const std::string picture = report::draw_plot(plot_of(curves, fit)).svg();  // before any file is written

  const std::string base = arguments.output.empty() ? "fit" : arguments.output;
  write_file(base + ".svg", picture);
  write_file(base + ".xml", study::fitted_xml(fit, study::joined(curves)));
  for (const auto& [model, reason] : choice.refused) console.note(fmt::format("{} is left out: {}", model, reason));
  for (const std::string& note : fit.notes) console.note(note);
  if (all) print(console, choice, !request.layers.empty());
  if (all) console.line(fmt::format("The best, {}:\n", fit.model));
  print(console, fit);
  console.line(fmt::format("\n{}\n{}", fs::absolute(base + ".svg").string(), fs::absolute(base + ".xml").string()));
  nlohmann::json result = json_of(fit);
  if (all) {
    for (const study::CurveFit& one : choice.fits) {
      result["models"].push_back(
          {{"model", one.model}, {"aic", one.aic}, {"r_squared", json_number(one.r_squared)}, {"rmse_N", one.rmse}});
    }
  }
  result["svg"] = fs::absolute(base + ".svg").string();
  result["xml"] = fs::absolute(base + ".xml").string();
  console.json(result.dump(2));
}

}  // namespace

void add_fit_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "fit", "Parameters of a force model from measured force-depth curves", fit_footer(),
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<FitArguments>();
        study::FitRequest& request = arguments->request;
        add_text(command, "MODEL", arguments->model,
                 "Name of the force model, or all: which of them describes it best")
            .required();
        add_texts(command, "CURVE", arguments->curves, "CSV tables of the measurements, fitted together").required();
        add_number(command, "--from", request.from, -1000.0, 1000.0, "Only samples from this depth count, mm")
            .without_default();
        add_number(command, "--to", request.to, -1000.0, 1000.0, "Only samples to this depth count, mm")
            .without_default();
        add_number(command, "--speed", arguments->speed, 0.01, 1000.0, "mm/s of a curve without times, 0.01 to 1000")
            .without_default();
        add_number(command, "--resolution", request.resolution, 0.0, 1.0, "Step of the measured depth, mm, 0 to 1");
        add_texts(command, "--fix", arguments->fix, "Fix a parameter at a value, name=value");
        add_texts(command, "--start", arguments->start, "Begin with a value, name=value");
        add_texts(command, "--bounds", arguments->bounds, "Keep a parameter within name=low:high");
        add_texts(command, "--free", request.free, "Fit a parameter that is fixed by default");
        add_texts(command, "--layers", arguments->layers,
                  fmt::format("mm at which the layers of a stack begin, the first 0: values for each ({})",
                              model_list(true)))
            .separated_by_commas("MM,MM,...");
        add_texts(command, "--needles", arguments->needles,
                  "The gauge of each curve's needle: fits each curve, then the law of puncture force and diameter")
            .separated_by_commas("16G,18G,...");
        add_text(command, "-o,--output", arguments->output, "BASE of BASE.svg and BASE.xml (default: fit)");
        on_run(command, [arguments, &context] { run_fit(*arguments, context); });
      });
}

}  // namespace bodkin::cli
