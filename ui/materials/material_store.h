#pragma once

#include "ui/services.h"
#include "ui/tasks/ordered_worker.h"

#include <QObject>
#include <QString>

#include <vector>

namespace knead {

/// The materials one can choose: those that come with the program, and those that the person saved. Every change is written
/// in the background, whole or not at all, and holds when it is. Window thread only.
class MaterialStore final : public QObject {
    Q_OBJECT
public:
    explicit MaterialStore(const Services& services, QObject* parent = nullptr);

    /// First those of the program, then the person's own.
    const std::vector<MaterialPreset>& all() const { return m_all; }
    bool isOwn(std::size_t index) const { return index >= m_bundled; }
    /// Of the preset with these numbers; the one named `preferred` when there are several.
    std::optional<std::size_t> find(const Material& material, const QString& preferred = {}) const;
    std::optional<std::size_t> named(const QString& name) const;

    /// Why a name cannot be given, a sentence; empty when it can.
    /// @param renamed index of the one that gets it; none: a new one
    QString problemWith(const QString& name, std::optional<std::size_t> renamed = {}) const;

    void save(const QString& name, const Material& material);
    void rename(std::size_t index, const QString& name); ///< of an own one
    void remove(std::size_t index);                      ///< of an own one

    /// Why own materials could not be read, a sentence; empty when they could.
    const QString& damage() const { return m_damage; }

signals:
    void changed();
    void failed(const QString& sentence); ///< nothing has changed

private:
    std::vector<MaterialPreset> own() const;
    void write(std::vector<MaterialPreset> own);
    void written(const std::vector<MaterialPreset>& own, const QString& problem);

    Services m_services;
    std::vector<MaterialPreset> m_all;
    std::size_t m_bundled;
    QString m_damage;
    OrderedWorker m_writing; // last: it ends first
};

} // namespace knead
