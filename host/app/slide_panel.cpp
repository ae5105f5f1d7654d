// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/slide_panel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <limits>

#include "host/app/field_edit.h"
#include "host/app/number_field.h"
#include "host/file/file_error.h"
#include "host/workspace/find_problem.h"

namespace cagewright::host {

SlidePanel::SlidePanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor) {
  setObjectName("slide");
  auto* form = new QFormLayout(this);
  form->setRowWrapPolicy(QFormLayout::WrapAllRows);  // three numbers beside one another need the room
  form->setVerticalSpacing(3);
  name_ = new FieldEdit(this);
  name_->setObjectName("slide_name");
  name_->setToolTip("The slide's name: files, reports and sentences about it use it.");
  connect(name_, &QLineEdit::editingFinished, this, [this] { rename(); });
  name_->on_give_up([this] { show_slide(); });
  form->addRow("Name", name_);
  add_numbers(*form, "Centre", "slide_centre", "Centre of the ellipse, in the mesh node's space.", translate_.data(),
              3);
  add_numbers(*form, "Rotation", "slide_rotation",
              "Degrees about x, then y, then z: from the x-y plane to the slide's.", rotate_.data(), 3);
  add_numbers(*form, "Radii", "slide_radii", "Of the ellipse, along its u and v.", radii_.data(), 2);
  for (NumberField* radius : radii_)
    radius->set_range(std::numeric_limits<double>::min(), std::numeric_limits<double>::max(), false);
  state_ = new QLabel(this);
  state_->setObjectName("slide_state");
  state_->setWordWrap(true);
  form->addRow(state_);
  editor_.listen_seldom([this](WorkspaceChange change) {
    if (change != WorkspaceChange::progress) show_slide();
  });
  show_slide();
}

void SlidePanel::add_numbers(QFormLayout& form, const QString& label, const QString& name, const QString& tip,
                             NumberField** first, int count) {
  auto* row = new QHBoxLayout;
  row->setSpacing(3);
  for (int i = 0; i < count; ++i) {
    auto* field = new NumberField(this);
    field->setObjectName(QString("%1_%2").arg(name).arg(i));
    field->setAccessibleName(QString("%1 %2").arg(label).arg(i + 1));
    field->setToolTip(tip);
    field->on_edit([this](double) { take_numbers(); });
    field->on_refusal([this](const std::string& sentence) { editor_.refuse_typed(sentence); });
    first[i] = field;
    row->addWidget(field);
  }
  form.addRow(label, row);
}

const SceneSlide* SlidePanel::slide() const {
  const Workspace& workspace = editor_.workspace();
  return workspace.has_scene() && !workspace.selection().empty()
             ? workspace.document().find_slide(workspace.selection().back())
             : nullptr;
}

void SlidePanel::show_slide() {
  const SceneSlide* shown = slide();
  setEnabled(shown != nullptr);
  if (!shown) {
    name_->clear();
    for (NumberField* field : findChildren<NumberField*>()) field->clear();
    state_->setText("Select a slide to see its numbers.");
    return;
  }
  const QString name = QString::fromStdString(shown->name);
  if (name_->text() != name && !(name_->isModified() && name_->hasFocus())) name_->setText(name);
  Slide::Ellipse ellipse = shown->ellipse;
  for (const PreviewSlide& preview : editor_.workspace().preview())
    if (preview.id == shown->id) ellipse = preview.ellipse;
  const SlidePlacement placement = placement_of(ellipse);
  for (std::size_t i = 0; i < 3; ++i) {
    translate_[i]->show(placement.translate[i]);
    rotate_[i]->show(placement.rotate[i]);
  }
  radii_[0]->show(placement.radius_u);
  radii_[1]->show(placement.radius_v);
  QString state = shown->stroke.empty() ? "" : QString("Fitted to a stroke of %1 points.").arg(shown->stroke.size());
  if (const Problem* problem = find_problem_or_advice(editor_.workspace().cage(), shown->id))
    state = QString::fromStdString(problem->sentence);
  state_->setText(state);
}

void SlidePanel::rename() {
  if (!name_->isModified()) return;
  const SceneSlide* shown = slide();
  const std::string name = name_->text().toStdString();
  name_->setModified(false);
  if (!shown || shown->name == name) return;
  if (!editor_.run_typed({{"command", "rename_slide"}, {"slide", shown->name}, {"name", name}})) show_slide();
}

void SlidePanel::take_numbers() {
  const SceneSlide* shown = slide();
  if (!shown) return;
  SlidePlacement placement;
  for (std::size_t i = 0; i < 3; ++i) {
    placement.translate[i] = translate_[i]->value();
    placement.rotate[i] = rotate_[i]->value();
  }
  placement.radius_u = radii_[0]->value();
  placement.radius_v = radii_[1]->value();
  // A negative one would turn the ellipse.
  for (const double radius : {placement.radius_u, placement.radius_v})
    if (!(radius > 0)) {
      editor_.refuse_typed("slide " + in_quotes(shown->name) + ": a radius has to be above 0, not " +
                           QLocale::c().toString(radius).toStdString());
      return show_slide();
    }
  const Slide::Ellipse ellipse = ellipse_of(placement);
  const nlohmann::json change = {{"name", shown->name}, {"center", ellipse.center}, {"u", ellipse.u}, {"v", ellipse.v}};
  if (!editor_.run_typed({{"command", "change_slides"}, {"slides", nlohmann::json::array({change})}})) show_slide();
}

}  // namespace cagewright::host
