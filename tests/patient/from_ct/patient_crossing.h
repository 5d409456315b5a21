#pragma once

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <vector>

#include "patient/from_ct/patient_builder.h"
#include "tests/io/images/test_images.h"
#include <nlohmann/json.hpp>

#include "anatomy/case.h"
#include "io/images/image_source.h"
#include "io/images/label_placement.h"
#include "io/label_scheme.h"

// The tissues crossed by a needle in a patient, for tests of building patients.

namespace bodkin::test {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;

// A stretch of one tissue along a path, mm from the entry.
struct Crossing {
  TissueId tissue;
  double from, to;
};

inline std::vector<Crossing> crossings(const TissueVolume& tissues, const NeedlePath& path, double beyond = 0.0) {
  constexpr double step = 0.25;
  std::vector<Crossing> found;
  for (double depth = 0.0; depth <= path.length() + beyond; depth += step) {
    const TissueId here = nearest(tissues, Vec3(path.entry + depth * path.direction()), tissue::air);
    if (found.empty() || found.back().tissue != here) found.push_back({here, depth, depth});
    found.back().to = depth + step;
  }
  return found;
}

// Depth at which a tissue is first met; -1 if never.
inline double first_of(const std::vector<Crossing>& way, TissueId id) {
  const auto found = std::find_if(way.begin(), way.end(), [&](const Crossing& c) { return c.tissue == id; });
  return found == way.end() ? -1.0 : found->from;
}

inline double last_of(const std::vector<Crossing>& way, TissueId id) {
  const auto found = std::find_if(way.rbegin(), way.rend(), [&](const Crossing& c) { return c.tissue == id; });
  return found == way.rend() ? -1.0 : found->to;
}

inline double total_of(const std::vector<Crossing>& way, TissueId id) {
  double sum = 0.0;
  for (const Crossing& c : way) sum += c.tissue == id ? c.to - c.from : 0.0;
  return sum;
}

inline bool bone(TissueId id) {
  return id == tissue::cortical_bone || id == tissue::cancellous_bone;
}

inline double first_bone(const std::vector<Crossing>& way) {
  const auto found = std::find_if(way.begin(), way.end(), [](const Crossing& c) { return bone(c.tissue); });
  return found == way.end() ? -1.0 : found->from;
}

// A real CT built into a patient. `labels` may be empty.
struct RealPatient {
  CtVolume ct;
  LabelVolume labels;
  BuiltPatient built;
};

inline RealPatient build_real(const std::filesystem::path& data, const std::string& ct, const std::string& labels,
                              const std::vector<Structure>& table) {
  RealPatient patient;
  patient.ct = read_ct(data / ct).ct;
  if (!labels.empty())
    patient.labels = place_labels(read_labels(data / labels), patient.ct.grid, false, labels).labels;
  patient.built = build_patient(patient.ct, patient.labels, table, {}, {});
  return patient;
}

// One of the trajectories supplied with the real data.
inline NeedlePath trajectory(const std::filesystem::path& data, const std::string& set, const std::string& name) {
  const auto point = [](const nlohmann::json& list) { return Vec3(list.at(0), list.at(1), list.at(2)); };
  for (const auto& entry : nlohmann::json::parse(std::ifstream(data / "trajectories.json"))) {
    if (entry.at("set") == set && entry.at("name") == name)
      return {point(entry.at("entry")), point(entry.at("target"))};
  }
  throw std::runtime_error("no trajectory " + set + " " + name);
}

inline std::vector<Structure> mass_table() {
  return {{1, "mass", "mass", false}};
}

inline Vec3 landmark(const std::vector<Landmark>& landmarks, const std::string& name) {
  const auto found =
      std::find_if(landmarks.begin(), landmarks.end(), [&](const Landmark& l) { return l.name == name; });
  return found == landmarks.end() ? Vec3::Constant(1e9) : found->position;
}

}  // namespace bodkin::test
