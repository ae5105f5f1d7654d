// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/main_window.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QStatusBar>
#include <QToolBar>
#include <QUrl>
#include <algorithm>

#include "host/app/done_text.h"
#include "host/app/plugin_manager.h"
#include "host/app/theme.h"
#include "host/app/view_widget.h"
#include "host/workspace/slide_names.h"

namespace cagewright::host {
namespace {

// The next step where the cage, and not the tool, decides it; empty: the tool does.
QString step_to_a_cage(const Workspace& workspace) {
  const CageState& cage = workspace.cage();
  if (workspace.mesh_node() < 0) return "No node of this scene has a mesh: File > Open opens another one.";
  // What is being drawn or dragged may mend it.
  if (!workspace.preview().empty()) return {};
  if (cage.failed) {
    const auto names_slides = [](const Problem& problem) { return !problem.slides.empty(); };
    return std::ranges::any_of(cage.problems, names_slides)
               ? "These slides give no cage: click the sentence under Problems to see where. Ctrl+Z takes the last "
                 "step back."
               : "This model gives no cage: the sentence under Problems says why; a click on it shows the place.";
  }
  if (cage.is_of_now || workspace.progress().is_solving) return {};
  return "The cage was stopped before it was made: G makes it, and so does any change.";
}

constexpr int failure_ms = 12000, done_ms = 6000;  // how long the status line shows one

}  // namespace

MainWindow::MainWindow(std::shared_ptr<const Plugin> plugin, Graphics graphics) {
  setObjectName("main_window");
  setAcceptDrops(true);
  resize(QSize(1400, 900).boundedTo(QGuiApplication::primaryScreen()->availableSize()));
  // The solver's thread wakes the window's by an event.
  editor_ = std::make_unique<Editor>(
      std::move(plugin),
      [this] {
        QMetaObject::invokeMethod(
            this, [this] { editor_->workspace().poll(); }, Qt::QueuedConnection);
      },
      [this](const nlohmann::json& command) { view_->run(command); });
  editor_->on_failure([this](const std::string& sentence) { say_failure(sentence); });
  editor_->on_refusal([this](const std::string& sentence) { say_refusal(sentence); });
  editor_->on_done(
      [this](const nlohmann::json& command, const nlohmann::json& said) { finish_command(command, said); });
  recorder_ = std::make_unique<ScriptRecorder>(*editor_, [this](const std::string& sentence) {
    record_->setChecked(false);
    say_warning(sentence);  // no failure: what was being recorded has been done
  });
  autosave_ = new Autosave(*editor_, this);
  bool is_given = false;
  if (const int delay = qEnvironmentVariableIntValue("CAGEWRIGHT_AUTOSAVE_MS", &is_given); is_given)
    autosave_->set_delay(delay);
  autosave_->on_failure([this](const std::string& sentence) { say_warning(sentence); });
  autosave_->on_lock([this] { show_title(); });
  view_ = new ViewWidget(*editor_, graphics, this);
  setCentralWidget(view_);
  make_docks();
  make_menus();
  make_tool_bar();
  make_status_line();
  view_->on_hint([this] {
    show_hint();
    show_first_help();
  });
  editor_->listen([this](WorkspaceChange change) { update(change); });
  for (const WorkspaceChange change : {WorkspaceChange::scene, WorkspaceChange::progress}) update(change);
  view_->setFocus();
}

MainWindow::~MainWindow() {
  // Widgets listen to the editor; the view's renderer has to go while the window is there.
  delete takeCentralWidget();
}

void MainWindow::make_status_line() {
  hint_ = new QLabel(this);
  hint_->setObjectName("hint");
  statusBar()->setObjectName("status_bar");
  statusBar()->addWidget(hint_, 1);
  connect(statusBar(), &QStatusBar::messageChanged, this, [this] { follow_status(); });
  stage_ = new QLabel(this);
  stage_->setObjectName("stage");
  progress_ = new QProgressBar(this);
  progress_->setObjectName("progress");
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedWidth(160);
  cancel_ = new QPushButton("Cancel", this);
  cancel_->setObjectName("cancel");
  cancel_->setToolTip("Stops the making of the cage; the last good one stays. (Esc)");
  connect(cancel_, &QPushButton::clicked, this, [this] { editor_->run({{"command", "cancel"}}); });
  for (QWidget* widget :
       {static_cast<QWidget*>(stage_), static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_)})
    statusBar()->addPermanentWidget(widget);
}

void MainWindow::update(WorkspaceChange change) {
  switch (change) {
    case WorkspaceChange::scene:
      if (not_opened_) not_opened_->close();
      note_file();
      set_mirror_axis("x");  // what was right for the model before says nothing about this one
      show_first_help();
      show_title();
      show_undo();
      break;
    case WorkspaceChange::progress:
    case WorkspaceChange::cage:
      show_progress();
      break;
    case WorkspaceChange::saved:
      show_title();
      break;
    case WorkspaceChange::slides:
      if (!editor_->workspace().preview().empty()) return;
      finish_first_run();
      [[fallthrough]];
    case WorkspaceChange::parameters:
      show_title();
      show_undo();
      break;
    case WorkspaceChange::selection:
      show_undo();
      break;
    case WorkspaceChange::mesh:
      show_title();
      show_undo();
      [[fallthrough]];
    case WorkspaceChange::plugin:
      editor_->workspace().prepare_to_fit();
      break;
  }
  show_hint();
}

void MainWindow::show_title() {
  const Workspace& workspace = editor_->workspace();
  if (!workspace.has_scene()) return setWindowTitle("Cagewright");
  setWindowTitle(QString("%1%2[*] - Cagewright")
                     .arg(QString::fromStdString(workspace.path().filename().string()),
                          autosave_->is_open_elsewhere() ? " (open in another window, too)" : ""));
  setWindowModified(!workspace.is_saved());
}

void MainWindow::show_undo() {
  const Workspace& workspace = editor_->workspace();
  const bool has_scene = workspace.has_scene();
  const auto show = [&](QAction* action, const QString& word, const std::string& label) {
    action->setText(label.empty() ? word : QString("%1 %2").arg(word, QString::fromStdString(without_echo(label))));
    action->setEnabled(!label.empty());
  };
  show(undo_, "&Undo", has_scene ? workspace.stack().undo_label() : "");
  show(redo_, "&Redo", has_scene ? workspace.stack().redo_label() : "");
  for (QAction* action : for_scene_) action->setEnabled(has_scene);
  for (QAction* action : for_selection_) action->setEnabled(has_scene && !workspace.selection().empty());
}

void MainWindow::show_progress() {
  const SolveProgress progress = editor_->workspace().progress();
  // A cage that follows the mouse is there before one has read of its progress.
  const bool is_shown = progress.is_solving && editor_->workspace().preview().empty();
  for (QWidget* widget :
       {static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_), static_cast<QWidget*>(stage_)})
    widget->setVisible(is_shown);
  if (!is_shown) return;
  progress_->setValue(static_cast<int>(1000 * progress.fraction));
  stage_->setText(QString::fromStdString(progress.stage));
}

void MainWindow::show_hint() {
  const Workspace& workspace = editor_->workspace();
  if (!hint_) return;
  if (!workspace.has_scene())
    return hint_->setText("Open a model or scene: File > Open, or drop a file on the window.");
  if (!workspace.plugin()) return hint_->setText("No plug-in is loaded: File > Plug-ins loads one.");
  const QString step = step_to_a_cage(workspace);
  hint_->setText(step.isEmpty() ? view_->hint() : step);
}

void MainWindow::say(const std::string& sentence, int milliseconds, Said of, bool is_wrong) {
  said_ = {QString::fromStdString(without_echo(sentence)), QDeadlineTimer(milliseconds), of, is_wrong};
  statusBar()->showMessage(said_.sentence, milliseconds);
  follow_status();
}

// Nothing where something else was said since.
void MainWindow::clear_said(Said of) {
  if (said_.of != of) return;
  said_ = {};
  statusBar()->clearMessage();
}

// A tool tip takes what was said away; when it is gone, that is shown again for the rest of its time.
void MainWindow::follow_status() {
  const QString shown = statusBar()->currentMessage();
  show_failure_colour(said_.is_wrong && shown == said_.sentence);
  if (!shown.isEmpty() || said_.sentence.isEmpty()) return;
  if (said_.until.remainingTime() < 50) {  // it was shown to its end
    said_ = {};
    return;
  }
  QTimer::singleShot(0, this, [this] {
    if (!said_.sentence.isEmpty() && statusBar()->currentMessage().isEmpty())
      statusBar()->showMessage(said_.sentence, std::max(1, static_cast<int>(said_.until.remainingTime())));
  });
}

void MainWindow::say_failure(const std::string& sentence) { say_wrong(sentence, Said::failure); }

void MainWindow::say_warning(const std::string& sentence) { say_wrong(sentence, Said::other); }

void MainWindow::say_refusal(const std::string& sentence) {
  if (sentence.empty()) return clear_said(Said::refusal);
  say_wrong(sentence, Said::refusal);
}

void MainWindow::say_wrong(const std::string& sentence, Said of) {
  say(sentence, failure_ms, of, true);
  QApplication::beep();
}

void MainWindow::show_failure_colour(bool is_failure) {
  QPalette palette;
  if (is_failure) palette.setColor(QPalette::WindowText, colour_of(Tone::bad, palette));
  statusBar()->setPalette(palette);
  stage_->setPalette(is_failure ? QApplication::palette() : QPalette());  // which stands beside it
}

void MainWindow::say_done(const std::string& sentence) { say(sentence, done_ms, Said::other); }

void MainWindow::finish_command(const nlohmann::json& command, const nlohmann::json& said) {
  clear_said(Said::failure);
  if (command.is_null()) return;
  clear_said(Said::slide);
  const std::string name = command.value("command", "");
  if (name == "save") note_file();
  const std::string sentence = done_text(command, said, editor_->workspace());
  if (!sentence.empty()) say(sentence, done_ms, name == "add_slide" ? Said::slide : Said::other);
}

void MainWindow::set_dark(bool dark) {
  apply_theme(*qApp, dark);
  view_->set_dark(dark);
  if (auto* action = findChild<QAction*>("dark")) action->setChecked(dark);
}

void MainWindow::set_z_up(bool z_up) { view_->run({{"command", "up"}, {"axis", z_up ? "z" : "y"}}); }

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_lose_changes()) return event->ignore();
  recorder_->stop();
  autosave_->discard();
  save_layout();
  event->accept();
}

// Of an action that is disabled: the others' keys do not come here.
void MainWindow::keyPressEvent(QKeyEvent* event) {
  const QKeySequence keys(static_cast<int>(event->modifiers()) | event->key());
  const auto has_keys = [&](const QAction* action) { return action->shortcuts().contains(keys); };
  const bool is_for_selection = std::ranges::any_of(for_selection_, has_keys);
  if (is_for_selection && editor_->workspace().has_scene() && editor_->workspace().selection().empty())
    return say_failure("Select a slide first: click one in the view or the outliner; Ctrl+A selects all");
  QMainWindow::keyPressEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

// Opened when the drop is over: whoever dropped it does not wait for questions.
void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  const QList<QUrl> urls = event->mimeData()->urls();
  const QString file = urls.size() == 1 ? urls.first().toLocalFile() : QString();
  if (!QFileInfo(file).isFile()) return say_failure("Drop one file: a scene or a model.");
  QTimer::singleShot(0, this, [this, file] { open(file.toStdString()); });
}

}  // namespace cagewright::host
