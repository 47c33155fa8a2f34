#include "ui/deforming/deform_feature.h"

#include "core/model/field_formats.h"
#include "core/model/file_formats.h"
#include "ui/commands/availability.h"
#include "ui/commands/make_action.h"
#include "ui/deforming/deform_panel.h"
#include "ui/deforming/field_deforming.h"
#include "ui/deforming/field_page.h"
#include "ui/deforming/number_page.h"
#include "ui/dialogs/file_question.h"
#include "ui/frame/docks.h"
#include "ui/frame/notices.h"
#include "ui/language/said.h"
#include "ui/modes.h"
#include "ui/selection/selection_model.h"
#include "ui/theme.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QSignalBlocker>

#include <utility>

namespace knead {

namespace {

constexpr double flatEnough = 0.9; // length of the mean of the normals of a face whose normal means something

QList<QAction*> makeKindActions(QWidget& window)
{
    QList<QAction*> actions;
    for (const NumberKindLook& look : numberKindLooks()) {
        const QByteArray name = QByteArray("deform") + look.name;
        QAction* action = makeAction(window, {name, look.text, look.icon, "", look.tip});
        action->setData(static_cast<int>(look.kind));
        actions.append(action);
    }
    return actions;
}

QStringList patternsOf(const std::vector<std::string>& endings)
{
    QStringList patterns;
    for (const std::string& ending : endings)
        patterns << "*." + QString::fromStdString(ending);
    return patterns;
}

/// "CalculiX results (*.frd)", all together first.
QStringList fieldFilters()
{
    QStringList all;
    QStringList filters;
    const auto add = [&](const QString& name, const QStringList& patterns) {
        all << patterns;
        filters << QStringLiteral("%1 (%2)").arg(name, patterns.join(' '));
    };
    for (const FieldFormat& format : fieldFormats())
        if (!format.isMeshOnly)
            add(said(format.name), patternsOf(format.endings));
    add(DeformFeature::tr("Projects of Knead"), {"*.knead"});
    QStringList scans;
    for (const FileFormat& format : fileFormats)
        if (format.isRead && !format.isSmooth)
            scans << patternsOf(format.endingsRead());
    add(DeformFeature::tr("Scans of the part"), scans);
    all.removeDuplicates();
    return QStringList(DeformFeature::tr("Fields (%1)").arg(all.join(' '))) + filters;
}

} // namespace

DeformFeature::Actions::Actions(QWidget& window)
    : deform(makeSwitch(window, {"deform", QT_TRANSLATE_NOOP("Actions", "Deform by numbers"), "deform", "",
                                 QT_TRANSLATE_NOOP("Actions", "Bend, twist, taper, stretch, shear or scale the part by "
                                                              "numbers between two planes")}))
    , kinds(makeKindActions(window))
    , byField(makeAction(window,
                         {"deformByField", QT_TRANSLATE_NOOP("Actions", "&Deform by a field..."), "deform-field", "",
                          QT_TRANSLATE_NOOP("Actions", "Move the part by displacements that another program computed, "
                                                       "or against them")}))
{
}

DeformFeature::DeformFeature(const Workbench& bench, Modes& modes)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_actions(bench.window)
    , m_panel(new DeformPanel(&bench.window))
    , m_stage(new DeformStage(bench))
    , m_handles(new DeformHandles(bench.document, bench.viewport))
    , m_byField(new FieldDeforming(bench, *m_stage, m_panel->field()))
{
    bench.docks.add("deformDock", tr("Deform"), m_panel);
    connectActions(modes);
    connect(m_panel, &DeformPanel::applyClicked, this, &DeformFeature::apply);
    connect(m_panel, &DeformPanel::cancelClicked, this, &DeformFeature::leave);
    connect(m_panel, &DeformPanel::beginClicked, this, [this] {
        if (m_actions.deform->isEnabled())
            m_actions.deform->setChecked(true);
        else
            m_bench.notices.problem(Availability::whyNot(*m_actions.deform));
    });
    connect(&m_panel->numbers(), &NumberPage::changed, this, &DeformFeature::take);
    connect(&m_panel->numbers(), &NumberPage::partsChanged, this, &DeformFeature::takeParts);
    connect(m_handles, &DeformHandles::dragged, this, &DeformFeature::drag);
    connect(m_handles, &DeformHandles::confirmed, this, &DeformFeature::apply);
    connect(m_byField, &FieldDeforming::opened, this, &DeformFeature::beginField);
    connect(m_byField, &FieldDeforming::refused, m_panel, &DeformPanel::showProblem);
    connect(m_stage, &DeformStage::seen, this, [this] { m_bench.availability.update(); });
    connect(m_stage, &DeformStage::applied, this, &DeformFeature::applied);
    connect(&bench.document.selected(), &SelectionModel::changed, this, [this] {
        if (m_actions.deform->isChecked() && !m_isByField && m_panel->numbers().isOfSelected())
            takeParts();
    });
    connect(&bench.document, &Document::changed, this, &DeformFeature::follow);
}

void DeformFeature::connectActions(Modes& modes)
{
    modes.add(m_actions.deform);
    connect(m_actions.deform, &QAction::toggled, this, &DeformFeature::switchOn);
    for (QAction* action : m_actions.kinds)
        connect(action, &QAction::triggered, this,
                [this, action] { chooseKind(static_cast<NumberKind>(action->data().toInt())); });
    connect(m_actions.byField, &QAction::triggered, this, &DeformFeature::askForField);
    m_bench.availability.needBodies(m_actions.kinds + QList{m_actions.deform}, [this] { return whyNot(); });
    m_bench.availability.needBodies({m_actions.byField}, [this] { return whyNot(); });
}

std::optional<QString> DeformFeature::whyNot() const
{
    if (m_bench.viewport.isLookingBack() && !m_actions.deform->isChecked())
        return tr("Come back to the present first: Esc.");
    return {};
}

QMenu* DeformFeature::newMenu() const
{
    auto* menu = new QMenu(tr("Deform"), &m_bench.window);
    menu->setObjectName("deformMenu");
    menu->setIcon(icon("deform"));
    menu->setToolTipsVisible(true);
    menu->addAction(m_actions.deform);
    menu->addSeparator();
    menu->addActions(m_actions.kinds);
    return menu;
}

void DeformFeature::chooseKind(NumberKind kind)
{
    m_kind = kind;
    if (!m_actions.deform->isChecked() || m_isByField) {
        m_actions.deform->setChecked(false);
        m_actions.deform->setChecked(true);
    } else
        begin(kind);
}

void DeformFeature::switchOn(bool on)
{
    if (!on)
        return end();
    m_bench.document.pause();
    m_bench.docks.show("deformDock");
    if (m_isByField) {
        m_panel->show(DeformPanel::Page::field);
        return;
    }
    m_normal = selectedNormal();
    m_panel->show(DeformPanel::Page::number);
    takeParts();
}

void DeformFeature::leave()
{
    m_actions.deform->setChecked(false);
}

/// What was said is of the parts as they were when it began: it ends with time that runs, and with other parts.
void DeformFeature::follow(Document::Change what)
{
    if (!m_actions.deform->isChecked())
        return;
    const bool isOther =
        what == Document::Change::Model || what == Document::Change::Moment || what == Document::Change::Filling;
    if (isOther || m_bench.document.isPlaying())
        leave();
    else if (what == Document::Change::Frame)
        followFrame();
}

/// A step was made, say.
void DeformFeature::followFrame()
{
    if (m_isByField) {
        m_handles->showGhost(m_bench.document.frame());
        return;
    }
    if (!m_form)
        return; // it begins just now
    m_subject.box = boxOfMeant();
    m_surface = m_stage->surfaceOf(m_meant);
    take(NumberForm(*m_form));
}

void DeformFeature::end()
{
    m_isByField = false;
    m_form.reset();
    m_byField->forget();
    m_stage->end();
    m_handles->hide();
    m_panel->show(DeformPanel::Page::none);
    m_bench.availability.update();
}

MeantParts DeformFeature::meant() const
{
    if (!m_panel->numbers().isOfSelected())
        return m_stage->allParts();
    return m_stage->selectedParts();
}

Box DeformFeature::boxOfMeant() const
{
    return m_meant.isAny() ? m_stage->boxOf(m_meant) : m_bench.document.content().box;
}

/// Other parts are meant: the planes are at their ends.
void DeformFeature::takeParts()
{
    m_meant = meant();
    m_subject = {boxOfMeant(), m_normal, {}};
    m_surface = m_stage->surfaceOf(m_meant);
    m_form.reset();
    begin(m_kind);
}

void DeformFeature::begin(NumberKind kind)
{
    NumberForm form = m_form.value_or(newForm(kind, m_subject));
    form.kind = kind;
    take(form);
}

/// What is typed or dragged.
void DeformFeature::take(const NumberForm& now)
{
    m_kind = now.kind;
    m_form = now;
    takeHeights(m_subject, now, m_surface);
    m_panel->numbers().show(now, m_subject, m_bench.document.content().bodies.size() > 1);
    if (!m_meant.isAny()) {
        m_panel->showProblem(tr("No part is selected: click one in the tree, or choose all parts."));
        m_stage->end();
        m_handles->hide();
        return;
    }
    const NumberDeformation deformation = deformationOf(now, m_subject);
    m_handles->show({deformation, m_subject.box}, m_bench.document.frame());
    const std::optional<Message> problem = knead::whyNot(now, m_subject);
    m_panel->showProblem(problem ? said(*problem) : QString());
    m_stage->look(
        {.deformations = std::make_shared<const std::vector<Deformation>>(std::vector<Deformation>{deformation}),
         .meant = m_meant,
         .caption = said(Message("Deforming", "Preview: %1").with(nameOf(now)))},
        m_handles->isDragging());
}

void DeformFeature::drag(DeformHandle handle, double value)
{
    NumberForm form = m_panel->numbers().form();
    if (handle == DeformHandle::from)
        form.from = value;
    else if (handle == DeformHandle::to)
        form.to = value;
    else if (hasAngle(form.kind))
        form.angle = value;
    else if (hasFactor(form.kind))
        form.factor = value;
    else
        form.shift = value;
    take(form);
}

void DeformFeature::apply()
{
    if (!m_actions.deform->isChecked())
        return;
    if (const QString problem = m_panel->problem(); !problem.isEmpty()) {
        m_bench.notices.problem(problem);
        return;
    }
    if (m_isByField)
        return m_byField->apply();
    const NumberForm form = m_panel->numbers().form();
    if (form.isByPhysics) {
        m_stage->applyByPhysics(physicalDeformationOf(form, m_subject), verbOf(form.kind), nameOf(form));
        return;
    }
    const NumberDeformation deformation = deformationOf(form, m_subject);
    m_stage->apply(std::make_shared<const std::vector<Deformation>>(std::vector<Deformation>{deformation}),
                   {RecipeDeformation{.bodies = {}, .what = deformation}}, verbOf(form.kind), nameOf(form));
}

void DeformFeature::askForField()
{
    const FileQuestion question{
        .name = "fieldDialog", .title = tr("Deform by a field"), .filters = fieldFilters(), .key = "fieldFolder"};
    askForFilesToRead(m_bench.window, question, [this](const QStringList& paths) { openField(paths.front()); });
}

void DeformFeature::openField(const QString& path)
{
    if (!m_bench.document.isEmpty())
        m_byField->open(path);
}

/// There is one: its page takes the place of what was being said.
void DeformFeature::beginField()
{
    if (m_isByField && m_actions.deform->isChecked())
        return;
    if (const std::optional<QString> why = whyNot()) {
        m_byField->forget();
        m_bench.notices.problem(*why);
        return;
    }
    if (m_actions.deform->isChecked()) {
        m_stage->end();
        m_handles->hide();
        m_isByField = true;
        switchOn(true);
    } else {
        m_isByField = true;
        m_actions.deform->setChecked(true);
    }
    m_handles->showGhost(m_bench.document.frame());
}

/// Of the one face that is selected, if it is flat.
std::optional<Vec3> DeformFeature::selectedNormal() const
{
    const Region& region = m_bench.document.selected().region();
    if (region.level != Level::Face || region.count() != 1)
        return {};
    const auto& [body, faces] = *region.items.begin();
    const Frame& frame = *m_bench.document.frame();
    const TriangleMesh& mesh = frame.filled[body]->mesh;
    Vec3 sum = Vec3::Zero();
    double area = 0;
    for (std::size_t t = 0; t < mesh.triangles.size() && t < mesh.faceOfTriangle.size(); ++t)
        if (mesh.faceOfTriangle[t] == faces.front()) {
            const Vec3 cross = crossOf(frame.bodies[body]->places, mesh.triangles[t]);
            sum += cross;
            area += cross.norm();
        }
    return area > 0 && sum.norm() > flatEnough * area ? std::optional<Vec3>(sum.normalized()) : std::nullopt;
}

} // namespace knead
