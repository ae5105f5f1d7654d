// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_PROBLEMS_LIST_H
#define CAGEWRIGHT_HOST_APP_PROBLEMS_LIST_H

#include <QListWidget>
#include <functional>
#include <optional>

#include "host/app/editor.h"

namespace cagewright::host {

// What is wrong with the cage, a sentence each. A click, or a key that goes to another, selects the slides at
// fault and asks for their place to be framed and marked; the mark is there as long as the problem is, or until another
// is chosen.
class ProblemsList : public QListWidget {
 public:
  ProblemsList(Editor& editor, QWidget* parent);

  void on_frame(std::function<void(const Problem&)> frame) { frame_ = std::move(frame); }
  // By a click or Enter, not by a key that goes on to the next one.
  void on_choose(std::function<void(const std::string& sentence)> choose) { choose_ = std::move(choose); }
  void on_mark(std::function<void(const std::optional<Point3>&)> mark) { mark_ = std::move(mark); }
  void on_count(std::function<void(int)> count) { count_ = std::move(count); }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void fill();
  void show_problem(int row);
  void mark(const std::optional<Problem>& problem);

  Editor& editor_;
  std::optional<Problem> marked_;
  std::function<void(const Problem&)> frame_;
  std::function<void(const std::optional<Point3>&)> mark_;
  std::function<void(const std::string&)> choose_;
  std::function<void(int)> count_;
};

}  // namespace cagewright::host

#endif
