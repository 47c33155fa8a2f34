#include "io/iges_groups.h"

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

/// Curves, surfaces, solids and what their borders consist of, as IGES 5.3 numbers types.
bool isGeometry(const IGESData_IGESEntity& entity)
{
    const int type = entity.TypeNumber();
    return (type >= 100 && type < 200 && type != 124) || (type >= 500 && type < 600);
}

/// Remembers what has been seen in other groups, and what entities are made of.
class MemberChoice {
public:
    explicit MemberChoice(const Interface_Graph& graph, const Interface_InterfaceModel& model)
    {
        for (int i = 1; i <= model.NbEntities(); ++i) {
            const auto entity = IgesMember::DownCast(model.Value(i));
            if (entity.IsNull() || !isGeometry(*entity))
                continue;
            for (Interface_EntityIterator parts = graph.Shareds(entity); parts.More(); parts.Next())
                m_taken.insert(parts.Value().get());
        }
    }

    /// @return those that are to stay
    std::vector<IgesMember> chosen(const std::vector<IgesMember>& members)
    {
        std::vector<IgesMember> result;
        for (const IgesMember& member : members)
            if (!isGeometry(*member) || m_taken.insert(member.get()).second)
                result.push_back(member);
        return result;
    }

private:
    std::unordered_set<const Standard_Transient*> m_taken;
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
    const auto members = choice.chosen(membersOf(group.NbEntities(), [&](int i) { return group.Entity(i); }));
    group.SetNb(static_cast<int>(members.size()));
    for (std::size_t i = 0; i < members.size(); ++i)
        group.SetValue(static_cast<int>(i) + 1, members[i]);
}

void reduce(IGESBasic_SubfigureDef& definition, MemberChoice& choice)
{
    const int count = definition.NbEntities();
    const auto members = choice.chosen(membersOf(count, [&](int i) { return definition.AssociatedEntity(i); }));
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
    for (int i = 1; i <= model->NbEntities(); ++i) {
        if (const auto group = Handle(IGESBasic_Group)::DownCast(model->Value(i)); !group.IsNull())
            reduce(*group, choice);
        else if (const auto definition = Handle(IGESBasic_SubfigureDef)::DownCast(model->Value(i));
                 !definition.IsNull())
            reduce(*definition, choice);
    }
}

} // namespace knead
