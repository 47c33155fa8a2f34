#include "ui/measuring/measurement_list.h"

#include "ui/language/said.h"
#include "ui/measuring/measurement_words.h"
#include "ui/units.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

QString quoted(QString text)
{
    return '"' + text.replace('"', "\"\"") + '"';
}

QString number(double value)
{
    return QLocale::c().toString(value, 'g', 9);
}

} // namespace

MeasurementList::MeasurementList(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model)
            contentChanged();
        else if (what == Document::Change::Filling)
            followSurfaces();
    });
}

void MeasurementList::add(MeasureKind kind, std::vector<SkinPlace> places)
{
    m_all.push_back({kind, std::move(places), ++m_count[kind]});
    emit changed();
}

void MeasurementList::remove(std::size_t index)
{
    m_all.erase(m_all.begin() + static_cast<std::ptrdiff_t>(index));
    emit changed();
}

void MeasurementList::clear()
{
    m_all.clear();
    m_count.clear();
    emit changed();
}

void MeasurementList::contentChanged()
{
    const FilledModel& content = m_document.content();
    const bool isSame = content.model == m_model;
    const FilledBodies before = std::exchange(m_bodies, content.bodies);
    m_model = content.model;
    if (!isSame)
        return clear();
    m_all = carriedOver(m_all, before, m_bodies);
    emit changed();
}

/// Bodies that have come apart have other triangles.
void MeasurementList::followSurfaces()
{
    const FilledBodies before = std::exchange(m_bodies, m_document.content().bodies);
    if (m_all.empty() || std::equal(before.begin(), before.end(), m_bodies.begin(), m_bodies.end(),
                                    [](const auto& a, const auto& b) { return haveSameSurface(*a, *b); }))
        return;
    m_all = carriedOver(m_all, before, m_bodies);
    emit changed();
}

std::vector<Measurement> carriedOver(const std::vector<Measurement>& measurements, const FilledBodies& before,
                                     const FilledBodies& after)
{
    std::vector<Measurement> kept;
    for (Measurement measurement : measurements) {
        bool isThere = true;
        for (SkinPlace& place : measurement.places) {
            const auto carried = carriedOver(place, before, after);
            isThere = isThere && carried;
            place = carried.value_or(place);
        }
        if (isThere)
            kept.push_back(std::move(measurement));
    }
    return kept;
}

QString csvOf(const std::vector<Measurement>& measurements, const std::vector<Measured>& results)
{
    QString text = MeasurementList::tr("Measurement,Reading,Unit,Now,At rest,Change") + '\n';
    for (std::size_t i = 0; i < measurements.size(); ++i)
        for (const Reading& reading : results[i].readings) {
            const auto [unit, scale] = plainUnit(reading.quantity);
            const QStringList cells{quoted(nameOf(measurements[i])),
                                    quoted(said(reading.name)),
                                    unit,
                                    number(reading.now / scale),
                                    number(reading.rest / scale),
                                    number((reading.now - reading.rest) / scale)};
            text += cells.join(',') + '\n';
        }
    return text;
}

} // namespace knead
