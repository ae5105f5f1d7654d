// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_COMMAND_PORT_H
#define CAGEWRIGHT_HOST_APP_COMMAND_PORT_H

#include <QSocketNotifier>
#include <nlohmann/json.hpp>
#include <string>

#include "host/app/main_window.h"

namespace cagewright::host {

// Runs commands that come on standard input while the window is open, a JSON object a line, and answers each with one
// on standard output: {"ok": true, ...} or {"ok": false, "error": "..."}. To those of scripts it adds what a program
// that steers the window has to know:
//   {"command": "where", "point": [x, y, z]}    a point of the mesh, as a position on the screen
//   {"command": "where", "widget": "outliner"}  a widget, by its object name or its text: its rectangle on the screen,
//                                              what is written on it and, of a list or tree, the rows that are seen
//   {"command": "where", "handle": 0}           a handle of the selected slides
//   {"command": "record", "path": "session.jsonl"}   records what is done; without a path: no longer
//   {"command": "state"}                        what is open, selected, wrong and being done, and which menu
//                                              entries have a mark
// The end of standard input closes nothing.
class CommandPort : public QObject {
 public:
  explicit CommandPort(MainWindow& window);

 private:
  void read();
  void answer(const std::string& line);
  nlohmann::json run(const nlohmann::json& command);
  nlohmann::json where(const nlohmann::json& command) const;
  Point3 handle(const nlohmann::json& number) const;
  nlohmann::json state() const;

  MainWindow& window_;
  QSocketNotifier notifier_;
  std::string pending_;
};

}  // namespace cagewright::host

#endif
