#pragma once

#include <nlohmann/json.hpp>

#include <QString>

#include <string>
#include <vector>

namespace knead::gallery {

/// A part sculpted by a recipe.
struct Piece {
    std::string name;  ///< of the recipe's file, without its ending
    std::string title; ///< of the page
    std::string line;  ///< what happens, in one sentence
};

/// What stands in gallery.json of a folder, in its order.
/// @throws std::runtime_error, nlohmann::json::exception
std::vector<Piece> read(const QString& folder);

/// Carries out the recipe of a piece into OUT/NAME: its exports, and before.png, the same picture at the start with
/// the tools.
/// @param coarser the spacing in terms of that of the recipe: 1 as it is shown
/// @return what came of it: "title", "line", "name", "step", "after" and "before" (files in OUT), "objects", "bodies",
/// "faces_before", "faces_after", "smooth" and "sound" (numbers of bodies), "volume_error" (of the file against the
/// skin, as a share), "off_mm" (of the file from the skin, at most), "run_s", "said"; or "fault"
nlohmann::ordered_json carryOut(const QString& program, const Piece& piece, const QString& folder, const QString& out,
                                double coarser = 1);

/// Whether all bodies are sound and have smooth faces, and nothing is said about them.
bool isGood(const nlohmann::ordered_json& piece);

/// A page with pictures before and after, and a table of facts.
std::string pageOf(const std::vector<nlohmann::ordered_json>& pieces);

} // namespace knead::gallery
