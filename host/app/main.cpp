// SPDX-License-Identifier: BSD-3-Clause
// The window, `cagewright view [SCENE]`: a program of its own, so that the command line needs no Qt.
#include <QVTKOpenGLNativeWidget.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QSettings>
#include <QStatusBar>
#include <QSurfaceFormat>
#include <clocale>
#include <exception>
#include <functional>
#include <iostream>
#include <optional>
#include <string>

#include "host/app/command_port.h"
#include "host/app/main_window.h"
#include "host/plugin_client/find_plugin.h"
#include "host/plugin_client/plugin_error.h"
#include "host/view/picture.h"

namespace {

using namespace cagewright::host;

constexpr int exit_usage = 2, exit_bad_input = 3, exit_internal = 4;

struct Arguments {
  std::optional<std::string> scene, plugin, theme;
  std::string graphics = "auto";
  bool takes_commands = false;
};

// What an event's handler throws is said in the window, which goes on: Qt would end the process.
class Application : public QApplication {
 public:
  using QApplication::QApplication;
  void on_failure(std::function<void(const std::string&)> tell) { tell_ = std::move(tell); }
  bool notify(QObject* receiver, QEvent* event) override {
    try {
      return QApplication::notify(receiver, event);
    } catch (const std::exception& error) {
      if (tell_) tell_(error.what());
      return false;
    }
  }

 private:
  std::function<void(const std::string&)> tell_;
};

int say(int code, const std::string& sentence) {
  std::cerr << "cagewright: " << sentence << "\n";
  return code;
}

std::shared_ptr<const Plugin> load_plugin(const Arguments& arguments, std::string& failure) {
  try {
    return Plugin::load(
        find_plugin(arguments.plugin ? std::optional<std::filesystem::path>(*arguments.plugin) : std::nullopt));
  } catch (const PluginLoadError& error) {
    failure = error.what();
    return nullptr;
  }
}

Graphics graphics_of(const std::string& name) {
  if (name == "card") return Graphics::card;
  return name == "processor" ? Graphics::processor : Graphics::automatic;
}

int show_window(int argc, char** argv, const Arguments& arguments) {
  std::string failure;
  auto plugin = load_plugin(arguments, failure);
  if (!plugin && arguments.plugin) return say(exit_bad_input, failure);
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  format.setAlphaBufferSize(0);  // nothing shines through the window
  QSurfaceFormat::setDefaultFormat(format);
  Application application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's, and numbers in sentences would get commas
  QCoreApplication::setOrganizationName("cagewright");
  QCoreApplication::setApplicationName("cagewright");
  QCoreApplication::setApplicationVersion(CAGEWRIGHT_VERSION);
  MainWindow window(std::move(plugin), graphics_of(arguments.graphics));
  window.set_dark(arguments.theme ? *arguments.theme == "dark" : QSettings().value("dark", true).toBool());
  window.set_z_up(QSettings().value("z_up", false).toBool());
  application.on_failure([&window](const std::string& sentence) { window.say_failure(sentence); });
  window.restore_layout();
  window.show();
  std::optional<CommandPort> port;
  if (arguments.takes_commands) port.emplace(window);
  if (arguments.scene) {
    window.open(*arguments.scene);
    // The window stays, so that another can be chosen.
    const std::string why = window.statusBar()->currentMessage().toStdString();  // empty: a question was cancelled
    if (!window.editor().workspace().has_scene() && !why.empty()) say(0, why);
  }
  const int code = QApplication::exec();
  application.on_failure({});
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Draws cut slides on a model; the cage follows.", "cagewright view");
  Arguments arguments;
  app.add_option("SCENE", arguments.scene, "a scene or model: .glb .gltf .obj .off .ply .stl");
  app.add_option("--plugin", arguments.plugin, "the plug-in to use");
  app.add_option("--theme", arguments.theme, "dark or light")->check(CLI::IsMember({"dark", "light"}));
  app.add_option("--graphics", arguments.graphics, "what draws: the graphics card or the processor")
      ->check(CLI::IsMember({"auto", "card", "processor"}));
  app.add_flag("--commands", arguments.takes_commands,
               "runs commands from standard input, a JSON object a line, and answers each on standard output");
  try {
    app.parse(argc, argv);
    require_display();
    return show_window(argc, argv, arguments);
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app.exit(error) : say(exit_usage, std::string(error.what()) + "; see --help");
  } catch (const PictureError& error) {
    return say(exit_bad_input, error.what());
  } catch (const std::exception& error) {
    return say(exit_internal, std::string("internal error: ") + error.what());
  }
}
