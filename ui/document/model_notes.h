#pragma once

#include "ui/selection/selection_set.h"

#include <QObject>
#include <QString>

#include <set>
#include <string>
#include <vector>

namespace knead {

/// What a person notes in the model tree, and what neither the material nor the history knows of: groups of parts, locks, selection
/// sets, and which files were written. A project keeps it with its panels. Window thread.
class ModelNotes final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    struct Group {
        std::string name;            ///< unique
        std::set<std::size_t> parts; ///< by index into Model::parts; in one group at most
    };
    struct Export {
        std::string file;
        double wallTime = 0; ///< [s since 1970]
    };

    const std::vector<Group>& groups() const { return m_groups; }
    const Group* groupOf(std::size_t part) const;
    void addGroup(const std::string& name, const std::set<std::size_t>& parts); ///< or to the one that is there
    void renameGroup(const std::string& name, const std::string& to);           ///< a name that is taken joins them
    void removeGroup(const std::string& name);                                  ///< its parts stay
    void takeOutOfGroup(const std::set<std::size_t>& parts);
    std::string freeGroupName() const;

    /// Locks name what they lock: "part 3", "tool Block 1".
    bool isLocked(const std::string& key) const { return m_locks.contains(key); }
    void setLocked(const std::string& key, bool on);

    const std::vector<SelectionSet>& sets() const { return m_sets; }
    const SelectionSet* set(const std::string& name) const;
    void putSet(SelectionSet set); ///< in place of the one with its name
    /// @return false, and nothing happens, when another one has that name
    bool renameSet(const std::string& name, const std::string& to);
    void removeSet(const std::string& name);
    std::string freeSetName() const;

    const std::vector<Export>& exports() const { return m_exports; } ///< each file once, the last one first
    void noteExport(const std::string& file, double wallTime);
    void forgetExport(const std::string& file);

    /// For a project file; and back. A text that is none is as if nothing was noted.
    std::string memory() const;
    void remember(const std::string& memory);

signals:
    void changed();
    void edited(); ///< something that should not be lost

private:
    void tellEdit();

    std::vector<Group> m_groups;
    std::set<std::string> m_locks;
    std::vector<SelectionSet> m_sets;
    std::vector<Export> m_exports;
};

} // namespace knead
