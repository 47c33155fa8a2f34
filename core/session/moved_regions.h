#pragma once

#include "core/session/transferred_recipe.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// What a turn or a mirror image R times a scale s makes of vectors, where all stresses stay what they are.
class CarriedVectors {
public:
    explicit CarriedVectors(const Mat3& linear);

    const Mat3& turn() const { return m_turn; } ///< R
    double scale() const { return m_scale; }    ///< s
    bool mirrors() const { return m_hand < 0; }

    Vec3 carried(const Vec3& way) const { return m_scale * (m_turn * way); } ///< s R v: ways and velocities
    Vec3 spun(const Vec3& turning) const
    {
        return m_hand * (m_turn * turning);
    }                                     ///< det R R w: turning, the other way in a mirror
    void carry(LoadAmount& amount) const; ///< forces by s^2, moments by s^3

private:
    Mat3 m_turn;
    double m_scale = 1;
    double m_hand = 1;
};

/// Moves regions of a recipe to another part.
class MovedRegions {
public:
    /// Both outlive it.
    MovedRegions(const TransferGround& ground, TransferReport& report);

    /// False where nothing of it is left, which is reported. @throws UnusableInput, see bodiesNamed()
    bool move(RecipeRegion& region, const Message& what);

    /// The same for what is of whole bodies where it says nothing else.
    template <class Where>
    bool moveWhere(Where& where, const Message& what)
    {
        RecipeRegion region{.name = {}, .body = where.body, .faces = {}, .box = where.box, .objects = where.objects};
        if (!region.box && !region.objects)
            return moveBody(where.body);
        if (!move(region, what))
            return false;
        where.body = region.body;
        where.box = region.box;
        where.objects = region.objects;
        return true;
    }

    /// The name that a body has on the other part; empty stays so. False, and reported, where it is not there.
    bool moveBody(std::string& name);

    /// Where a grip turns about goes with what it holds.
    void moveTurn(const std::string& fixture, GripTurn& turn) const;

private:
    const BodyMap* mapOf(BodyId before) const;
    std::vector<const BodyMap*> mapsOf(const std::string& name) const;
    std::string nameAfter(BodyId after) const;
    bool moveFaces(RecipeRegion& region, const BodyMap& body, const Message& what);
    bool moveBox(RecipeRegion& region, const std::vector<const BodyMap*>& bodies, const Message& what);
    bool moveObjects(RecipeRegion& region, const BodyMap& body, const Message& what);
    void note(const RecipeRegion& region, const BodyMap& body, const Message& what, const Vec3& before,
              const Vec3& after);
    bool leaveOut(const Message& what, const Message& why);

    const TransferGround& m_ground;
    CarriedVectors m_vectors;
    TransferReport& m_report;
    std::map<std::string, Vec3> m_beyond; ///< of regions by their names [m], see PlaceMap
};

} // namespace knead
