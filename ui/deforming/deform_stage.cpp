#include "ui/deforming/deform_stage.h"

#include "ui/frame/notices.h"
#include "ui/selection/selection_model.h"
#include "ui/viewport/viewport_widget.h"

#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace knead {

bool MeantParts::isAny() const
{
    return std::ranges::count(parts, true) > 0;
}

DeformStage::DeformStage(const Workbench& bench)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_preview(new DeformPreview(this))
{
    connect(m_preview, &DeformPreview::made, this, &DeformStage::showFrame);
    connect(m_preview, &DeformPreview::failed, this, &DeformStage::failed);
    connect(&bench.document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Frame && m_look)
            ask();
    });
    connect(&bench.viewport, &ViewportWidget::optionsChanged, this, &DeformStage::followColors);
    connect(&bench.tasks, &TaskRunner::finished, this, [this] { m_applying.clear(); });
}

MeantParts DeformStage::allParts() const
{
    const FilledModel& content = m_bench.document.content();
    return {std::vector<bool>(content.model->parts.size(), true), std::vector<bool>(content.bodies.size(), true)};
}

MeantParts DeformStage::selectedParts() const
{
    const FilledModel& content = m_bench.document.content();
    MeantParts meant{std::vector<bool>(content.model->parts.size()), std::vector<bool>(content.bodies.size())};
    const auto add = [&](BodyId body) {
        if (body >= content.bodies.size())
            return;
        meant.bodies[body] = true;
        meant.parts[content.bodies[body]->part] = true;
    };
    for (const auto& [body, items] : m_bench.document.selected().region().items)
        add(body);
    if (const Selection& selection = m_bench.document.selection(); selection.kind == Selection::Kind::Body)
        add(selection.id);
    return meant;
}

Box DeformStage::boxOf(const MeantParts& meant) const
{
    Box box;
    const Frame& frame = *m_bench.document.frame();
    for (std::size_t b = 0; b < frame.bodies.size(); ++b)
        if (meant.bodies[b])
            for (const Vec3& place : frame.bodies[b]->places)
                box.extend(place);
    return box;
}

TriangleMesh DeformStage::surfaceOf(const MeantParts& meant) const
{
    const Frame& frame = *m_bench.document.frame();
    TriangleMesh all;
    for (std::size_t b = 0; b < frame.bodies.size(); ++b) {
        if (!meant.bodies[b])
            continue;
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        const std::vector<Vec3>& places = frame.bodies[b]->places;
        all.vertices.insert(all.vertices.end(), places.begin(), places.end());
        for (const TriangleMesh::Triangle& t : frame.filled[b]->mesh.triangles)
            all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    return all;
}

void DeformStage::look(Look look, bool isDragged)
{
    m_look = std::move(look);
    m_wasAllSeen = !isDragged && m_bench.viewport.showsAll();
    ask();
}

void DeformStage::ask()
{
    m_preview->ask({.deformations = m_look->deformations,
                    .exaggeration = m_look->exaggeration,
                    .which = m_look->meant.bodies,
                    .from = m_bench.document.frame(),
                    .examine = m_look->examine});
}

void DeformStage::showFrame(const DeformedFrame& made)
{
    if (!m_look || m_isHidden || m_bench.document.isEmpty() || made.frame->filled != m_bench.document.frame()->filled)
        return;
    auto fields = std::make_shared<SurfaceFields>();
    fields->frame = made.frame;
    if (m_look->showsColors) {
        fields->request.quantity = SurfaceQuantity::displacement;
        fields->values = made.ways;
        for (std::size_t b = 0; b < fields->values.size(); ++b)
            fields->values[b].resize(made.frame->filled[b]->mesh.vertices.size());
        if (m_look->exaggeration != 0)
            for (std::vector<float>& values : fields->values)
                for (float& value : values)
                    value /= static_cast<float>(std::abs(m_look->exaggeration));
    }
    setColored(m_look->showsColors);
    m_bench.viewport.lookAhead(made.frame, fields, m_look->caption);
    if (m_wasAllSeen && !m_bench.viewport.showsAll())
        m_bench.viewport.fit();
    emit seen(made);
}

void DeformStage::setColored(bool on)
{
    if (on == m_colorsBefore.has_value())
        return;
    SceneOptions options = m_bench.viewport.options();
    if (on) {
        m_colorsBefore = options.colors;
        options.colors.quantity = SurfaceQuantity::displacement;
        options.colors.range.reset();
    } else {
        const ColorMap map = options.colors.map;
        options.colors = *std::exchange(m_colorsBefore, {});
        options.colors.map = map;
    }
    m_bench.viewport.setOptions(options);
}

/// What a person has chosen meanwhile is shown at the end: the values of now are displacements.
void DeformStage::followColors()
{
    SceneOptions options = m_bench.viewport.options();
    if (!m_colorsBefore || options.colors.quantity == SurfaceQuantity::displacement)
        return;
    m_colorsBefore = options.colors;
    options.colors.quantity = SurfaceQuantity::displacement;
    options.colors.range.reset();
    m_bench.viewport.setOptions(options);
}

void DeformStage::end()
{
    if (!std::exchange(m_look, {}))
        return;
    m_isHidden = false;
    showPresent();
    m_preview->release();
    if (!m_applying.isEmpty() && m_bench.tasks.title() == m_applying)
        m_bench.tasks.cancel();
}

void DeformStage::showPresent()
{
    m_bench.viewport.lookAhead(nullptr, nullptr, {});
    setColored(false);
}

void DeformStage::setHidden(bool on)
{
    if (!m_look || std::exchange(m_isHidden, on) == on)
        return;
    if (on)
        showPresent();
    else
        ask();
}

void DeformStage::apply(std::shared_ptr<const std::vector<Deformation>> deformations,
                        std::vector<RecipeDeformation> said, const QString& title, const Message& name)
{
    if (!m_look || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    m_bench.document.pause();
    m_bench.document.whenSettled([this, deformations = std::move(deformations), said = std::move(said), title, name] {
        if (m_look && !m_bench.isBusy())
            startApplying({deformations, m_look->meant.parts, said}, title, name);
    });
}

void DeformStage::applyByPhysics(const PhysicalDeformation& deformation, const QString& title, const Message& name)
{
    if (!m_look || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    m_bench.document.deformByPhysics(deformation, m_look->meant.bodies, title, name);
    m_applying = title;
}

void DeformStage::startApplying(const DeformationRequest& request, const QString& title, const Message& name)
{
    const auto work = [before = m_bench.document.content(), shown = m_bench.document.frame(),
                       fixtures = m_bench.document.fixtures().list(), request,
                       writeAndRead = m_bench.services.writeAndRead](TaskControl& control) {
        return prepareDeformation(before, shown, fixtures, request, writeAndRead, control);
    };
    const auto finished = [this, name, edits = m_bench.document.edits()](PreparedDeformation done) {
        if (m_bench.document.isEmpty())
            return;
        if (m_bench.document.edits() != edits || m_bench.document.isGoing())
            m_bench.notices.problem(tr("Something else was done while the parts were deformed, so they stay as they "
                                       "are. Apply the deformation again."));
        else
            finish(std::move(done), name);
    };
    if (m_bench.tasks.run<PreparedDeformation>(title, work, finished))
        m_applying = title;
}

/// The document shows another model, with which the mode ends.
void DeformStage::finish(PreparedDeformation done, const Message& name)
{
    end();
    const ExportReport report = std::move(done.report);
    m_bench.document.deform(std::move(done), name);
    emit applied(report);
}

} // namespace knead
