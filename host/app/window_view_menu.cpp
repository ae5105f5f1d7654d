// SPDX-License-Identifier: BSD-3-Clause
// The view menu. Its marks are what the view shows, also where a script has changed that.
#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

#include "host/app/main_window.h"
#include "host/app/view_widget.h"

namespace cagewright::host {

using nlohmann::json;

// A mark of the menu: what it runs when it is set or taken away, and whether it holds now. Those of a group are
// exclusive.
void MainWindow::add_mark(QMenu& menu, const Item& item, QActionGroup* group, const std::function<json(bool)>& command,
                          const std::function<bool()>& holds) {
  QAction* action = add_check(menu, item, holds());
  if (group) group->addAction(action);
  if (group) for_scene_.push_back(action);  // of the model's surface
  marks_.push_back([action, holds] { action->setChecked(holds()); });
  connect(action, &QAction::triggered, this, [this, command](bool on) {
    editor_->run(command(on));
    show_marks();  // as they were, where that has failed
  });
}

void MainWindow::show_marks() {
  for (const auto& show : marks_) show();
}

void MainWindow::make_view_menu() {
  QMenu& menu = *menuBar()->addMenu("&View");
  add_command(menu, "frame_selection", "Frame &Selection", "F", "Brings the selected slides into view",
              {{"command", "frame"}, {"what", "selection"}});
  add_command(menu, "frame_all", "Frame &All", "A", "Brings everything into view",
              {{"command", "frame"}, {"what", "all"}});
  add_command(menu, "frame_model", "Frame Model", "Shift+A",
              "Brings the model that is being caged into view, however far away slides and cage reach",
              {{"command", "frame"}, {"what", "model"}});
  QMenu& look = *menu.addMenu("&Look");
  const char* axes[] = {"perspective", "front", "back", "left", "right", "top", "bottom"};
  for (int i = 0; i < 7; ++i)
    add_command(look, axes[i], QString("&%1 %2").arg(i).arg(axes[i]).toUtf8().constData(),
                QString("Alt+%1").arg(i).toUtf8().constData(),
                QString("Looks from there: %1").arg(axes[i]).toUtf8().constData(),
                {{"command", "look"}, {"axis", axes[i]}});
  add_mark(
      menu, {"orthographic", "&Orthographic", "O", "Without perspective", [] {}}, nullptr,
      [](bool on) {
        return json{{"command", "projection"}, {"orthographic", on}};
      },
      [this] { return view_->camera().is_orthographic(); });
  add_mark(
      menu, {"z_up", "&Z Up", "", "The model stands along z, not y: grid, camera and exported pictures", [] {}},
      nullptr,
      [](bool on) {
        return json{{"command", "up"}, {"axis", on ? "z" : "y"}};
      },
      [this] { return view_->scene().options().z_up; });
  connect(findChild<QAction*>("z_up"), &QAction::triggered, this, [](bool on) { QSettings().setValue("z_up", on); });
  menu.addSeparator();
  add_look_marks(menu);
  menu.addSeparator();
  add_show_marks(menu);
  QMenu& panels = *menu.addMenu("Pa&nels");
  for (QDockWidget* dock : findChildren<QDockWidget*>()) panels.addAction(dock->toggleViewAction());
  panels.addSeparator();
  add(panels, {"reset_panels", "&Reset Panels", "", "Every panel where it was at first", [this] { reset_panels(); }});
  menu.addSeparator();
  QAction* dark = add_check(menu, {"dark", "Dar&k Theme", "", "Dark or light colours", [] {}}, true);
  connect(dark, &QAction::triggered, this, [this](bool on) {  // not where set_dark sets it
    set_dark(on);
    QSettings().setValue("dark", on);
  });
  view_->on_look([this] { show_marks(); });
}

void MainWindow::add_look_marks(QMenu& menu) {
  const auto look = [this]() -> const ViewOptions& { return view_->scene().options(); };
  auto* surface = new QActionGroup(this);
  const auto add_surface = [&](const Item& item, bool is_wireframe) {
    add_mark(
        menu, item, surface,
        [is_wireframe](bool) {
          return json{{"command", "show"}, {"what", "wireframe"}, {"on", is_wireframe}};
        },
        [look, is_wireframe] { return look().wireframe == is_wireframe; });
  };
  add_surface({"wireframe", "&Wireframe", "4", "The model's edges", [] {}}, true);
  add_surface({"shaded", "S&haded", "5", "The model's surface", [] {}}, false);
  auto* colours = new QActionGroup(this);
  const auto add_colours = [&](const Item& item, const std::string& by, ViewOptions::Colours value) {
    add_mark(
        menu, item, colours,
        [by](bool) {
          return json{{"command", "colours"}, {"by", by}};
        },
        [look, value] { return look().colours == value; });
  };
  using Colours = ViewOptions::Colours;
  add_colours({"colours_plain", "&Plain Colour", "6", "The model in one colour", [] {}}, "plain", Colours::plain);
  add_colours({"colours_parts", "Colour Pa&rts", "7", "Each part of the model in a colour of its own", [] {}}, "parts",
              Colours::parts);
  add_colours({"colours_coverage", "Colour &Coverage", "8", "What pokes out of the cage is red", [] {}}, "coverage",
              Colours::coverage);
}

void MainWindow::add_show_marks(QMenu& menu) {
  const auto add_show = [&](const char* name, const char* text, const char* tip, const std::string& what,
                            const std::function<bool()>& holds) {
    add_mark(
        menu, {name, text, "", tip, [] {}}, nullptr,
        [what](bool on) {
          return json{{"command", "show"}, {"what", what}, {"on", on}};
        },
        holds);
  };
  const struct {
    const char *name, *text, *what;
    bool ViewOptions::*is_shown;
  } parts[] = {{"show_model", "Show &Model", "model", &ViewOptions::model},
               {"show_slides", "Show Sli&des", "slides", &ViewOptions::slides},
               {"show_sections", "Show Sec&tions", "sections", &ViewOptions::sections},
               {"show_cage", "Show Ca&ge", "cage", &ViewOptions::cage},
               {"show_cage_faces", "Show Cage &Faces", "cage_faces", &ViewOptions::cage_faces},
               {"show_grid", "Show Gr&id", "grid", &ViewOptions::grid}};
  for (const auto& part : parts)
    add_show(part.name, part.text, "Whether it is drawn", part.what,
             [this, is_shown = part.is_shown] { return view_->scene().options().*is_shown; });
  add_show("show_other_meshes", "Show Other Meshes", "Whether the meshes that are not being caged are drawn",
           "other_meshes", [this] { return view_->scene().options().other_meshes; });
  add_show("show_speed", "Show Sp&eed", "How many cages a second follow a drag, and how long one takes", "speed",
           [this] { return view_->shows_speed(); });
}

}  // namespace cagewright::host
