// SPDX-License-Identifier: BSD-3-Clause
// The menus, tool bar and shortcuts of the window: what each says and which command it runs.
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QTextBrowser>
#include <QToolBar>
#include <QVBoxLayout>

#include "host/app/main_window.h"
#include "host/app/plugin_manager.h"
#include "host/app/view_widget.h"

namespace cagewright::host {

using nlohmann::json;

QAction* MainWindow::add(QMenu& menu, const Item& item) {
  QAction* action = menu.addAction(item.text);
  action->setObjectName(item.name);
  action->setShortcuts(QKeySequence::listFromString(QString(item.keys).replace(", ", "; ")));
  const QString keys = action->shortcut().toString();
  action->setToolTip(keys.isEmpty() ? QString(item.tip) : QString("%1 (%2)").arg(item.tip, keys));
  action->setStatusTip(item.tip);
  connect(action, &QAction::triggered, this, [run = item.run] { run(); });
  return action;
}

QAction* MainWindow::add_check(QMenu& menu, const Item& item, bool on) {
  QAction* action = add(menu, item);
  action->setCheckable(true);
  action->setChecked(on);
  return action;
}

QAction* MainWindow::add_command(QMenu& menu, const char* name, const char* text, const char* keys, const char* tip,
                                 const json& command) {
  QAction* action = add(menu, {name, text, keys, tip, [this, command] { editor_->run(command); }});
  for_scene_.push_back(action);
  return action;
}

QAction* MainWindow::add_for_selection(QMenu& menu, const char* name, const char* text, const char* keys,
                                       const char* tip, const json& command) {
  QAction* action = add(menu, {name, text, keys, tip, [this, command] {
                                 json with_slides = command;
                                 with_slides["slides"] = editor_->selected_names();
                                 editor_->run(with_slides);
                               }});
  for_selection_.push_back(action);
  return action;
}

void MainWindow::make_menus() {
  plugins_ = new PluginManager(*editor_, this);
  tools_ = new QActionGroup(this);
  make_file_menu();
  make_edit_menu();
  make_slide_menu();
  make_view_menu();
  make_cage_menu();
  make_help_menu();
  for (QMenu* menu : menuBar()->findChildren<QMenu*>()) menu->setToolTipsVisible(true);
}

void MainWindow::make_file_menu() {
  QMenu& menu = *menuBar()->addMenu("&File");
  add(menu, {"open", "&Open ...", "Ctrl+O", "Opens a scene (.glb, .gltf) or a model (.obj, .off, .ply, .stl)",
             [this] { choose_file(); }});
  recent_ = menu.addMenu("Open &Recent");
  recent_->setObjectName("recent");
  connect(recent_, &QMenu::aboutToShow, this, [this] { fill_recent(); });
  const auto for_scene = [&](const Item& item) { for_scene_.push_back(add(menu, item)); };
  for_scene({"save", "&Save", "Ctrl+S", "Saves the scene with its slides and cage", [this] { save(); }});
  for_scene(
      {"save_as", "Save &As ...", "Ctrl+Shift+S", "Saves the scene as another .glb or .gltf", [this] { save_as(); }});
  for_scene({"close_scene", "&Close Scene", "Ctrl+W", "Closes the scene", [this] {
               if (may_lose_changes()) editor_->run({{"command", "close"}});
             }});
  menu.addSeparator();
  for_scene({"export_cage", "&Export Cage ...", "Ctrl+E", "Writes the cage alone", [this] { export_cage(); }});
  for_scene({"export_picture", "Export &Picture ...", "", "Writes a picture of model, slides and cage",
             [this] { export_picture(); }});
  for_scene({"export_turntable", "Export &Turntable ...", "", "Writes the frames of one turn as pictures",
             [this] { export_turntable(); }});
  menu.addSeparator();
  record_ = add_check(menu,
                      {"record_script", "Recor&d Script ...", "",
                       "Writes every command into a file that "
                       "`cagewright --command` replays",
                       [this] { record_script(); }},
                      false);
  add(menu, {"run_script", "R&un Script ...", "", "Runs the commands of a file", [this] { run_script(); }});
  menu.addSeparator();
  add(menu, {"plugins", "Plu&g-ins ...", "", "Which plug-in makes the cages", [this] { plugins_->show(); }});
  menu.addSeparator();
  add(menu, {"quit", "&Quit", "Ctrl+Q", "Ends the program", [this] { close(); }});
}

void MainWindow::make_edit_menu() {
  QMenu& menu = *menuBar()->addMenu("&Edit");
  undo_ = add(menu, {"undo", "&Undo", "Ctrl+Z, Z", "Takes the last step back", [this] {
                       if (!view_->cancel_tool()) editor_->run({{"command", "undo"}});
                     }});
  redo_ = add(menu, {"redo", "&Redo", "Ctrl+Shift+Z, Ctrl+Y, Shift+Z", "Does again what was taken back", [this] {
                       editor_->run({{"command", "redo"}});
                     }});
  menu.addSeparator();
  for_selection_.push_back(add(menu, {"copy", "&Copy Slides", "Ctrl+C",
                                      "Copies the selected slides, also for another "
                                      "scene",
                                      [this] { copy_slides(); }}));
  for_scene_.push_back(
      add(menu, {"paste", "&Paste Slides", "Ctrl+V", "Adds the slides that were copied, here or in another window",
                 [this] { paste_slides(); }}));
  add_for_selection(menu, "duplicate", "&Duplicate Slides", "Ctrl+D", "Adds a copy of each selected slide beside it",
                    {{"command", "duplicate_slides"}});
  for_selection_.push_back(add(
      menu, {"rename", "Re&name Slide", "F2", "Types another name in the outliner, of the slide that was selected last",
             [this] { rename_slide(); }}));
  add_for_selection(menu, "delete", "De&lete Slides", "Del, Backspace", "Removes the selected slides",
                    {{"command", "remove_slides"}});
  menu.addSeparator();
  for_scene_.push_back(
      add(menu, {"select_all", "Select &All Slides", "Ctrl+A", "Selects every slide of the mesh", [this] {
                   json names = json::array();
                   for (const SceneSlide* slide : editor_->workspace().slides()) names.push_back(slide->name);
                   editor_->run({{"command", "select"}, {"slides", names}});
                 }}));
  add_command(menu, "select_none", "Select &None", "Ctrl+Shift+A", "Selects nothing",
              {{"command", "select"}, {"slides", json::array()}});
}

void MainWindow::make_slide_menu() {
  QMenu& menu = *menuBar()->addMenu("&Slides");
  using Mode = SlideHandles::Mode;
  const auto tool = [&](const Item& item) {
    QAction* action = add_check(menu, item, false);
    tools_->addAction(action);
    return action;
  };
  tool({"tool_select", "&Select", "Q", "Selects slides; what is beside them turns the view",
        [this] { view_->use_select_tool(Mode::none); }})
      ->setChecked(true);
  tool({"tool_draw", "&Draw Slides", "D", "A stroke across a limb, or a click on it, becomes a cut slide",
        [this] { view_->use_stroke_tool(); }});
  tool({"tool_move", "&Move", "W", "Handles that move the selected slides",
        [this] { view_->use_select_tool(Mode::move); }});
  tool({"tool_turn", "&Turn", "E", "Handles that turn the selected slides",
        [this] { view_->use_select_tool(Mode::turn); }});
  tool({"tool_scale", "S&cale", "R", "Handles that scale the selected slides",
        [this] { view_->use_select_tool(Mode::scale); }});
  menu.addSeparator();
  QAction* complete = add_check(menu,
                                {"complete_stroke", "C&omplete Stroke", "",
                                 "On: a short stroke is enough, the loop "
                                 "of its plane is found. Off: the ellipse is fitted to the stroke alone, and Shift "
                                 "adds to the selected slide's",
                                 [] {}},
                                true);
  connect(complete, &QAction::toggled, this, [this](bool on) {
    view_->stroke_tool().set_complete(on);
    show_hint();
  });
  menu.addSeparator();
  add_for_selection(menu, "snap", "S&nap to Loop", "N", "Each selected slide becomes the ellipse of its plane's loop",
                    {{"command", "snap_slides"}});
  mirror_ = add(menu, {"mirror", "M&irror", "M", "", [this] { mirror_slides(mirror_axis_); }});
  for_selection_.push_back(mirror_);
  QMenu& across = *menu.addMenu("Mirror &Across");
  auto* axes = new QActionGroup(this);
  for (const char* axis : {"x", "y", "z"}) {
    QAction* action =
        add_check(across,
                  {axis, axis, "", "Adds a copy of each selected slide on the other side of the mesh's middle",
                   [this, axis] { mirror_slides(axis); }},
                  false);
    action->setObjectName(QString("mirror_") + axis);
    action->setText(QString("&") + axis);
    axes->addAction(action);
    for_selection_.push_back(action);
  }
  set_mirror_axis("x");
}

void MainWindow::mirror_slides(const QString& axis) {
  set_mirror_axis(axis);
  editor_->run({{"command", "mirror_slides"}, {"axis", axis.toStdString()}, {"slides", editor_->selected_names()}});
}

// The key and the button do what was chosen last.
void MainWindow::set_mirror_axis(const QString& axis) {
  mirror_axis_ = axis;
  findChild<QAction*>("mirror_" + axis)->setChecked(true);
  mirror_->setText(QString("M&irror Across %1").arg(axis));
  const QString tip =
      QString("Adds a copy of each selected slide on the other side of the mesh's middle, across %1").arg(axis);
  mirror_->setStatusTip(tip);
  mirror_->setToolTip(tip + "; another plane: Slides > Mirror Across (M)");
}

void MainWindow::make_cage_menu() {
  QMenu& menu = *menuBar()->addMenu("&Cage");
  add_command(menu, "solve", "&Make Cage Again", "G", "Makes the whole cage with its certificate",
              {{"command", "solve"}});
  QAction* cancel = add(
      menu, {"cancel_solve", "&Cancel", "Esc", "Gives up the stroke or drag, or stops the making of the cage", [this] {
               if (!view_->cancel_tool() && editor_->workspace().progress().is_solving)
                 editor_->run({{"command", "cancel"}});
             }});
  for_scene_.push_back(cancel);
  view_->cancel_drag_by({undo_, cancel});
  menu.addSeparator();
  for_scene_.push_back(add(menu, {"validate", "&Validate with Ceres ...", "",
                                  "An independent optimiser checks the "
                                  "refinement and looks for a tighter cage",
                                  [this] { validate(); }}));
}

void MainWindow::make_help_menu() {
  QMenu& menu = *menuBar()->addMenu("&Help");
  add(menu, {"shortcuts", "&Keys and Mouse", "F1", "All keys, and what the mouse does", [this] { show_shortcuts(); }});
  add(menu, {"about", "&About Cagewright", "", "Version and licence", [this] {
               QMessageBox::about(
                   this, "About Cagewright",
                   QString("<b>Cagewright %1</b><p>Cages for mesh deformation from cut slides.<br>Le and "
                           "Deng, <i>Interactive Cage Generation for Mesh Deformation</i>, I3D 2017.</p>"
                           "<p>BSD 3-clause licence.</p>")
                       .arg(QApplication::applicationVersion()));
             }});
}

void MainWindow::make_tool_bar() {
  QToolBar* bar = addToolBar("Tools");
  bar->setObjectName("tool_bar");
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  // Its arrows are dark in every theme.
  if (auto* overflow = bar->findChild<QWidget*>("qt_toolbar_ext_button"))
    overflow->setStyleSheet("background: #a6a8ae; border-radius: 3px;");
  bar->addActions(tools_->actions());
  bar->addSeparator();
  for (const char* name : {"snap", "mirror", "frame_all", "colours_plain", "colours_parts", "colours_coverage"})
    if (auto* action = findChild<QAction*>(name)) bar->addAction(action);
}

void MainWindow::show_shortcuts() {
  QString rows;
  for (const QAction* action : findChildren<QAction*>())
    if (!action->shortcuts().isEmpty() && !action->objectName().isEmpty())
      rows += QString("<tr><td>%1&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>")
                  .arg(QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText).toHtmlEscaped(),
                       action->statusTip().toHtmlEscaped());
  QDialog box(this);
  box.setObjectName("keys");
  box.setWindowTitle("Keys and mouse");
  box.resize(620, 640);
  auto* text = new QTextBrowser(&box);
  text->setHtml(
      "<p>Alt + left, middle, right mouse: tumble, track, dolly. Without Alt: middle tracks, right tumbles, the "
      "wheel goes nearer; left belongs to the tool, and turns the view where there is nothing for it.</p>"
      "<table>" +
      rows + "</table>");
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, &box);
  connect(buttons, &QDialogButtonBox::rejected, &box, &QDialog::reject);
  auto* column = new QVBoxLayout(&box);
  column->addWidget(text);
  column->addWidget(buttons);
  box.exec();
}

}  // namespace cagewright::host
