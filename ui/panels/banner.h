#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace knead {

/// One sentence that does not stop the work, with at most two remedies to click. It lies over the upper edge of the
/// view, which stays where it is while the mouse works in it.
class Banner final : public QFrame {
    Q_OBJECT
public:
    explicit Banner(QWidget* parent = nullptr);

    /// @param view that it lies over, of the same parent
    void layOver(QWidget& view);

    /// @param remedy text of the button; none when empty
    /// @param other text of a second button; none when empty
    void show(const QString& sentence, const QString& remedy = {}, const QString& other = {});
    QString sentence() const;

signals:
    void remedyClicked();
    void otherClicked();

protected:
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void drawSign();
    void place();

    QLabel* m_sign;
    QLabel* m_sentence;
    QToolButton* m_remedy;
    QToolButton* m_other;
    QWidget* m_view = nullptr; ///< that it lies over
};

} // namespace knead
