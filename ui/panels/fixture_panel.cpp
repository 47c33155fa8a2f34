#include "ui/panels/fixture_panel.h"

#include "ui/panels/form.h"
#include "ui/theme.h"

#include <QLabel>
#include <QPushButton>

namespace knead {

FixturePanel::FixturePanel(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_name(makeHeading({}, this))
    , m_body(makeReading("fixtureBody", this))
    , m_faces(makeReading("fixtureFaces", this))
    , m_objects(makeReading("fixtureObjects", this))
{
    setObjectName("fixturePanel");
    QFormLayout* form = makeForm(this);
    form->addRow(m_name);
    form->addRow(tr("Body"), m_body);
    form->addRow(tr("Faces"), m_faces);
    form->addRow(tr("Objects held"), m_objects);
    auto* hint = new QLabel(tr("With \"Fix faces\" on, a click on a face adds it to this fixture, or frees it."), this);
    hint->setProperty("role", "dimmed");
    hint->setWordWrap(true);
    form->addRow(hint);
    auto* remove = new QPushButton(icon("delete"), tr("Remove fixture"), this);
    remove->setObjectName("removeFixture");
    connect(remove, &QPushButton::clicked, this, [this] { m_document.removeSelected(); });
    form->addRow(QString(), remove);
    connect(&document, &Document::changed, this, [this](Document::Change) { showFixture(); });
}

void FixturePanel::showFixture()
{
    const Selection& selection = m_document.selection();
    const FaceFixture* fixture =
        selection.kind == Selection::Kind::Fixture ? m_document.fixtures().find(selection.id) : nullptr;
    if (fixture == nullptr)
        return;
    std::size_t objects = 0;
    for (const Fixture& held : m_document.frame()->snapshot->fixtures)
        if (held.name == fixture->name)
            objects = held.objects.size();
    m_name->setText(QString::fromStdString(fixture->name));
    m_body->setText(m_document.nameOfBody(fixture->body));
    m_faces->setText(formatCount(fixture->faces.size()));
    m_objects->setText(formatCount(objects));
}

} // namespace knead
