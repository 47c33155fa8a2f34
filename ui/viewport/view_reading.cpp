#include "ui/viewport/view_reading.h"

#include "ui/document/document.h"
#include "ui/focus_ring.h"
#include "ui/screen_reader.h"
#include "ui/selection/region_words.h"
#include "ui/selection/selection_model.h"
#include "ui/viewport/viewport_widget.h"

namespace knead {

namespace {

struct ViewWords {
    Q_DECLARE_TR_FUNCTIONS(ViewReading)
};

/// What is selected, by its name where it is one thing.
QString selectedThing(Document& document)
{
    const Selection& selection = document.selection();
    switch (selection.kind) {
    case Selection::Kind::Body:
        return document.nameOfBody(selection.id);
    case Selection::Kind::Tool:
        if (const ToolState* tool = document.tool(selection.id))
            return QString::fromStdString(tool->name);
        break;
    case Selection::Kind::Fixture:
        if (const FaceFixture* fixture = document.fixtures().find(selection.id))
            return QString::fromStdString(fixture->name);
        break;
    case Selection::Kind::Region: {
        const Region& region = document.selected().region();
        return wordsFor(region, sizeOf(region, document.content(), *document.frame()));
    }
    case Selection::Kind::None:
        break;
    }
    return {};
}

QString spokenView(Document& document)
{
    if (document.isEmpty())
        return ViewWords::tr("Nothing is open");
    const QString thing = selectedThing(document);
    return thing.isEmpty() ? ViewWords::tr("Nothing is selected") : ViewWords::tr("Selected: %1").arg(thing);
}

} // namespace

void makeReadable(ViewportWidget& view, Document& document)
{
    readAs(view, QAccessible::Canvas, [&document] { return spokenView(document); });
    view.setAccessibleName(ViewWords::tr("3D view"));
    QObject::connect(&document, &Document::changed, &view, [&view](Document::Change what) {
        if (what == Document::Change::Selection || what == Document::Change::Model)
            tellReader(view);
    });
    new FocusRing(view);
}

} // namespace knead
