package cga.exercise.components.shader

import cga.framework.Phases
import org.joml.Matrix3fc
import org.joml.Matrix4fc
import org.joml.Vector2fc
import org.joml.Vector3fc
import org.joml.Vector4fc
import org.lwjgl.BufferUtils
import org.lwjgl.opengl.GL33C.*

/**
 * A vertex and a fragment shader, read now, and compiled and linked when first used, so a program can be made without a context.
 *
 * @param constants numbers for the `const int NAME = …;` lines of the shaders, where they differ from what the files say.
 * Throws [cga.framework.InputError] when a file is missing, and [ShaderError] when GLSL does not compile or link.
 */
public open class ShaderProgram(
    private val vertexPath: String,
    private val fragmentPath: String,
    private val constants: Map<String, Int> = emptyMap(),
) {
    private var vertex = ShaderSource.read(vertexPath, constants)
    private var fragment = ShaderSource.read(fragmentPath, constants)
    private var program = 0
    private val locations = HashMap<String, Location>()
    private val matrix = BufferUtils.createFloatBuffer(16)

    /** Makes this the program that draws and that [setUniform] speaks to. */
    public open fun use() {
        if (program == 0) program = Phases.span("shaders") { ShaderCompiler.link(vertex, fragment) }
        glUseProgram(program)
    }

    /** Compiles the files as they are now. When they do not compile, the [ShaderError] is thrown and the old program stays. */
    public open fun reload() {
        val freshVertex = ShaderSource.read(vertexPath, constants)
        val freshFragment = ShaderSource.read(fragmentPath, constants)
        val fresh = ShaderCompiler.link(freshVertex, freshFragment)
        cleanup()
        vertex = freshVertex
        fragment = freshFragment
        program = fresh
    }

    /**
     * Sets the uniform [name] of the program in use. A name it does not have is reported once, on standard error; one that the shaders
     * declare and do not use is passed over.
     */
    public open fun setUniform(
        name: String,
        value: Int,
    ) {
        glUniform1i(location(name), value)
    }

    /** As for Int; true is 1. */
    public open fun setUniform(
        name: String,
        value: Boolean,
    ) {
        setUniform(name, if (value) 1 else 0)
    }

    /** As for Int. */
    public open fun setUniform(
        name: String,
        value: Float,
    ) {
        glUniform1f(location(name), value)
    }

    /** As for Int. */
    public open fun setUniform(
        name: String,
        value: Vector2fc,
    ) {
        glUniform2f(location(name), value.x(), value.y())
    }

    /** As for Int. */
    public open fun setUniform(
        name: String,
        value: Vector3fc,
    ) {
        glUniform3f(location(name), value.x(), value.y(), value.z())
    }

    /** As for Int. */
    public open fun setUniform(
        name: String,
        value: Vector4fc,
    ) {
        glUniform4f(location(name), value.x(), value.y(), value.z(), value.w())
    }

    /** As for Int; [transpose] swaps rows and columns on the way. */
    public open fun setUniform(
        name: String,
        value: Matrix3fc,
        transpose: Boolean,
    ) {
        value.get(matrix.clear().limit(9))
        glUniformMatrix3fv(location(name), transpose, matrix)
    }

    /** As for Int; [transpose] swaps rows and columns on the way. */
    public open fun setUniform(
        name: String,
        value: Matrix4fc,
        transpose: Boolean,
    ) {
        value.get(matrix.clear())
        glUniformMatrix4fv(location(name), transpose, matrix)
    }

    /** Frees the program; using it again compiles again. */
    public open fun cleanup() {
        if (program != 0) glDeleteProgram(program)
        program = 0
        locations.clear()
    }

    /** How unknown uniforms are reported; one line. */
    protected open fun warn(message: String) {
        System.err.println(message)
    }

    private fun location(name: String): Int = (locations[name] ?: find(name)).value

    // −1 is remembered like any other answer, which is what makes the warning come once.
    private fun find(name: String): Location {
        val found = Location(glGetUniformLocation(program, name))
        locations[name] = found
        if (found.value < 0) warnIfUnknown(name, UniformNames.of(program))
        return found
    }

    // A uniform that the shaders declare and this variant of them does not need (no lights, no normals) is no mistake.
    private fun warnIfUnknown(
        name: String,
        known: List<String>,
    ) {
        if (UniformNames.isDeclared(name, known, vertex.text) || UniformNames.isDeclared(name, known, fragment.text)) return
        warn(UniformNames.unknown(name, known, "$vertexPath + $fragmentPath"))
    }

    // An object of our own: a boxed Int would be allocated at every look-up of a location beyond 127.
    private class Location(val value: Int)
}
