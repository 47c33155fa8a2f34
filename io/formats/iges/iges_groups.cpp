#include "io/formats/iges/iges_groups.h"

#include <IGESBasic_Group.hxx>
#include <IGESBasic_SubfigureDef.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_HArray1OfIGESEntity.hxx>
#include <IGESData_IGESEntity.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <XSControl_WorkSession.hxx>

#include <unordered_set>
#include <vector>

namespace knead {

namespace {

using IgesMember = Handle(IGESData_IGESEntity);

/// Curves, surfaces, boundary representations and what their borders consist of, as IGES 5.3 numbers types. Not solids by
/// construction (150 to 184), which are not read.
bool isGeometry(const IGESData_IGESEntity& entity)
{
    const int type = entity.TypeNumber();
    return (type >= 100 && type < 150 && type != 124) || (type >= 186 && type < 200) || (type >= 500 && type < 600);
}

/// Knows what entities are made of, and what groups have had.
class MemberChoice {
public:
    MemberChoice(const Interface_Graph& graph, const Interface_InterfaceModel& model)
    {
        for (int i = 1; i <= model.NbEntities(); ++i) {
            const auto entity = IgesMember::DownCast(model.Value(i));
            if (entity.IsNull() || !isGeometry(*entity))
                continue;
            for (Interface_EntityIterator parts = graph.Shareds(entity); parts.More(); parts.Next())
                m_parts.insert(parts.Value().get());
        }
    }

    /// @return those that are no part of another entity
    std::vector<IgesMember> whole(const std::vector<IgesMember>& members) const
    {
        std::vector<IgesMember> result;
        for (const IgesMember& member : members)
            if (!isGeometry(*member) || !m_parts.contains(member.get()))
                result.push_back(member);
        return result;
    }

    /// @return those of them that no group has had
    std::vector<IgesMember> fresh(const std::vector<IgesMember>& members)
    {
        std::vector<IgesMember> result;
        for (const IgesMember& member : whole(members))
            if (!isGeometry(*member) || m_had.insert(member.get()).second)
                result.push_back(member);
        return result;
    }

private:
    std::unordered_set<const Standard_Transient*> m_parts;
    std::unordered_set<const Standard_Transient*> m_had;
};

std::vector<IgesMember> membersOf(int count, const auto& memberAt)
{
    std::vector<IgesMember> members;
    for (int i = 1; i <= count; ++i)
        if (const IgesMember member = memberAt(i); !member.IsNull())
            members.push_back(member);
    return members;
}

void reduce(IGESBasic_Group& group, MemberChoice& choice)
{
    const auto members = choice.fresh(membersOf(group.NbEntities(), [&](int i) { return group.Entity(i); }));
    if (members.empty()) { // SetNb() knows no 0
        group.Init(nullptr);
        return;
    }
    group.SetNb(static_cast<int>(members.size()));
    for (std::size_t i = 0; i < members.size(); ++i)
        group.SetValue(static_cast<int>(i) + 1, members[i]);
}

/// What a definition holds is at another place in each instance of it, so it may be in others, too.
void reduce(IGESBasic_SubfigureDef& definition, const MemberChoice& choice)
{
    const int count = definition.NbEntities();
    const auto members = choice.whole(membersOf(count, [&](int i) { return definition.AssociatedEntity(i); }));
    if (members.empty() || static_cast<int>(members.size()) == count)
        return;
    const Handle(IGESData_HArray1OfIGESEntity) list =
        new IGESData_HArray1OfIGESEntity(1, static_cast<int>(members.size()));
    for (std::size_t i = 0; i < members.size(); ++i)
        list->SetValue(static_cast<int>(i) + 1, members[i]);
    definition.Init(definition.Depth(), definition.Name(), list);
}

} // namespace

void keepMembersOnce(IGESCAFControl_Reader& reader)
{
    const Handle(Interface_InterfaceModel) model = reader.Model();
    MemberChoice choice(reader.WS()->Graph(), *model);
    constexpr int shown = 0;
    for (const bool isShown : {true, false}) // what is in a hidden group as well is shown
        for (int i = 1; i <= model->NbEntities(); ++i)
            if (const auto group = Handle(IGESBasic_Group)::DownCast(model->Value(i));
                !group.IsNull() && (group->BlankStatus() == shown) == isShown)
                reduce(*group, choice);
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (const auto definition = Handle(IGESBasic_SubfigureDef)::DownCast(model->Value(i)); !definition.IsNull())
            reduce(*definition, choice);
}

} // namespace knead
