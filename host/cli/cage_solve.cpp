// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/cage_solve.h"

#include <string>
#include <utility>

#include "host/cli/input_error.h"
#include "host/cli/interrupt.h"
#include "host/cli/run_report.h"
#include "host/cli/stopwatch.h"
#include "host/plugin_client/plugin_error.h"

namespace cagewright::host {
namespace {

class Solving {
 public:
  Solving(const CageCommand& command, const CageTarget& target) : command_(command), target_(target) {}

  SolvedCage run(const std::shared_ptr<const Plugin>& plugin, SessionListener listener) const {
    SolvedCage solved;
    solved.session = std::make_unique<Session>(plugin, std::move(listener));
    set_parameters(*solved.session);
    double prepare_ms = 0;
    try {
      const Stopwatch preparing;
      solved.session->set_mesh(target_.model);
      prepare_ms = preparing.milliseconds();
      for (const Slide& slide : target_.slides) solved.session->add_slide(slide);
      const HeededInterrupts heeded;  // by the listener's may_continue
      solved.session->solve(command_.threads);
      throw_if_interrupted();
    } catch (const PluginError& error) {
      rethrow(error);
    }
    solved.cage = solved.session->cage();
    solved.report =
        describe_run(options_of(command_), *plugin, *solved.session, solved.cage, plugin->inspect(solved.cage));
    const Report::Certificate& certificate = solved.report.certificate;
    const bool was_asked_for = solved.session->summary().last_stage >= CGW_STAGE_ENCLOSE;
    solved.is_good = was_asked_for ? *certificate.encloses && *certificate.keeps_distance : *certificate.closed;
    solved.report.node = target_.name;
    solved.report.timings_ms.prepare = prepare_ms;
    return solved;
  }

 private:
  void set_parameters(Session& session) const {
    for (const Setting& setting : command_.settings) {
      try {
        session.set_parameter(setting.id, setting.value);
      } catch (const PluginError& error) {
        if (blame(error.status()) != Blame::parameter) throw;
        throw InputError(setting.typed + ": " + error.what());
      }
    }
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
    const std::string file = culprit(error.status());
    if (file.empty()) throw error;
    throw InputError(file + ": " + (target_.name.empty() ? "" : target_.name + ": ") + error.what());
  }

  const CageCommand& command_;
  const CageTarget& target_;
};

}  // namespace

SolvedCage solve_cage(const CageCommand& command, const std::shared_ptr<const Plugin>& plugin, const CageTarget& target,
                      SessionListener listener) {
  return Solving(command, target).run(plugin, std::move(listener));
}

}  // namespace cagewright::host
