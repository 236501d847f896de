// An OpenGL 3.3 core context without a window, the same two ways as ours: OSMesa, or EGL on Mesa's surfaceless platform. The
// libraries are loaded at run time, as LWJGL does.
#pragma once

#include "error.h"
#include "gl.h"

#include <dlfcn.h>

#include <array>
#include <initializer_list>

class Library {
public:
    explicit Library(std::initializer_list<const char*> names)
    {
        for (const char* name : names)
            if ((handle_ = dlopen(name, RTLD_LAZY | RTLD_LOCAL))) return;
        fail(std::string("cannot load ") + *names.begin() + ": " + dlerror());
    }

    // The function called `name`, of the type of the pointer that is asked for.
    template <typename Function> Function find(const char* name) const
    {
        void* address = dlsym(handle_, name);
        require(address, std::string("there is no ") + name);
        return reinterpret_cast<Function>(address);
    }

private:
    void* handle_ = nullptr;
};

using Lookup = void (*(*)(const char*))();

inline void loadFunctions(Lookup address)
{
#define TWIN_GL_LOAD(result, name, parameters) \
    name = reinterpret_cast<result(*) parameters>(address(#name)); \
    require(name, "the driver has no " #name);
    TWIN_GL_FUNCTIONS(TWIN_GL_LOAD)
#undef TWIN_GL_LOAD
}

inline void openOsMesa()
{
    // Format RGBA; 24 bits of depth, 8 of stencil, none of accumulation; core profile 3.3: what GLFW asks for.
    const std::array<int, 15> attributes{0x22, GL_RGBA, 0x30, 24, 0x31, 8, 0x32, 0, 0x33, 0x34, 0x36, 3, 0x37, 3, 0};
    static std::array<unsigned char, 4> pixel;
    const Library library{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    void* context = library.find<void* (*)(const int*, void*)>("OSMesaCreateContextAttribs")(attributes.data(), nullptr);
    require(context, "OSMesa gives no OpenGL 3.3 core context");
    const auto makeCurrent = library.find<unsigned char (*)(void*, void*, GLenum, int, int)>("OSMesaMakeCurrent");
    require(makeCurrent(context, pixel.data(), GL_UNSIGNED_BYTE, 1, 1), "OSMesaMakeCurrent failed");
    loadFunctions(library.find<Lookup>("OSMesaGetProcAddress"));
}

inline void openEgl()
{
    constexpr unsigned surfaceless = 0x31DD;
    constexpr unsigned openGlApi = 0x30A2;
    const std::array<int, 5> wanted{0x3033, 0x0001, 0x3040, 0x0008, 0x3038};                 // pbuffers, OpenGL
    const std::array<int, 7> version{0x3098, 3, 0x30FB, 3, 0x30FD, 0x0001, 0x3038};          // 3.3 core
    const std::array<int, 5> size{0x3057, 1, 0x3056, 1, 0x3038};                             // 1x1
    const Library library{"libEGL.so.1", "libEGL.so"};
    void* display = library.find<void* (*)(unsigned, void*, const void*)>("eglGetPlatformDisplay")(surfaceless, nullptr, nullptr);
    require(display, "there is no surfaceless EGL display");
    require(library.find<unsigned (*)(void*, int*, int*)>("eglInitialize")(display, nullptr, nullptr), "eglInitialize failed");
    void* config = nullptr;
    int count = 0;
    const auto choose = library.find<unsigned (*)(void*, const int*, void**, int, int*)>("eglChooseConfig");
    require(choose(display, wanted.data(), &config, 1, &count) && count > 0, "EGL has no configuration for OpenGL");
    library.find<unsigned (*)(unsigned)>("eglBindAPI")(openGlApi);
    void* context = library.find<void* (*)(void*, void*, void*, const int*)>("eglCreateContext")(display, config, nullptr, version.data());
    void* surface = library.find<void* (*)(void*, void*, const int*)>("eglCreatePbufferSurface")(display, config, size.data());
    const auto makeCurrent = library.find<unsigned (*)(void*, void*, void*, void*)>("eglMakeCurrent");
    require(context && surface && makeCurrent(display, surface, surface, context), "EGL gives no OpenGL 3.3 core context");
    loadFunctions(library.find<Lookup>("eglGetProcAddress"));
}
