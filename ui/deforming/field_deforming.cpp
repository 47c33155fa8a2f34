#include "ui/deforming/field_deforming.h"

#include "core/deformation/kept_faces.h"
#include "core/session/present_surface.h"
#include "ui/deforming/field_page.h"
#include "ui/frame/notices.h"
#include "ui/language/said.h"
#include "ui/selection/selection_model.h"

#include <QFile>
#include <QFileInfo>
#include <QMainWindow>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr double usualFade = 0.1; // of the size of the parts

QString fileNameOf(const std::string& path)
{
    return QFileInfo(QFile::decodeName(path.c_str())).fileName();
}

} // namespace

FieldDeforming::FieldDeforming(const Workbench& bench, DeformStage& stage, FieldPage& page)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_stage(stage)
    , m_page(page)
    , m_arrows(bench.viewport)
{
    connect(&page, &FieldPage::choiceChanged, this, &FieldDeforming::readAnew);
    connect(&page, &FieldPage::changed, this, &FieldDeforming::lookAnew);
    connect(&page, &FieldPage::lookChanged, this, &FieldDeforming::look);
    connect(&page, &FieldPage::keepToggled, this, &FieldDeforming::chooseKept);
    connect(&page, &FieldPage::keepNothingClicked, this, &FieldDeforming::keepNothing);
    connect(&stage, &DeformStage::seen, this, &FieldDeforming::showSeen);
    connect(&stage, &DeformStage::failed, this, [this](const QString& sentence) {
        if (hasField())
            emit refused(sentence);
    });
    connect(&bench.tasks, &TaskRunner::finished, this, [this] { m_reading.clear(); });
}

void FieldDeforming::open(const QString& path)
{
    read(QFile::encodeName(QFileInfo(path).absoluteFilePath()).toStdString(), {});
}

void FieldDeforming::read(const std::string& path, const FieldChoice& choice)
{
    if (m_bench.document.isEmpty() || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    const auto work = [read = m_bench.services.readField, path, choice, content = m_bench.document.content(),
                       shown = m_bench.document.frame()](TaskControl& control) {
        FieldFile file = read(path, choice, presentSurface(content, *shown), control);
        file.path = path;
        return file;
    };
    const QString title = said(Message("Deforming", "Reading %1").with(fileNameOf(path).toStdString()));
    const auto ended = [this, isInPlace = choice.isInPlace](FieldFile file) { take(std::move(file), isInPlace); };
    if (m_bench.tasks.run<FieldFile>(title, work, ended))
        m_reading = title;
}

/// Until it is read, or where it cannot be, the page says what the field of now is.
void FieldDeforming::readAnew(const FieldChoice& choice)
{
    m_page.show(m_file, m_field->nodes.size(), m_choice.isInPlace);
    read(std::string(m_file.path), choice);
}

void FieldDeforming::take(FieldFile file, bool isInPlace)
{
    if (m_bench.document.isEmpty())
        return;
    if (file.path != m_file.path || !hasField()) {
        m_kept = {};
        m_keptFaces = {};
    }
    m_field = std::make_shared<const DisplacementField>(std::exchange(file.field, {}));
    m_file = std::move(file);
    m_choice = {.step = m_file.step, .name = m_file.name, .unit = m_file.unit, .isInPlace = isInPlace};
    m_page.show(m_file, m_field->nodes.size(), isInPlace);
    m_page.showSentences(warnings());
    m_page.showKept(m_keptFaces.count());
    emit opened();
    lookAnew();
}

void FieldDeforming::forget()
{
    if (hasField() && !m_reading.isEmpty() && m_bench.tasks.title() == m_reading)
        m_bench.tasks.cancel(); // it was to be the next one
    m_field = nullptr;
    m_page.endChoosing();
    m_deformations = nullptr;
    m_kept = {};
    m_keptFaces = {};
    m_arrows.hide();
    emit refused({});
}

FieldDeformation FieldDeforming::deformation() const
{
    const FieldForm& form = m_page.form();
    FieldDeformation deformation{.field = m_field, .factor = form.factor};
    deformation.locked = form.locked;
    deformation.kept = m_kept;
    if (!m_kept.empty())
        deformation.fade = form.fade > 0 ? form.fade : usualFade * m_bench.document.content().box.diagonal().norm();
    return deformation;
}

/// Another map.
void FieldDeforming::lookAnew()
{
    if (!hasField())
        return;
    m_deformations = std::make_shared<const std::vector<Deformation>>(std::vector<Deformation>{deformation()});
    m_seenFold.reset();
    m_mapFold.reset();
    emit refused({});
    look();
}

/// The same map, looked at otherwise.
void FieldDeforming::look()
{
    if (!hasField())
        return;
    const FieldForm& form = m_page.form();
    m_stage.look(
        {.deformations = m_deformations,
         .meant = m_stage.allParts(),
         .exaggeration = form.exaggeration,
         .showsColors = form.showsColors,
         .caption = said(Message("Deforming", "Preview: deformed by %1").with(fileNameOf(m_file.path).toStdString())),
         .examine = examiner()});
    if (form.showsArrows && !m_page.isChoosing())
        m_arrows.show(m_field, form.factor * form.exaggeration);
    else
        m_arrows.hide();
}

/// Says how the field fits the parts, once its map is known.
std::function<void(const SmoothMap&, TaskControl&)> FieldDeforming::examiner()
{
    return [this, deformations = m_deformations, unit = m_file.unit,
            shown = m_bench.document.frame()](const SmoothMap& map, TaskControl& control) {
        std::vector<TriangleMesh> surfaces;
        for (std::size_t b = 0; b < shown->bodies.size(); ++b) {
            surfaces.push_back(shown->filled[b]->mesh);
            surfaces.back().vertices = shown->bodies[b]->places;
        }
        const FieldFit fit =
            fitOfField(std::get<FieldDeformation>(deformations->front()), map, surfaces, unit, control);
        QMetaObject::invokeMethod(
            this,
            [this, deformations, fit] {
                if (deformations == m_deformations)
                    showFit(fit);
            },
            Qt::QueuedConnection);
    };
}

QStringList FieldDeforming::warnings() const
{
    QStringList sentences;
    for (const Message& warning : m_file.warnings)
        sentences << said(warning);
    return sentences;
}

void FieldDeforming::showFit(const FieldFit& fit)
{
    QStringList sentences = warnings();
    if (fit.mismatch)
        sentences.prepend(said(*fit.mismatch));
    for (const Message& remark : fit.remarks)
        sentences << said(remark);
    m_page.showSentences(sentences);
    if (fit.folds())
        m_mapFold = fit.determinant.place;
    sayFold();
}

void FieldDeforming::showSeen(const DeformedFrame& seen)
{
    if (!hasField())
        return;
    const double exaggeration = m_page.form().exaggeration;
    m_page.showLargest(exaggeration != 0 ? seen.largestWay / std::abs(exaggeration) : 0);
    if (exaggeration == 1)
        m_seenFold = seen.fold;
    sayFold();
}

/// Parts that are seen as they will be say it themselves; by its map a field is judged that is looked at otherwise.
void FieldDeforming::sayFold()
{
    const std::optional<Vec3>& fold = m_page.form().exaggeration == 1 ? m_seenFold : m_mapFold;
    if (!fold)
        return emit refused({});
    emit refused(
        said(Message("Deforming", "The field turns material inside out near %1, %2, %3 mm. Take a smaller factor.")
                 .with(numberMessage(1e3 * fold->x(), 'g', 4), numberMessage(1e3 * fold->y(), 'g', 4),
                       numberMessage(1e3 * fold->z(), 'g', 4))));
}

/// In the present, as it is without the field.
void FieldDeforming::chooseKept(bool on)
{
    if (!hasField())
        return;
    if (on) {
        m_arrows.hide();
        m_bench.document.selected().setLevel(Level::Face);
    }
    m_stage.setHidden(on);
    if (!on)
        keepSelected();
}

void FieldDeforming::keepSelected()
{
    const Region& region = m_bench.document.selected().region();
    if (region.level != Level::Face)
        return look();
    m_kept = {};
    for (const auto& [body, faces] : region.items)
        m_kept = besides(std::move(m_kept), presentFaces(m_bench.document.content(), *m_bench.document.frame(), body,
                                                         {faces.begin(), faces.end()}));
    m_keptFaces = region;
    m_page.showKept(m_keptFaces.count());
    lookAnew();
}

void FieldDeforming::keepNothing()
{
    m_kept = {};
    m_keptFaces = {};
    m_page.showKept(0);
    lookAnew();
}

/// As a recipe has it; nothing where a face that stays has no number in a file, or no name says of which part it is.
std::vector<RecipeDeformation> FieldDeforming::toldInRecipe() const
{
    const FieldDeformation whole = deformation();
    RecipeField field{.file = m_file.path, .choice = m_choice, .factor = whole.factor};
    field.fade = whole.fade;
    field.locked = whole.locked;
    const FilledModel& content = m_bench.document.content();
    for (const auto& [body, faces] : m_keptFaces.items) {
        const std::size_t part = content.bodies[body]->part;
        const std::optional<std::string> name = nameOfPartAlone(*content.model, part);
        if (!name || content.model->parts[part].faces.empty())
            return {};
        KeptFaces& kept = field.kept.emplace_back();
        if (content.model->parts.size() > 1)
            kept.body = *name;
        kept.faces.assign(faces.begin(), faces.end());
    }
    return {RecipeDeformation{.bodies = {}, .what = std::move(field)}};
}

void FieldDeforming::apply()
{
    if (!hasField())
        return;
    m_page.endChoosing();
    const std::string file = fileNameOf(m_file.path).toStdString();
    const double factor = m_page.form().factor;
    const Message name = factor == 1
                             ? Message("Deforming", "Deformed by %1").with(file)
                             : Message("Deforming", "Deformed by %1, times %2").with(file, numberMessage(factor));
    m_stage.apply(m_deformations, toldInRecipe(), said(Message("Deforming", "Deforming by %1").with(file)), name);
}

} // namespace knead
