// SPDX-License-Identifier: BSD-3-Clause
//
// A small window on top of others from which the files that are its arguments can be dragged, for tests of dropping.
#include <QApplication>
#include <QDrag>
#include <QMimeData>
#include <QTimer>
#include <QUrl>
#include <QWidget>

namespace {

constexpr int wait_ms = 2000;  // whom it was dropped on fetches it after the drop

class DragSource : public QWidget {
 public:
  explicit DragSource(const QStringList& files) : QWidget(nullptr, Qt::X11BypassWindowManagerHint) {
    for (const QString& file : files) urls_.append(QUrl::fromLocalFile(file));
    setWindowTitle("Drag source");
    setGeometry(20, 200, 60, 60);
  }

 protected:
  void mouseMoveEvent(QMouseEvent*) override {
    auto* dragged = new QMimeData;
    dragged->setUrls(urls_);
    auto* drag = new QDrag(this);
    drag->setMimeData(dragged);
    drag->exec(Qt::CopyAction);
    QTimer::singleShot(wait_ms, &QApplication::quit);
  }

 private:
  QList<QUrl> urls_;
};

}  // namespace

int main(int argc, char** argv) {
  const QApplication application(argc, argv);
  DragSource source(QApplication::arguments().mid(1));
  source.show();
  return QApplication::exec();
}
