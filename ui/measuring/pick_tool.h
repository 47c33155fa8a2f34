#pragma once

#include "ui/measuring/measurement_words.h"
#include "ui/measuring/skin_picker.h"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

namespace knead {

/// Takes left clicks of the view while something is picked, place after place; everything else goes on as usual. When all are
/// there it tells them and begins again, until stop().
class PickTool final : public QObject {
    Q_OBJECT
public:
    PickTool(const Document& document, ViewportWidget& view, QObject* parent = nullptr);

    using Done = std::function<void(const std::vector<SkinPlace>& places)>;
    /// @param title of what is done: "Distance"
    void begin(const QString& title, std::vector<PickWhat> picks, Done done);
    /// The same in another language.
    void setTitle(const QString& title);
    void stop();
    bool isPicking() const { return !m_wanted.empty(); }

    /// What to do next: "Distance: click the first place".
    QString prompt() const;

    const std::vector<SkinPlace>& picked() const { return m_picked; }
    const std::optional<SkinPicker::Hit>& hovered() const { return m_hovered; }
    PickWhat wanted() const { return m_wanted[m_picked.size()]; }

    /// The mouse is over the same scene, seen from elsewhere.
    void hoverFrom(const SkinPicker::Eye& eye, const QPointF& position);
    void leave(); ///< the mouse is over no view

signals:
    void changed(); ///< what is picked, hovered or asked for
    void begun();
    void stopped();
    void refused(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    SkinPicker::Eye eye() const; ///< of the active view
    void take(const QPointF& position);

    const Document& m_document;
    ViewportWidget& m_view;
    SkinPicker m_picker;
    QString m_title;
    std::vector<PickWhat> m_wanted; ///< empty: nothing is picked
    Done m_done;
    std::vector<SkinPlace> m_picked;
    bool m_hasPress = false; ///< of the left button: its release belongs to it
    std::optional<SkinPicker::Hit> m_hovered;
};

} // namespace knead
