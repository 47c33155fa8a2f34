#include "ui/probes/probe_set.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t mostFilmFrames = 300; // that are read at a time
constexpr std::size_t fewObjects = 20'000;  // of which strains are read as fast as frames come
constexpr int mostProbes = 1'000'000;       // numbers beyond that are no numbers of probes
// Distinct on light and dark ground, and for people who see few colors.
constexpr std::array colors{"#3d8bfd", "#e6a23c", "#2fa56a", "#c9579b", "#8b6fd8", "#d9622b", "#5fc2c9", "#9aa5b1"};

QColor colorOfProbe(int number)
{
    return QColor(colors[static_cast<std::size_t>(number - 1) % colors.size()]);
}

bool isEarlier(const ProbeSample& a, const ProbeSample& b)
{
    return a.time < b.time;
}

/// The film up to the present since the last reset, evenly thinned.
std::vector<PlaybackFramePointer> framesSoFar(const Timeline& timeline)
{
    std::vector<PlaybackFramePointer> frames;
    for (const Timeline::Picture& picture : timeline.pictures)
        if (picture.at <= timeline.present)
            frames.push_back(picture.frame);
    if (frames.empty())
        return frames;
    const std::uint32_t run = frames.back()->run;
    std::erase_if(frames, [run](const PlaybackFramePointer& frame) { return frame->run != run; });
    const std::size_t stride = 1 + frames.size() / mostFilmFrames;
    std::vector<PlaybackFramePointer> kept;
    for (std::size_t i = 0; i < frames.size(); i += stride)
        kept.push_back(frames[i]);
    return kept;
}

/// What was read live knows more than the film.
void merge(std::vector<ProbeSample>& live, const std::vector<ProbeSample>& film)
{
    constexpr double same = 1e-9; // [s]
    std::vector<ProbeSample> added;
    for (const ProbeSample& sample : film) {
        const auto near =
            std::lower_bound(live.begin(), live.end(), ProbeSample{.time = sample.time - same}, isEarlier);
        if (near == live.end() || near->time > sample.time + same)
            added.push_back(sample);
        else {
            near->strain = std::isfinite(near->strain) ? near->strain : sample.strain;
            near->stress = std::isfinite(near->stress) ? near->stress : sample.stress;
        }
    }
    live.insert(live.end(), added.begin(), added.end());
    std::sort(live.begin(), live.end(), isEarlier);
}

QString number(double value)
{
    return std::isfinite(value) ? QLocale::c().toString(value, 'g', 8) : QString();
}

} // namespace

ProbeSet::ProbeSet(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document, &Document::changed, this, &ProbeSet::documentChanged);
}

/// Nobody waits for the film any more.
ProbeSet::~ProbeSet()
{
    ++m_readings;
}

void ProbeSet::documentChanged(Document::Change what)
{
    if (what == Document::Change::Model) {
        contentChanged();
    } else if (what == Document::Change::Filling) {
        followBodies();
    } else if (what == Document::Change::Frame) {
        read();
    } else if (what == Document::Change::Moment && !m_all.empty()) {
        forgetAfter(m_document.frame()->snapshot->time);
        readFilm();
        read();
    }
}

/// They have other objects, and where they came apart other triangles.
void ProbeSet::followBodies()
{
    const FilledBodies before = std::exchange(m_bodies, m_document.content().bodies);
    for (Probe& probe : m_all)
        if (!haveSameSurface(*before[probe.place.body], *m_bodies[probe.place.body]))
            probe.place = carriedOver(probe.place, before, m_bodies).value_or(SkinPlace{.body = probe.place.body});
    findPlaces();
}

/// Bodies that are filled anew keep their probes, which begin again.
void ProbeSet::contentChanged()
{
    const FilledModel& content = m_document.content();
    if (std::exchange(m_opening, m_document.opening()) != m_document.opening()) {
        m_kept.clear();
        m_model = content.model;
        m_bodies = content.bodies;
        return clear();
    }
    const std::shared_ptr<const Model> shown = std::exchange(m_model, content.model);
    if (m_model != shown)
        keepFor(shown);
    const FilledBodies before = std::exchange(m_bodies, content.bodies);
    std::vector<Probe> kept;
    const auto keep = [&kept](const Probe& probe, const std::optional<SkinPlace>& place) {
        if (place)
            kept.push_back({*place, probe.number, probe.color, {}});
    };
    if (m_model == shown)
        for (const Probe& probe : m_all)
            keep(probe, carriedOver(probe.place, before, m_bodies));
    else if (const CarriedSurfaces* carried = m_document.carried())
        for (const Probe& probe : m_all)
            keep(probe, carriedOver(probe.place, before, *carried, m_bodies));
    else
        for (const Kept& earlier : m_kept[m_model])
            keep(earlier.probe, placeNear(earlier.place, m_bodies));
    m_all = std::move(kept);
    placesChanged();
}

/// For whoever comes back to these parts. @pre m_bodies are theirs
void ProbeSet::keepFor(const std::shared_ptr<const Model>& model)
{
    std::vector<Kept>& kept = m_kept[model];
    kept.clear();
    for (const Probe& probe : m_all)
        kept.push_back({{probe.place, probe.number, probe.color, {}}, restPlace(probe.place, m_bodies)});
}

void ProbeSet::add(const SkinPlace& place)
{
    ++m_count;
    m_all.push_back({place, m_count, colorOfProbe(m_count), {}});
    placesChanged();
}

void ProbeSet::remove(std::size_t index)
{
    m_all.erase(m_all.begin() + static_cast<std::ptrdiff_t>(index));
    placesChanged();
}

void ProbeSet::clear()
{
    m_all.clear();
    m_count = 0;
    placesChanged();
}

std::string ProbeSet::memory() const
{
    if (m_all.empty())
        return {};
    QJsonArray all;
    for (const Probe& probe : m_all) {
        const FilledBody& body = *m_bodies[probe.place.body];
        const Vec3 at = placeOf(probe.place, body, body.mesh.vertices);
        all.append(QJsonObject{{"number", probe.number},
                               {"body", static_cast<qint64>(probe.place.body)},
                               {"place", QJsonArray{at.x(), at.y(), at.z()}}});
    }
    return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

void ProbeSet::remember(const std::string& memory)
{
    m_all.clear();
    m_count = 0;
    const QJsonArray all = QJsonDocument::fromJson(QByteArray::fromStdString(memory)).array();
    for (const QJsonValue& value : all) {
        const auto body = static_cast<std::size_t>(value["body"].toInteger(-1));
        const int number = value["number"].toInt();
        if (body >= m_bodies.size() || number < 1 || number > mostProbes)
            continue;
        const QJsonArray at = value["place"].toArray();
        FilledBodies own(m_bodies.size()); // bodies that touch have the same places
        own[body] = m_bodies[body];
        const auto place = nearestPlace(Vec3(at[0].toDouble(), at[1].toDouble(), at[2].toDouble()), own);
        if (!place)
            continue;
        m_all.push_back({*place, number, colorOfProbe(number), {}});
        m_count = std::max(m_count, number);
    }
    placesChanged();
}

void ProbeSet::setWithStrains(bool on)
{
    if (std::exchange(m_withStrains, on) == on || !on || m_all.empty())
        return;
    m_seen = nullptr; // the present once more
    readFilm();
    read();
}

void ProbeSet::findPlaces()
{
    m_places.clear();
    for (const Probe& probe : m_all)
        m_places.push_back(probePlace(probe.place, m_bodies));
}

void ProbeSet::placesChanged()
{
    ++m_generation;
    ++m_readings;
    m_isReading = false;
    m_seen = nullptr;
    findPlaces();
    if (!m_all.empty()) {
        readFilm();
        read();
    }
    emit changed();
}

void ProbeSet::forgetAfter(double time)
{
    ++m_readings; // what is read of one may be later
    for (Probe& probe : m_all)
        std::erase_if(probe.samples, [time](const ProbeSample& sample) { return sample.time > time; });
    m_seen = nullptr;
}

/// What stands still is read whole: nobody waits for the next frame.
bool ProbeSet::readsStrains(const Snapshot& snapshot) const
{
    return m_withStrains || !snapshot.playing || snapshot.objects <= fewObjects;
}

/// The newest frame, when the one before is done.
void ProbeSet::read()
{
    if (m_all.empty() || m_isReading || m_document.frame()->snapshot == m_seen)
        return;
    m_isReading = true;
    m_seen = m_document.frame()->snapshot;
    m_reading.run(
        [this, generation = m_generation, places = m_places, snapshot = m_seen, with = readsStrains(*m_seen)] {
            const auto tell = [this, generation, samples = readProbes(places, *snapshot, with)] {
                take(generation, samples);
            };
            QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
        });
}

void ProbeSet::take(std::uint64_t generation, const std::vector<ProbeSample>& samples)
{
    if (generation != m_generation)
        return;
    m_isReading = false;
    for (std::size_t i = 0; i < m_all.size(); ++i) {
        auto& known = m_all[i].samples;
        if (!known.empty() && known.back().time > samples[i].time) // what is read of the film was later, too
            ++m_readings;
        while (!known.empty() && known.back().time >= samples[i].time) // back after a reset, or the same moment again
            known.pop_back();
        known.push_back(samples[i]);
    }
    emit sampled();
    read();
}

void ProbeSet::readFilm()
{
    const std::vector<PlaybackFramePointer> frames = framesSoFar(m_document.timeline());
    if (frames.empty())
        return;
    m_reading.run([this, film = ++m_readings, places = m_places, frames, with = m_withStrains] {
        std::vector<std::vector<ProbeSample>> samples(places.size());
        for (const PlaybackFramePointer& frame : frames) {
            if (film != m_readings)
                return;
            const std::vector<ProbeSample> read = readProbes(places, *frame, with);
            for (std::size_t i = 0; i < read.size(); ++i)
                samples[i].push_back(read[i]);
        }
        const auto tell = [this, film, samples = std::move(samples)] { takeFilm(film, samples); };
        QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
    });
}

void ProbeSet::takeFilm(std::uint64_t film, const std::vector<std::vector<ProbeSample>>& samples)
{
    if (film != m_readings)
        return;
    for (std::size_t i = 0; i < m_all.size(); ++i)
        merge(m_all[i].samples, samples[i]);
    emit sampled();
}

QString csvOf(const std::vector<Probe>& probes)
{
    QStringList header{QStringLiteral("time [s]")};
    std::map<double, QStringList> lines; // by time
    for (std::size_t p = 0; p < probes.size(); ++p) {
        const QString name = ProbeSet::tr("Probe %1").arg(probes[p].number);
        header << name + " displacement [mm]" << name + " equivalent strain [-]" << name + " von Mises stress [MPa]"
               << name + " tool force [N]";
        for (const ProbeSample& sample : probes[p].samples) {
            QStringList& cells = lines[sample.time];
            cells.resize(static_cast<qsizetype>(4 * p));
            cells << number(1e3 * sample.displacement) << number(sample.strain) << number(1e-6 * sample.stress)
                  << number(sample.force);
        }
    }
    QString text = header.join(',') + '\n';
    for (auto& [time, cells] : lines) {
        cells.resize(static_cast<qsizetype>(4 * probes.size()));
        text += number(time) + ',' + cells.join(',') + '\n';
    }
    return text;
}

} // namespace knead
