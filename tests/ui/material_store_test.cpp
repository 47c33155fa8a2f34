#include "ui/materials/material_store.h"

#include <QtTest>

#include <chrono>
#include <stdexcept>
#include <thread>

using namespace knead;

/// Materials of one's own, written to a disk that takes its time.
class MaterialStoreTest : public QObject {
    Q_OBJECT

    std::vector<MaterialPreset> m_file;

    Services services()
    {
        Services services;
        services.readOwnMaterials = [this] { return m_file; };
        services.writeOwnMaterials = [this](const std::vector<MaterialPreset>& presets) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            m_file = presets;
        };
        return services;
    }

    static Material softer(double factor)
    {
        Material material;
        material.youngsModulus /= factor;
        return material;
    }

private slots:
    void init() { m_file.clear(); }

    void changesThatFollowEachOtherQuicklyAreAllKept()
    {
        MaterialStore store(services());
        store.save("First", softer(2));
        store.save("Second", softer(3));
        QTRY_COMPARE(store.all().size(), std::size_t{2});
        QVERIFY(store.all()[0].id != store.all()[1].id);
        store.remove(0);
        store.rename(1, "Third");
        QTRY_COMPARE(QString::fromStdString(store.all().front().name), QString("Third"));
        QCOMPARE(store.all().size(), std::size_t{1});
        QCOMPARE(m_file.size(), std::size_t{1});
        QCOMPARE(m_file[0].name, std::string("Third"));
        QCOMPARE(m_file[0].material, softer(3));
    }

    void whatIsSavedAtTheEndIsWritten()
    {
        {
            MaterialStore store(services());
            store.save("First", softer(2));
            store.save("Second", softer(3));
        }
        QCOMPARE(m_file.size(), std::size_t{2});
        const MaterialStore again(services());
        QVERIFY(again.named("second").has_value());
    }

    void aFailureLeavesEverythingAsItWas()
    {
        Services failing = services();
        failing.writeOwnMaterials = [](const std::vector<MaterialPreset>&) {
            throw std::runtime_error("materials.json: no room. Make room on the disk.");
        };
        MaterialStore store(failing);
        QSignalSpy failed(&store, &MaterialStore::failed);
        store.save("First", softer(2));
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toString().contains("no room"));
        QVERIFY(store.all().empty());
    }
};

QTEST_MAIN(MaterialStoreTest)
#include "material_store_test.moc"
