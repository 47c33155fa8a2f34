#include "core/message/message.h"
#include "io/export/deformation_bytes.h"
#include "support/shapes.h"

#include <QtTest>

#include <cstring>

using namespace knead;

namespace {

std::shared_ptr<const DisplacementField> fieldOf(int count)
{
    auto field = std::make_shared<DisplacementField>();
    for (int i = 0; i < count; ++i) {
        field->nodes.emplace_back(0.1 * i, 0.01 * i * i, 1.0 / 3);
        field->displacements.emplace_back(1e-3 * i, -2e-3, 1e-300);
    }
    return field;
}

NumberDeformation numberOf(NumberKind kind)
{
    return {.kind = kind,
            .origin = Vec3(0.1, 0.2, 0.3),
            .axis = Vec3::UnitY(),
            .side = Vec3::UnitX(),
            .from = -0.01,
            .to = 1.0 / 3,
            .angle = 1.5,
            .factor = 0.7,
            .shift = 0.02,
            .neutral = 1e-3,
            .stays = 0.5,
            .eases = kind != NumberKind::bend};
}

using List = DeformationLists::List;

List listOf(std::vector<Deformation> deformations)
{
    return std::make_shared<const std::vector<Deformation>>(std::move(deformations));
}

/// Two lists with one field in common.
std::vector<List> lists()
{
    const auto shared = fieldOf(5);
    const FieldDeformation plain{.field = shared, .kept = {}};
    const FieldDeformation held{.field = shared,
                                .factor = -1,
                                .kept = shapes::box(Vec3(1, 2, 3)),
                                .fade = 0.25,
                                .locked = {false, true, false}};
    return {listOf({numberOf(NumberKind::bend), plain, numberOf(NumberKind::scale)}),
            listOf({held, FieldDeformation{.field = fieldOf(2), .kept = {}}})};
}

std::string bytesOf(const std::vector<List>& all)
{
    DeformationLists lists;
    for (const List& list : all)
        lists.add(list);
    BlockWriter blocks;
    lists.write(blocks);
    return std::move(blocks).bytes();
}

DeformationLists readFrom(const std::string& bytes)
{
    BlockReader blocks(bytes, "export job");
    return DeformationLists(blocks);
}

bool isSame(const Deformation& a, const Deformation& b)
{
    if (a.index() != b.index())
        return false;
    if (const auto* number = std::get_if<NumberDeformation>(&a))
        return *number == std::get<NumberDeformation>(b);
    const auto& one = std::get<FieldDeformation>(a);
    const auto& other = std::get<FieldDeformation>(b);
    return one.field->nodes == other.field->nodes && one.field->displacements == other.field->displacements &&
           one.factor == other.factor && one.fade == other.fade && one.locked == other.locked &&
           one.kept.vertices == other.kept.vertices && one.kept.triangles == other.kept.triangles;
}

} // namespace

class DeformationBytesTest : public QObject {
    Q_OBJECT

private slots:
    void listsComeBackAsTheyWere()
    {
        const std::vector<List> all = lists();
        const DeformationLists read = readFrom(bytesOf(all));
        for (std::size_t l = 0; l < all.size(); ++l) {
            const List list = read.at(l + 1);
            QCOMPARE(list->size(), all[l]->size());
            for (std::size_t i = 0; i < list->size(); ++i)
                QVERIFY(isSame((*list)[i], (*all[l])[i]));
        }
        QVERIFY(read.at(0) == nullptr);
        QVERIFY_EXCEPTION_THROWN(read.at(3), Problem);
    }

    void everyKindOfNumberComesBack()
    {
        for (int kind = 0; kind <= static_cast<int>(NumberKind::scale); ++kind) {
            const List list = listOf({numberOf(static_cast<NumberKind>(kind))});
            QVERIFY(isSame(readFrom(bytesOf({list})).at(1)->front(), list->front()));
        }
    }

    /// A list of many parts and a field of many lists are there once.
    void whatIsSharedIsWrittenOnce()
    {
        DeformationLists lists;
        const List list = listOf({numberOf(NumberKind::twist)});
        QCOMPARE(lists.add(nullptr), std::size_t(0));
        QCOMPARE(lists.add(listOf({})), std::size_t(0));
        QCOMPARE(lists.add(list), std::size_t(1));
        QCOMPARE(lists.add(listOf({numberOf(NumberKind::bend)})), std::size_t(2));
        QCOMPARE(lists.add(list), std::size_t(1));

        const auto field = fieldOf(1000);
        const std::vector<List> two{listOf({FieldDeformation{.field = field, .kept = {}}}),
                                    listOf({FieldDeformation{.field = field, .factor = -1, .kept = {}}})};
        QVERIFY(bytesOf(two).size() < 1.1 * bytesOf({two.front()}).size());
        const DeformationLists read = readFrom(bytesOf(two));
        QVERIFY(std::get<FieldDeformation>(read.at(1)->front()).field ==
                std::get<FieldDeformation>(read.at(2)->front()).field);
    }

    void whatIsCutOffIsRefused()
    {
        const std::string bytes = bytesOf(lists());
        for (std::size_t length = 0; length < bytes.size(); ++length)
            QVERIFY_EXCEPTION_THROWN(readFrom(bytes.substr(0, length)), Problem);
    }

    /// Any eight bytes that are others give a list that is well formed, or a sentence; never a crash.
    void whatIsDamagedIsRefusedOrWellFormed()
    {
        const std::string bytes = bytesOf(lists());
        int refused = 0;
        for (const std::uint64_t damage :
             {std::uint64_t(0), std::uint64_t(3), ~std::uint64_t(0), std::uint64_t(1) << 40U})
            for (std::size_t at = 0; at + sizeof damage <= bytes.size(); at += 8) {
                std::string damaged = bytes;
                std::memcpy(damaged.data() + at, &damage, sizeof damage);
                try {
                    const DeformationLists read = readFrom(damaged);
                    for (std::size_t l = 1; l <= 2; ++l)
                        for (const Deformation& deformation : *read.at(l))
                            if (const auto* field = std::get_if<FieldDeformation>(&deformation)) {
                                QCOMPARE(field->field->nodes.size(), field->field->displacements.size());
                                for (const TriangleMesh::Triangle& triangle : field->kept.triangles)
                                    for (const std::uint32_t corner : triangle)
                                        QVERIFY(corner < field->kept.vertices.size());
                            } else {
                                QVERIFY(std::get<NumberDeformation>(deformation).kind <= NumberKind::scale);
                            }
                } catch (const Problem&) {
                    ++refused;
                }
            }
        QVERIFY(refused > 0);
    }
};

QTEST_APPLESS_MAIN(DeformationBytesTest)
#include "deformation_bytes_test.moc"
