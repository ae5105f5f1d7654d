// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/run_script.h"

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "host/cli/exit_code.h"
#include "host/cli/input_error.h"
#include "host/cli/interrupt.h"
#include "host/cli/text.h"
#include "host/file/file_error.h"
#include "host/plugin_client/find_plugin.h"
#include "host/plugin_client/plugin_error.h"
#include "host/view/picture.h"
#include "host/workspace/script.h"

namespace cagewright::host {
namespace {

// Not asked to enclose, a cage only has to be closed.
bool is_good(const CageState& cage) {
  if (cage.failed || !cage.certificate || !cage.is_of_now) return false;
  if (cage.summary.last_stage < CGW_STAGE_ENCLOSE) return cage.certificate->closed;
  return cage.certificate->encloses && cage.certificate->keeps_distance;
}

// Of one that is not good.
std::string why_bad(const CageState& cage) {
  const bool is_made = cage.certificate && cage.is_of_now;
  if (!cage.failed && !is_made) return "no cage was made of the slides as they are";
  if (!cage.problems.empty()) return cage.problems.front().sentence;
  return is_made && !cage.certificate->closed ? "the cage is not closed" : "the cage does not enclose the model";
}

class ScriptRun {
 public:
  explicit ScriptRun(const ScriptCommandLine& command)
      : name_(command.script == "-" ? "standard input" : command.script.string()),
        workspace_(Plugin::load(find_plugin(command.plugin)),
                   [this] {
                     if (was_interrupted()) workspace_.interrupt_solve();
                   }),
        runner_(workspace_) {
    runner_.interrupt_where(was_interrupted);
  }

  int run(std::istream& script) {
    std::string line;
    for (std::size_t number = 1; std::getline(script, line); ++number) {
      if (is_blank_script_line(line)) continue;
      const std::string place = name_ + ":" + std::to_string(number) + ": ";
      try {
        const HeededInterrupts heeded;  // by wake and between lines
        run_line(line, place);
        throw_if_interrupted();
      } catch (const Cancelled&) {
        std::cerr << "cagewright: " << one_line(place) << "cancelled; what was written before stays\n";
        return exit_cancelled;
      }
    }
    if (is_good_) return exit_done;
    std::cerr << "cagewright: " << one_line(bad_) << '\n';
    return exit_not_certified;
  }

 private:
  void run_line(const std::string& line, const std::string& place) {
    try {
      const nlohmann::json command = parse_script_line(line);
      const nlohmann::json said = runner_.run(command);
      using nlohmann::json;
      // A path in it may be no UTF-8.
      if (!said.empty()) std::cout << said.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
      judge(command["command"].get<std::string>(), place);
    } catch (const PluginError& error) {
      throw_if_interrupted();
      if (blame(error.status()) == Blame::program) throw;
      throw InputError(place + error.what());
    } catch (const PictureError& error) {
      if (error.fault() == PictureFault::render) throw;
      throw InputError(place + error.what());
    } catch (const ScriptError& error) {
      throw InputError(place + error.what());
    } catch (const CommandError& error) {
      throw InputError(place + error.what());
    } catch (const FileError& error) {
      throw InputError(place + error.what());
    } catch (const PluginLoadError& error) {
      throw InputError(place + error.what());
    }
  }

  void judge(const std::string& command, const std::string& place) {
    static const std::set<std::string> judged = {"save", "export_cage", "wait", "report"};
    if (judged.count(command) == 0 || workspace_.mesh_node() < 0) return;
    is_good_ = is_good(workspace_.cage());
    bad_ = place + why_bad(workspace_.cage());
  }

  std::string name_;
  Workspace workspace_;
  ScriptRunner runner_;
  bool is_good_ = true;
  std::string bad_;  // says why it is not
};

}  // namespace

int run_script(const ScriptCommandLine& command) {
  std::ifstream file;
  if (command.script != "-") {
    file.open(command.script);
    if (!file || std::filesystem::is_directory(command.script)) {
      throw InputError(command.script.string() + ": cannot be read as a script");
    }
  }
  return ScriptRun(command).run(command.script == "-" ? std::cin : file);
}

}  // namespace cagewright::host
