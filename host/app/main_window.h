// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_MAIN_WINDOW_H
#define CAGEWRIGHT_HOST_APP_MAIN_WINDOW_H

#include <QDeadlineTimer>
#include <QMainWindow>
#include <QPointer>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/app/autosave.h"
#include "host/app/canvas.h"
#include "host/app/editor.h"
#include "host/app/script_recorder.h"

class QAction;
class QActionGroup;
class QDockWidget;
class QLabel;
class QMenu;
class QMessageBox;
class QProgressBar;
class QPushButton;
class QTabWidget;

namespace cagewright::host {

class ParameterPanel;
class PluginManager;
class ProblemsList;
class ViewWidget;

// The window: view in the middle, tree on the left, attributes, report and problems on the right. Its menus run the
// commands of ScriptRunner.
class MainWindow : public QMainWindow {
 public:
  // `plugin` may be null.
  MainWindow(std::shared_ptr<const Plugin> plugin, Graphics graphics);
  ~MainWindow() override;

  Editor& editor() { return *editor_; }
  ViewWidget& view() { return *view_; }
  // Asks about unsaved changes, and whether an autosave is to be recovered.
  void open(const std::filesystem::path& path);
  void set_dark(bool dark);
  void set_z_up(bool z_up);
  void restore_layout();  // size and panels of when the window was last closed; before it is shown
  // In the status line. A failure's sentence goes when the next thing succeeds, or after a while.
  void say_failure(const std::string& sentence);
  void say_warning(const std::string& sentence);  // of no attempt: it stays for its time
  void say_done(const std::string& sentence);
  // Into that file; empty: stops.
  void record(const std::filesystem::path& path);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Item {        // of a menu
    const char* name;  // object name, for tests and styles
    const char* text;
    const char* keys;  // empty: none; several divided by ", "
    const char* tip;
    std::function<void()> run;
  };
  QAction* add(QMenu& menu, const Item& item);
  QAction* add_check(QMenu& menu, const Item& item, bool on);
  QAction* add_command(QMenu& menu, const char* name, const char* text, const char* keys, const char* tip,
                       const nlohmann::json& command);
  QAction* add_for_selection(QMenu& menu, const char* name, const char* text, const char* keys, const char* tip,
                             const nlohmann::json& command);
  void add_mark(QMenu& menu, const Item& item, QActionGroup* group, const std::function<nlohmann::json(bool)>& command,
                const std::function<bool()>& holds);
  void show_marks();
  void make_docks();
  bool is_small() const;  // too small for panels on both sides
  // Whether the panels are tabs on the left, so that the view has the room; they go back to where they were, and are
  // as high as they were, but what was shown or hidden meanwhile stays so.
  void set_narrow(bool narrow);
  void forget_border();              // that the pointer is on, before panels are moved
  void show_tab(QDockWidget* dock);  // of a narrow window, in front of the others
  // Panels and tool bar, by their object names.
  QStringList shown_panels() const;
  void show_panels(const QStringList& shown);
  void show_panel(const QString& name);
  void rename_slide();
  void reset_panels();
  void save_layout() const;
  void show_parameter_of(const std::string& sentence);
  void share_heights();  // of the panels above one another
  void share_first_heights();
  void make_menus();
  void make_file_menu();
  void make_edit_menu();
  void make_slide_menu();
  void make_view_menu();
  void add_look_marks(QMenu& menu);
  void add_show_marks(QMenu& menu);
  void make_cage_menu();
  void make_help_menu();
  void make_status_line();
  void make_tool_bar();

  void update(WorkspaceChange change);
  void finish_command(const nlohmann::json& command, const nlohmann::json& said);
  // What the status line says, by what makes it go before its time.
  enum class Said {
    other,    // nothing does
    failure,  // the next attempt that succeeds
    refusal,  // of what was typed: what is typed and taken
    slide,    // of one that was added: the next command
  };
  void say(const std::string& sentence, int milliseconds, Said of, bool is_wrong = false);
  void say_wrong(const std::string& sentence, Said of);
  void clear_said(Said of);
  void follow_status();                           // what the status line shows has changed
  void say_refusal(const std::string& sentence);  // empty: something that was typed was taken
  void show_title();
  void show_undo();
  void show_progress();
  void show_hint();
  void show_failure_colour(bool is_failure);  // of the status line's message

  bool may_lose_changes();
  struct Left {                                 // of a scene that is opened: what was not saved
    std::optional<std::filesystem::path> file;  // nothing: there is none
    bool recovers = false;
  };
  // Of what is claimed, `opened` itself or a model that is saved as `scene`: about another machine's lock, which it may
  // remove, and what was not saved. Nothing, here and below: it is not to be opened at all.
  std::optional<Left> ask_before_opening(const std::filesystem::path& opened, const std::filesystem::path& scene);
  std::optional<bool> ask_to_remove_lock(const QString& before);  // a sentence that goes before; may be empty
  std::optional<bool> ask_to_recover(const std::filesystem::path& left, const std::filesystem::path& opened,
                                     const std::filesystem::path& scene);
  void show_not_opened(const QString& sentence);
  void choose_file();
  void finish_typing();
  bool wait_for_cage();
  QString why_not_done(const nlohmann::json& command);
  bool write(const nlohmann::json& command, const QString& failure);
  bool save_to(const std::filesystem::path& path);
  // To write to; empty: given up. With the chosen filter's first ending where none was typed.
  QString choose_name(const QString& title, const std::filesystem::path& suggested, const QString& filters);
  void note_file();                                            // the open scene has just been read or written
  bool save_over_another(const std::filesystem::path& scene);  // asks first
  bool save();
  bool save_as();
  void export_cage();
  void export_picture();
  void export_turntable();
  void draw_turntable(const std::filesystem::path& folder, int frames);
  void remember(const std::filesystem::path& path);
  void fill_recent();
  void mirror_slides(const QString& axis);
  void set_mirror_axis(const QString& axis);
  void copy_slides();
  void paste_slides();
  void record_script();
  void run_script();
  struct ScriptLine {
    int number = 0;
    std::string text;
  };
  void run_lines(const std::vector<ScriptLine>& lines, const QString& name);
  // False: it was cancelled before it ran. Throws what the command throws.
  bool run_line(const std::string& line, const std::function<bool()>& is_cancelled);
  void validate();
  void show_shortcuts();
  void show_first_help();
  void finish_first_run();

  std::unique_ptr<Editor> editor_;
  std::unique_ptr<ScriptRecorder> recorder_;
  ViewWidget* view_ = nullptr;
  ProblemsList* problems_ = nullptr;
  ParameterPanel* parameters_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  PluginManager* plugins_ = nullptr;
  Autosave* autosave_ = nullptr;
  std::optional<std::filesystem::file_time_type> on_disk_;  // of the open scene's file, when it was read or written
  struct {
    QString sentence;  // empty: nothing, or its time is over
    QDeadlineTimer until;
    Said of = Said::other;
    bool is_wrong = false;
  } said_;
  QPointer<QMessageBox> not_opened_;  // says why a file could not be opened
  bool is_narrow_ = false;
  QByteArray first_docks_;       // saveState() of a wide window, as it is made
  QByteArray wide_docks_;        // saveState() of when it was last wide
  bool was_never_wide_ = false;  // and nobody has made the panels as high as they are there
  QLabel *hint_ = nullptr, *stage_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QMenu* recent_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr, *record_ = nullptr, *mirror_ = nullptr;
  QString mirror_axis_;                              // chosen last in this scene: "x", "y" or "z"
  std::vector<std::function<void()>> marks_;         // of menus: each sets one as the view is
  std::vector<QAction*> for_scene_, for_selection_;  // enabled only then
  QActionGroup* tools_ = nullptr;
};

}  // namespace cagewright::host

#endif
