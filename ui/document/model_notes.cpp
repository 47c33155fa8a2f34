#include "ui/document/model_notes.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>

namespace knead {

namespace {

constexpr std::size_t mostExports = 12;

template <class Named>
auto named(std::vector<Named>& all, const std::string& name)
{
    return std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
}

template <class Named>
std::string freeName(const std::vector<Named>& all, const std::string& base)
{
    for (int number = 1;; ++number) {
        const std::string name = base + " " + std::to_string(number);
        if (std::none_of(all.begin(), all.end(), [&](const Named& one) { return one.name == name; }))
            return name;
    }
}

} // namespace

void ModelNotes::tellEdit()
{
    emit changed();
    emit edited();
}

// --- groups ---------------------------------------------------------------------------------------------------------------

const ModelNotes::Group* ModelNotes::groupOf(std::size_t part) const
{
    const auto found = std::find_if(m_groups.begin(), m_groups.end(),
                                    [part](const Group& group) { return group.parts.contains(part); });
    return found == m_groups.end() ? nullptr : &*found;
}

void ModelNotes::addGroup(const std::string& name, const std::set<std::size_t>& parts)
{
    if (name.empty())
        return;
    for (Group& group : m_groups)
        for (const std::size_t part : parts)
            group.parts.erase(part);
    auto group = named(m_groups, name);
    if (group == m_groups.end())
        group = m_groups.insert(m_groups.end(), {name, {}});
    group->parts.insert(parts.begin(), parts.end());
    tellEdit();
}

void ModelNotes::renameGroup(const std::string& name, const std::string& to)
{
    const auto group = named(m_groups, name);
    if (group == m_groups.end() || to.empty() || name == to)
        return;
    const std::set<std::size_t> parts = group->parts;
    if (named(m_groups, to) != m_groups.end()) {
        m_groups.erase(group);
        addGroup(to, parts);
        return;
    }
    group->name = to;
    tellEdit();
}

void ModelNotes::removeGroup(const std::string& name)
{
    if (std::erase_if(m_groups, [&](const Group& group) { return group.name == name; }) > 0)
        tellEdit();
}

void ModelNotes::takeOutOfGroup(const std::set<std::size_t>& parts)
{
    for (Group& group : m_groups)
        for (const std::size_t part : parts)
            group.parts.erase(part);
    tellEdit();
}

std::string ModelNotes::freeGroupName() const
{
    return freeName(m_groups, tr("Group").toStdString());
}

// --- locks ----------------------------------------------------------------------------------------------------------------

void ModelNotes::setLocked(const std::string& key, bool on)
{
    const bool isOther = on ? m_locks.insert(key).second : m_locks.erase(key) > 0;
    if (isOther)
        tellEdit();
}

// --- selection sets -------------------------------------------------------------------------------------------------------

const SelectionSet* ModelNotes::set(const std::string& name) const
{
    const auto found =
        std::find_if(m_sets.begin(), m_sets.end(), [&](const SelectionSet& one) { return one.name == name; });
    return found == m_sets.end() ? nullptr : &*found;
}

void ModelNotes::putSet(SelectionSet set)
{
    if (const auto same = named(m_sets, set.name); same != m_sets.end())
        *same = std::move(set);
    else
        m_sets.push_back(std::move(set));
    tellEdit();
}

bool ModelNotes::renameSet(const std::string& name, const std::string& to)
{
    const auto set = named(m_sets, name);
    if (set == m_sets.end() || to.empty())
        return false;
    if (name == to)
        return true;
    if (named(m_sets, to) != m_sets.end())
        return false;
    set->name = to;
    tellEdit();
    return true;
}

void ModelNotes::removeSet(const std::string& name)
{
    if (std::erase_if(m_sets, [&](const SelectionSet& set) { return set.name == name; }) > 0)
        tellEdit();
}

std::string ModelNotes::freeSetName() const
{
    return freeName(m_sets, tr("Selection").toStdString());
}

// --- exports --------------------------------------------------------------------------------------------------------------

void ModelNotes::noteExport(const std::string& file, double wallTime)
{
    std::erase_if(m_exports, [&](const Export& one) { return one.file == file; });
    m_exports.insert(m_exports.begin(), {file, wallTime});
    if (m_exports.size() > mostExports)
        m_exports.resize(mostExports);
    emit changed();
}

void ModelNotes::forgetExport(const std::string& file)
{
    if (std::erase_if(m_exports, [&](const Export& one) { return one.file == file; }) > 0)
        emit changed();
}

// --- for projects ---------------------------------------------------------------------------------------------------------

std::string ModelNotes::memory() const
{
    QJsonArray groups;
    for (const Group& group : m_groups) {
        QJsonArray parts;
        for (const std::size_t part : group.parts)
            parts.append(static_cast<qint64>(part));
        groups.append(QJsonObject{{"name", QString::fromStdString(group.name)}, {"parts", parts}});
    }
    QJsonArray locks;
    for (const std::string& key : m_locks)
        locks.append(QString::fromStdString(key));
    QJsonArray sets;
    for (const SelectionSet& set : m_sets)
        sets.append(toJson(set));
    QJsonArray exports;
    for (const Export& one : m_exports)
        exports.append(QJsonObject{{"file", QString::fromStdString(one.file)}, {"made_at_unix_s", one.wallTime}});
    const QJsonObject all{{"groups", groups}, {"locks", locks}, {"sets", sets}, {"exports", exports}};
    return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

void ModelNotes::remember(const std::string& memory)
{
    const QJsonObject all = QJsonDocument::fromJson(QByteArray::fromStdString(memory)).object();
    m_groups.clear();
    m_locks.clear();
    m_sets.clear();
    m_exports.clear();
    for (const QJsonValue& value : all["groups"].toArray()) {
        Group group{value["name"].toString().toStdString(), {}};
        for (const QJsonValue& part : value["parts"].toArray())
            if (part.toInteger(-1) >= 0 && groupOf(static_cast<std::size_t>(part.toInteger())) == nullptr)
                group.parts.insert(static_cast<std::size_t>(part.toInteger()));
        if (!group.name.empty() && named(m_groups, group.name) == m_groups.end())
            m_groups.push_back(std::move(group));
    }
    for (const QJsonValue& key : all["locks"].toArray())
        m_locks.insert(key.toString().toStdString());
    for (const QJsonValue& value : all["sets"].toArray())
        if (std::optional<SelectionSet> set = selectionSetFrom(value.toObject());
            set && named(m_sets, set->name) == m_sets.end())
            m_sets.push_back(std::move(*set));
    for (const QJsonValue& value : all["exports"].toArray())
        m_exports.push_back({value["file"].toString().toStdString(), value["made_at_unix_s"].toDouble()});
    emit changed();
}

} // namespace knead
