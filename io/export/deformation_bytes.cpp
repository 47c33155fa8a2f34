#include "io/export/deformation_bytes.h"

#include "core/message/message.h"

#include <algorithm>
#include <map>

namespace knead {

namespace {

enum : std::uint8_t { byNumber, byField };

void addVector(const Vec3& v, std::vector<double>& numbers)
{
    numbers.insert(numbers.end(), v.begin(), v.end());
}

std::vector<double> numbersOf(const NumberDeformation& d)
{
    std::vector<double> numbers{static_cast<double>(d.kind), d.eases ? 1.0 : 0.0};
    for (const Vec3& v : {d.origin, d.axis, d.side})
        addVector(v, numbers);
    numbers.insert(numbers.end(), {d.from, d.to, d.angle, d.factor, d.shift, d.neutral, d.stays});
    return numbers;
}

NumberDeformation numberFrom(const std::vector<double>& numbers, const BlockReader& blocks)
{
    constexpr std::size_t count = 18;
    if (numbers.size() != count || !(numbers[0] >= 0 && numbers[0] <= static_cast<double>(NumberKind::scale)))
        blocks.fail("a deformation is none");
    const auto vectorAt = [&](std::size_t i) { return Vec3(numbers[i], numbers[i + 1], numbers[i + 2]); };
    return {.kind = static_cast<NumberKind>(static_cast<int>(numbers[0])),
            .origin = vectorAt(2),
            .axis = vectorAt(5),
            .side = vectorAt(8),
            .from = numbers[11],
            .to = numbers[12],
            .angle = numbers[13],
            .factor = numbers[14],
            .shift = numbers[15],
            .neutral = numbers[16],
            .stays = numbers[17],
            .eases = numbers[1] != 0};
}

} // namespace

std::size_t DeformationLists::add(const List& list)
{
    if (list == nullptr || list->empty())
        return 0;
    const auto found = std::ranges::find(m_lists, list);
    if (found != m_lists.end())
        return static_cast<std::size_t>(found - m_lists.begin()) + 1;
    m_lists.push_back(list);
    return m_lists.size();
}

DeformationLists::List DeformationLists::at(std::size_t number) const
{
    if (number > m_lists.size())
        throw Problem(Message::verbatim("export job: a list of deformations is missing"));
    return number == 0 ? nullptr : m_lists[number - 1];
}

void DeformationLists::write(BlockWriter& blocks) const
{
    std::map<const DisplacementField*, std::uint64_t> fields;
    std::vector<std::uint64_t> lengths; // of the lists
    for (const List& list : m_lists) {
        lengths.push_back(list->size());
        for (const Deformation& deformation : *list)
            if (const auto* field = std::get_if<FieldDeformation>(&deformation))
                fields.try_emplace(field->field.get(), fields.size());
    }
    std::vector<const DisplacementField*> inOrder(fields.size());
    for (const auto& [field, number] : fields)
        inOrder[number] = field;
    blocks.add(lengths);
    blocks.add(std::vector<std::uint64_t>{inOrder.size()});
    for (const DisplacementField* field : inOrder) {
        blocks.add(field->nodes);
        blocks.add(field->displacements);
    }
    for (const List& list : m_lists)
        for (const Deformation& deformation : *list) {
            if (const auto* number = std::get_if<NumberDeformation>(&deformation)) {
                blocks.add(std::vector<std::uint8_t>{byNumber});
                blocks.add(numbersOf(*number));
                continue;
            }
            const FieldDeformation& field = std::get<FieldDeformation>(deformation);
            blocks.add(std::vector<std::uint8_t>{byField, field.locked[0], field.locked[1], field.locked[2]});
            blocks.add(std::vector<std::uint64_t>{fields.at(field.field.get())});
            blocks.add(std::vector<double>{field.factor, field.fade});
            blocks.add(field.kept.vertices);
            blocks.add(field.kept.triangles);
        }
}

DeformationLists::DeformationLists(BlockReader& blocks)
{
    const auto lengths = blocks.nextArray<std::uint64_t>();
    const auto count = blocks.nextArray<std::uint64_t>();
    if (count.size() != 1)
        blocks.fail("the number of fields is missing");
    std::vector<std::shared_ptr<const DisplacementField>> fields;
    for (std::uint64_t i = 0; i < count.front(); ++i) {
        auto field = std::make_shared<DisplacementField>();
        field->nodes = blocks.nextArray<Vec3>();
        field->displacements = blocks.nextArray<Vec3>();
        if (field->nodes.size() != field->displacements.size())
            blocks.fail("not every node of a field has its displacement");
        fields.push_back(std::move(field));
    }
    for (const std::uint64_t length : lengths) {
        std::vector<Deformation> list;
        for (std::uint64_t i = 0; i < length; ++i) {
            const auto flags = blocks.nextArray<std::uint8_t>();
            if (flags.size() == 1 && flags.front() == byNumber) {
                list.emplace_back(numberFrom(blocks.nextArray<double>(), blocks));
                continue;
            }
            const auto number = blocks.nextArray<std::uint64_t>();
            const auto values = blocks.nextArray<double>();
            if (flags.size() != 4 || number.size() != 1 || number.front() >= fields.size() || values.size() != 2)
                blocks.fail("a deformation is none");
            FieldDeformation field{.field = fields[number.front()],
                                   .factor = values[0],
                                   .kept = {},
                                   .fade = values[1],
                                   .locked = {flags[1] != 0, flags[2] != 0, flags[3] != 0}};
            field.kept.vertices = blocks.nextArray<Vec3>();
            field.kept.triangles = blocks.nextArray<TriangleMesh::Triangle>();
            for (const TriangleMesh::Triangle& triangle : field.kept.triangles)
                for (const std::uint32_t corner : triangle)
                    if (corner >= field.kept.vertices.size())
                        blocks.fail("a triangle has a corner that is missing");
            list.emplace_back(std::move(field));
        }
        m_lists.push_back(std::make_shared<const std::vector<Deformation>>(std::move(list)));
    }
}

} // namespace knead
