#pragma once

#include "core/document/project.h"
#include "core/message/message.h"
#include "io/project/blobs.h"
#include "io/project/json_fields.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

struct ReadingChoices {
    bool rescues = false;    ///< takes what is whole and lists what is not, instead of throwing
    bool withMoments = true; ///< else they are null, and their blobs are not looked at
    std::uint64_t bytes = 0; ///< of the file: what is packed in it may be a hundred times that, or a gigabyte
};

/// Reads a project from the tables of a database. Trusts nothing: what comes out can be used without further checks, but for what
/// Simulation checks itself.
class ProjectReader {
public:
    ProjectReader(SQLite::Database& database, const ReadingChoices& choices, TaskControl& control);

    /// @throws DamagedData unless it rescues, or when far too much is missing; Cancelled
    Project read();

    /// Does a part of the reading; what goes wrong is thrown as DamagedData, or listed as missing when it rescues.
    /// @return whether it went well
    bool attempt(const Message& what, const std::function<void()>& read);

    /// Commands in another table. @throws Problem
    std::vector<RecordedCommand> commands(const std::string& json, const std::string& source);

    /// What is not whole, a phrase each: "the state of entry 7 (row 9 of the table blobs is missing)".
    const std::vector<Message>& missing() const { return m_missing; }

private:
    std::int64_t countOf(const std::string& table);
    Bytes blob(std::int64_t id);
    template <class Value>
    void readFields(const std::string& json, const std::string& source, Value& value);

    void readModel();
    void readToolParts();
    void readStarts();
    ProjectStart startAt(std::int64_t id);
    std::shared_ptr<const Model> modelOfStart(std::int64_t id);
    std::vector<RecipeDeformation> deformationsOfStart(std::int64_t id);
    std::size_t readBody(const Row& row, const std::shared_ptr<const Model>& model, Body& body);
    std::shared_ptr<const Aggregate> aggregateAt(std::int64_t id);
    void readEntries();
    std::uint32_t wholeEntryBefore(std::uint32_t entry) const;
    HistoryRecord entryAt(const Row& row, std::uint32_t number);
    void checkFixtures(const HistoryRecord& record);
    void readMoments();
    void readView();
    void readWords();
    void readMarks();
    void readPanels();

    SQLite::Database& m_database;
    ReadingChoices m_choices;
    TaskControl& m_control;
    std::size_t m_budget;                 ///< of what is unpacked [bytes]
    std::size_t m_longList = 1ULL << 28U; ///< numbers in all lists of objects together
    Project m_project;
    ToolPartTable m_tools;
    std::map<std::int64_t, std::shared_ptr<const Aggregate>> m_aggregates;
    std::map<std::int64_t, std::shared_ptr<const Model>> m_models; ///< of starts, by their blobs
    std::vector<std::optional<std::uint32_t>> m_starts;  ///< per start in the file: which of the project it is
    std::vector<std::optional<std::uint32_t>> m_entries; ///< the same for entries
    std::vector<Message> m_missing;
};

} // namespace knead
