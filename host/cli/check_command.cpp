// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/check_command.h"

#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "host/cli/exit_code.h"
#include "host/cli/input_error.h"
#include "host/cli/output_files.h"
#include "host/cli/progress.h"
#include "host/cli/run_report.h"
#include "host/cli/text.h"
#include "host/file/atomic_file.h"
#include "host/file/file_error.h"
#include "host/file/mesh_reader.h"
#include "host/plugin_client/find_plugin.h"
#include "host/plugin_client/plugin_error.h"

namespace cagewright::host {
namespace {

// A mesh of a file, and what it is.
struct CheckedMesh {
  TriangleMesh mesh;
  cgw_mesh_report report;
};

CheckedMesh inspect_file(const Plugin& plugin, const std::filesystem::path& path, MeshRole role, Progress& progress) {
  MeshFile file = read_mesh(path, role);
  for (const std::string& note : file.notes) progress.note(note);
  try {
    const cgw_mesh_report report = plugin.inspect(file.mesh);
    return {std::move(file.mesh), report};
  } catch (const PluginError& error) {
    if (blame(error.status()) != Blame::model) throw;
    throw InputError(path.string() + ": " + error.what());
  }
}

Plugin::Evaluation evaluate(const CheckCommand& command, const Plugin& plugin, const CheckedMesh& model,
                            const CheckedMesh& cage) {
  try {
    return plugin.evaluate(model.mesh, cage.mesh, 0);
  } catch (const PluginError& error) {
    if (blame(error.status()) != Blame::model) throw;
    throw InputError(command.model.string() + ", " + command.cage.string() + ": " + error.what());
  }
}

void append_fault(std::string& faults, std::uint64_t count, const char* noun) {
  if (count == 0) return;
  if (!faults.empty()) faults += ", ";
  faults += counted(count, noun);
}

// What keeps a mesh from being a closed, consistently oriented 2-manifold; "" where nothing does.
std::string faults_of(const cgw_mesh_report& mesh) {
  std::string faults;
  append_fault(faults, mesh.open_edges, "open edge");
  append_fault(faults, mesh.non_manifold_edges, "non-manifold edge");
  append_fault(faults, mesh.inconsistent_edges, "inconsistently oriented edge");
  append_fault(faults, mesh.bow_tie_vertices, "bow-tie vertex");
  return faults;
}

void print_mesh(const char* name, const std::filesystem::path& path, const cgw_mesh_report& mesh) {
  std::cout << name << " " << path.string() << "\n  " << counted(mesh.vertices, "vertex") << ", "
            << counted(mesh.triangles, "triangle") << ", " << counted(mesh.components, "component");
  if (mesh.genus >= 0) std::cout << ", genus " << mesh.genus;
  std::cout << "\n  " << (mesh.closed == 1 ? "closed" : "not closed") << ", "
            << (mesh.consistently_oriented == 1 ? "consistently oriented" : "not consistently oriented")
            << (mesh.inside_out == 1 ? ", inside out" : "") << "\n";
  if (const std::string faults = faults_of(mesh); !faults.empty()) std::cout << "  " << faults << "\n";
  if (mesh.degenerate_triangles > 0) {
    std::cout << "  " << counted(mesh.degenerate_triangles, "degenerate triangle") << " not counted\n";
  }
}

Report::Option path_option(const std::filesystem::path& path) { return path.string(); }

}  // namespace

int run_check(const CheckCommand& command) {
  if (command.report) {
    require_distinct({command.model, command.cage}, {*command.report});
    require_writable(*command.report);
  }
  const std::shared_ptr<const Plugin> plugin = Plugin::load(find_plugin(command.plugin));
  Progress progress(command.quiet);
  const CheckedMesh model = inspect_file(*plugin, command.model, MeshRole::model, progress);
  const CheckedMesh cage = inspect_file(*plugin, command.cage, MeshRole::cage, progress);
  const Plugin::Evaluation evaluation = evaluate(command, *plugin, model, cage);

  Report report;
  report.model = describe_mesh(model.report);
  const Report::Mesh cage_mesh = describe_mesh(cage.report);
  report.cage = {cage_mesh.vertices, cage_mesh.triangles, cage_mesh.genus};
  report.certificate = describe_certificate(evaluation.certificate);
  report.certificate.keeps_distance = {};  // nobody has asked for one
  report.tightness = describe_tightness(evaluation.measures);
  if (model.report.closed != 1 || model.report.consistently_oriented != 1) report.tightness.volume_ratio = {};
  report.quality = describe_quality(evaluation.measures);
  report.peak_memory_mb = peak_memory_mb();
  report.version = CAGEWRIGHT_VERSION;
  report.options = {{"model", path_option(command.model)}, {"cage", path_option(command.cage)}};
  std::vector<std::pair<std::filesystem::path, std::string>> files;
  if (command.report) files.emplace_back(*command.report, report_text(report));
  write_files(files, [&] {
    print_mesh("model", command.model, model.report);
    print_mesh("cage", command.cage, cage.report);
    std::cout << tightness_text(report.tightness) << certificate_summary(report.certificate);
  });
  return evaluation.certificate.encloses ? exit_done : exit_not_certified;
}

}  // namespace cagewright::host
