#pragma once

#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

/// A solid of an example, lengths in mm, with its name and its sRGB color.
struct ExampleBody {
    std::string name;
    TopoDS_Shape shape;
    double red = 0;
    double green = 0;
    double blue = 0;
};

/// A bar of 160 x 20 x 20 mm, to bend, twist and stretch.
std::vector<ExampleBody> makeBar();

/// An angle bracket with holes and rounded corners, and the bushing in its upper hole.
std::vector<ExampleBody> makeBracket();

/// A lump of 60 x 40 x 24 mm with rounded edges, flat below.
std::vector<ExampleBody> makeLump();

/// The bar of the published scenes, 10 x 10 x 34 mm: 5 x 5 x 17 objects of 2 mm.
std::vector<ExampleBody> makePaperBar();

/// A plate of 60 x 44 x 6 mm with rounded corners, to break.
std::vector<ExampleBody> makePlate();

/// A grip to be kneaded, 120 mm long: it lies on its flat side.
std::vector<ExampleBody> makeGrip();

/// A curved grip that stands upright, with a swelling for the palm, and the metal ferrule below it.
std::vector<ExampleBody> makeHandle();

/// A steel tube of 20 x 2 mm along x, 200 mm long, to be bent by number.
std::vector<ExampleBody> makeTube();

/// An arm of 120 x 20 x 10 mm along x, with two screw holes at its held end.
std::vector<ExampleBody> makeCantilever();

/// An angle bracket of 60 x 30 x 40 mm with a wall of 4 mm, rounded in its corner, with two holes: to be printed.
std::vector<ExampleBody> makePrintedBracket();

// Parts of the gallery, in the colors that the window gives their materials.

/// A bowl of 96 mm across with a wall of 3.5 mm and a foot, upside up.
std::vector<ExampleBody> makeBowl();

/// A slender vase, 110 mm tall, with a wall of 5 mm.
std::vector<ExampleBody> makeVase();

/// A clay jug with a handle along x, 80 mm tall, with a wall of 4.5 mm.
std::vector<ExampleBody> makeJug();

/// A cushion of 90 x 90 x 26 mm, rounded all around.
std::vector<ExampleBody> makeCushion();

/// A square rod of 160 x 14 x 14 mm along x, with round ends for the hands.
std::vector<ExampleBody> makeRod();

/// A round cake of clay, 64 mm across and 14 mm thick.
std::vector<ExampleBody> makeCake();

/// A stamp: a star of five rays under a disk. It stamps downwards; its star ends at z = 0.
std::vector<ExampleBody> makeStamp();
