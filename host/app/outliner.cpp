// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/outliner.h"

#include <QHeaderView>
#include <QScrollBar>
#include <QStyle>
#include <QTreeWidgetItemIterator>
#include <set>
#include <utility>

#include "host/workspace/find_problem.h"

namespace cagewright::host {
namespace {

constexpr int node_item = QTreeWidgetItem::UserType, mesh_item = node_item + 1, slide_item = node_item + 2,
              cage_item = node_item + 3;
constexpr int id_role = Qt::UserRole;  // a slide's id or a mesh's node

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

// Of the cage that follows the slides.
QString kind_of_cage(const Workspace& workspace) {
  const CageState& cage = workspace.cage();
  const bool is_solving = workspace.progress().is_solving;
  if (cage.cage.triangles.empty()) return is_solving ? "being made" : cage.failed ? "none: see Problems" : "none yet";
  if (cage.failed) return "cage, last good";
  if (cage.is_of_now || !workspace.preview().empty()) return "cage, live";
  return is_solving ? "cage, being made" : "cage, outdated";
}

QStyle::StandardPixmap mark_of(const Problem& problem) {
  return problem.is_advice ? QStyle::SP_MessageBoxInformation : QStyle::SP_MessageBoxWarning;
}

}  // namespace

Outliner::Outliner(Editor& editor, QWidget* parent) : QTreeWidget(parent), editor_(editor) {
  setObjectName("outliner");
  setAccessibleName("Outliner");
  setColumnCount(2);
  setHeaderLabels({"Node", "Kind"});
  header()->setStretchLastSection(false);
  // As wide as the deepest name: what is wider than the panel can be scrolled to.
  header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  setUniformRowHeights(true);
  connect(this, &QTreeWidget::itemSelectionChanged, this, [this] { take_selection(); });
  connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int) { rename(item); });
  connect(this, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item, int) {
    if (item->type() == mesh_item) editor_.run({{"command", "select_mesh"}, {"node", item->data(0, id_role).toInt()}});
  });
  editor_.listen_seldom([this](WorkspaceChange change) { update(change); });
}

void Outliner::update(WorkspaceChange change) {
  switch (change) {
    case WorkspaceChange::scene:
      fill();
      break;
    case WorkspaceChange::mesh:
    case WorkspaceChange::slides:
    case WorkspaceChange::plugin:
      if (editor_.workspace().preview().empty()) fill_again();
      break;
    case WorkspaceChange::selection:
      show_selection();
      for (QTreeWidgetItem* item : selectedItems())
        if (visualItemRect(item).isValid()) scrollToItem(item);  // not within a branch that is folded up
      break;
    case WorkspaceChange::progress:
      show_cage();
      break;
    case WorkspaceChange::cage:
      show_problems();
      break;
    default:
      break;
  }
}

QTreeWidgetItem* Outliner::add(QTreeWidgetItem* parent, const QString& name, const QString& kind, int type) {
  auto* item = new QTreeWidgetItem(type);
  item->setText(0, name);
  item->setText(1, kind);
  item->setToolTip(0, name);
  parent ? parent->addChild(item) : addTopLevelItem(item);
  return item;
}

void Outliner::fill() {
  is_filling_ = true;
  clear();
  slides_.clear();
  live_cage_ = nullptr;
  if (editor_.workspace().has_scene()) {
    std::map<int, QTreeWidgetItem*> items;
    add_nodes(items);
    add_slides(items);
    add_cages(items);
    expandAll();
  }
  is_filling_ = false;
  show_selection();
  show_problems();
}

Outliner::Key Outliner::key_of(const QTreeWidgetItem& item) {
  return {item.type(), item.data(0, id_role).toLongLong()};
}

void Outliner::fill_again() {
  std::set<Key> folded;
  for (QTreeWidgetItemIterator it(this); *it; ++it)
    if ((*it)->childCount() > 0 && !(*it)->isExpanded()) folded.insert(key_of(**it));
  const Key current = currentItem() ? key_of(*currentItem()) : Key();
  const int across = horizontalScrollBar()->value(), down = verticalScrollBar()->value();
  fill();
  for (QTreeWidgetItemIterator it(this); *it; ++it) {
    const Key key = key_of(**it);
    if (folded.contains(key)) (*it)->setExpanded(false);
    if (key == current) selectionModel()->setCurrentIndex(indexFromItem(*it), QItemSelectionModel::NoUpdate);
  }
  executeDelayedItemsLayout();  // else the scroll bars have no range yet
  horizontalScrollBar()->setValue(across);
  verticalScrollBar()->setValue(down);
}

void Outliner::add_nodes(std::map<int, QTreeWidgetItem*>& items) {
  const Workspace& workspace = editor_.workspace();
  const std::vector<SceneNode> nodes = workspace.document().nodes();
  std::vector<const SceneNode*> waiting;
  for (const SceneNode& node : nodes)
    if (node.index >= 0) waiting.push_back(&node);
  // Parents may come after their children.
  for (bool any = true; any && !waiting.empty();) {
    any = false;
    std::vector<const SceneNode*> later;
    for (const SceneNode* node : waiting) {
      const auto parent = items.find(node->parent);
      if (node->parent >= 0 && parent == items.end()) {
        later.push_back(node);
        continue;
      }
      any = true;
      const bool is_mesh = node->kind == SceneNode::Kind::mesh;
      const QString name = node->name.empty() ? QString("node %1").arg(node->index) : text(node->name);
      QTreeWidgetItem* item = add(node->parent >= 0 ? parent->second : nullptr, name, is_mesh ? "mesh" : "",
                                  is_mesh ? mesh_item : node_item);
      item->setData(0, id_role, node->index);
      if (is_mesh && node->index == workspace.mesh_node()) {
        QFont bold = item->font(0);
        bold.setBold(true);
        item->setFont(0, bold);
        item->setText(1, "mesh, being caged");
      } else if (is_mesh) {
        item->setToolTip(0, name + ": double-click to make this mesh the one to cage");
      }
      items[node->index] = item;
    }
    waiting = std::move(later);
  }
}

void Outliner::add_slides(const std::map<int, QTreeWidgetItem*>& items) {
  for (const SceneSlide& slide : editor_.workspace().document().slides()) {
    const auto parent = items.find(slide.mesh_node);
    QTreeWidgetItem* item =
        add(parent == items.end() ? nullptr : parent->second, text(slide.name), "slide", slide_item);
    item->setData(0, id_role, QVariant::fromValue<qlonglong>(slide.id));
    if (slide.mesh_node == editor_.workspace().mesh_node())
      item->setFlags(item->flags() | Qt::ItemIsEditable);
    else
      item->setFlags(item->flags() & ~Qt::ItemIsSelectable);
    slides_[slide.id] = item;
  }
}

void Outliner::add_cages(const std::map<int, QTreeWidgetItem*>& items) {
  const Workspace& workspace = editor_.workspace();
  for (const auto& [node, parent] : items) {
    if (parent->type() != mesh_item) continue;
    const SceneCage* stored = workspace.document().find_cage(node);
    const bool is_live = node == workspace.mesh_node() && workspace.plugin();
    if (!stored && !is_live) continue;
    const QString name = stored && !stored->name.empty() ? text(stored->name) : "cage";
    QTreeWidgetItem* item = add(parent, name, "cage", cage_item);
    item->setData(0, id_role, node);
    if (is_live) live_cage_ = item;
  }
}

void Outliner::show_selection() {
  is_filling_ = true;
  clearSelection();
  for (const std::int64_t id : editor_.workspace().selection())
    if (const auto found = slides_.find(id); found != slides_.end()) found->second->setSelected(true);
  is_filling_ = false;
}

void Outliner::show_problems() {
  is_filling_ = true;
  const CageState& cage = editor_.workspace().cage();
  for (const auto& [id, item] : slides_) {
    const Problem* found = find_problem_or_advice(cage, id);
    // Without a colour of its own it has the theme's, also after a change of that.
    item->setData(0, Qt::ForegroundRole, found && cage.failed ? QBrush(QColor(0xff, 0x6b, 0x5e)) : QVariant());
    // A selected one has the selection's colours: the mark is seen there, too.
    item->setIcon(0, found ? style()->standardIcon(mark_of(*found)) : QIcon());
    item->setToolTip(0, found ? text(found->sentence) : item->text(0));
  }
  is_filling_ = false;
  show_cage();
}

void Outliner::show_cage() {
  if (!live_cage_) return;
  const bool was_filling = std::exchange(is_filling_, true);
  const QString kind = kind_of_cage(editor_.workspace());
  if (live_cage_->text(1) != kind) live_cage_->setText(1, kind);
  is_filling_ = was_filling;
}

void Outliner::take_selection() {
  if (is_filling_) return;
  nlohmann::json names = nlohmann::json::array();
  for (const QTreeWidgetItem* item : selectedItems())
    if (item->type() == slide_item) names.push_back(item->text(0).toStdString());
  editor_.run({{"command", "select"}, {"slides", names}});
}

void Outliner::edit_name(std::int64_t slide) {
  const auto found = slides_.find(slide);
  if (found == slides_.end()) return;
  setFocus();
  scrollToItem(found->second);  // unfolds what it is in
  selectionModel()->setCurrentIndex(indexFromItem(found->second), QItemSelectionModel::NoUpdate);
  editItem(found->second, 0);
}

bool Outliner::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
  return QTreeWidget::edit(index.sibling(index.row(), 0), trigger, event);
}

void Outliner::rename(QTreeWidgetItem* item) {
  if (is_filling_ || item->type() != slide_item) return;
  const SceneSlide* slide = editor_.workspace().document().find_slide(item->data(0, id_role).toLongLong());
  if (!slide || slide->name == item->text(0).toStdString()) return;
  if (!editor_.run({{"command", "rename_slide"}, {"slide", slide->name}, {"name", item->text(0).toStdString()}}))
    fill();
}

}  // namespace cagewright::host
