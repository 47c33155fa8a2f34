// Carries out the recipes of the gallery and makes a page of them: knead_gallery GALLERY OUT

#include "gallery/gallery.h"

#include <QCoreApplication>
#include <QDir>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() != 3) {
        std::cerr << "knead_gallery GALLERY OUT: GALLERY holds gallery.json and its recipes\n";
        return 2;
    }
    try {
        const QDir out(arguments[2]);
        QDir().mkpath(out.path());
        std::vector<nlohmann::ordered_json> pieces;
        for (const knead::gallery::Piece& piece : knead::gallery::read(arguments[1])) {
            std::cout << piece.title << ": " << std::flush;
            pieces.push_back(knead::gallery::carryOut(KNEAD_PROGRAM, piece, arguments[1], out.path()));
            std::cout << (knead::gallery::isGood(pieces.back()) ? "good" : pieces.back().value("fault", "not sound"))
                      << '\n';
            std::ofstream(out.filePath("index.html").toStdString()) << knead::gallery::pageOf(pieces);
        }
        std::cout << "See " << out.filePath("index.html").toStdString() << '\n';
        return std::all_of(pieces.begin(), pieces.end(), knead::gallery::isGood) ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << "knead_gallery: " << error.what() << '\n';
        return 1;
    }
}
