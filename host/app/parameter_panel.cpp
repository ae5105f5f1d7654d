// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/parameter_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "host/app/number_field.h"

namespace cagewright::host {
namespace {

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

// "refine" of "refine.delta".
std::string group_of(const std::string& id) { return id.substr(0, id.find('.')); }

QString capitalised(const std::string& word) {
  QString name = text(word);
  if (!name.isEmpty()) name[0] = name[0].toUpper();
  return name;
}

// The style frames the text of the box that has the keys, and these have none.
class CheckField : public QCheckBox {
 public:
  using QCheckBox::QCheckBox;

 protected:
  void paintEvent(QPaintEvent* event) override {
    QCheckBox::paintEvent(event);
    if (!hasFocus()) return;
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::Link));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
};

}  // namespace

ParameterPanel::ParameterPanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor) {
  setObjectName("parameters");
  layout_ = new QVBoxLayout(this);
  layout_->setContentsMargins(6, 6, 6, 6);
  build();
  editor_.listen([this](WorkspaceChange change) {
    if (change == WorkspaceChange::plugin) build();
    if (change == WorkspaceChange::parameters || change == WorkspaceChange::scene || change == WorkspaceChange::mesh)
      show_values();
  });
}

void ParameterPanel::build() {
  delete fields_;
  show_.clear();
  fields_ = new QWidget(this);
  auto* column = new QVBoxLayout(fields_);
  column->setContentsMargins(0, 0, 0, 0);
  if (!editor_.workspace().plugin()) {
    auto* none = new QLabel("No plug-in is loaded: File > Plug-ins loads one.", fields_);
    none->setWordWrap(true);
    column->addWidget(none);
  } else {
    std::map<std::string, QFormLayout*> groups;
    for (const Parameter& parameter : editor_.workspace().plugin()->parameters()) {
      QFormLayout*& form = groups[group_of(parameter.id)];
      if (!form) {
        auto* box = new QGroupBox(capitalised(group_of(parameter.id)), fields_);
        form = new QFormLayout(box);
        column->addWidget(box);
      }
      add(parameter, *form);
    }
    auto* reset = new QPushButton("Reset to defaults", fields_);
    reset->setObjectName("reset_parameters");
    reset->setToolTip("Every parameter as the plug-in has it by default; one step of undo.");
    connect(reset, &QPushButton::clicked, this, [this] { editor_.run({{"command", "reset_parameters"}}); });
    column->addWidget(reset);
  }
  column->addStretch();
  layout_->addWidget(fields_);
  show_values();
}

void ParameterPanel::add(const Parameter& parameter, QFormLayout& form) {
  QWidget* field = make_field(parameter);
  field->setObjectName(text(parameter.id));
  field->setAccessibleName(text(parameter.label));
  QString tip = text(parameter.doc);
  if (!parameter.unit.empty()) tip += QString(" [%1]").arg(text(parameter.unit));
  tip += QString("\n%1").arg(text(parameter.id));
  field->setToolTip(tip);
  auto* label = new QLabel(text(parameter.label), form.parentWidget());
  label->setToolTip(tip);
  label->setBuddy(field);
  form.addRow(label, field);
}

QWidget* ParameterPanel::make_field(const Parameter& parameter) {
  const std::string id = parameter.id;
  if (parameter.type == CGW_PARAM_BOOLEAN) {
    auto* box = new CheckField(fields_);
    connect(box, &QCheckBox::clicked, this, [this, id](bool on) { set(id, on); });
    show_[id] = [box](double value) { box->setChecked(value != 0); };
    return box;
  }
  if (parameter.type == CGW_PARAM_CHOICE) {
    auto* choices = new QComboBox(fields_);
    for (const std::string& choice : parameter.choices) choices->addItem(text(choice));
    connect(choices, QOverload<int>::of(&QComboBox::activated), this, [this, id](int row) { set(id, row); });
    show_[id] = [choices](double value) { choices->setCurrentIndex(static_cast<int>(value)); };
    return choices;
  }
  auto* number = new NumberField(fields_);
  number->set_range(parameter.minimum, parameter.maximum, parameter.type == CGW_PARAM_INTEGER);
  number->on_edit([this, id](double value) { set(id, value); });
  number->on_refusal([this](const std::string& sentence) { editor_.refuse_typed(sentence); });
  show_[id] = [number](double value) { number->show(value); };
  return number;
}

// An id may be the beginning of another: the longest is meant.
QWidget* ParameterPanel::field_named_in(const std::string& sentence) const {
  std::string named;
  for (const auto& [id, show] : show_)
    if (sentence.find(id) != std::string::npos && id.size() > named.size()) named = id;
  return named.empty() ? nullptr : fields_->findChild<QWidget*>(text(named));
}

void ParameterPanel::show_values() {
  const bool is_open = editor_.workspace().mesh_node() >= 0 && editor_.workspace().plugin();
  fields_->setEnabled(is_open);
  if (!is_open) return;
  for (const auto& [id, show] : show_) show(editor_.workspace().parameter(id));
}

void ParameterPanel::set(const std::string& id, double value) {
  if (!editor_.run_typed({{"command", "set_parameter"}, {"id", id}, {"value", value}})) show_values();
}

}  // namespace cagewright::host
