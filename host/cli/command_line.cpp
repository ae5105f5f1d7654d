// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "host/cli/exit_code.h"

namespace cagewright::host {
namespace {

// CLI11's options for the structs of the header.
class CommandLine {
 public:
  CommandLine() : app_("Cagewright makes deformation cages of closed meshes from cut slides.", "cagewright") {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", "cagewright " CAGEWRIGHT_VERSION);
    add_cage();
    add_check();
    add_params();
    validate_ = app_.add_subcommand("validate", "Check a scene's cages (not part of this version)");
    view_ = app_.add_subcommand("view", "Open the window (not part of this version)");
    for (CLI::App* later : {validate_, view_}) later->allow_extras();
  }

  Command parse(int argc, const char* const* argv) {
    if (argc > 1 && *argv[1] != '-' && !is_command(argv[1])) {
      std::cerr << "cagewright: there is no command \"" << argv[1] << "\", only cage, check and params; see --help\n";
      return Ended{exit_usage};
    }
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return Ended{app_.exit(error, std::cout, std::cerr) == 0 ? exit_done : exit_usage};
    }
    if (cage_app_->parsed()) return cage();
    if (check_app_->parsed()) return check_;
    if (params_app_->parsed()) return params_;
    const char* name = view_->parsed() ? "view" : "validate";
    std::cerr << "cagewright: \"" << name << "\" is not part of this version; there are cage, check and params\n";
    return Ended{exit_usage};
  }

 private:
  bool is_command(const std::string& name) const {
    const auto has_name = [&name](const CLI::App* command) { return command->get_name() == name; };
    return !app_.get_subcommands(has_name).empty();
  }

  void add_cage() {
    cage_app_ = app_.add_subcommand("cage", "Make a cage of a model");
    cage_app_->add_option("MODEL", cage_.model, "Closed mesh: .glb .gltf .obj .off .ply .stl")->required();
    cage_app_->add_option("--slides", cage_.slides, "The cut slides, JSON; without any, the cage is a box");
    cage_app_->add_option("-o,--out", cage_.out, "The cage: .obj .off .ply .stl .glb");
    const CLI::Validator number = CLI::Number;
    cage_app_->add_option("--delta", delta_, "Short for --set refine.delta=D, a fraction of the diagonal")
        ->check(number);
    cage_app_->add_option("--lambda", lambda_, "Short for --set orient.lambda=L")->check(number);
    cage_app_->add_option("--iterations", iterations_, "Short for --set refine.iterations=N")->check(number);
    cage_app_->add_option("--set", set_, "Set a parameter; \"cagewright params\" lists them")
        ->type_name("ID=VALUE")
        ->allow_extra_args(false)
        ->check([](const std::string& text) -> std::string {
          return text.find('=') == 0 || text.find('=') == text.npos ? "--set needs ID=VALUE, not \"" + text + "\"" : "";
        });
    cage_app_->add_option("--report", cage_.report, "Figures of the run, JSON");
    cage_app_->add_option("--picture", cage_.picture, "Model, slides and cage, PNG; needs a display");
    cage_app_->add_option("--threads", cage_.threads, "0 (default): as many as the machine has")
        ->check(CLI::Range(0, 4096));
    cage_app_->add_flag("--quiet", cage_.quiet, "No progress and no notes on stderr, only errors");
    add_plugin(*cage_app_, cage_.plugin);
  }

  void add_check() {
    check_app_ = app_.add_subcommand("check", "Judge any cage of a model");
    check_app_->add_option("MODEL", check_.model, "Mesh: .glb .gltf .obj .off .ply .stl")->required();
    check_app_->add_option("CAGE", check_.cage, "Its cage, in any of these formats")->required();
    check_app_->add_option("--report", check_.report, "The figures, JSON");
    check_app_->add_flag("--quiet", check_.quiet, "No notes on stderr, only errors");
    add_plugin(*check_app_, check_.plugin);
  }

  void add_params() {
    params_app_ = app_.add_subcommand("params", "List the plug-in's parameters");
    params_app_->add_flag("--json", params_.as_json, "As JSON");
    add_plugin(*params_app_, params_.plugin);
  }

  static void add_plugin(CLI::App& app, OptionalPath& plugin) {
    app.add_option("--plugin", plugin,
                   "The plug-in; otherwise $CAGEWRIGHT_PLUGIN, or the one installed with this program");
  }

  CageCommand cage() {
    const std::pair<const char*, const std::optional<std::string>*> short_forms[] = {
        {"refine.delta", &delta_}, {"orient.lambda", &lambda_}, {"refine.iterations", &iterations_}};
    for (const auto& [id, value] : short_forms) {
      if (*value) cage_.parameters.emplace_back(id, **value);
    }
    for (const std::string& text : set_) {
      const std::size_t equals = text.find('=');
      cage_.parameters.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
    return cage_;
  }

  CLI::App app_;
  CLI::App *cage_app_ = nullptr, *check_app_ = nullptr, *params_app_ = nullptr, *validate_ = nullptr, *view_ = nullptr;
  CageCommand cage_;
  CheckCommand check_;
  ParamsCommand params_;
  std::optional<std::string> delta_, lambda_, iterations_;
  std::vector<std::string> set_;
};

}  // namespace

Command parse_command_line(int argc, const char* const* argv) { return CommandLine().parse(argc, argv); }

}  // namespace cagewright::host
