// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "host/cli/input_error.h"
#include "host/cli/picture_arguments.h"
#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

std::string number_fault(const std::string& text) {
  double number = 0;
  return CLI::detail::lexical_cast(text, number) ? "" : "needs a number, not " + in_quotes(text);
}

// CLI11's options for the structs of the header.
class CommandLine {
 public:
  CommandLine() : app_("Cagewright makes deformation cages of closed meshes from cut slides.", "cagewright") {
    app_.require_subcommand(0, 1);
    app_.set_version_flag("--version", "cagewright " CAGEWRIGHT_VERSION);
    add_file(app_, "--command", script_file_, "Run a script, a command a line, JSON; - is standard input");
    add_plugin(app_, script_.plugin);
    add_cage();
    add_check();
    add_params();
    add_strip();
    add_validate();
    add_view();
  }

  Invocation parse(int argc, const char* const* argv) {
    if (argc > 1 && *argv[1] != '-' && !is_command(argv[1])) {
      throw UsageError("there is no command " + in_quotes(argv[1]) +
                       ", only cage, check, params, strip, validate and view");
    }
    try {
      app_.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // for help or the version
      app_.exit(asked, std::cout, std::cerr);
      return Ended{};
    } catch (const CLI::RequiredError& error) {
      // CLI11 misses an argument before it minds one that it does not know, which may be that one mistyped.
      const std::vector<std::string> unknown = app_.remaining(true);
      throw UsageError(unknown.empty() ? error.what() : CLI::ExtrasError(unknown).what());
    } catch (const CLI::ParseError& error) {
      throw UsageError(error.what());
    }
    const bool has_subcommand = !app_.get_subcommands().empty();
    if (script_file_) return script(has_subcommand);
    if (!has_subcommand) {
      throw UsageError("A subcommand is required: cage, check, params, strip or validate; or --command FILE");
    }
    if (script_.plugin) throw UsageError("--plugin before the subcommand is of --command FILE only: put it behind");
    if (cage_app_->parsed()) return cage();
    if (check_app_->parsed()) return check_;
    if (params_app_->parsed()) return params_;
    if (strip_app_->parsed()) return strip_;
    if (validate_app_->parsed()) return validate();
    return view_;
  }

 private:
  bool is_command(const std::string& name) const {
    const auto has_name = [&name](const CLI::App* command) { return command->get_name() == name; };
    return !app_.get_subcommands(has_name).empty();
  }

  void add_cage() {
    cage_app_ = app_.add_subcommand("cage", "Make a cage of a model");
    add_file(*cage_app_, "MODEL", cage_.model, "Closed mesh: .glb .gltf .obj .off .ply .stl")->required();
    add_file(*cage_app_, "--slides", cage_.slides, "The cut slides, JSON; without it, those of the scene");
    add_file(*cage_app_, "-o,--out", cage_.out,
             "The scene with model, slides and cage: .glb .gltf; the cage alone: .obj .off .ply .stl");
    cage_app_->add_option("--node", cage_.node, "Of a scene: the node with the mesh, where several have one")
        ->type_name("NAME");
    const CLI::Validator number([](const std::string& text) { return number_fault(text); }, "");
    cage_app_->add_option("--delta", delta_, "Short for --set refine.delta=D, a fraction of the diagonal")
        ->type_name("NUMBER")
        ->check(number);
    cage_app_->add_option("--lambda", lambda_, "Short for --set orient.lambda=L")->type_name("NUMBER")->check(number);
    cage_app_->add_option("--iterations", iterations_, "Short for --set refine.iterations=N")
        ->type_name("NUMBER")
        ->check(number);
    add_set(*cage_app_);
    add_file(*cage_app_, "--report", cage_.report, "Figures of the run, JSON");
    add_picture();
    add_threads(*cage_app_, cage_.threads);
    cage_app_->add_flag("--quiet", cage_.quiet, "No progress and no notes on stderr, only errors");
    add_plugin(*cage_app_, cage_.plugin);
  }

  void add_validate() {
    validate_app_ = app_.add_subcommand("validate", "Have Ceres check the plug-in's figures on a scene's cages");
    CageCommand& cage = validate_.cage;
    add_file(*validate_app_, "SCENE", cage.model, "A scene with slides, or any model that cage takes")->required();
    add_file(*validate_app_, "--slides", cage.slides, "The cut slides, JSON; without it, those of the scene");
    validate_app_->add_option("--node", cage.node, "Of a scene: the node with the mesh, where several have one")
        ->type_name("NAME");
    add_set(*validate_app_);
    add_file(*validate_app_, "--report", cage.report, "What was found, JSON");
    add_file(*validate_app_, "--html", validate_.html, "What was found, a page; its pictures need a display");
    validate_app_->add_option("--starts", validate_.starts, "Random starts for equation (1) (default 200)")
        ->check(CLI::Range(0, 1000000));
    validate_app_->add_option("--seconds", validate_.seconds, "For the search of a tighter cage (default 120); 0: none")
        ->check(CLI::Range(0.0, 1e6));
    add_threads(*validate_app_, cage.threads);
    validate_app_->add_flag("--quiet", cage.quiet, "No progress and no notes on stderr, only errors");
    add_plugin(*validate_app_, cage.plugin);
  }

  void add_view() {
    CLI::App* app = app_.add_subcommand("view", "Open the window: draw slides, and the cage follows");
    add_file(*app, "SCENE", view_.scene, "What to open: .glb .gltf .obj .off .ply .stl");
    app->add_option("--theme", view_.theme, "dark or light")->check(CLI::IsMember({"dark", "light"}));
    app->add_option("--graphics", view_.graphics,
                    "What draws: card or processor (default auto: the card, if there is one)")
        ->check(CLI::IsMember({"auto", "card", "processor"}));
    app->add_flag("--commands", view_.takes_commands,
                  "Run commands from standard input, a JSON object a line, and answer each on standard output");
    add_plugin(*app, view_.plugin);
  }

  void add_set(CLI::App& app) {
    app.add_option("--set", set_, "Set a parameter; \"cagewright params\" lists them")
        ->type_name("ID=VALUE")
        ->allow_extra_args(false)
        ->check([](const std::string& text) -> std::string {
          return text.find('=') == 0 || text.find('=') == text.npos ? "needs ID=VALUE, not " + in_quotes(text) : "";
        });
  }

  static void add_threads(CLI::App& app, std::uint32_t& threads) {
    app.add_option("--threads", threads, "0 (default): as many as the machine has")->check(CLI::Range(0, 4096));
  }

  template <class Path>
  static CLI::Option* add_file(CLI::App& app, const char* name, Path& path, const char* meaning) {
    return app.add_option(name, path, meaning)->type_name("FILE");
  }

  void add_picture() {
    CLI::Option* picture =
        add_file(*cage_app_, "--picture", cage_.picture, "Model, slides and cage, PNG; needs a display");
    cage_app_->add_option("--picture-up", picture_.up, "What is up in the picture (default 0,1,0)")
        ->type_name("X,Y,Z")
        ->needs(picture);
    cage_app_->add_option("--picture-from", picture_.from, "Direction from the model to the viewer")
        ->type_name("X,Y,Z")
        ->needs(picture);
    cage_app_->add_option("--picture-size", picture_.size, "In pixels (default 1280x800)")
        ->type_name("WxH")
        ->needs(picture);
  }

  void add_check() {
    check_app_ = app_.add_subcommand("check", "Judge any cage of a model");
    add_file(*check_app_, "MODEL", check_.model, "Mesh: .glb .gltf .obj .off .ply .stl")->required();
    add_file(*check_app_, "CAGE", check_.cage, "Its cage, in any of these formats")->required();
    add_file(*check_app_, "--report", check_.report, "The figures, JSON");
    check_app_->add_flag("--quiet", check_.quiet, "No notes on stderr, only errors");
    add_plugin(*check_app_, check_.plugin);
  }

  void add_params() {
    params_app_ = app_.add_subcommand("params", "List the plug-in's parameters");
    params_app_->add_flag("--json", params_.as_json, "As JSON");
    add_plugin(*params_app_, params_.plugin);
  }

  void add_strip() {
    strip_app_ = app_.add_subcommand("strip", "Take slides and cages out of a scene");
    add_file(*strip_app_, "SCENE", strip_.scene, "A scene: .glb .gltf")->required();
    add_file(*strip_app_, "-o,--out", strip_.out, "The scene without them; may be SCENE itself")->required();
    strip_app_->add_flag("--quiet", strip_.quiet, "No notes on stderr, only errors");
  }

  static void add_plugin(CLI::App& app, OptionalPath& plugin) {
    add_file(app, "--plugin", plugin,
             "The plug-in; otherwise $CAGEWRIGHT_PLUGIN, or the one installed with this program");
  }

  CageCommand cage() {
    struct ShortForm {
      const char *option, *id;
      const std::optional<std::string>& value;
    };
    for (const ShortForm& form : {ShortForm{"--delta", "refine.delta", delta_},
                                  {"--lambda", "orient.lambda", lambda_},
                                  {"--iterations", "refine.iterations", iterations_}}) {
      if (form.value) cage_.settings.push_back({form.id, *form.value, form.option + (" " + *form.value)});
    }
    append_settings(cage_);
    cage_.picture_options = to_options(picture_);
    return cage_;
  }

  ScriptCommandLine script(bool has_subcommand) {
    if (has_subcommand) throw UsageError("--command FILE is all that is run: leave out the subcommand");
    script_.script = *script_file_;
    return script_;
  }

  ValidateCommand validate() {
    append_settings(validate_.cage);
    return validate_;
  }

  void append_settings(CageCommand& command) const {
    for (const std::string& text : set_) {
      const std::size_t equals = text.find('=');
      command.settings.push_back({text.substr(0, equals), text.substr(equals + 1), "--set " + text});
    }
  }

  CLI::App app_;
  CLI::App *cage_app_ = nullptr, *check_app_ = nullptr, *params_app_ = nullptr, *strip_app_ = nullptr,
           *validate_app_ = nullptr;
  ViewCommand view_;
  CageCommand cage_;
  PictureArguments picture_;
  CheckCommand check_;
  ParamsCommand params_;
  StripCommand strip_;
  ValidateCommand validate_;
  ScriptCommandLine script_;
  OptionalPath script_file_;
  std::optional<std::string> delta_, lambda_, iterations_;
  std::vector<std::string> set_;
};

}  // namespace

Invocation parse_command_line(int argc, const char* const* argv) { return CommandLine().parse(argc, argv); }

}  // namespace cagewright::host
