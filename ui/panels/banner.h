#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace knead {

/// One sentence above the view that does not stop the work, with at most two remedies to click.
class Banner final : public QFrame {
    Q_OBJECT
public:
    explicit Banner(QWidget* parent = nullptr);

    /// @param remedy text of the button; none when empty
    /// @param other text of a second button; none when empty
    void show(const QString& sentence, const QString& remedy = {}, const QString& other = {});
    QString sentence() const;

signals:
    void remedyClicked();
    void otherClicked();

protected:
    void changeEvent(QEvent* event) override;

private:
    void drawSign();

    QLabel* m_sign;
    QLabel* m_sentence;
    QToolButton* m_remedy;
    QToolButton* m_other;
};

} // namespace knead
