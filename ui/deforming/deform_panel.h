#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QStackedWidget;

namespace knead {

class FieldPage;
class NumberPage;

/// What deforms the parts: by numbers or by a field, a page each, and the buttons that do it or give it up. Without either it says how
/// to begin.
class DeformPanel final : public QWidget {
    Q_OBJECT
public:
    enum class Page { none, number, field };

    explicit DeformPanel(QWidget* parent = nullptr);

    NumberPage& numbers() { return *m_numbers; }
    FieldPage& field() { return *m_field; }
    void show(Page page);
    /// Why what is said cannot be done; empty: it can.
    void showProblem(const QString& sentence);
    QString problem() const; ///< that is shown

signals:
    void applyClicked();
    void cancelClicked();
    void beginClicked(); ///< a deformation by numbers

private:
    QStackedWidget* m_pages;
    NumberPage* m_numbers;
    FieldPage* m_field;
    QLabel* m_problem;
    QWidget* m_buttons;
    QPushButton* m_apply;
};

} // namespace knead
