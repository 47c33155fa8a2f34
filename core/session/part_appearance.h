#pragma once

#include "core/document/history.h"
#include "core/model/export_job.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace knead {

/// What parts are called and how they are colored: as in their file, or as the person chose. A value; follows from the commands of
/// the history, so that it is undone, kept and recovered with them.
class PartAppearance {
public:
    /// Those of an entry.
    static PartAppearance at(const History& tree, History::Entry entry);

    /// Carries out what a command says of looks, if anything.
    void follow(const Command& command);

    /// As chosen, empty where it is that of the file. @param part index into Model::parts
    std::string chosenName(std::size_t part) const;
    std::optional<Color> chosenColor(std::size_t part) const;

    /// What is drawn: a chosen color covers those of the faces.
    Color faceColor(const Model& model, std::size_t part, std::uint32_t face) const;
    Color partColor(const Model& model, std::size_t part) const;

    /// A part, and the tree of parts, as they go into a file.
    void dress(Part& copy, std::size_t part) const;
    PartNode dressed(const PartNode& tree) const;

    friend bool operator==(const PartAppearance&, const PartAppearance&) = default;

private:
    struct Look {
        std::string name;
        std::optional<Color> color;
        friend bool operator==(const Look&, const Look&) = default;
    };
    std::map<std::size_t, Look> m_chosen; ///< by index into Model::parts
};

/// "#rrggbb", and back; none for a text that is not such.
std::string textOf(const Color& color);
std::optional<Color> colorOf(const std::string& text);

} // namespace knead
