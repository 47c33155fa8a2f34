#pragma once

#include "core/message/message.h"
#include "core/task/ordered_worker.h"
#include "ui/services.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// The materials one can choose: those that come with the program, and those that the person saved. Every change is written
/// in the background, whole or not at all, and holds when it is. Window thread only.
class MaterialStore final : public QObject {
    Q_OBJECT
public:
    explicit MaterialStore(const Services& services, QObject* parent = nullptr);
    ~MaterialStore() override; ///< when all is written

    /// First those of the program, then the person's own.
    const std::vector<MaterialPreset>& all() const { return m_all; }
    bool isOwn(std::size_t index) const { return index >= m_bundled; }
    /// Of the preset with these numbers; the one named `preferred` when there are several.
    std::optional<std::size_t> find(const Material& material, const QString& preferred = {}) const;
    std::optional<std::size_t> named(const QString& name) const;
    std::optional<std::size_t> withId(const std::string& id) const;

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
    using Presets = std::vector<MaterialPreset>;
    void write(std::function<void(Presets& own)> change);
    void written(const std::vector<MaterialPreset>& own, const Message& problem);

    Services m_services;
    std::vector<MaterialPreset> m_all;
    std::size_t m_bundled;
    QString m_damage;
    Presets m_kept;          ///< own ones as the file has them; of the thread that writes
    OrderedWorker m_writing; // last: it ends first
};

} // namespace knead
