package cga.exercise.components.shader

import cga.framework.Home
import org.joml.Matrix3fc
import org.joml.Matrix4fc
import org.joml.Vector2fc
import org.joml.Vector3fc
import org.joml.Vector4fc
import org.lwjgl.BufferUtils
import org.lwjgl.opengl.GL33C.*

/**
 * A vertex and a fragment shader, compiled and linked when first used, so a program can be made without a context.
 *
 * Throws [cga.framework.InputError] when a file is missing, and [ShaderError] when GLSL does not compile or link.
 */
public open class ShaderProgram(
    private val vertexPath: String,
    private val fragmentPath: String,
) {
    private var program = 0
    private val locations = HashMap<String, Location>()
    private val matrix = BufferUtils.createFloatBuffer(16)

    init {
        Home.read(vertexPath, "shader")
        Home.read(fragmentPath, "shader")
    }

    /** Makes this the program that draws and that [setUniform] speaks to. */
    public fun use() {
        if (program == 0) program = ShaderCompiler.link(vertexPath, fragmentPath)
        glUseProgram(program)
    }

    /** Compiles the files as they are now. When they do not compile, the [ShaderError] is thrown and the old program stays. */
    public fun reload() {
        val fresh = ShaderCompiler.link(vertexPath, fragmentPath)
        cleanup()
        program = fresh
    }

    /** Sets the uniform [name] of the program in use. A name it does not have is reported once, on standard error. */
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
    public fun cleanup() {
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
        if (found.value < 0) warn(UniformNames.unknown(name, UniformNames.of(program), "$vertexPath + $fragmentPath"))
        return found
    }

    // An object of our own: a boxed Int would be allocated at every look-up of a location beyond 127.
    private class Location(val value: Int)
}
