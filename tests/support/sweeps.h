#pragma once

#include "support/workshop.h"

#include <QFile>

#include <string>

/// Sweeps of a recipe that takes milliseconds.
namespace sweeps {

using namespace workshop;

/// A bar of 81 objects, pushed for a hundredth of a second.
inline json tinyRecipe()
{
    json recipe = pressRecipe();
    recipe["spacing_mm"] = 5;
    recipe["duration_s"] = 0.01;
    recipe["manipulators"][0]["keyframes"] = json::parse(R"([{"time_s": 0.01, "position_mm": [35, 5, 12]}])");
    recipe["exports"] = json::parse(R"([{"file": "bent.stl"}])");
    return recipe;
}

/// Twenty points: four stiffnesses, five sizes.
inline QStringList twentyPoints()
{
    return {"--vary", "material.youngs_modulus_pa=1e5:1e6:log:4", "--vary", "manipulators.press.size_mm.0=4:8:lin:5"};
}

inline QStringList sweepArguments(const QString& recipe, const QString& folder, const QStringList& more)
{
    return QStringList{"sweep", recipe, "--out", folder} + more;
}

inline std::string contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : "";
}

inline std::string tableIn(const QString& folder)
{
    return contentOf(folder + "/sweep.csv");
}

/// Lines and cells of comma-separated values as RFC 4180 has them.
inline std::vector<QStringList> rowsOf(const std::string& table)
{
    std::vector<QStringList> rows(1, {QString()});
    bool isQuoted = false;
    for (const char character : table)
        if (character == '"')
            isQuoted = !isQuoted; // of the two that mean one, the second begins again; none of these tables has them
        else if (character == ',' && !isQuoted)
            rows.back() << QString();
        else if (character == '\n' && !isQuoted)
            rows.push_back({QString()});
        else
            rows.back().back() += QChar(character);
    rows.pop_back();
    return rows;
}

inline int resultsIn(const QString& folder)
{
    return static_cast<int>(QDir(folder + "/points").entryList({"*.json"}, QDir::Files).size());
}

} // namespace sweeps
