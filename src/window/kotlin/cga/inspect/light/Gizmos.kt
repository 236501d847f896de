package cga.inspect.light

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3d
import org.joml.Vector4d
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil

/** Shows where the lights are. Needs the OpenGL context. */
internal class Gizmos(private val camera: TronCamera) : AutoCloseable {
    private val program = ShaderProgram("shaders/inspect/lines.vert", "shaders/inspect/lines.frag")
    private val lines = GizmoLines(MemoryUtil.memAllocFloat(MAX_VERTICES * GizmoLines.FLOATS))
    private val vao = glGenVertexArrays()
    private val vbo = glGenBuffers()
    private val view = Matrix4d()
    private val toClip = Matrix4d()
    private val projection = Matrix4f()
    private val sent = Matrix4f()
    private val world = Vector3d()
    private val clip = Vector4d()

    init {
        glBindVertexArray(vao)
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glVertexAttribPointer(0, 3, GL_FLOAT, false, GizmoLines.FLOATS * Float.SIZE_BYTES, 0)
        glVertexAttribPointer(1, 3, GL_FLOAT, false, GizmoLines.FLOATS * Float.SIZE_BYTES, 12)
        glEnableVertexAttribArray(0)
        glEnableVertexAttribArray(1)
        glBindVertexArray(0)
    }

    /** Draws [lights] over the scene that was just drawn, whose depth is still there: faintly where they are behind something. */
    fun draw(lights: List<InspectedLight>) {
        lines.clear()
        for (i in lights.indices) lights[i].draw(lines)
        lines.vertices.flip()
        camera.calculateViewMatrix(view)
        toClip.set(camera.calculateProjectionMatrix(projection)).mul(view)
        glBindVertexArray(vao)
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glBufferData(GL_ARRAY_BUFFER, lines.vertices, GL_STREAM_DRAW)
        program.use()
        program.setUniform("toClip", sent.set(toClip), false)
        glEnable(GL_BLEND)
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
        glDepthMask(false)
        draw(GL_LEQUAL, IN_SIGHT)
        draw(GL_GREATER, BEHIND)
        glDepthFunc(GL_LESS)
        glDepthMask(true)
        glDisable(GL_BLEND)
        glBindVertexArray(0)
    }

    /**
     * Where [light] was in the picture that was drawn last, as shares of its width and height from the upper left, into [dest]; false where it is
     * behind the camera.
     */
    fun place(
        light: InspectedLight,
        dest: Vector2f,
    ): Boolean {
        clip.set(light.light.getWorldPosition(world), 1.0)
        toClip.transform(clip)
        if (clip.w <= 0) return false
        dest.set(((clip.x / clip.w + 1) / 2).toFloat(), ((1 - clip.y / clip.w) / 2).toFloat())
        return true
    }

    private fun draw(
        depth: Int,
        strength: Float,
    ) {
        glDepthFunc(depth)
        program.setUniform("strength", strength)
        glDrawArrays(GL_LINES, 0, lines.vertices.limit() / GizmoLines.FLOATS)
    }

    override fun close() {
        program.cleanup()
        glDeleteVertexArrays(vao)
        glDeleteBuffers(vbo)
        MemoryUtil.memFree(lines.vertices)
    }

    private companion object {
        const val MAX_VERTICES = 4096
        const val IN_SIGHT = 0.9f
        const val BEHIND = 0.2f
    }
}
