// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_OUTLINER_H
#define CAGEWRIGHT_HOST_APP_OUTLINER_H

#include <QTreeWidget>
#include <map>

#include "host/app/editor.h"

namespace cagewright::host {

// The scene's nodes as a tree, slides and cages under the meshes that they are of. A click selects slides, a double
// click on a mesh chooses it as the one to cage, F2 renames a slide.
class Outliner : public QTreeWidget {
 public:
  Outliner(Editor& editor, QWidget* parent);

 private:
  void update(WorkspaceChange change);
  void fill();
  void add_nodes(std::map<int, QTreeWidgetItem*>& items);
  void add_slides(const std::map<int, QTreeWidgetItem*>& items);
  void add_cages(const std::map<int, QTreeWidgetItem*>& items);
  QTreeWidgetItem* add(QTreeWidgetItem* parent, const QString& name, const QString& kind, int type);
  void show_selection();
  void show_problems();
  void take_selection();
  void rename(QTreeWidgetItem* item);

  Editor& editor_;
  std::map<std::int64_t, QTreeWidgetItem*> slides_;
  bool is_filling_ = false;
};

}  // namespace cagewright::host

#endif
