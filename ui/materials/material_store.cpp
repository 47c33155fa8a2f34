#include "ui/materials/material_store.h"

#include "core/message/message.h"
#include "ui/language/said.h"

#include <algorithm>
#include <exception>
#include <future>
#include <utility>

namespace knead {

namespace {

/// An id that no other preset has.
std::string newId(const std::vector<MaterialPreset>& all)
{
    for (int number = 1;; ++number) {
        const std::string id = "own-" + std::to_string(number);
        if (std::none_of(all.begin(), all.end(), [&](const MaterialPreset& preset) { return preset.id == id; }))
            return id;
    }
}

} // namespace

MaterialStore::MaterialStore(const Services& services, QObject* parent)
    : QObject(parent)
    , m_services(services)
    , m_all(services.materials)
    , m_bundled(services.materials.size())
{
    if (!m_services.readOwnMaterials)
        return;
    try {
        m_kept = m_services.readOwnMaterials();
        m_all.insert(m_all.end(), m_kept.begin(), m_kept.end());
    } catch (const std::exception& error) {
        m_damage =
            said(Message("MaterialStore",
                         "Your own materials cannot be read: %1 Mend or remove the file; until then none can be saved.")
                     .with(messageOf(error)));
    }
}

MaterialStore::~MaterialStore()
{
    std::promise<void> isWritten;
    m_writing.run([&isWritten] { isWritten.set_value(); });
    isWritten.get_future().wait();
}

std::optional<std::size_t> MaterialStore::find(const Material& material, const QString& preferred) const
{
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < m_all.size(); ++i)
        if (m_all[i].material == material && (!found || QString::fromStdString(m_all[i].name) == preferred))
            found = i;
    return found;
}

std::optional<std::size_t> MaterialStore::named(const QString& name) const
{
    for (std::size_t i = 0; i < m_all.size(); ++i)
        if (QString::fromStdString(m_all[i].name).compare(name.trimmed(), Qt::CaseInsensitive) == 0)
            return i;
    return std::nullopt;
}

std::optional<std::size_t> MaterialStore::withId(const std::string& id) const
{
    for (std::size_t i = 0; i < m_all.size(); ++i)
        if (m_all[i].id == id)
            return i;
    return std::nullopt;
}

QString MaterialStore::problemWith(const QString& name, std::optional<std::size_t> renamed) const
{
    if (name.trimmed().isEmpty())
        return tr("A material needs a name: type one.");
    const auto other = named(name);
    if (other && other != renamed)
        return said(Message("MaterialStore", "There is a material named \"%1\" already: choose another name.")
                        .with(name.trimmed().toStdString()));
    return {};
}

void MaterialStore::save(const QString& name, const Material& material)
{
    if (const QString problem = problemWith(name); !problem.isEmpty())
        return emit failed(problem);
    MaterialPreset preset{{}, name.trimmed().toStdString(), tr("Saved by you").toStdString(), material};
    write([preset = std::move(preset)](Presets& own) {
        own.push_back(preset);
        own.back().id = newId(own);
    });
}

void MaterialStore::rename(std::size_t index, const QString& name)
{
    if (const QString problem = problemWith(name, index); !problem.isEmpty())
        return emit failed(problem);
    write([id = m_all[index].id, name = name.trimmed().toStdString()](Presets& own) {
        for (MaterialPreset& preset : own)
            if (preset.id == id)
                preset.name = name;
    });
}

void MaterialStore::remove(std::size_t index)
{
    write([id = m_all[index].id](Presets& own) {
        std::erase_if(own, [&](const MaterialPreset& preset) { return preset.id == id; });
    });
}

/// Each change is made to what the one before has left, however quickly they follow each other. What is damaged is not written
/// over: there may be work in it.
void MaterialStore::write(std::function<void(Presets& own)> change)
{
    if (!m_damage.isEmpty())
        return emit failed(m_damage);
    m_writing.run([this, change = std::move(change), write = m_services.writeOwnMaterials] {
        Presets own = m_kept;
        change(own);
        Message problem;
        try {
            write(own);
            m_kept = own;
        } catch (const std::exception& error) {
            problem = messageOf(error);
        }
        QMetaObject::invokeMethod(
            this, [this, own, problem] { written(own, problem); }, Qt::QueuedConnection);
    });
}

void MaterialStore::written(const std::vector<MaterialPreset>& own, const Message& problem)
{
    if (!problem.empty())
        return emit failed(said(Message("MaterialStore", "The material was not saved: %1").with(problem)));
    m_all.resize(m_bundled);
    m_all.insert(m_all.end(), own.begin(), own.end());
    emit changed();
}

} // namespace knead
