#pragma once

#include "ui/viewport/scene_picker.h"

#include <QObject>

#include <optional>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace knead {

class Document;
class ViewportWidget;

/// Takes mouse and keys of a view before the view does. What a hand answers with true is its own; the rest goes on to the hands
/// that were made before it, and to the view. Owned by the view.
class ViewHand : public QObject {
    Q_OBJECT
public:
    ViewHand(Document& document, ViewportWidget& view);

    /// What is said to who works at a moment that was, or is still to come.
    static QString notThePresent();

    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    /// Of what does not move the view.
    virtual bool mousePressed(QMouseEvent& /*event*/) { return false; }
    virtual bool mouseMoved(QMouseEvent& /*event*/) { return false; }
    virtual bool mouseReleased(QMouseEvent& /*event*/) { return false; }
    virtual bool wheelTurned(QWheelEvent& /*event*/) { return false; }
    virtual void mouseLeft() {} ///< it is over something else now
    /// Whether a key is this hand's now, whatever the window uses it for.
    virtual bool wantsKey(const QKeyEvent& /*event*/) const { return false; }
    virtual bool keyPressed(QKeyEvent& /*event*/) { return false; }
    virtual bool keyReleased(QKeyEvent& /*event*/) { return false; }
    virtual void keyboardLost() {} ///< another widget has it now

    /// The place of a body, as it is now, that the left button is pressed on; tools and the cube are the view's.
    std::optional<PickHit> pressedBody(const QMouseEvent& event) const;
    /// Why nothing is worked at wherever the left button is pressed; empty: it is, or the press is the cube's.
    QString whyNotNow(const QMouseEvent& event) const;

    Document& m_document;
    ViewportWidget& m_view;
};

} // namespace knead
