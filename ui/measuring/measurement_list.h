#pragma once

#include "core/session/measurement.h"
#include "ui/document/document.h"

#include <QObject>

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace knead {

/// What was measured in the open document. Bodies that are filled anew keep their measurements, and so do parts that are deformed; who
/// takes that back finds those of before again. Another document has none. Window thread only.
class MeasurementList final : public QObject {
    Q_OBJECT
public:
    explicit MeasurementList(Document& document, QObject* parent = nullptr);

    const std::vector<Measurement>& all() const { return m_all; }
    void add(MeasureKind kind, std::vector<SkinPlace> places);
    void remove(std::size_t index);
    void clear();

signals:
    void changed();

private:
    struct Kept {
        Measurement measurement;
        std::vector<RestPlace> places;
    };

    void contentChanged();
    void keepFor(const std::shared_ptr<const Model>& model);
    void bringBack();
    void followSurfaces();

    Document& m_document;
    std::vector<Measurement> m_all;
    std::map<MeasureKind, int> m_count; ///< made so far, for their names
    std::shared_ptr<const Model> m_model;
    FilledBodies m_bodies; ///< that the places belong to
    std::uint64_t m_opening = 0;
    std::map<std::shared_ptr<const Model>, std::vector<Kept>> m_kept; ///< by the parts that were shown then
};

/// The same places on other bodies; what is no longer there is left out.
std::vector<Measurement> carriedOver(const std::vector<Measurement>& measurements, const FilledBodies& before,
                                     const FilledBodies& after);

/// The same places on deformed bodies.
std::vector<Measurement> carriedOver(const std::vector<Measurement>& measurements, const FilledBodies& before,
                                     const CarriedSurfaces& carried, const FilledBodies& after);

/// A table with a line per reading, units in columns of their own, so that numbers stay numbers: in mm, mm³, g and degrees.
/// @param measurements in the same order as `results`
QString csvOf(const std::vector<Measurement>& measurements, const std::vector<Measured>& results);

} // namespace knead
