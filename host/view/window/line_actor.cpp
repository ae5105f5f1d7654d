// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/line_actor.h"

#include <vtkMatrix4x4.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <utility>

#include "host/view/window/depth_order.h"

namespace cagewright::host {

LineActor::LineActor(vtkRenderer& renderer, const LineStyle& style) : renderer_(renderer), style_(style) {
  for (const auto& [mapper, actor] : {std::pair{mapper_.Get(), actor_.Get()}, {hidden_mapper_, hidden_actor_}}) {
    mapper->ScalarVisibilityOff();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    renderer_.AddActor(actor);
  }
  draw_slightly_nearer(*actor_);
  draw_on_top(*hidden_actor_, TopLayer::hidden_lines);
  hidden_actor_->ForceTranslucentOn();  // after all that is opaque
  apply();
}

LineActor::~LineActor() {
  renderer_.RemoveActor(actor_);
  renderer_.RemoveActor(hidden_actor_);
}

void LineActor::set(std::vector<std::vector<Point>> runs, bool closed) {
  if (runs == runs_ && closed == closed_) return;
  runs_ = std::move(runs);
  closed_ = closed;
  const auto lines = line_polydata(runs_, closed_);
  mapper_->SetInputData(lines);
  hidden_mapper_->SetInputData(lines);
  apply();
}

void LineActor::set_style(const LineStyle& style) {
  style_ = style;
  apply();
}

void LineActor::set_transform(const Matrix4& to_scene) {
  const vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(to_scene.data());
  actor_->SetUserMatrix(matrix);
  hidden_actor_->SetUserMatrix(matrix);
}

void LineActor::set_visible(bool visible) {
  visible_ = visible;
  apply();
}

void LineActor::set_pixel_ratio(double ratio) {
  if (ratio == ratio_) return;
  ratio_ = ratio;
  apply();
}

void LineActor::ignore_bounds() {
  actor_->UseBoundsOff();
  hidden_actor_->UseBoundsOff();
}

void LineActor::apply() {
  const bool is_there = visible_ && !runs_.empty();
  actor_->SetVisibility(is_there);
  hidden_actor_->SetVisibility(is_there && style_.opacity_of_hidden > 0);
  for (vtkActor* actor : {actor_.Get(), hidden_actor_.Get()}) {
    actor->GetProperty()->SetColor(style_.colour[0], style_.colour[1], style_.colour[2]);
    actor->GetProperty()->SetLineWidth(static_cast<float>(style_.width * ratio_));
  }
  actor_->GetProperty()->SetOpacity(style_.opacity);
  hidden_actor_->GetProperty()->SetOpacity(style_.opacity_of_hidden);
}

}  // namespace cagewright::host
