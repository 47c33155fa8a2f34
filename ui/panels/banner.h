#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace knead {

/// One sentence above the view that does not stop the work, with at most one remedy to click.
class Banner final : public QFrame {
    Q_OBJECT
public:
    explicit Banner(QWidget* parent = nullptr);

    /// @param remedy text of the button; none when empty
    void show(const QString& sentence, const QString& remedy = {});
    QString sentence() const;

signals:
    void remedyClicked();

protected:
    void changeEvent(QEvent* event) override;

private:
    void drawSign();

    QLabel* m_sign;
    QLabel* m_sentence;
    QToolButton* m_remedy;
};

} // namespace knead
