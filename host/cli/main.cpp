// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "host/cli/cage_command.h"
#include "host/cli/check_command.h"
#include "host/cli/command_line.h"
#include "host/cli/exit_code.h"
#include "host/cli/input_error.h"
#include "host/cli/interrupt.h"
#include "host/cli/output_files.h"
#include "host/cli/params_command.h"
#include "host/cli/run_script.h"
#include "host/cli/strip_command.h"
#include "host/cli/text.h"
#include "host/cli/validate_command.h"
#include "host/cli/view_command.h"
#include "host/file/file_error.h"
#include "host/plugin_client/plugin_error.h"
#include "host/view/picture.h"

namespace {

using namespace cagewright::host;

struct Run {
  int operator()(const CageCommand& command) const { return run_cage(command); }
  int operator()(const CheckCommand& command) const { return run_check(command); }
  int operator()(const ParamsCommand& command) const { return run_params(command); }
  int operator()(const StripCommand& command) const { return run_strip(command); }
  int operator()(const ValidateCommand& command) const { return run_validate(command); }
  int operator()(const ViewCommand& command) const { return run_view(command); }
  int operator()(const ScriptCommandLine& command) const { return run_script(command); }
  int operator()(const Ended&) const { return exit_done; }
};

int say(int exit_code, const std::string& sentence) {
  std::cerr << "cagewright: " << one_line(sentence) << "\n";
  return exit_code;
}

int exit_code_of(PictureFault fault) { return fault == PictureFault::no_display ? exit_bad_input : exit_internal; }

}  // namespace

int main(int argc, char** argv) {
  try {
    end_on_interrupts();
    // A reader that has gone and a limit on the size of files are errors like a full disk, with files to clear away.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    const int exit_code = std::visit(Run{}, parse_command_line(argc, argv));
    flush_standard_output();
    return exit_code;
  } catch (const UsageError& error) {
    return say(exit_usage, std::string(error.what()) + "; see --help");
  } catch (const InputError& error) {
    return say(exit_bad_input, error.what());
  } catch (const FileError& error) {
    return say(exit_bad_input, error.what());
  } catch (const PluginLoadError& error) {
    return say(exit_bad_input, error.what());
  } catch (const PictureError& error) {
    return say(exit_code_of(error.fault()), error.what());
  } catch (const Cancelled&) {
    return say(exit_cancelled, "cancelled; nothing was written");
  } catch (const PluginError& error) {
    return say(exit_internal, std::string("internal error in the plug-in: ") + error.what());
  } catch (const std::bad_alloc&) {
    return say(exit_internal, "out of memory");
  } catch (const std::exception& error) {
    return say(exit_internal, std::string("internal error: ") + error.what());
  }
}
