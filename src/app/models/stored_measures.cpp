#include "app/models/stored_measures.h"

#include <fstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "core/files.h"

namespace bodkin::app {

using views::Measure;

namespace {

constexpr const char* file_name = "measures.json";

}  // namespace

std::vector<Measure> stored_measures(const std::filesystem::path& folder) {
  std::ifstream stream(folder / file_name);
  std::vector<Measure> measures;
  try {
    for (const nlohmann::json& each : stream ? nlohmann::json::parse(stream) : nlohmann::json::array()) {
      Measure measure;
      if (each.size() == 3) measure.kind = Measure::Kind::angle;
      if (each.size() != measure.count()) continue;
      for (std::size_t i = 0; i < each.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
          measure.places[i][axis] = each[i].at(static_cast<std::size_t>(axis)).get<double>();
      measures.push_back(measure);
    }
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  return measures;
}

void store_measures(const std::vector<Measure>& measures, const std::filesystem::path& folder) {
  if (measures.empty()) {
    std::error_code ignored;
    std::filesystem::remove(folder / file_name, ignored);
    return;
  }
  nlohmann::json all = nlohmann::json::array();
  for (const Measure& measure : measures) {
    nlohmann::json places = nlohmann::json::array();
    for (std::size_t i = 0; i < measure.count(); ++i)
      places.push_back({measure.places[i].x(), measure.places[i].y(), measure.places[i].z()});
    all.push_back(places);
  }
  write_file(folder / file_name, all.dump() + "\n");
}

}  // namespace bodkin::app
