// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/cage_command.h"

#include <algorithm>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "host/cli/cage_input.h"
#include "host/cli/cage_solve.h"
#include "host/cli/exit_code.h"
#include "host/cli/input_error.h"
#include "host/cli/interrupt.h"
#include "host/cli/output_files.h"
#include "host/cli/progress.h"
#include "host/cli/run_report.h"
#include "host/cli/scene_output.h"
#include "host/cli/stopwatch.h"
#include "host/cli/text.h"
#include "host/file/atomic_file.h"
#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/file/gltf_uri.h"
#include "host/file/mesh_writer.h"
#include "host/plugin_client/find_plugin.h"
#include "host/view/picture.h"
#include "host/workspace/describe_run.h"
#include "host/workspace/scene_picture.h"

namespace cagewright::host {
namespace {

bool is_output_name(const std::filesystem::path& path) { return is_scene_name(path) || is_writable_mesh_name(path); }

std::vector<std::filesystem::path> outputs_of(const CageCommand& command) {
  std::vector<std::filesystem::path> outputs;
  for (const OptionalPath* output : {&command.out, &command.report, &command.picture}) {
    if (*output) outputs.push_back(**output);
  }
  return outputs;
}

// All that can be known to fail before the work begins.
void check_outputs(const CageCommand& command) {
  if (command.out && !is_output_name(*command.out)) {
    throw UsageError("-o " + command.out->string() +
                     ": a scene is written as .glb or .gltf, a cage alone as .obj, .off, .ply or .stl");
  }
  if (command.picture && lower_ending(*command.picture) != ".png") {
    throw UsageError("--picture " + command.picture->string() + ": a picture is written as .png");
  }
  std::vector<std::filesystem::path> inputs;
  const std::vector<std::filesystem::path> outputs = outputs_of(command);
  // A scene may take the place of the one that was read: nothing of it is lost.
  const bool is_scene_to_scene = command.out && is_scene_name(command.model) && is_scene_name(*command.out);
  if (!is_scene_to_scene || !same_file(command.model, *command.out)) inputs.push_back(command.model);
  if (command.slides) inputs.push_back(*command.slides);
  require_distinct(inputs, outputs);
  for (const std::filesystem::path& output : outputs) require_writable(output);
  if (command.picture) require_display();
}

std::string value_text(const Parameter& parameter, double value) {
  std::ostringstream text;
  std::visit([&text](const auto& it) { text << std::boolalpha << it; }, option_value(parameter, value));
  return text.str();
}

// As the options that would set them, "--set refine.delta=0.02"; empty: there are none that the plug-in knows.
std::string other_parameters(const std::vector<std::pair<std::string, double>>& of_scene, const Plugin& plugin,
                             const Session& session) {
  std::string text;
  for (const Parameter& parameter : plugin.parameters())
    for (const auto& [id, value] : of_scene)
      if (id == parameter.id && value != session.parameter(id))
        text += (text.empty() ? "--set " : " --set ") + id + "=" + value_text(parameter, value);
  return text;
}

class CageRun {
 public:
  explicit CageRun(const CageCommand& command) : command_(command), progress_(command.quiet) {}

  int run() {
    check_outputs(command_);
    plugin_ = Plugin::load(find_plugin(command_.plugin));
    progress_.show(0, "read");
    input_ = read_cage_input(command_);
    for (const std::string& note : input_.notes) progress_.note(note);
    require_one_target();
    require_scene_kept();
    const double read_ms = total_.milliseconds();
    for (const CageTarget& target : input_.targets)
      solved_.push_back(solve_cage(command_, plugin_, target, listener()));
    note_other_parameters();
    write(read_ms);
    const auto is_good = [](const SolvedCage& solved) { return solved.is_good; };
    return std::all_of(solved_.begin(), solved_.end(), is_good) ? exit_done : exit_not_certified;
  }

 private:
  SessionListener listener() {
    SessionListener listener;
    listener.log = [this](int level, const std::string& message) {
      if (level >= CGW_LOG_INFO) progress_.note(message);
    };
    listener.may_continue = [this](double fraction, const std::string& stage) {
      progress_.show(fraction, stage);
      return !was_interrupted();
    };
    return listener;
  }

  // A cage in the scene may have been made with others, which a written scene has no longer.
  void note_other_parameters() {
    if (!input_.scene) return;
    for (std::size_t i = 0; i < solved_.size(); ++i) {
      const std::string others =
          other_parameters(input_.scene->parameters(input_.targets[i].node), *plugin_, *solved_[i].session);
      if (!others.empty())
        progress_.note("the scene's cage was made with other parameters than this one; to keep them: " + others);
    }
  }

  // No output takes the place of a file that the scene names.
  void require_scene_kept() const {
    if (!input_.scene) return;
    std::vector<std::filesystem::path> named;
    for (const std::string& uri : input_.scene->external_files()) {
      if (const auto name = relative_path(uri)) named.push_back(command_.model.parent_path() / *name);
    }
    require_distinct(named, outputs_of(command_));
  }

  // A cage alone, and a picture, show one model.
  void require_one_target() const {
    if (input_.targets.size() == 1) return;
    const std::string reason = ": slides cut " + counted(input_.targets.size(), "mesh") + ", " +
                               input_.targets[0].name + " and others; choose one with --node";
    if (command_.out && !is_scene_name(*command_.out)) throw InputError("-o " + command_.out->string() + reason);
    if (command_.picture) throw InputError("--picture " + command_.picture->string() + reason);
  }

  std::string picture() const {
    const Session& session = *solved_.front().session;
    const TriangleMesh& cage = solved_.front().cage;
    PictureInput input = session_picture(session, input_.targets.front().model, cage, cage.points);
    for (const cgw_section& section : session.sections()) {
      if (std::ranges::find(section.cage_vertex, -1) != std::end(section.cage_vertex)) continue;  // merged away
      input.sections.push_back(std::to_array(section.corners));
    }
    const std::vector<std::uint8_t> png = render_picture(input, command_.picture_options);
    return {png.begin(), png.end()};
  }

  void write(double read_ms) {
    progress_.show(1, "write");
    const Stopwatch writing;
    std::vector<OutputFile> files;
    if (command_.out && is_scene_name(*command_.out)) {
      files = scene_files(input_, solved_, *plugin_, *command_.out);
    } else if (command_.out) {
      files.emplace_back(*command_.out, mesh_bytes(solved_.front().cage, *command_.out));
    }
    if (command_.picture) files.emplace_back(*command_.picture, picture());
    std::vector<Report> reports;
    for (const SolvedCage& solved : solved_) reports.push_back(solved.report);
    Report::Timings& timings = reports.front().timings_ms;
    timings.read = read_ms;
    timings.write = writing.milliseconds();
    timings.total = total_.milliseconds();
    reports.front().peak_memory_mb = peak_memory_mb();
    if (command_.report) files.emplace_back(*command_.report, reports_text(reports));
    write_files(files, [&] {
      for (const Report& report : reports) sum_up(report);
    });
  }

  void sum_up(const Report& report) const {
    if (!report.node.empty()) std::cout << one_line(report.node) << "\n";
    std::cout << "cage: " << counted(*report.cage.vertices, "vertex") << ", "
              << counted(*report.cage.triangles, "triangle");
    if (report.cage.genus) std::cout << ", genus " << *report.cage.genus;
    std::cout << (*report.certificate.closed ? ", closed\n" : ", NOT closed\n");
    std::cout << tightness_text(report.tightness);
    std::cout << "refinement: " << (*report.refinement.converged ? "converged" : "not converged") << " after "
              << counted(*report.refinement.iterations, "iteration") << "\n"
              << certificate_summary(report.certificate);
  }

  const CageCommand& command_;
  Stopwatch total_;
  Progress progress_;
  std::shared_ptr<const Plugin> plugin_;
  CageInput input_;
  std::vector<SolvedCage> solved_;
};

}  // namespace

int run_cage(const CageCommand& command) { return CageRun(command).run(); }

}  // namespace cagewright::host
