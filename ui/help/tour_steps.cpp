#include "ui/help/tour_steps.h"

#include "ui/document/model_notes.h"
#include "ui/frame/notices.h"
#include "ui/interaction/hands.h"
#include "ui/interaction/press_hand.h"
#include "ui/interaction/sculpt_hand.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QApplication>
#include <QMainWindow>
#include <QToolBar>
#include <QWidget>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace knead {

namespace {

constexpr int tourMarkSize = 56; // of the ring around a place of the part [pixels]

/// Asks the window where things are, and what is going on.
class TourWatch {
public:
    explicit TourWatch(const TourSources& sources)
        : m_bench(sources.bench)
        , m_hands(sources.hands)
        , m_brushes(sources.brushes)
        , m_banner(sources.banner)
    {
    }

    /// In the window's coordinates; empty where it is not seen.
    QRect rectOf(const QWidget* widget) const
    {
        if (widget == nullptr || !widget->isVisible())
            return {};
        return {widget->mapTo(&m_bench.window, QPoint(0, 0)), widget->size()};
    }

    /// Around a place of the part. @param place in it [m]
    QRect mark(const Vec3& place) const
    {
        const ViewportWidget& view = m_bench.viewport;
        const std::optional<QPointF> seen = view.isVisible() ? view.widgetPosition(place) : std::nullopt;
        if (!seen)
            return {};
        const QPoint middle = view.mapTo(&m_bench.window, seen->toPoint());
        return QRect(middle - QPoint(tourMarkSize / 2, tourMarkSize / 2), QSize(tourMarkSize, tourMarkSize))
            .intersected(rectOf(&view));
    }

    QRect topOfPart() const
    {
        if (m_bench.document.isEmpty())
            return {};
        const Box box = m_bench.viewport.materialBox();
        return mark({box.center().x(), box.center().y(), box.max().z()});
    }

    /// The upper one that is nearest to the eye.
    QRect cornerOfPart() const
    {
        if (m_bench.document.isEmpty())
            return {};
        constexpr double inwards = 0.06; // where edges are round, the corner of the box lies beside the material
        const Box box = m_bench.viewport.materialBox();
        const Vec3 towardsEye = m_bench.viewport.camera().towardsEye();
        const Vec3 corner(towardsEye.x() > 0 ? box.max().x() : box.min().x(),
                          towardsEye.y() > 0 ? box.max().y() : box.min().y(), box.max().z());
        return mark(corner + inwards * (box.center() - corner));
    }

    /// All of the part that can be worked, as it is seen, and what lies on the view and beside it to be clicked.
    QList<QRect> part() const
    {
        QList<QRect> rects{rectOf(&m_banner), rectOf(&m_brushes)};
        if (m_bench.document.isEmpty() || !m_bench.viewport.isVisible())
            return rects;
        const Box box = m_bench.viewport.materialBox();
        QRectF seen;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 place((corner & 1) != 0 ? box.max().x() : box.min().x(),
                             (corner & 2) != 0 ? box.max().y() : box.min().y(),
                             (corner & 4) != 0 ? box.max().z() : box.min().z());
            if (const std::optional<QPointF> at = m_bench.viewport.widgetPosition(place))
                seen = seen.united(QRectF(*at - QPointF(1, 1), QSizeF(2, 2)));
        }
        const QPoint origin = m_bench.viewport.mapTo(&m_bench.window, QPoint(0, 0));
        rects << seen.toAlignedRect().translated(origin).intersected(rectOf(&m_bench.viewport));
        return rects;
    }

    /// Whether a tool, a thumb among them, is pressed by the material since a step.
    bool isPressed(std::uint64_t since) const
    {
        if (m_bench.document.isEmpty())
            return false;
        const Snapshot& now = *m_bench.document.frame()->snapshot;
        return now.step > since &&
               std::ranges::any_of(now.tools, [](const ToolState& tool) { return tool.force.squaredNorm() > 0; });
    }

    bool isPulled() const
    {
        const SculptHand& hand = m_hands.sculpting();
        return hand.isStroking() && hand.brush() == SculptBrush::pull && hand.force() > 0;
    }

    /// No hand is at work: what was done is over.
    bool isLetGo() const
    {
        return !m_hands.sculpting().isStroking() && !m_hands.pressing().isPressing() &&
               QApplication::mouseButtons() == Qt::NoButton;
    }

    std::uint64_t step() const { return m_bench.document.isEmpty() ? 0 : m_bench.document.frame()->snapshot->step; }

    /// By which a new one is known.
    std::pair<std::string, double> lastExport() const
    {
        const std::vector<ModelNotes::Export>& all = m_bench.document.notes().exports();
        return all.empty() ? std::pair<std::string, double>() : std::pair(all.front().file, all.front().wallTime);
    }

private:
    Workbench m_bench;
    const Hands& m_hands;
    const QWidget& m_brushes;
    const QWidget& m_banner;
};

QString tourKeysOf(const QAction& action)
{
    return action.shortcut().toString(QKeySequence::NativeText);
}

/// @param seen is asked with each look, before the hand lets go
Tour::Step tourHandStep(const TourWatch& watch, std::function<bool(std::uint64_t since)> seen)
{
    struct State {
        std::uint64_t since = 0; ///< step of the simulation
        bool isSeen = false;
    };
    const auto state = std::make_shared<State>();
    Tour::Step step;
    step.begin = [watch, state] { *state = {watch.step(), false}; };
    step.isDone = [watch, state, seen = std::move(seen)] {
        state->since = std::min(state->since, watch.step()); // after undoing
        state->isSeen = state->isSeen || seen(state->since);
        return state->isSeen && watch.isLetGo();
    };
    step.uncovered = [watch] { return watch.part(); };
    return step;
}

} // namespace

std::vector<Tour::Step> claySteps(const TourSources& sources)
{
    const TourWatch watch(sources);
    const QList<QAction*> modes = sources.hands.modes();
    const auto modeNamed = [&modes](const char* name) {
        return *std::ranges::find(modes, QString(name), [](const QAction* mode) { return mode->objectName(); });
    };
    QAction* const thumb = modeNamed("sculptThumb");
    const QAction* const pull = modeNamed("pull");

    Tour::Step press = tourHandStep(watch, [watch](std::uint64_t since) { return watch.isPressed(since); });
    press.title = [] { return Tour::tr("Press"); };
    press.text = [] {
        return Tour::tr("Hold the left button on the clay: a thumb goes in for as long as you hold it.");
    };
    press.place = [watch] { return watch.topOfPart(); };
    press.begin = [begin = press.begin, thumb] {
        begin();
        thumb->setChecked(true);
    };

    Tour::Step pulling = tourHandStep(watch, [watch](std::uint64_t) { return watch.isPulled(); });
    pulling.title = [] { return Tour::tr("Pull"); };
    pulling.text = [pull] {
        return Tour::tr("Choose Pull material at the right of the view (%1). Then drag a corner of the clay outwards.")
            .arg(tourKeysOf(*pull));
    };
    pulling.place = [watch, pull, &bar = sources.brushes] {
        return pull->isChecked() ? watch.cornerOfPart() : watch.rectOf(bar.widgetForAction(const_cast<QAction*>(pull)));
    };

    const auto before = std::make_shared<std::pair<std::string, double>>();
    Tour::Step exporting;
    exporting.title = [] { return Tour::tr("Export"); };
    exporting.text = [&action = sources.exporting] {
        return Tour::tr("Press %1 and write the clay as STEP or as a mesh, into a folder of your choice. Or skip this.")
            .arg(tourKeysOf(action));
    };
    exporting.place = [watch, &bar = sources.toolBar, &action = sources.exporting] {
        return watch.rectOf(bar.widgetForAction(const_cast<QAction*>(&action)));
    };
    exporting.begin = [watch, before] { *before = watch.lastExport(); };
    exporting.isDone = [watch, before] { return watch.lastExport() != *before; };
    exporting.uncovered = [watch] { return watch.part(); };

    Tour::Step last;
    last.title = [] { return Tour::tr("That was all"); };
    last.text = [] {
        return Tour::tr("Ctrl+Z takes back whatever you did. Ctrl+K finds any command, F1 opens the handbook, and this "
                        "tour is in the menu Help.");
    };
    last.uncovered = [watch] { return watch.part(); };
    return {press, pulling, exporting, last};
}

} // namespace knead
