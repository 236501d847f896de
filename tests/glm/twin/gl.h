// The part of OpenGL 3.3 that the twin calls, declared here so that a compiler and GLM are all that building it needs.
#pragma once

#include <cstddef>
#include <cstdint>

using GLenum = unsigned int;
using GLuint = unsigned int;
using GLint = int;
using GLsizei = int;
using GLfloat = float;
using GLboolean = unsigned char;

constexpr GLenum GL_TRIANGLES = 0x0004;
constexpr GLenum GL_DEPTH_BUFFER_BIT = 0x0100;
constexpr GLenum GL_COLOR_BUFFER_BIT = 0x4000;
constexpr GLenum GL_CULL_FACE = 0x0B44;
constexpr GLenum GL_DEPTH_TEST = 0x0B71;
constexpr GLenum GL_DITHER = 0x0BD0;
constexpr GLenum GL_TEXTURE_2D = 0x0DE1;
constexpr GLenum GL_UNSIGNED_BYTE = 0x1401;
constexpr GLenum GL_UNSIGNED_INT = 0x1405;
constexpr GLenum GL_FLOAT = 0x1406;
constexpr GLenum GL_RGBA = 0x1908;
constexpr GLenum GL_NEAREST = 0x2600;
constexpr GLenum GL_TEXTURE_MAG_FILTER = 0x2800;
constexpr GLenum GL_TEXTURE_MIN_FILTER = 0x2801;
constexpr GLenum GL_TEXTURE_WRAP_S = 0x2802;
constexpr GLenum GL_TEXTURE_WRAP_T = 0x2803;
constexpr GLenum GL_RGBA8 = 0x8058;
constexpr GLenum GL_TEXTURE_MAX_LEVEL = 0x813D;
constexpr GLenum GL_DEPTH_COMPONENT24 = 0x81A6;
constexpr GLenum GL_TEXTURE0 = 0x84C0;
constexpr GLenum GL_ARRAY_BUFFER = 0x8892;
constexpr GLenum GL_ELEMENT_ARRAY_BUFFER = 0x8893;
constexpr GLenum GL_STATIC_DRAW = 0x88E4;
constexpr GLenum GL_FRAGMENT_SHADER = 0x8B30;
constexpr GLenum GL_VERTEX_SHADER = 0x8B31;
constexpr GLenum GL_COMPILE_STATUS = 0x8B81;
constexpr GLenum GL_LINK_STATUS = 0x8B82;
constexpr GLenum GL_READ_FRAMEBUFFER = 0x8CA8;
constexpr GLenum GL_DRAW_FRAMEBUFFER = 0x8CA9;
constexpr GLenum GL_FRAMEBUFFER_COMPLETE = 0x8CD5;
constexpr GLenum GL_COLOR_ATTACHMENT0 = 0x8CE0;
constexpr GLenum GL_DEPTH_ATTACHMENT = 0x8D00;
constexpr GLenum GL_FRAMEBUFFER = 0x8D40;
constexpr GLenum GL_RENDERBUFFER = 0x8D41;

// X(result, name, parameters) for each function.
#define TWIN_GL_FUNCTIONS(X) \
    X(void, glActiveTexture, (GLenum)) \
    X(void, glAttachShader, (GLuint, GLuint)) \
    X(void, glBindBuffer, (GLenum, GLuint)) \
    X(void, glBindFramebuffer, (GLenum, GLuint)) \
    X(void, glBindRenderbuffer, (GLenum, GLuint)) \
    X(void, glBindTexture, (GLenum, GLuint)) \
    X(void, glBindVertexArray, (GLuint)) \
    X(void, glBlitFramebuffer, (GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLenum, GLenum)) \
    X(void, glBufferData, (GLenum, std::ptrdiff_t, const void*, GLenum)) \
    X(GLenum, glCheckFramebufferStatus, (GLenum)) \
    X(void, glClear, (GLenum)) \
    X(void, glClearColor, (GLfloat, GLfloat, GLfloat, GLfloat)) \
    X(void, glCompileShader, (GLuint)) \
    X(GLuint, glCreateProgram, ()) \
    X(GLuint, glCreateShader, (GLenum)) \
    X(void, glDisable, (GLenum)) \
    X(void, glDrawElements, (GLenum, GLsizei, GLenum, const void*)) \
    X(void, glEnable, (GLenum)) \
    X(void, glEnableVertexAttribArray, (GLuint)) \
    X(void, glFinish, ()) \
    X(void, glFramebufferRenderbuffer, (GLenum, GLenum, GLenum, GLuint)) \
    X(void, glGenBuffers, (GLsizei, GLuint*)) \
    X(void, glGenFramebuffers, (GLsizei, GLuint*)) \
    X(void, glGenRenderbuffers, (GLsizei, GLuint*)) \
    X(void, glGenTextures, (GLsizei, GLuint*)) \
    X(void, glGenVertexArrays, (GLsizei, GLuint*)) \
    X(GLenum, glGetError, ()) \
    X(void, glGetProgramInfoLog, (GLuint, GLsizei, GLsizei*, char*)) \
    X(void, glGetProgramiv, (GLuint, GLenum, GLint*)) \
    X(void, glGetShaderInfoLog, (GLuint, GLsizei, GLsizei*, char*)) \
    X(void, glGetShaderiv, (GLuint, GLenum, GLint*)) \
    X(GLint, glGetUniformLocation, (GLuint, const char*)) \
    X(void, glLinkProgram, (GLuint)) \
    X(void, glReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*)) \
    X(void, glRenderbufferStorageMultisample, (GLenum, GLsizei, GLenum, GLsizei, GLsizei)) \
    X(void, glShaderSource, (GLuint, GLsizei, const char* const*, const GLint*)) \
    X(void, glTexImage2D, (GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*)) \
    X(void, glTexParameteri, (GLenum, GLenum, GLint)) \
    X(void, glUniform1f, (GLint, GLfloat)) \
    X(void, glUniform1i, (GLint, GLint)) \
    X(void, glUniform2f, (GLint, GLfloat, GLfloat)) \
    X(void, glUniform3f, (GLint, GLfloat, GLfloat, GLfloat)) \
    X(void, glUniformMatrix3fv, (GLint, GLsizei, GLboolean, const GLfloat*)) \
    X(void, glUniformMatrix4fv, (GLint, GLsizei, GLboolean, const GLfloat*)) \
    X(void, glUseProgram, (GLuint)) \
    X(void, glVertexAttribPointer, (GLuint, GLint, GLenum, GLboolean, GLsizei, const void*)) \
    X(void, glViewport, (GLint, GLint, GLsizei, GLsizei))

#define TWIN_GL_POINTER(result, name, parameters) inline result(*name) parameters = nullptr;
TWIN_GL_FUNCTIONS(TWIN_GL_POINTER)
#undef TWIN_GL_POINTER
