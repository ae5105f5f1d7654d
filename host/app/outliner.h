// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_OUTLINER_H
#define CAGEWRIGHT_HOST_APP_OUTLINER_H

#include <QTreeWidget>
#include <map>

#include "host/app/editor.h"

namespace cagewright::host {

// The scene's nodes as a tree, slides and cages under the meshes that they are of. A click selects slides, a double
// click on a mesh chooses it as the one to cage, F2 renames a slide. What was folded up stays so while the scene is
// open.
class Outliner : public QTreeWidget {
 public:
  Outliner(Editor& editor, QWidget* parent);
  // Begins, where the slide of that id is in the tree.
  void edit_name(std::int64_t slide);

 protected:
  // A row's name, whichever column is meant.
  bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;

 private:
  void update(WorkspaceChange change);
  using Key = std::pair<int, std::int64_t>;  // of an item: its type and id
  static Key key_of(const QTreeWidgetItem& item);
  void fill();        // as a new scene
  void fill_again();  // folded, scrolled and with the keys where it was
  void add_nodes(std::map<int, QTreeWidgetItem*>& items);
  void add_slides(const std::map<int, QTreeWidgetItem*>& items);
  void add_cages(const std::map<int, QTreeWidgetItem*>& items);
  QTreeWidgetItem* add(QTreeWidgetItem* parent, const QString& name, const QString& kind, int type);
  void show_selection();
  void show_problems();
  void show_cage();
  void take_selection();
  void rename(QTreeWidgetItem* item);

  Editor& editor_;
  std::map<std::int64_t, QTreeWidgetItem*> slides_;
  QTreeWidgetItem* live_cage_ = nullptr;  // that follows the slides; null: there is none
  bool is_filling_ = false;
};

}  // namespace cagewright::host

#endif
