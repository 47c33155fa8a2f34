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
    if (std::exchange(m_opening, m_document.opening()) != m_document.opening()) {
        m_kept.clear();
        m_bodies = content.bodies;
        m_model = content.model;
        return clear();
    }
    const std::shared_ptr<const Model> shown = std::exchange(m_model, content.model);
    if (m_model != shown)
        keepFor(shown);
    const FilledBodies before = std::exchange(m_bodies, content.bodies);
    if (m_model == shown)
        m_all = carriedOver(m_all, before, m_bodies);
    else if (const CarriedSurfaces* carried = m_document.carried())
        m_all = carriedOver(m_all, before, *carried, m_bodies);
    else
        bringBack();
    emit changed();
}

/// For whoever comes back to these parts. @pre m_bodies are theirs
void MeasurementList::keepFor(const std::shared_ptr<const Model>& model)
{
    std::vector<Kept>& kept = m_kept[model];
    kept.clear();
    for (const Measurement& measurement : m_all) {
        kept.push_back({measurement, {}});
        for (const SkinPlace& place : measurement.places)
            kept.back().places.push_back(restPlace(place, m_bodies));
    }
}

void MeasurementList::bringBack()
{
    m_all.clear();
    for (const Kept& kept : m_kept[m_model]) {
        Measurement measurement = kept.measurement;
        bool isThere = true;
        for (std::size_t i = 0; i < kept.places.size(); ++i) {
            const auto place = placeNear(kept.places[i], m_bodies);
            isThere = isThere && place;
            measurement.places[i] = place.value_or(measurement.places[i]);
        }
        if (isThere)
            m_all.push_back(std::move(measurement));
    }
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

namespace {

/// @param carry a place, or none
template <class Carry>
std::vector<Measurement> withPlaces(const std::vector<Measurement>& measurements, const Carry& carry)
{
    std::vector<Measurement> kept;
    for (Measurement measurement : measurements) {
        bool isThere = true;
        for (SkinPlace& place : measurement.places) {
            const std::optional<SkinPlace> carried = carry(place);
            isThere = isThere && carried;
            place = carried.value_or(place);
        }
        if (isThere)
            kept.push_back(std::move(measurement));
    }
    return kept;
}

} // namespace

std::vector<Measurement> carriedOver(const std::vector<Measurement>& measurements, const FilledBodies& before,
                                     const FilledBodies& after)
{
    return withPlaces(measurements, [&](const SkinPlace& place) { return carriedOver(place, before, after); });
}

std::vector<Measurement> carriedOver(const std::vector<Measurement>& measurements, const FilledBodies& before,
                                     const CarriedSurfaces& carried, const FilledBodies& after)
{
    return withPlaces(measurements, [&](const SkinPlace& place) { return carriedOver(place, before, carried, after); });
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
