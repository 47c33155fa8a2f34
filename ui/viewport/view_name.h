#pragma once

#include <QWidget>

namespace knead {

struct Camera;

/// What a view from there is called: "Front", "Isometric"; "Perspective" or "Parallel" for no direction of its own.
QString nameOfView(const Camera& camera);

/// The name in the corner of a view. A click makes the view the active one, a double click the only one, and back.
class ViewName final : public QWidget {
    Q_OBJECT
public:
    explicit ViewName(QWidget* parent);

    void show(const QString& name, bool isActive);
    const QString& name() const { return m_name; }
    QSize sizeHint() const override;

signals:
    void clicked();
    void doubleClicked();

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    QString m_name;
    bool m_isActive = false;
};

} // namespace knead
