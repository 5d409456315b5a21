#include <cmath>
#include <string>

#include "study/fitting/fit.h"
#include <fmt/format.h>

#include "io/xml_writer.h"

namespace bodkin::study {

namespace {

void write(const io::XmlElement& element, io::XmlWriter& writer) {
  if (!element.text.empty()) return writer.text_element(element.name, element.text);
  writer.open(element.name);
  for (const auto& [name, value] : element.attributes) writer.attribute(name, value);
  for (const io::XmlElement& child : element.children) write(child, writer);
  writer.close();
}

// The origin of the numbers, for people.
std::string source_of(const CurveFit& fit, const MeasuredCurve& curve) {
  std::string kept;
  for (const FittedParameter& one : fit.parameters) {
    if (one.status != ParameterStatus::not_identified) continue;
    kept += (kept.empty() ? "" : ", ") + one.name;
  }
  return fmt::format(
      "{} fitted to {}: {} samples, R^2 {}, RMSE {:.3g} N.{}", fit.model, curve.name, fit.samples,
      std::isnan(fit.r_squared) ? "undefined" : fmt::format("{:.4f}", fit.r_squared), fit.rmse,
      kept.empty() ? "" : fmt::format(" Not determined by the data, kept at a usual value: {}.", kept));
}

}  // namespace

std::string fitted_xml(const CurveFit& fit, const MeasuredCurve& curve) {
  io::XmlElement root;
  root.name = "fit";
  root.attributes.emplace_back("model", fit.model);
  for (const io::XmlElement& element : fit.elements.tissues) {
    io::XmlElement tissue, source;
    tissue.name = "tissue";
    source.name = "source";
    source.text = source_of(fit, curve);
    tissue.children = {element, source};
    root.children.push_back(std::move(tissue));
  }
  if (fit.elements.resistance) {
    io::XmlElement haptics, resistance;
    haptics.name = "haptics";
    resistance.name = "resistance";
    resistance.children = {*fit.elements.resistance};
    haptics.children = {std::move(resistance)};
    root.children.push_back(std::move(haptics));
  }
  io::XmlWriter writer;
  write(root, writer);
  return writer.finish();
}

}  // namespace bodkin::study
