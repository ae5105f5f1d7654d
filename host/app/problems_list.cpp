// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/problems_list.h"

#include <QKeyEvent>
#include <QStyle>
#include <algorithm>
#include <array>

namespace cagewright::host {
namespace {

bool is_same(const Problem& a, const Problem& b) {
  return a.sentence == b.sentence && a.slides == b.slides && a.place == b.place;
}

}  // namespace

ProblemsList::ProblemsList(Editor& editor, QWidget* parent) : QListWidget(parent), editor_(editor) {
  setObjectName("problems");
  setAccessibleName("Problems");
  setWordWrap(true);
  setAlternatingRowColors(true);
  const auto choose = [this](QListWidgetItem* item) {
    const std::string sentence = item->text().toStdString();  // what is shown may make another cage
    show_problem(row(item));
    if (choose_) choose_(sentence);
  };
  connect(this, &QListWidget::itemClicked, this, choose);
  connect(this, &QListWidget::itemActivated, this, choose);
  editor_.listen_seldom([this](WorkspaceChange change) {
    if (change == WorkspaceChange::cage || change == WorkspaceChange::scene || change == WorkspaceChange::mesh) fill();
  });
}

void ProblemsList::fill() {
  const std::vector<Problem>& problems = editor_.workspace().cage().problems;
  clear();
  for (const Problem& problem : problems) {
    auto* item = new QListWidgetItem(QString::fromStdString(problem.sentence), this);
    item->setIcon(
        style()->standardIcon(problem.is_advice ? QStyle::SP_MessageBoxInformation : QStyle::SP_MessageBoxWarning));
    item->setToolTip("Click to see the place: " + item->text());
    if (marked_ && is_same(problem, *marked_)) setCurrentItem(item);
  }
  if (marked_ && std::ranges::none_of(problems, [this](const Problem& it) { return is_same(it, *marked_); })) mark({});
  if (count_) count_(static_cast<int>(problems.size()));
}

void ProblemsList::show_problem(int row) {
  const std::vector<Problem>& problems = editor_.workspace().cage().problems;
  if (row < 0 || row >= static_cast<int>(problems.size())) return;
  const Problem problem = problems[static_cast<std::size_t>(row)];
  if (!problem.slides.empty()) {
    nlohmann::json names = nlohmann::json::array();
    for (const std::int64_t id : problem.slides)
      if (const SceneSlide* slide = editor_.workspace().document().find_slide(id)) names.push_back(slide->name);
    editor_.run({{"command", "select"}, {"slides", names}});
  }
  mark(problem);
  if (frame_) frame_(problem);
}

// A key that leads nowhere, as down in a list of one, shows where one is.
void ProblemsList::keyPressEvent(QKeyEvent* event) {
  const int before = currentRow();
  QListWidget::keyPressEvent(event);
  constexpr std::array leading = {Qt::Key_Up,  Qt::Key_Down,   Qt::Key_Home,
                                  Qt::Key_End, Qt::Key_PageUp, Qt::Key_PageDown};
  if (currentRow() != before || std::ranges::find(leading, event->key()) != leading.end()) show_problem(currentRow());
}

void ProblemsList::mark(const std::optional<Problem>& problem) {
  marked_ = problem;
  if (mark_) mark_(problem ? problem->place : std::nullopt);
}

}  // namespace cagewright::host
