#include "core/model/file_formats.h"

#include <QtTest>

using namespace knead;

class FileFormatsTest : public QObject {
    Q_OBJECT

private slots:
    void sentencesListTheFormats()
    {
        QCOMPARE(formatNames(" or "), std::string("STEP, IGES, BREP, STL, OBJ, PLY, glTF or 3MF"));
        QCOMPARE(formatNames(" and ", [](const FileFormat& format) { return format.isSmooth; }),
                 std::string("STEP, IGES and BREP"));
        QCOMPARE(formatEndings(" and "), std::string(".step, .stp, .iges, .igs, .brep, .brp, .stl, .obj, .ply, .glb, "
                                                     ".gltf, .3mf and .vtp"));
    }

    void theEndingTellsWhatIsWritten()
    {
        for (const FileFormat& format : fileFormats)
            for (const std::string& ending : format.endings)
                QCOMPARE(formatToWrite("/tmp/a.b." + ending), &formatOf(format.kind));
        QCOMPARE(formatToWrite("A.STP"), &formatOf(FormatKind::Step));
        for (const char* other : {"a.p21", "a.png", "step", "a.step/b", ""})
            QVERIFY(formatToWrite(other) == nullptr);
        QVERIFY(isPicture("a.PNG") && !isPicture("png"));
    }

    void whatIsReadHasMoreEndings()
    {
        QVERIFY(isNamedAs(FormatKind::Step, "gear.P21") && isNamedAs(FormatKind::Step, "gear.stp"));
        QVERIFY(!isNamedAs(FormatKind::Step, "gear.igs"));
    }
};

QTEST_GUILESS_MAIN(FileFormatsTest)
#include "file_formats_test.moc"
