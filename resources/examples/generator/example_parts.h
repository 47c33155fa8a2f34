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

/// The bar of the paper's experiments: 160 x 20 x 20 mm, to bend, twist and stretch.
std::vector<ExampleBody> makeBar();

/// An angle bracket with holes and rounded corners, and the bushing in its upper hole.
std::vector<ExampleBody> makeBracket();

/// A curved grip that stands upright, with a swelling for the palm, and the metal ferrule below it.
std::vector<ExampleBody> makeHandle();
