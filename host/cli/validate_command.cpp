// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/validate_command.h"

#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "host/cli/cage_input.h"
#include "host/cli/cage_solve.h"
#include "host/cli/exit_code.h"
#include "host/cli/interrupt.h"
#include "host/cli/output_files.h"
#include "host/cli/progress.h"
#include "host/cli/text.h"
#include "host/file/atomic_file.h"
#include "host/plugin_client/find_plugin.h"
#include "host/validate/validation_file.h"
#include "host/view/picture.h"
#include "host/workspace/validate_mesh.h"

namespace cagewright::host {
namespace {

void check_outputs(const ValidateCommand& command) {
  std::vector<std::filesystem::path> inputs = {command.cage.model}, outputs;
  if (command.cage.slides) inputs.push_back(*command.cage.slides);
  for (const OptionalPath* output : {&command.cage.report, &command.html}) {
    if (*output) outputs.push_back(**output);
  }
  require_distinct(inputs, outputs);
  for (const std::filesystem::path& output : outputs) require_writable(output);
}

class ValidateRun {
 public:
  explicit ValidateRun(const ValidateCommand& command) : command_(command), progress_(command.cage.quiet) {}

  int run() {
    check_outputs(command_);
    plugin_ = Plugin::load(find_plugin(command_.cage.plugin));
    progress_.show(0, "read");
    input_ = read_cage_input(command_.cage);
    for (const std::string& note : input_.notes) progress_.note(note);
    // A merged cage has other triangles than the refinement's records are about.
    CageCommand unmerged = command_.cage;
    for (const Parameter& parameter : plugin_->parameters()) {
      if (parameter.id == "enclose.merge")
        unmerged.settings.push_back({parameter.id, "false", "--set enclose.merge=false"});
    }
    ValidationReport report{command_.cage.model.string(), CAGEWRIGHT_VERSION, options(), {}};
    for (const CageTarget& target : input_.targets) {
      solved_.push_back(solve_cage(unmerged, plugin_, target, listener()));
      const HeededInterrupts heeded;
      report.cages.push_back(validate(
          *plugin_, *solved_.back().session, target.model, {command_.starts, command_.seconds, command_.cage.threads},
          [this](double fraction, const std::string& what) { return goes_on(fraction, what); }));
      report.cages.back().node = target.name;
    }
    write(report);
    return report.agrees() ? exit_done : exit_not_certified;
  }

 private:
  bool goes_on(double fraction, const std::string& what) {
    progress_.show(fraction, what);
    return !was_interrupted();
  }

  SessionListener listener() {
    SessionListener listener;
    listener.log = [this](int level, const std::string& message) {
      if (level >= CGW_LOG_INFO) progress_.note(message);
    };
    listener.may_continue = [this](double fraction, const std::string& stage) { return goes_on(fraction, stage); };
    return listener;
  }

  std::vector<std::pair<std::string, std::string>> options() const {
    std::vector<std::pair<std::string, std::string>> options = {{"model", command_.cage.model.string()}};
    if (command_.cage.slides) options.emplace_back("slides", command_.cage.slides->string());
    options.emplace_back("plugin", plugin_->path().string());
    options.emplace_back("plugin version", plugin_->version());
    options.emplace_back("starts", std::to_string(command_.starts));
    options.emplace_back("seconds", figure_text(command_.seconds));
    options.emplace_back("threads", std::to_string(command_.cage.threads));
    for (const Setting& setting : command_.cage.settings) options.emplace_back(setting.id, setting.value);
    return options;
  }

  // Empty, with a reason, where nothing can be rendered.
  std::vector<std::vector<PagePicture>> pictures(const ValidationReport& report, std::string& why_none) const {
    std::vector<std::vector<PagePicture>> pictures;
    try {
      require_display();
      for (std::size_t i = 0; i < solved_.size(); ++i) {
        pictures.push_back(
            validation_pictures(*solved_[i].session, input_.targets[i].model, solved_[i].cage, report.cages[i]));
      }
    } catch (const PictureError& error) {
      pictures.clear();
      why_none = error.what();
    }
    return pictures;
  }

  void write(const ValidationReport& report) {
    progress_.show(1, "write");
    std::vector<std::pair<std::filesystem::path, std::string>> files;
    if (command_.cage.report) files.emplace_back(*command_.cage.report, validation_json(report));
    if (command_.html) {
      std::string why_none;
      const auto shown = pictures(report, why_none);
      if (!why_none.empty()) progress_.note("the page has no pictures: " + why_none);
      files.emplace_back(*command_.html, validation_page(report, shown, why_none));
    }
    write_files(files, [&] {
      for (const Validation& cage : report.cages) std::cout << validation_summary(cage);
      std::cout << (report.agrees() ? "the plug-in's figures hold\n" : "the plug-in's figures DO NOT hold\n");
    });
  }

  const ValidateCommand& command_;
  Progress progress_;
  std::shared_ptr<const Plugin> plugin_;
  CageInput input_;
  std::vector<SolvedCage> solved_;
};

}  // namespace

int run_validate(const ValidateCommand& command) { return ValidateRun(command).run(); }

}  // namespace cagewright::host
