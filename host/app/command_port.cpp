// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/command_port.h"

#include <unistd.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QStatusBar>
#include <algorithm>
#include <array>
#include <exception>
#include <iostream>

#include "host/app/view_widget.h"

namespace cagewright::host {
namespace {

using nlohmann::json;

QWidget* find_widget(const QString& name) {
  for (QWidget* widget : QApplication::allWidgets()) {
    if (!widget->isVisible()) continue;
    const auto* button = qobject_cast<QAbstractButton*>(widget);
    if (widget->objectName() == name || (button && button->text().remove('&') == name)) return widget;
  }
  return nullptr;
}

json position(const QPoint& at) { return {{"x", at.x()}, {"y", at.y()}}; }

json names(const Workspace& workspace, const std::vector<std::int64_t>& ids) {
  json all = json::array();
  for (const std::int64_t id : ids)
    if (const SceneSlide* slide = workspace.document().find_slide(id)) all.push_back(slide->name);
  return all;
}

// Those that are seen: their texts, and the middle of each on the screen.
json rows_of(const QAbstractItemView& view) {
  json rows = json::array();
  const int inside = 2;
  QModelIndex row = view.indexAt(QPoint(inside, inside));
  while (row.isValid()) {
    json texts = json::array();
    for (int column = 0; column < view.model()->columnCount(row.parent()); ++column)
      texts.push_back(row.sibling(row.row(), column).data().toString().toStdString());
    const QRect at = view.visualRect(row);
    rows.push_back(position(view.viewport()->mapToGlobal(at.center())));
    rows.back()["texts"] = std::move(texts);
    row = view.indexAt(QPoint(inside, at.bottom() + inside));
  }
  return rows;
}

Point3 point_of(const json& command) {
  const json& point = command["point"];
  if (!point.is_array() || point.size() != 3 ||
      !std::all_of(point.begin(), point.end(), [](const json& it) { return it.is_number(); }))
    throw ScriptError("where: \"point\" has to be [x, y, z]");
  return point.get<Point3>();
}

// Of a line; what the JSON library says of it is not for people.
json parse_command(const std::string& line) {
  json command = json::parse(line, nullptr, false);
  if (!command.is_object() || !command.contains("command") || !command["command"].is_string())
    throw ScriptError("a command is a JSON object on one line, {\"command\": \"state\"}");
  return command;
}

}  // namespace

CommandPort::CommandPort(MainWindow& window)
    : QObject(&window), window_(window), notifier_(STDIN_FILENO, QSocketNotifier::Read) {
  connect(&notifier_, &QSocketNotifier::activated, this, [this] { read(); });
}

void CommandPort::read() {
  std::array<char, 65536> bytes;
  const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  if (count <= 0) return notifier_.setEnabled(false);
  pending_.append(bytes.data(), static_cast<std::size_t>(count));
  for (std::size_t end; (end = pending_.find('\n')) != std::string::npos;) {
    const std::string line = pending_.substr(0, end);
    pending_.erase(0, end + 1);
    if (line.find_first_not_of(" \t\r") != std::string::npos) answer(line);
  }
}

void CommandPort::answer(const std::string& line) {
  json reply = {{"ok", true}};
  try {
    reply.update(run(parse_command(line)));
  } catch (const std::exception& error) {
    reply = {{"ok", false}, {"error", error.what()}};
  }
  std::cout << reply.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
}

json CommandPort::run(const json& command) {
  const std::string name = command.value("command", "");
  if (name == "where") return where(command);
  if (name == "state") return state();
  if (name == "record") {
    const json path = command.value("path", json(""));
    if (!path.is_string()) throw ScriptError("record: \"path\" has to be text");
    window_.record(path.get<std::string>());
    return json::object();
  }
  const json result = window_.editor().run_or_throw(command);
  return result.is_object() ? result : json{{"result", result}};
}

json CommandPort::where(const json& command) const {
  if (command.contains("point")) return position(window_.view().screen_position(point_of(command)));
  if (command.contains("handle")) return position(window_.view().screen_position(handle(command["handle"])));
  if (!command.contains("widget") || !command["widget"].is_string())
    throw ScriptError("where: needs \"point\", [x, y, z], \"handle\", a number, or \"widget\", a name");
  const auto name = QString::fromStdString(command["widget"].get<std::string>());
  const QWidget* widget = find_widget(name);
  if (!widget) throw ScriptError("where: no such widget is there: " + name.toStdString());
  json place = position(widget->mapToGlobal(QPoint(0, 0)));
  place["width"] = widget->width();
  place["height"] = widget->height();
  for (const char* property : {"plainText", "text", "title", "windowTitle"})
    if (const QVariant text = widget->property(property); text.isValid() && !text.toString().isEmpty()) {
      place["text"] = text.toString().toStdString();
      break;
    }
  if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) place["rows"] = rows_of(*view);
  return place;
}

Point3 CommandPort::handle(const json& number) const {
  const std::vector<Point3> places = window_.view().handles().places();
  if (!number.is_number_unsigned() || number.get<std::size_t>() >= places.size())
    throw ScriptError("where: there is no handle " + number.dump() +
                      (places.empty() ? ": select a slide and take the tool move, turn or scale"
                                      : ": they are numbered from 0 to " + std::to_string(places.size() - 1)));
  return places[number.get<std::size_t>()];
}

json CommandPort::state() const {
  const Workspace& workspace = window_.editor().workspace();
  QString title = window_.windowTitle();
  title.replace("[*]", window_.isWindowModified() ? "*" : "");
  json all = {{"title", title.toStdString()},
              {"focus", QApplication::focusWidget() ? QApplication::focusWidget()->objectName().toStdString() : ""},
              {"status", window_.statusBar()->currentMessage().toStdString()},
              {"solving", workspace.progress().is_solving},
              {"has_scene", workspace.has_scene()}};
  json marks = json::array(), disabled = json::array();
  for (const QAction* action : window_.findChildren<QAction*>()) {
    if (action->objectName().isEmpty()) continue;
    if (action->isChecked()) marks.push_back(action->objectName().toStdString());
    if (!action->isEnabled()) disabled.push_back(action->objectName().toStdString());
  }
  all["marks"] = std::move(marks);
  all["disabled"] = std::move(disabled);
  if (!workspace.has_scene()) return all;
  const CageState& cage = workspace.cage();
  all["mesh"] = workspace.mesh_node();
  all["saved"] = workspace.is_saved();
  all["selection"] = names(workspace, workspace.selection());
  json slides = json::array(), problems = json::array();
  for (const SceneSlide* slide : workspace.slides())
    slides.push_back(
        {{"name", slide->name}, {"center", slide->ellipse.center}, {"u", slide->ellipse.u}, {"v", slide->ellipse.v}});
  for (const Problem& problem : cage.problems)
    problems.push_back({{"sentence", problem.sentence},
                        {"slides", names(workspace, problem.slides)},
                        {"is_advice", problem.is_advice}});
  all["slides"] = slides;
  all["problems"] = problems;
  all["undo"] = workspace.stack().undo_label();
  all["redo"] = workspace.stack().redo_label();
  all["cage"] = {{"triangles", cage.cage.triangle_count()},
                 {"is_of_now", cage.is_of_now},
                 {"is_of_editing", cage.is_of_editing},
                 {"failed", cage.failed},
                 {"certified", cage.certificate && cage.certificate->encloses}};
  const SpeedMeter::Figures speed = window_.view().speed().figures();
  all["speed"] = {{"cages", speed.cages},
                  {"per_second", speed.cages_per_second},
                  {"median_ms", speed.median_ms},
                  {"percentile_95_ms", speed.percentile_95_ms},
                  {"frame_ms", speed.frame_ms}};
  return all;
}

}  // namespace cagewright::host
