#include "patient/meshing/mesher.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "patient/meshing/meshable_tissues.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "anatomy/mesh_parts.h"
#include "core/error.h"
#include "io/shared_memory.h"
#include "io/worker_program.h"

namespace bodkin::patient {
namespace {

using nlohmann::json;

const io::WorkerProgram mesh_program{"bodkin-mesher", "BODKIN_MESHER_WORKER", "BODKIN_MESHER"};

constexpr int guesses = 1;  // of the scale, before anything is meshed
constexpr int most_rounds = 5;
constexpr double close_enough = 0.10;  // of the wanted number of nodes
constexpr double nodes_power = 2.6;    // nodes go with the edge to minus this, between a surface and a volume
constexpr double least_power = 0.5, most_power = 4.0;  // [D] the same as found from two attempts
constexpr double widest_scale = 50.0;                  // beyond this a scale makes no sense
// [D] With preserved layers, edges are at most this times those of the settings, and less where a layer would be
// lost. The nodes then depend on the layers and the growth around them: the same from 6 to 50 for lumbar patients.
constexpr double coarsest_preserving = 8.0;
constexpr double finest_preserving = 0.5;
constexpr int halvings_of_coarsest = 7;  // of what lies between these two: then it is known to 2 %
constexpr double reported_loss = 0.5;    // share of a tissue above which its merging is reported
constexpr std::size_t bytes_per_node = 3 * sizeof(double), bytes_per_element = 4 * sizeof(std::uint32_t) + 1;

struct Attempt {
  std::size_t refined_nodes = 0;
  anatomy::TetrahedralMesh mesh;  // empty when the number of nodes was missed
};

io::ChildLimits mesher_limits() {
  io::ChildLimits limits;
#ifndef BODKIN_ADDRESS_SANITIZER  // its shadow memory alone is larger
  limits.memory = 8ULL << 30U;
#endif
  return limits;
}

[[noreturn]] void fail_worker(const io::WorkerOutput& output) {
  if (output.kind == "memory") throw SystemError("the mesh needs more memory than there is; ask for fewer nodes");
  if (!output.error.empty()) throw SystemError(fmt::format("bodkin-mesher failed: {}", output.error));
  if (output.child.end == io::ChildEnd::out_of_time) {
    throw SystemError("meshing took more than ten minutes and was given up; ask for fewer nodes");
  }
  throw SystemError("bodkin-mesher ended without a message; ask for fewer nodes");
}

// The worker's mesh from shared memory, in patient coordinates.
anatomy::TetrahedralMesh take_mesh(const io::SharedMemory& memory, const json& result, const anatomy::Grid& grid) {
  const std::size_t nodes = result.value("nodes", std::size_t{0}),
                    elements = result.value("elements", std::size_t{0});
  anatomy::TetrahedralMesh mesh;
  if (nodes > memory.size() / bytes_per_node || elements > memory.size() / bytes_per_element ||
      memory.size() != nodes * bytes_per_node + elements * bytes_per_element) {
    throw SystemError(
        "bodkin-mesher returned an invalid mesh; it is another version than the program that called it");
  }
  std::vector<std::array<double, 3>> places(nodes);
  mesh.elements.resize(elements);
  mesh.tissues.resize(elements);
  memory.copy_to(places.data(), nodes * bytes_per_node);
  memory.copy_to(mesh.elements.data(), elements * 4 * sizeof(std::uint32_t), nodes * bytes_per_node);
  memory.copy_to(mesh.tissues.data(), elements, nodes * bytes_per_node + elements * 4 * sizeof(std::uint32_t));
  mesh.nodes.reserve(nodes);
  for (const auto& place : places) {
    mesh.nodes.push_back(grid.origin + grid.direction * Vec3(place[0], place[1], place[2]));
  }
  for (const auto& element : mesh.elements) {
    if (*std::max_element(element.begin(), element.end()) >= nodes)
      throw SystemError("bodkin-mesher returned an invalid mesh");
  }
  return mesh;
}

Attempt run_mesher(const MeshableTissues& meshable, const json& options, const Progress& progress) {
  io::SharedMemory memory("bodkin-mesh");
  memory.append(meshable.tissues.voxels.data(), meshable.tissues.voxels.size());
  memory.append(meshable.edges.data(), meshable.edges.size() * sizeof(float));
  json request = options;
  const anatomy::Grid& grid = meshable.tissues.grid;
  request["size"] = grid.size;
  request["spacing"] = {grid.spacing.x(), grid.spacing.y(), grid.spacing.z()};
  const io::WorkerOutput output =
      io::run_worker(mesh_program, "mesh", request.dump(), memory.descriptor(), mesher_limits(), progress);
  if (!output.succeeded()) fail_worker(output);
  const json result = json::parse(output.result, nullptr, false);
  return {result.value("refined_nodes", std::size_t{0}), take_mesh(memory, result, grid)};
}

// Tissues that lost half of their voxels or more to their neighbours, and the parts cut off.
std::vector<std::string> merge_notes(const MeshPlan& plan, const MeshableTissues& merged,
                                     const anatomy::TissueLibrary& library) {
  std::vector<std::string> notes;
  std::string names;
  for (std::size_t id = 0; id < merged.before.size(); ++id) {
    const double left = static_cast<double>(merged.after[id]);
    if (merged.before[id] == 0 || left > reported_loss * static_cast<double>(merged.before[id])) continue;
    names += fmt::format("{}{}{}", names.empty() ? "" : ", ", library.title(static_cast<anatomy::TissueId>(id)),
                         merged.after[id] == 0 ? "" : " (in part)");
  }
  if (!names.empty()) {
    notes.push_back(fmt::format("Too thin for the elements there, and so meshed as the adjacent tissue: {}.", names));
  }
  if (plan.boxed) {
    notes.push_back("The body extends beyond the mesh, which covers only the surroundings of the planned path.");
  }
  if (merged.dropped > 0) {
    const double volume = static_cast<double>(merged.dropped) * plan.tissues.grid.spacing.prod() / 1000.0;
    notes.push_back(fmt::format("{:.2g} ml of tissue were left out: too thin, or apart from the rest.", volume));
  }
  return notes;
}

std::string named(const std::vector<PathLayer>& layers, const anatomy::TissueLibrary& library) {
  constexpr std::size_t most = 5;
  std::string names;
  for (const PathLayer& layer : std::span(layers).first(std::min(most, layers.size()))) {
    names += fmt::format("{}{} ({:.1f} mm thick, {:.1f} mm deep)", names.empty() ? "" : ", ",
                         library.title(layer.tissue), layer.thickness(), layer.depth);
  }
  if (layers.size() > most) names += fmt::format(" and {} more", layers.size() - most);
  return names;
}

// Rounded up to three digits.
long long rounded_nodes(double nodes) {
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(nodes)) - 2.0));
  return static_cast<long long>(unit * std::ceil(nodes / unit));
}

// The number of nodes for a scale.
struct ScaledNodes {
  double scale = 0.0, nodes = 0.0;
};

// Exponent of the nodes over the edge between two attempts: preserved layers need the same nodes at any scale.
double power_between(const ScaledNodes& a, const ScaledNodes& b, double otherwise) {
  const double power = std::log(a.nodes / b.nodes) / std::log(b.scale / a.scale);
  return std::isfinite(power) ? std::clamp(power, least_power, most_power) : otherwise;
}

// Looks for the scale that gives the wanted number of nodes, by attempts that missed it.
class ScaleSearch {
 public:
  // `coarsest`: the largest scale, with the fewest nodes; nothing: unknown. `preserves_layers`: layers are preserved,
  // so the nodes depend on the edge in another way.
  ScaleSearch(double wanted, double first, std::optional<double> coarsest, bool preserves_layers)
      : wanted_(wanted), coarsest_(coarsest), preserves_layers_(preserves_layers), scale_(limited(first)) {}

  double scale() const { return scale_; }
  bool is_coarsest() const { return coarsest_ && scale_ >= *coarsest_; }
  // Records the number of nodes at the present scale.
  void missed(double nodes) {
    if (preserves_layers_ && before_.nodes > 0.0) power_ = power_between(before_, {scale_, nodes}, power_);
    before_ = {scale_, nodes};
    (nodes > wanted_ ? too_fine_ : too_coarse_) = scale_;
    scale_ = limited(scale_ * std::pow(nodes / wanted_, 1.0 / power_));
    const bool between = too_fine_ < scale_ && scale_ < too_coarse_;
    if (!between && too_fine_ > 0.0 && std::isfinite(too_coarse_)) scale_ = std::sqrt(too_fine_ * too_coarse_);
  }
  // A scale that gives at most the wanted nodes, if any does.
  void use_coarse_scale() { scale_ = std::isfinite(too_coarse_) ? too_coarse_ : coarsest_.value_or(scale_); }

 private:
  double limited(double scale) const { return coarsest_ ? std::min(scale, *coarsest_) : scale; }

  double wanted_;
  std::optional<double> coarsest_;
  bool preserves_layers_;
  double scale_, power_ = nodes_power;
  ScaledNodes before_;
  double too_fine_ = 0.0, too_coarse_ = std::numeric_limits<double>::infinity();  // the newest of each
};

[[noreturn]] void refuse_nodes(double least, const MeshPlan& plan, const MeshSettings& settings,
                               const anatomy::TissueLibrary& library) {
  std::vector<PathLayer> thin = plan.layers;
  const auto thinner = [](const PathLayer& a, const PathLayer& b) { return a.width < b.width; };
  std::sort(thin.begin(), thin.end(), thinner);
  thin.resize(std::min<std::size_t>(thin.size(), 3));
  throw InputError(
      fmt::format("{} nodes are too few to hold the layers of the planned path, of which the thinnest are {}; "
                  "expected at least {}: give --nodes {}, or --merge-layers for a mesh without them",
                  settings.nodes, named(thin, library), rounded_nodes(least), rounded_nodes(least)));
}

std::vector<PathLayer> lost_with(const MeshPlan& plan, double scale) {
  return lost_layers(plan, meshable_tissues(plan, scale));
}

// The largest scale that preserves the plan's layers, if one does.
std::optional<double> find_coarsest(const MeshPlan& plan) {
  if (lost_with(plan, coarsest_preserving).empty()) return coarsest_preserving;
  if (!lost_with(plan, finest_preserving).empty()) return {};
  double preserves = finest_preserving, loses = coarsest_preserving;
  for (int halving = 0; halving < halvings_of_coarsest; ++halving) {
    const double middle = std::sqrt(preserves * loses);
    (lost_with(plan, middle).empty() ? preserves : loses) = middle;
  }
  return preserves;
}

// A scale, and the tissues that can be meshed with it.
struct ScaledTissues {
  double scale = 0.0;
  MeshableTissues tissues;
};

// The largest scale that preserves the layers of the planned path; nothing: none are requested. Refuses a path with
// layers that no scale preserves. Looks in the surroundings of the layers first, a small part of the whole.
std::optional<ScaledTissues> coarsest_meshable(const MeshPlan& plan, const MeshSettings& settings,
                                               const anatomy::TissueLibrary& library) {
  if (!settings.preserve_layers || plan.preserving_edges.empty()) return {};
  if (const std::optional<double> scale = find_coarsest(around_layers(plan))) {
    ScaledTissues found{*scale, meshable_tissues(plan, *scale)};
    if (lost_layers(plan, found.tissues).empty()) return found;
  }
  const std::optional<double> scale = find_coarsest(plan);
  if (!scale) {
    throw InputError(
        fmt::format("no mesh holds {} on the planned path; expected a path that crosses these layers less obliquely, "
                    "or --merge-layers for a mesh without them",
                    named(lost_with(plan, finest_preserving), library)));
  }
  return ScaledTissues{*scale, meshable_tissues(plan, *scale)};
}

// The notes about layers that are missing in the mesh.
std::vector<std::string> layer_notes(const MeshPlan& plan, const MeshableTissues& meshable,
                                     const anatomy::TissueLibrary& library) {
  const std::vector<PathLayer> lost = lost_layers(plan, meshable);
  if (lost.empty()) return {};
  return {fmt::format(
      "The mesh does not hold these layers of the planned path: {}. Models that deform read them from the voxels; "
      "without --merge-layers the mesh is refined there.",
      named(lost, library))};
}

}  // namespace

bool mesher_present() {
  try {
    std::error_code ignored;
    return std::filesystem::exists(io::find_worker(mesh_program), ignored);
  } catch (const SystemError&) {
    return false;
  }
}

MeshedBody mesh_tissues(const anatomy::TissueVolume& tissues, const std::optional<anatomy::NeedlePath>& path,
                        const anatomy::TissueLibrary& library, const MeshSettings& settings,
                        const Progress& progress) {
  io::find_worker(mesh_program);
  const auto report = [&](std::string_view stage, double fraction) {
    if (progress) progress(stage, fraction);
  };
  report("planning the mesh", 0.0);
  const MeshPlan plan = plan_mesh(tissues, path, settings);
  const std::optional<ScaledTissues> coarsest = coarsest_meshable(plan, settings, library);
  const double wanted = static_cast<double>(settings.nodes);
  const auto nonsense = [](double scale) { return !(scale < widest_scale && scale > 1.0 / widest_scale); };
  double first = 1.0;
  for (int guess = 0; guess < guesses && !nonsense(first); ++guess)
    first *= std::cbrt(expected_nodes(meshable_tissues(plan, first)) / wanted);
  ScaleSearch search(wanted, first, coarsest ? std::optional(coarsest->scale) : std::nullopt,
                     settings.preserve_layers);
  for (int round = 1;; ++round) {
    const double scale = search.scale();
    if (nonsense(scale)) {
      throw InputError(
          fmt::format("{} nodes ask for edges of {:.3g} mm in the corridor, which makes no sense here; "
                      "ask for another number of nodes, or other --fine and --coarse",
                      settings.nodes, scale * settings.fine));
    }
    std::optional<MeshableTissues> computed;
    if (!search.is_coarsest()) computed = meshable_tissues(plan, scale);
    const MeshableTissues& meshable = computed ? *computed : coarsest->tissues;
    const double most = std::ceil((1.0 + close_enough) * wanted);
    const json options = {{"fewest", round >= most_rounds ? 0.0 : std::floor((1.0 - close_enough) * wanted)},
                          {"most", round >= most_rounds && !coarsest ? 1e12 : most},
                          {"expected", wanted}};
    Attempt made = run_mesher(meshable, options, [&](std::string_view stage, double fraction) {
      report(fmt::format("{}, round {}", stage, round), fraction);
    });
    if (made.refined_nodes == 0) {
      throw InputError("no tissue is thick enough for elements of this size; ask for more nodes");
    }
    if (made.mesh.elements.empty()) {
      const auto nodes = static_cast<double>(made.refined_nodes);
      if (search.is_coarsest() && nodes > wanted) refuse_nodes(nodes, plan, settings, library);
      search.missed(nodes);
      if (round + 1 > most_rounds) search.use_coarse_scale();
      continue;
    }
    MeshedBody body{std::move(made.mesh), scale, merge_notes(plan, meshable, library)};
    for (std::string& note : layer_notes(plan, meshable, library)) body.notes.push_back(std::move(note));
    anatomy::orient_elements(body.mesh);
    if (const std::size_t removed = anatomy::keep_largest_part(body.mesh); removed > 0) {
      body.notes.push_back(fmt::format("{} elements that share no face with the rest were left out.", removed));
    }
    return body;
  }
}

}  // namespace bodkin::patient
