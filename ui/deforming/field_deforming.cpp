#include "ui/deforming/field_deforming.h"

#include "ui/deforming/field_page.h"
#include "ui/frame/notices.h"
#include "ui/language/said.h"
#include "ui/selection/selection_model.h"

#include <QFile>
#include <QFileInfo>
#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr double usualFade = 0.1; // of the size of the parts

QString fileNameOf(const std::string& path)
{
    return QFileInfo(QFile::decodeName(path.c_str())).fileName();
}

/// The triangles of some faces of a body, where they are now.
void addFaces(const FilledBody& body, const BodyFrame& shown, const Region::Items& faces, TriangleMesh& mesh)
{
    for (std::size_t t = 0; t < body.mesh.triangles.size(); ++t) {
        if (t >= body.mesh.faceOfTriangle.size() || !std::ranges::binary_search(faces, body.mesh.faceOfTriangle[t]))
            continue;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const Vec3& corner : cornersOf(shown.places, body.mesh.triangles[t]))
            mesh.vertices.push_back(corner);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
}

} // namespace

FieldDeforming::FieldDeforming(const Workbench& bench, DeformStage& stage, FieldPage& page)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_stage(stage)
    , m_page(page)
    , m_arrows(bench.viewport)
{
    connect(&page, &FieldPage::choiceChanged, this, [this](const FieldChoice& choice) { read(m_path, choice); });
    connect(&page, &FieldPage::changed, this, &FieldDeforming::lookAnew);
    connect(&page, &FieldPage::lookChanged, this, &FieldDeforming::look);
    connect(&page, &FieldPage::keepToggled, this, &FieldDeforming::chooseKept);
    connect(&page, &FieldPage::keepNothingClicked, this, &FieldDeforming::keepNothing);
    connect(&stage, &DeformStage::seen, this, &FieldDeforming::showSeen);
    connect(&stage, &DeformStage::failed, this, [this](const QString& sentence) {
        if (hasField())
            emit refused(sentence);
    });
}

void FieldDeforming::open(const QString& path)
{
    read(QFile::encodeName(path).toStdString(), {});
}

void FieldDeforming::read(const std::string& path, const FieldChoice& choice)
{
    if (m_bench.document.isEmpty() || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    const auto work = [read = m_bench.services.readField, path, choice](TaskControl& control) {
        FieldFile file = read(path, choice, control);
        file.path = path;
        return file;
    };
    m_bench.tasks.run<FieldFile>(said(Message("Deforming", "Reading %1").with(fileNameOf(path).toStdString())), work,
                                 [this](FieldFile file) { take(std::move(file)); });
}

void FieldDeforming::take(FieldFile file)
{
    if (m_bench.document.isEmpty())
        return;
    m_warnings.clear();
    for (const Message& warning : file.warnings)
        m_warnings << said(warning);
    const bool isOther = file.path != m_path || !hasField();
    m_path = file.path;
    m_unit = file.unit;
    m_page.show(file);
    m_page.showSentences(m_warnings);
    m_field = std::make_shared<const DisplacementField>(std::move(file.field));
    if (isOther) {
        m_kept = {};
        m_keptFaces = 0;
    }
    m_page.showKept(m_keptFaces);
    emit opened();
    lookAnew();
}

void FieldDeforming::forget()
{
    m_field = nullptr;
    m_page.endChoosing();
    m_whole = nullptr;
    m_kept = {};
    m_keptFaces = 0;
    m_arrows.hide();
    emit refused({});
}

FieldDeformation FieldDeforming::deformation(double factor) const
{
    const FieldForm& form = m_page.form();
    FieldDeformation deformation{.field = m_field, .factor = factor};
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
    m_whole = std::make_shared<const std::vector<Deformation>>(std::vector<Deformation>{deformation(1)});
    look();
}

/// The same map: its ways grow with the factor.
void FieldDeforming::look()
{
    if (!hasField())
        return;
    const FieldForm& form = m_page.form();
    const double scale = form.factor * form.exaggeration;
    emit refused({});
    m_stage.look(
        {.deformations = m_whole,
         .meant = m_stage.allParts(),
         .scale = scale,
         .showsColors = form.showsColors,
         .caption = said(Message("Deforming", "Preview: deformed by %1").with(fileNameOf(m_path).toStdString())),
         .examine = examiner()});
    if (form.showsArrows && !m_page.isChoosing())
        m_arrows.show(m_field, scale);
    else
        m_arrows.hide();
}

/// Says how the field fits the parts, once its map is known.
std::function<void(const SmoothMap&, TaskControl&)> FieldDeforming::examiner()
{
    return [this, field = m_field, whole = m_whole, unit = m_unit,
            shown = m_bench.document.frame()](const SmoothMap& map, TaskControl& control) {
        std::vector<TriangleMesh> surfaces;
        for (std::size_t b = 0; b < shown->bodies.size(); ++b) {
            surfaces.push_back(shown->filled[b]->mesh);
            surfaces.back().vertices = shown->bodies[b]->places;
        }
        const FieldFit fit = fitOfField(std::get<FieldDeformation>(whole->front()), map, surfaces, unit, control);
        QMetaObject::invokeMethod(
            this,
            [this, field, fit] {
                if (field == m_field)
                    showFit(fit);
            },
            Qt::QueuedConnection);
    };
}

void FieldDeforming::showFit(const FieldFit& fit)
{
    QStringList sentences = m_warnings;
    if (fit.mismatch)
        sentences.prepend(said(*fit.mismatch));
    for (const Message& remark : fit.remarks)
        sentences << said(remark);
    m_page.showSentences(sentences);
}

void FieldDeforming::showSeen(const DeformedFrame& seen)
{
    if (!hasField())
        return;
    const FieldForm& form = m_page.form();
    const double exaggeration = std::abs(form.exaggeration);
    m_page.showLargest(exaggeration > 0 ? seen.largestWay / exaggeration : 0);
    emit refused(
        seen.fold && exaggeration <= 1
            ? said(
                  Message("Deforming", "The field turns material inside out near %1, %2, %3 mm. Take a smaller factor.")
                      .with(numberMessage(1e3 * seen.fold->x(), 'g', 4), numberMessage(1e3 * seen.fold->y(), 'g', 4),
                            numberMessage(1e3 * seen.fold->z(), 'g', 4)))
            : QString());
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
    const Frame& frame = *m_bench.document.frame();
    m_kept = {};
    for (const auto& [body, faces] : region.items)
        addFaces(*frame.filled[body], *frame.bodies[body], faces, m_kept);
    m_keptFaces = region.count();
    m_page.showKept(m_keptFaces);
    lookAnew();
}

void FieldDeforming::keepNothing()
{
    m_kept = {};
    m_keptFaces = 0;
    m_page.showKept(0);
    lookAnew();
}

void FieldDeforming::apply()
{
    if (!hasField())
        return;
    m_page.endChoosing();
    const std::string file = fileNameOf(m_path).toStdString();
    const double factor = m_page.form().factor;
    const Message name = factor == 1
                             ? Message("Deforming", "Deformed by %1").with(file)
                             : Message("Deforming", "Deformed by %1, times %2").with(file, numberMessage(factor));
    m_stage.apply(std::make_shared<const std::vector<Deformation>>(std::vector<Deformation>{deformation(factor)}),
                  said(Message("Deforming", "Deforming by %1").with(file)), name);
}

} // namespace knead
