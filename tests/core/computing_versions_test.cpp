#include "core/computing_versions.h"

#include <Eigen/Core>
#include <tbb/version.h>

#include <QRegularExpression>
#include <QtTest>

using namespace knead;

class ComputingVersionsTest : public QObject {
    Q_OBJECT

private slots:
    /// Of the headers that this test is compiled with, which are those of core.
    void eigenIsTheOneOfTheHeaders()
    {
        const QStringList parts = QString::fromStdString(eigenVersion()).split('.');
        QCOMPARE(parts.size(), 3);
        QCOMPARE(parts[0].toInt(), EIGEN_WORLD_VERSION);
        QCOMPARE(parts[1].toInt(), EIGEN_MAJOR_VERSION);
        QCOMPARE(parts[2].toInt(), EIGEN_MINOR_VERSION);
    }

    /// A library that runs may be newer than the headers, within what it promises to be compatible with.
    void tbbRunsWithTheInterfaceOfTheHeaders()
    {
        const QString version = QString::fromStdString(tbbVersion());
        QVERIFY2(QRegularExpression("^\\d+\\.\\d+(\\.\\d+)?$").match(version).hasMatch(), qPrintable(version));
        const QStringList parts = version.split('.');
        QCOMPARE(parts[0].toInt(), TBB_VERSION_MAJOR);
        QVERIFY(parts[1].toInt() >= TBB_VERSION_MINOR);
    }
};

QTEST_GUILESS_MAIN(ComputingVersionsTest)
#include "computing_versions_test.moc"
