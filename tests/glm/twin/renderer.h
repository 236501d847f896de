// Draws a recorded frame: what Scene.render, ShaderProgram, Mesh, Texture2D and RenderTarget do, call by call.
#pragma once

#include "cooked.h"
#include "gl.h"
#include "recording.h"

#include <algorithm>
#include <sstream>

class Renderer {
public:
    explicit Renderer(const Recording& recording, bool backFaces = false) : recording_(recording), backFaces_(backFaces)
    {
        for (const std::string& file : recording.models) {
            std::vector<Mesh>& meshes = models_.emplace_back();
            for (const CookedMesh& mesh : readModel(file)) meshes.push_back(upload(mesh));
        }
        for (const RecordedTexture& texture : recording.textures) textures_.push_back(upload(texture));
        drawn_ = makeFramebuffer(recording.samples);
        if (recording.samples > 0) resolved_ = makeFramebuffer(0);
        program_ = link();
        for (const Call& call : recording.calls) locations_.push_back(call.name.empty() ? -1 : glGetUniformLocation(program_, call.name.c_str()));
    }

    // `calls` are the recorded ones, perhaps with other values.
    void draw(const std::vector<Call>& calls) const
    {
        glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
        glViewport(0, 0, recording_.width, recording_.height);
        glEnable(GL_DEPTH_TEST);
        if (!backFaces_) glEnable(GL_CULL_FACE);
        glDisable(GL_DITHER);
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUseProgram(program_);
        for (std::size_t i = 0; i < calls.size(); i++) send(calls[i], locations_[i]);
    }

    // The picture, four bytes a pixel, rows from top to bottom.
    std::vector<unsigned char> read() const
    {
        const int width = recording_.width;
        const int height = recording_.height;
        if (recording_.samples > 0) {
            glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
            glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        }
        glBindFramebuffer(GL_READ_FRAMEBUFFER, recording_.samples > 0 ? resolved_ : drawn_);
        const auto row = 4 * static_cast<std::size_t>(width);
        std::vector<unsigned char> pixels(row * static_cast<std::size_t>(height));
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        for (auto top = pixels.begin(), bottom = pixels.end() - static_cast<std::ptrdiff_t>(row); top < bottom;
             top += static_cast<std::ptrdiff_t>(row), bottom -= static_cast<std::ptrdiff_t>(row))
            std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
        require(glGetError() == 0, "OpenGL reports an error");
        return pixels;
    }

private:
    struct Mesh {
        GLuint vertexArray;
        GLsizei count;
    };

    void send(const Call& call, GLint location) const
    {
        const auto& v = call.values;
        switch (call.kind) {
        case Call::integer: glUniform1i(location, call.number); break;
        case Call::floats1: glUniform1f(location, v[0]); break;
        case Call::floats2: glUniform2f(location, v[0], v[1]); break;
        case Call::floats3: glUniform3f(location, v[0], v[1], v[2]); break;
        case Call::matrix3: glUniformMatrix3fv(location, 1, 0, v.data()); break;
        case Call::matrix4: glUniformMatrix4fv(location, 1, 0, v.data()); break;
        case Call::texture:
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(call.number));
            glBindTexture(GL_TEXTURE_2D, textures_.at(static_cast<std::size_t>(call.index)));
            break;
        case Call::draw: {
            const Mesh& mesh = models_.at(static_cast<std::size_t>(call.number)).at(static_cast<std::size_t>(call.index));
            glBindVertexArray(mesh.vertexArray);
            glDrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
            break;
        }
        }
    }

    static GLuint buffer(GLenum target, const unsigned char* data, std::int32_t numbers)
    {
        GLuint name = 0;
        glGenBuffers(1, &name);
        glBindBuffer(target, name);
        glBufferData(target, 4 * static_cast<std::ptrdiff_t>(numbers), data, GL_STATIC_DRAW);
        return name;
    }

    static Mesh upload(const CookedMesh& cooked)
    {
        constexpr GLsizei stride = 8 * sizeof(float);
        Mesh mesh{0, cooked.count};
        glGenVertexArrays(1, &mesh.vertexArray);
        glBindVertexArray(mesh.vertexArray);
        buffer(GL_ARRAY_BUFFER, cooked.vertices, cooked.floats);
        const auto attribute = [](GLuint location, GLint size, std::uintptr_t offset) {
            glEnableVertexAttribArray(location);
            glVertexAttribPointer(location, size, GL_FLOAT, 0, stride, reinterpret_cast<const void*>(offset));
        };
        attribute(0, 3, 0);
        attribute(1, 2, 12);
        attribute(2, 3, 20);
        buffer(GL_ELEMENT_ARRAY_BUFFER, cooked.indices, cooked.count);
        glBindVertexArray(0);
        return mesh;
    }

    static GLuint upload(const RecordedTexture& texture)
    {
        GLuint name = 0;
        glGenTextures(1, &name);
        glBindTexture(GL_TEXTURE_2D, name);
        const std::vector<CookedLevel> levels = readTexture(texture.file);
        for (std::size_t i = 0; i < levels.size(); i++)
            glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(i), GL_RGBA8, levels[i].width, levels[i].height, 0, GL_RGBA, GL_UNSIGNED_BYTE, levels[i].rgba);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels.size()) - 1);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, texture.parameters[0]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, texture.parameters[1]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, texture.parameters[2]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, texture.parameters[3]);
        return name;
    }

    GLuint makeFramebuffer(int samples) const
    {
        GLuint framebuffer = 0;
        glGenFramebuffers(1, &framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        const auto attach = [&](GLenum point, GLenum storage) {
            GLuint name = 0;
            glGenRenderbuffers(1, &name);
            glBindRenderbuffer(GL_RENDERBUFFER, name);
            glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, storage, recording_.width, recording_.height);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
        };
        attach(GL_COLOR_ATTACHMENT0, GL_RGBA8);
        attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24);
        require(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "the driver refuses the framebuffer");
        return framebuffer;
    }

    // The file, with our numbers in its "const int NAME = ...;" lines.
    std::string source(const std::string& path) const
    {
        std::ifstream file(path);
        require(file.good(), "cannot read " + path);
        std::ostringstream read;
        read << file.rdbuf();
        std::string text = read.str();
        for (const auto& [name, value] : recording_.constants) {
            const std::string head = "const int " + name + " = ";
            for (auto at = text.find(head); at != std::string::npos; at = text.find(head, at + 1)) {
                const auto number = at + head.size();
                text.replace(number, text.find(';', number) - number, std::to_string(value));
            }
        }
        return text;
    }

    GLuint compile(GLenum stage, const std::string& path) const
    {
        const std::string text = source(path);
        const char* lines = text.c_str();
        const GLuint shader = glCreateShader(stage);
        glShaderSource(shader, 1, &lines, nullptr);
        glCompileShader(shader);
        GLint ok = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
        std::array<char, 2000> log{};
        if (!ok) glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
        require(ok, path + ": " + log.data());
        return shader;
    }

    GLuint link() const
    {
        const GLuint program = glCreateProgram();
        glAttachShader(program, compile(GL_VERTEX_SHADER, recording_.vertexShader));
        glAttachShader(program, compile(GL_FRAGMENT_SHADER, recording_.fragmentShader));
        glLinkProgram(program);
        GLint ok = 0;
        glGetProgramiv(program, GL_LINK_STATUS, &ok);
        std::array<char, 2000> log{};
        if (!ok) glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
        require(ok, std::string("the shaders do not link: ") + log.data());
        return program;
    }

    const Recording& recording_;
    const bool backFaces_;
    std::vector<std::vector<Mesh>> models_;
    std::vector<GLuint> textures_;
    GLuint drawn_ = 0;
    GLuint resolved_ = 0;
    GLuint program_ = 0;
    std::vector<GLint> locations_;
};
