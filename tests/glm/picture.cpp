// A third renderer, in double precision, that shares nothing with the other two: its own readers of OBJ, MTL and PNG, its own mip levels,
// camera, lights and rays. What OpenGL and the Kotlin reference get from common code (models, textures, mip levels, places, angles,
// constants) is checked by its pictures.
//
//     g++ -std=c++17 -O2 -o build/picture tests/glm/picture.cpp -lpng
//     build/picture STEP T MOUSE WIDTH HEIGHT ASSETS OUT
//
// STEP is the sheet's number (4.1 … 4.7), T the time in seconds, MOUSE how far the mouse moved to the right, in pixels. OUT gets three
// doubles a pixel in the machine's byte order, linear red, green and blue, rows from the top.

#include "picture/model.h"
#include "picture/rays.h"
#include "picture/scene.h"

#include <cstdio>
#include <cstdlib>
#include <exception>

int main(int count, char** words)
{
    if (count != 8) {
        std::fprintf(stderr, "usage: picture STEP T MOUSE WIDTH HEIGHT ASSETS OUT\n");
        return 2;
    }
    try {
        const int width = std::atoi(words[4]), height = std::atoi(words[5]);
        const std::string assets = words[6];
        const Scene scene(words[1], std::atof(words[2]), std::atof(words[3]), double(width) / height);
        Picture picture(width, height, scene);
        picture.draw(readModel(assets + "/ground/ground.obj"), glm::dmat4(1), scene.groundTint(), 64);
        picture.draw(readModel(assets + "/motorcycle/motorcycle.obj"), scene.motorcycle(), scene.motorcycleTint(), 1);
        picture.write(words[7]);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "picture: %s\n", e.what());
        return 2;
    }
}
