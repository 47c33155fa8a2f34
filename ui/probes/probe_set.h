#pragma once

#include "core/session/probe_readings.h"
#include "core/task/ordered_worker.h"
#include "ui/document/document.h"

#include <QColor>
#include <QObject>

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace knead {

/// A place that is watched while time runs.
struct Probe {
    SkinPlace place;
    int number = 1; ///< from 1
    QColor color;
    std::vector<ProbeSample> samples; ///< by ascending time, since the last reset
};

/// The probes of the open document. They read what time brings, and of what was before them what the film has kept. Where one
/// goes back, they forget what came after. Where parts are deformed they go along, and who takes that back finds those of before again. Readings are taken on a thread of their own, always of the newest frame.
/// Window thread only.
class ProbeSet final : public QObject {
    Q_OBJECT
public:
    explicit ProbeSet(Document& document, QObject* parent = nullptr);
    ~ProbeSet() override;

    const std::vector<Probe>& all() const { return m_all; }
    void add(const SkinPlace& place);
    void remove(std::size_t index);
    void clear();

    /// As a project keeps them: a JSON text of where they are on the bodies as they were filled; empty: there are
    /// none.
    std::string memory() const;
    /// The other way; what is no such text, or belongs to other bodies, is none.
    void remember(const std::string& memory);

    /// Whether strain and stress are read while time runs, too, however many objects there are: it takes longer the
    /// more they are.
    void setWithStrains(bool on);

signals:
    void changed(); ///< which there are
    void sampled();

private:
    struct Kept {
        Probe probe; ///< without samples
        RestPlace place;
    };

    void documentChanged(Document::Change what);
    void contentChanged();
    void keepFor(const std::shared_ptr<const Model>& model);
    void followBodies();
    void findPlaces();
    void placesChanged();
    void forgetAfter(double time);
    bool readsStrains(const Snapshot& snapshot) const;
    void read();
    void readFilm();
    void take(std::uint64_t generation, const std::vector<ProbeSample>& samples);
    void takeFilm(std::uint64_t film, const std::vector<std::vector<ProbeSample>>& samples);

    Document& m_document;
    std::vector<Probe> m_all;
    int m_count = 0;
    bool m_withStrains = false;
    std::shared_ptr<const Model> m_model;
    FilledBodies m_bodies;
    std::uint64_t m_opening = 0;
    std::map<std::shared_ptr<const Model>, std::vector<Kept>> m_kept; ///< by the parts that were shown then
    std::vector<ProbePlace> m_places;
    std::uint64_t m_generation = 0;            ///< of the places; readings of earlier ones are dropped
    std::atomic<std::uint64_t> m_readings = 0; ///< readings of the film that began; only the last one goes on
    bool m_isReading = false;
    SnapshotPointer m_seen;  ///< that is read, or was last
    OrderedWorker m_reading; // last: it ends first
};

/// A table with a line per moment: time, and per probe what it read, with units in the header.
QString csvOf(const std::vector<Probe>& probes);

} // namespace knead
