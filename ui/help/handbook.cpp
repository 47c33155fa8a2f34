#include "ui/help/handbook.h"

#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <QTextDocument>

#include <algorithm>

namespace knead::handbook {

namespace {

Page read(const QString& name)
{
    QFile file(":/handbook/" + name + ".md");
    if (!file.open(QFile::ReadOnly))
        return {name, name, {}, {}};
    static const QRegularExpression elsewhere(R"((?<!!)\[([^\]]+)\]\((?!http)[^)]*(?<!\.md)\))"); // files, not pages
    const QString text = QString::fromUtf8(file.readAll()).replace(elsewhere, R"(\1)");
    QTextDocument read;
    read.setMarkdown(text);
    return {name, text.section('\n', 0, 0).remove(QStringLiteral("# ")), text, read.toPlainText()};
}

} // namespace

const std::vector<Page>& pages()
{
    static const std::vector<Page> all = [] {
        std::vector<Page> read;
        for (const char* name : {"keys",      "opening",   "hands",        "selecting",    "seeing",  "measuring",
                                 "history",   "keeping",   "exporting",    "deforming",    "fields",  "compensating",
                                 "nodes",     "revisions", "preferences",  "command-line", "recipes", "python",
                                 "mechanics", "speed",     "construction", "limits"})
            read.push_back(handbook::read(name));
        return read;
    }();
    return all;
}

const Page* pageNamed(const QString& name)
{
    const auto found =
        std::find_if(pages().begin(), pages().end(), [&name](const Page& page) { return page.name == name; });
    return found == pages().end() ? nullptr : &*found;
}

qsizetype hitsIn(const Page& page, const QString& wanted)
{
    qsizetype hits = 0;
    for (const QString& word : wanted.split(' ', Qt::SkipEmptyParts)) {
        const qsizetype count = page.words.count(word, Qt::CaseInsensitive);
        if (count == 0)
            return 0;
        hits += count;
    }
    return hits;
}

QString pageOfPlace(const QString& name)
{
    static const QHash<QString, QString> pageOf{
        // panels; that of the properties goes by what is selected
        {"modelDock", "selecting"},
        {"historyDock", "history"},
        {"simulationDock", "measuring"},
        {"displayDock", "seeing"},
        {"handsDock", "hands"},
        {"timelineDock", "history"},
        {"logDock", "seeing"},
        {"importDock", "opening"},
        {"exportDock", "exporting"},
        {"deformDock", "deforming"},
        {"performanceDock", "speed"},
        {"measureDock", "measuring"},
        {"probeDock", "measuring"},
        {"forcesDock", "hands"},
        {"traceDock", "python"},
        {"sculptBar", "hands"},
        {"selectionBar", "selecting"},
        {"homePage", "opening"},
        // dialogs
        {"importDialog", "opening"},
        {"openDialog", "opening"},
        {"addPartDialog", "opening"},
        {"exportDialog", "exporting"},
        {"exportFileDialog", "exporting"},
        {"fieldDialog", "deforming"},
        {"recipeDialog", "recipes"},
        {"otherPartDialog", "revisions"},
        {"otherPartBox", "revisions"},
        {"otherPartOptions", "revisions"},
        {"preferencesDialog", "preferences"},
        {"recordDialog", "history"},
        {"recordFileDialog", "history"},
        {"pictureDialog", "seeing"},
        {"pictureFileDialog", "seeing"},
        {"comparisonDialog", "measuring"},
        {"materialComparison", "measuring"},
        {"materialNameDialog", "measuring"},
        {"textFileDialog", "measuring"},
        {"partColorDialog", "selecting"},
        {"saveDialog", "keeping"},
        {"saveQuestion", "keeping"},
        {"recoveryDialog", "keeping"},
        {"discardBox", "keeping"},
        {"missingBox", "keeping"},
        {"controlsBox", "keys"},
        {"aboutBox", "construction"},
    };
    return pageOf.value(name);
}

} // namespace knead::handbook
