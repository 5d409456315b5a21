#include <cmath>
#include <filesystem>
#include <memory>

#include "patient/meshing/mesh_record.h"
#include "patient/meshing/mesh_regions.h"
#include "patient/meshing/mesher.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "anatomy/mesh_quality.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/json_values.h"
#include "core/error.h"
#include "core/files.h"
#include "fem/solid/mesh_soundness.h"
#include "imaging/mesh_picture.h"
#include "io/case_folder.h"
#include "io/label_scheme.h"
#include "io/mesh/foreign_mesh.h"
#include "io/resources.h"

namespace bodkin::cli {
namespace {

namespace fs = std::filesystem;

constexpr double mesh_png_zoom = 1.5;  // pixels per px of the picture
constexpr double mm3_per_ml = 1000.0;  // mm^3
constexpr std::size_t largest_import = std::size_t{2} << 30U, largest_scheme = 8U << 20U;  // bytes
constexpr int longest_bar = 40;                                                            // characters
constexpr int bins_per_line = 3;  // of MeshQuality::angles, 15 degrees

constexpr const char* case_mesh_footer = R"(Examples:
  bodkin case mesh patient                         20,000 nodes, fine along the planned path
  bodkin case mesh patient --nodes 100000
  bodkin case mesh patient --fine 1.5 --coarse 15 --corridor 20
  bodkin case mesh patient --nodes 3000 --merge-layers    coarse, without the thin layers of the planned path
  bodkin case mesh patient --import body.msh --regions regions.csv

The mesh is kept in the case folder as mesh.vtu and made again only when the tissues, the path or these options have
changed. --nodes takes precedence: the edge lengths are scaled until the number of nodes fits. docs/meshing.md says what
is meshed and how. Meshes are made by the program bodkin-mesher, which is under the GNU GPL version 3 or later because it
contains CGAL's Mesh_3; --import works without it.)";

struct CaseMeshOptions {
  std::string folder, import, regions, output;
  patient::MeshSettings settings;
  bool force = false, merge_layers = false;
};

// A mesh with the remarks about it.
struct MeshOutcome {
  patient::CaseMesh body;
  bool reused = false;
};

MeshOutcome from_record(const fs::path& folder, const anatomy::TissueLibrary& library) {
  std::optional<patient::CaseMesh> found = patient::read_case_mesh(folder, library);
  return {std::move(*found), true};
}

void refuse_foreign_mesh(const fs::path& folder, bool force) {
  if (force || patient::case_mesh_is_ours(folder)) return;
  throw InputError(
      fmt::format("{}: this mesh was not made by this command, or has been changed since; say --force to "
                  "replace it",
                  (folder / patient::mesh_file_name).string()));
}

// Whether the folder contains the mesh made from `made_from`.
bool is_there(const fs::path& folder, const std::string& made_from) {
  const std::optional<patient::MeshRecord> record = patient::read_mesh_record(folder);
  return record && record->made_from == made_from;
}

MeshOutcome make_mesh(const CaseMeshOptions& options, const anatomy::CaseDescription& description,
                      const anatomy::TissueLibrary& library, const anatomy::TissueVolume& tissues,
                      const Progress& progress) {
  const auto& path = description.procedure.path;
  patient::MeshSettings settings = options.settings;
  settings.stiff_skin = patient::has_stiff_skin(library);
  const std::string made_from = patient::mesh_made_from(tissues, path, settings);
  if (!options.force && is_there(options.folder, made_from)) return from_record(options.folder, library);
  refuse_foreign_mesh(options.folder, options.force);
  patient::MeshedBody made = patient::mesh_tissues(tissues, path, library, settings, progress);
  patient::MeshRecord record{made_from, {}, made.scale, {}, std::move(made.notes)};
  patient::write_case_mesh(made.mesh, record, options.folder);
  return {{std::move(made.mesh), std::move(record)}, false};
}

// Refuses a mesh that lies outside the patient, as one in metres does.
void require_overlap(const anatomy::TetrahedralMesh& mesh, const anatomy::TissueVolume& tissues,
                     const std::string& file) {
  std::size_t inside = 0;
  Vec3 low = mesh.nodes.front(), high = low;
  for (const Vec3& node : mesh.nodes) {
    low = low.cwiseMin(node);
    high = high.cwiseMax(node);
    if (anatomy::nearest(tissues, node, anatomy::tissue::air) != anatomy::tissue::air) ++inside;
  }
  const anatomy::Grid& grid = tissues.grid;
  const Vec3 across = grid.spacing.cwiseProduct(Vec3(grid.size[0], grid.size[1], grid.size[2]));
  const bool tiny = (high - low).maxCoeff() < 0.02 * across.maxCoeff();
  if (inside > 0 && !tiny) return;
  throw InputError(
      fmt::format("{}: the mesh runs from ({:.3g}, {:.3g}, {:.3g}) to ({:.3g}, {:.3g}, {:.3g}), {}; expected patient "
                  "coordinates, LPS in mm",
                  file, low.x(), low.y(), low.z(), high.x(), high.y(), high.z(),
                  tiny ? "which is much smaller than the patient" : "where the case has no body"));
}

// Errors that the body's solver would report later. Its warnings become notes.
void require_usable(const anatomy::TetrahedralMesh& mesh, const std::string& file, std::vector<std::string>& notes) {
  try {
    for (std::string& warning : fem::check_mesh(mesh)) notes.push_back(std::move(warning));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
}

MeshOutcome import_mesh(const CaseMeshOptions& options, const anatomy::TissueLibrary& library,
                        const anatomy::TissueVolume& tissues) {
  const std::string scheme =
      options.regions.empty() ? std::string() : io::read_text_file(options.regions, largest_scheme);
  const std::string made_from = patient::mesh_made_from(io::read_text_file(options.import, largest_import), scheme);
  if (!options.force && is_there(options.folder, made_from)) return from_record(options.folder, library);
  refuse_foreign_mesh(options.folder, options.force);
  const io::ForeignMesh foreign = io::read_foreign_mesh(options.import);
  patient::MeshRecord record{made_from, {}, 1.0, options.import, foreign.notes};
  std::vector<anatomy::Structure> regions;
  if (!options.regions.empty()) regions = io::parse_label_scheme(scheme, options.regions, library);
  anatomy::TetrahedralMesh mesh = patient::with_tissues(
      foreign, library, regions, options.regions.empty() ? options.import : options.regions, record.notes);
  require_overlap(mesh, tissues, options.import);
  require_usable(mesh, options.import, record.notes);
  patient::write_case_mesh(mesh, record, options.folder);
  return {{std::move(mesh), std::move(record)}, false};
}

void print_tissues(const Console& console, const anatomy::MeshQuality& quality,
                   const anatomy::TissueLibrary& library) {
  console.line(
      fmt::format("  {:<26} {:>9} {:>12} {:>12} {:>14}", "tissue", "nodes", "tetrahedra", "volume, ml", "size, mm"));
  for (const anatomy::TissueMesh& own : quality.tissues) {
    // Of the regular tetrahedron with the mean volume.
    const double edge = std::cbrt(6.0 * std::sqrt(2.0) * own.volume / static_cast<double>(own.elements));
    console.line(fmt::format("  {:<26} {:>9} {:>12} {:>12.2f} {:>14.1f}", library.title(own.tissue), own.nodes,
                             own.elements, own.volume / mm3_per_ml, edge));
  }
}

void print_angles(const Console& console, const anatomy::MeshQuality& quality) {
  std::size_t all = 0;
  for (const std::size_t count : quality.angles) all += count;
  console.line("  dihedral angles, degrees");
  for (int first = 0; first < anatomy::angle_bins; first += bins_per_line) {
    std::size_t count = 0;
    for (int bin = first; bin < first + bins_per_line; ++bin) count += quality.angles[static_cast<std::size_t>(bin)];
    const double share = static_cast<double>(count) / static_cast<double>(all);
    const int degrees = first * 180 / anatomy::angle_bins;
    const std::string bar(static_cast<std::size_t>(std::lround(longest_bar * share)), '#');
    console.line(fmt::format("    {:>3} to {:>3} {:>6.2f} %{}", degrees,
                             degrees + bins_per_line * 180 / anatomy::angle_bins, 100.0 * share,
                             bar.empty() ? bar : "  " + bar));
  }
}

void print_mesh(const Console& console, const CaseMeshOptions& options, const MeshOutcome& outcome,
                const anatomy::MeshQuality& quality, const anatomy::TissueLibrary& library) {
  const std::string file = (fs::path(options.folder) / patient::mesh_file_name).string();
  const std::optional<patient::MeshRecord>& record = outcome.body.record;
  console.line(outcome.reused ? fmt::format("{} is up to date; --force makes it again", file)
                              : fmt::format("{} is ready", file));
  console.line(fmt::format("  {} nodes, {} tetrahedra, {:.1f} ml", quality.nodes, quality.elements,
                           quality.volume / mm3_per_ml));
  console.line(fmt::format("  edges {:.2f} to {:.1f} mm, {:.2f} mm in the mean", quality.shortest_edge,
                           quality.longest_edge, quality.mean_edge));
  if (quality.nodes_in_region > 0) {
    console.line(fmt::format("  corridor: {} nodes, edges {:.2f} mm in the mean", quality.nodes_in_region,
                             quality.mean_edge_in_region));
  }
  if (record && record->source.empty()) {
    console.line(
        fmt::format("  to reach that number of nodes, edges are {:.2f} times as long as requested: {:.2f} mm fine, "
                    "{:.1f} mm coarse",
                    record->scale, record->scale * options.settings.fine, record->scale * options.settings.coarse));
  }
  console.line(
      fmt::format("  element volumes {:.3g} to {:.3g} mm3, dihedral angles {:.1f} to {:.1f} degrees, {} "
                  "tetrahedra with one below 10",
                  quality.smallest_volume, quality.largest_volume, quality.smallest_angle, quality.largest_angle,
                  quality.below_10));
  print_tissues(console, quality, library);
  print_angles(console, quality);
}

nlohmann::json json_of(const MeshOutcome& outcome, const anatomy::MeshQuality& quality,
                       const anatomy::TissueLibrary& library) {
  nlohmann::json tissues = nlohmann::json::array();
  for (const anatomy::TissueMesh& own : quality.tissues) {
    const anatomy::TissueProperties* properties = library.find(own.tissue);
    tissues.push_back({{"id", own.tissue},
                       {"tissue", properties == nullptr ? "" : properties->name},
                       {"nodes", own.nodes},
                       {"elements", own.elements},
                       {"volume_ml", own.volume / mm3_per_ml}});
  }
  nlohmann::json result = {
      {"up_to_date", outcome.reused},
      {"nodes", quality.nodes},
      {"elements", quality.elements},
      {"volume_ml", quality.volume / mm3_per_ml},
      {"element_volume_mm3", {quality.smallest_volume, quality.largest_volume}},
      {"dihedral_angle_deg", {quality.smallest_angle, quality.largest_angle}},
      {"elements_below_10_deg", quality.below_10},
      {"dihedral_angles", {{"bin_deg", 180.0 / anatomy::angle_bins}, {"counts", quality.angles}}},
      {"edge_mm",
       {{"shortest", quality.shortest_edge}, {"mean", quality.mean_edge}, {"longest", quality.longest_edge}}},
      {"corridor", {{"nodes", quality.nodes_in_region}, {"mean_edge_mm", quality.mean_edge_in_region}}},
      {"tissues", tissues}};
  if (const auto& record = outcome.body.record) {
    result["scale"] = record->scale;
    result["source"] = record->source;
    result["notes"] = record->notes;
  }
  return result;
}

void run_case_mesh(const CaseMeshOptions& options, const CommandContext& context) {
  Console console(context);
  const fs::path given = options.output.empty() ? fs::path(options.folder) / "mesh.png" : fs::path(options.output);
  if (given.extension() != ".png" && given.extension() != ".svg") {
    throw InputError(fmt::format("the picture {} has the ending '{}', expected .png or .svg", options.output,
                                 given.extension().string()));
  }
  if (!options.output.empty()) require_writable(given, "--output", options.import);
  if (!options.regions.empty() && options.import.empty())
    throw InputError("--regions says what the regions of an imported mesh are; expected --import FILE with it");
  if (options.settings.coarse < options.settings.fine) {
    throw InputError(fmt::format("--coarse is {:g}; expected at least --fine, {:g}", options.settings.coarse,
                                 options.settings.fine));
  }
  const anatomy::CaseDescription description = io::read_case_description(options.folder);
  const anatomy::TissueLibrary library = io::read_case_library(options.folder, description);
  const anatomy::TissueVolume tissues = io::load_case_tissues(options.folder, description, console.progress());
  const MeshOutcome outcome = options.import.empty()
                                  ? make_mesh(options, description, library, tissues, console.progress())
                                  : import_mesh(options, library, tissues);
  console.clear_bar();

  const anatomy::TetrahedralMesh& mesh = outcome.body.mesh;
  const auto& path = description.procedure.path;
  std::function<bool(const Vec3&)> in_corridor;
  if (path) {
    in_corridor = [&](const Vec3& point) {
      return patient::distance_to_corridor(point, *path, options.settings) <= 0.0;
    };
  }
  const anatomy::MeshQuality quality = anatomy::measure_quality(mesh, in_corridor);
  const imaging::Canvas picture = imaging::mesh_picture(mesh, quality, path, library, description.name);
  write_file(given, given.extension() == ".svg" ? picture.svg() : picture.png(mesh_png_zoom));

  if (outcome.body.record) {
    for (const std::string& note : outcome.body.record->notes) console.note(note);
  }
  print_mesh(console, options, outcome, quality, library);
  console.line(fmt::format("\n{}", fs::absolute(given).string()));
  nlohmann::json result = json_of(outcome, quality, library);
  result["mesh"] = fs::absolute(fs::path(options.folder) / patient::mesh_file_name).string();
  result["picture"] = fs::absolute(given).string();
  console.json(result.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

void add_case_mesh_command(CLI::App& case_group, CommandContext& context) {
  add_command(
      case_group, "mesh", "Fill a patient with tetrahedra for the deformable body", case_mesh_footer,
      [&context](CLI::App& command) {
        const auto options = std::make_shared<CaseMeshOptions>();
        patient::MeshSettings& settings = options->settings;
        add_text(command, "CASE", options->folder, "Folder of the case").required();
        add_whole_number(command, "--nodes", settings.nodes, 500, 400000,
                         "Number of nodes; the mesh has this many within 10 %");
        add_number(command, "--fine", settings.fine, 0.2, 20.0,
                   "mm, edges in the corridor and at tissue borders near it, before scaling to --nodes");
        add_number(command, "--coarse", settings.coarse, 0.2, 100.0, "mm, edges far away, before scaling");
        add_number(command, "--corridor", settings.corridor_radius, 1.0, 200.0,
                   "mm, radius of the corridor around the planned path");
        add_switch(
            command, "--merge-layers", options->merge_layers,
            "Merge thin layers (skin, ligamentum flavum, dura) with their neighbours where the planned path crosses "
            "them, too; without it the mesh is finer there, and too few --nodes for that are refused with the number "
            "needed");
        add_text(command, "--import", options->import,
                 "Take this mesh instead: Gmsh .msh (ASCII 2.2 or 4.1) or VTK .vtu");
        add_text(
            command, "--regions", options->regions,
            "CSV with label,name,tissue,critical: tissues of the imported regions (without it they are tissue ids)");
        add_text(command, "-o,--output", options->output,
                 "The picture, .png or .svg (default: mesh.png in the case)");
        add_switch(command, "--force", options->force,
                   "Make the mesh again, and replace one that this command did not make");
        on_run(command, [options, &context] {
          options->settings.preserve_layers = !options->merge_layers;
          run_case_mesh(*options, context);
        });
      });
}

}  // namespace bodkin::cli
