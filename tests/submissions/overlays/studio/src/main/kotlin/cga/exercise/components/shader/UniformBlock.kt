package cga.exercise.components.shader

import org.joml.Matrix4f
import org.joml.Vector3f
import org.lwjgl.BufferUtils
import org.lwjgl.opengl.GL31.*

/** A buffer of uniforms that several programs share. Filled with the put functions, then sent at once. */
class UniformBlock(private val name: String, private val binding: Int, bytes: Int) {
    private val buffer = glGenBuffers()
    private val data = BufferUtils.createByteBuffer(bytes)

    init {
        glBindBuffer(GL_UNIFORM_BUFFER, buffer)
        glBufferData(GL_UNIFORM_BUFFER, bytes.toLong(), GL_DYNAMIC_DRAW)
        glBindBuffer(GL_UNIFORM_BUFFER, 0)
        glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer)
    }

    /** Must be called once for each program that declares the block. */
    fun attachTo(program: ShaderProgram) {
        val index = glGetUniformBlockIndex(program.id, name)
        if (index != GL_INVALID_INDEX) glUniformBlockBinding(program.id, index, binding)
    }

    fun put(offset: Int, value: Int) {
        data.putInt(offset, value)
    }

    fun put(offset: Int, value: Float) {
        data.putFloat(offset, value)
    }

    fun put(offset: Int, value: Vector3f) {
        value.get(offset, data)
    }

    fun put(offset: Int, value: Matrix4f) {
        value.get(offset, data)
    }

    fun send() {
        glBindBuffer(GL_UNIFORM_BUFFER, buffer)
        glBufferSubData(GL_UNIFORM_BUFFER, 0, data)
        glBindBuffer(GL_UNIFORM_BUFFER, 0)
    }

    fun cleanup() {
        glDeleteBuffers(buffer)
    }
}
