#pragma once

#include <QImage>
#include <QPushButton>

namespace knead {

/// A button that is a picture with a name and a line about it: a file to be opened.
class PictureCard final : public QPushButton {
    Q_OBJECT
public:
    static constexpr QSize pictureSize{146, 92};

    /// @param picture of thumbnails' shape; null: a sign in its place
    PictureCard(const QImage& picture, const QString& name, const QString& about, QWidget* parent = nullptr);

    QSize sizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void drawPicture(QPainter& painter, const QRect& place);

    QImage m_picture;
    QString m_about;
};

} // namespace knead
