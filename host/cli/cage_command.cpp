// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/cage_command.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "host/cli/exit_code.h"
#include "host/cli/input_error.h"
#include "host/cli/interrupt.h"
#include "host/cli/output_files.h"
#include "host/cli/progress.h"
#include "host/cli/run_report.h"
#include "host/cli/text.h"
#include "host/file/atomic_file.h"
#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/file/mesh_reader.h"
#include "host/file/mesh_writer.h"
#include "host/plugin_client/find_plugin.h"
#include "host/plugin_client/plugin_error.h"
#include "host/view/picture.h"

namespace cagewright::host {
namespace {

class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// All that can be known to fail before the work begins.
void check_outputs(const CageCommand& command) {
  if (command.out && !is_writable_mesh_name(*command.out)) {
    throw UsageError("-o " + command.out->string() + ": a cage is written as .obj, .off, .ply, .stl or .glb");
  }
  if (command.picture && lower_ending(*command.picture) != ".png") {
    throw UsageError("--picture " + command.picture->string() + ": a picture is written as .png");
  }
  std::vector<std::filesystem::path> inputs = {command.model}, outputs;
  if (command.slides) inputs.push_back(*command.slides);
  for (const OptionalPath* output : {&command.out, &command.report, &command.picture}) {
    if (*output) outputs.push_back(**output);
  }
  require_distinct(inputs, outputs);
  for (const std::filesystem::path& output : outputs) require_writable(output);
  if (command.picture) require_display();
}

class CageRun {
 public:
  explicit CageRun(const CageCommand& command) : command_(command), progress_(command.quiet) {}

  int run() {
    check_outputs(command_);
    plugin_ = Plugin::load(find_plugin(command_.plugin));
    read_inputs();
    Session session(plugin_, listener());
    fill(session);
    solve(session);
    const TriangleMesh cage = session.cage();
    const cgw_mesh_report cage_report = plugin_->inspect(cage);
    Report report = describe_run(command_, *plugin_, session, cage, cage_report);
    write(session, cage, report);
    return is_closed_manifold(cage_report) ? exit_done : exit_not_certified;
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

  void read_inputs() {
    progress_.show(0, "read");
    MeshFile file = read_mesh(command_.model);
    for (const std::string& note : file.notes) progress_.note(note);
    model_ = std::move(file.mesh);
    if (command_.slides) {
      slides_ = read_slides(*command_.slides);
    } else {
      progress_.note("no slides are given, so the cage is a box; see --slides");
    }
    read_ms_ = total_.milliseconds();
  }

  // The file, or other thing that the user gave, which an error of the plug-in is about.
  std::string culprit(cgw_status status) const {
    switch (blame(status)) {
      case Blame::model:
        return command_.model.string();
      case Blame::slides:
        return command_.slides.value_or(command_.model).string();
      case Blame::parameter:
        return "--set";
      case Blame::program:
        break;
    }
    return "";
  }

  [[noreturn]] void rethrow(const PluginError& error) const {
    const std::string name = culprit(error.status());
    if (name.empty()) throw error;
    throw InputError(name + ": " + error.what());
  }

  void fill(Session& session) {
    for (const Setting& setting : command_.settings) {
      try {
        session.set_parameter(setting.id, setting.value);
      } catch (const PluginError& error) {
        if (blame(error.status()) != Blame::parameter) throw;
        throw InputError(setting.typed + ": " + error.what());
      }
    }
    try {
      const Stopwatch preparing;
      session.set_mesh(model_);
      prepare_ms_ = preparing.milliseconds();
      for (const Slide& slide : slides_) session.add_slide(slide);
    } catch (const PluginError& error) {
      rethrow(error);
    }
  }

  void solve(Session& session) const {
    try {
      const HeededInterrupts heeded;  // by the listener's may_continue
      session.solve(command_.threads);
      throw_if_interrupted();
    } catch (const PluginError& error) {
      rethrow(error);
    }
  }

  std::string picture(const Session& session, const TriangleMesh& cage) const {
    PictureInput input;
    input.model_points = model_.points;
    input.model_triangles = model_.triangles;
    input.cage_points = cage.points;
    input.cage_triangles = cage.triangles;
    for (const SlideInfo& slide : session.slides()) {
      if (slide.info.has_ellipse != 1) continue;
      input.slides.push_back({std::to_array(slide.info.center), std::to_array(slide.info.u),
                              std::to_array(slide.info.v), slide.info.status != CGW_OK});
    }
    for (const cgw_section& section : session.sections()) input.sections.push_back(std::to_array(section.corners));
    const std::vector<std::uint8_t> png = render_picture(input, command_.picture_options);
    return {png.begin(), png.end()};
  }

  void write(const Session& session, const TriangleMesh& cage, Report& report) {
    progress_.show(1, "write");
    const Stopwatch writing;
    std::vector<std::pair<std::filesystem::path, std::string>> files;
    if (command_.out) files.emplace_back(*command_.out, mesh_bytes(cage, *command_.out));
    if (command_.picture) files.emplace_back(*command_.picture, picture(session, cage));
    report.timings_ms.read = read_ms_;
    report.timings_ms.prepare = prepare_ms_;
    report.timings_ms.write = writing.milliseconds();
    report.timings_ms.total = total_.milliseconds();
    report.peak_memory_mb = peak_memory_mb();
    if (command_.report) files.emplace_back(*command_.report, report_text(report));
    write_files(files, [&] { sum_up(report); });
  }

  void sum_up(const Report& report) const {
    std::cout << "cage: " << counted(*report.cage.vertices, "vertex") << ", "
              << counted(*report.cage.triangles, "triangle");
    if (report.cage.genus) std::cout << ", genus " << *report.cage.genus;
    std::cout << (*report.certificate.closed ? ", closed\n" : ", NOT closed\n");
    if (report.tightness.volume_ratio) {
      std::cout << "volume ratio: " << figure_text(*report.tightness.volume_ratio) << "\n";
    }
    std::cout << "refinement: " << (*report.refinement.converged ? "converged" : "not converged") << " after "
              << counted(*report.refinement.iterations, "iteration") << "\n";
  }

  const CageCommand& command_;
  Stopwatch total_;
  Progress progress_;
  std::shared_ptr<const Plugin> plugin_;
  TriangleMesh model_;
  std::vector<Slide> slides_;
  double read_ms_ = 0, prepare_ms_ = 0;
};

}  // namespace

int run_cage(const CageCommand& command) { return CageRun(command).run(); }

}  // namespace cagewright::host
