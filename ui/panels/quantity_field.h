#pragma once

#include "core/message/message.h"
#include "ui/units.h"

#include <QLineEdit>

#include <limits>

namespace knead {

/// A number with its unit in one field. Enter or leaving the field commits, Esc restores. Text that is not a number in
/// range stays
/// visible, marked, while the old value holds. A text that was not edited is never read back, so a value cannot drift.
class QuantityField final : public QLineEdit {
    Q_OBJECT
public:
    explicit QuantityField(Quantity quantity, QWidget* parent = nullptr);

    void setRange(double minimum, double maximum); ///< SI, both ends allowed
    /// A tool tip for as long as there is no problem. @param tip in it %1 and %2 are the ends of the range
    void setTip(const Message& tip);
    /// What 0 means, in words: shown in its place. An emptied field then is 0.
    void setZeroText(const QString& text);
    double value() const { return m_value; } ///< SI
    bool hasProblem() const { return !m_problem.isEmpty(); }

    /// Shows a value without emitting. From a click into the field to Enter, Esc or leaving it, text and selection are left
    /// alone; what came in meanwhile shows then.
    void setValue(double value);
    /// Words instead of a value, until there is one again; as setValue() otherwise.
    void setNoValue(const QString& words);

    /// Drops what is being typed and shows the value.
    void restore();

    /// What the tool tip says: what is wrong, else what it is for, what is allowed, and in which units it may be typed.
    QString tip() const;

    QSize sizeHint() const override;

signals:
    void committed(double value);
    void finished(); ///< by Enter or Esc, and nothing is wrong with what is in it

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void commit();
    void showValue();
    void showProblem(const QString& problem);
    QString shown() const;

    Quantity m_quantity;
    double m_value = 0;
    bool m_hasNoValue = false;
    double m_minimum = -std::numeric_limits<double>::infinity();
    double m_maximum = std::numeric_limits<double>::infinity();
    QString m_zeroText;
    QString m_tip;
    QString m_problem;
    bool m_isBeingEdited = false;
};

} // namespace knead
