package cga.exercise.components.effects

import cga.exercise.components.camera.ICamera
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f
import org.lwjgl.opengl.GL32.*
import kotlin.random.Random

/** Sparks that fly when a sphere is collected. */
class Sparks {
    private class Spark(val position: Vector3f, val velocity: Vector3f, val color: Vector3f, var life: Float)

    private val shader = ShaderProgram("assets/shaders/spark_vert.glsl", "assets/shaders/spark_frag.glsl")
    private val random = Random(3)
    private val sparks = mutableListOf<Spark>()
    private val vao = glGenVertexArrays()
    private val vbo = glGenBuffers()

    init {
        glBindVertexArray(vao)
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glBufferData(GL_ARRAY_BUFFER, MAX * 28L, GL_DYNAMIC_DRAW)
        glEnableVertexAttribArray(0)
        glVertexAttribPointer(0, 3, GL_FLOAT, false, 28, 0)
        glEnableVertexAttribArray(1)
        glVertexAttribPointer(1, 4, GL_FLOAT, false, 28, 12)
        glBindVertexArray(0)
    }

    private fun around() = random.nextFloat() * 4.0f - 2.0f

    fun explode(at: Vector3f, color: Vector3f) {
        repeat(24) {
            if (sparks.size < MAX) sparks.add(Spark(Vector3f(at), Vector3f(around(), 3.0f + around(), around()), color, 1.0f))
        }
    }

    fun update(dt: Float) {
        for (spark in sparks) {
            spark.life -= dt
            spark.velocity.y -= 9.81f * dt
            spark.position.fma(dt, spark.velocity)
        }
        sparks.removeIf { it.life <= 0.0f || it.position.y < 0.0f }
    }

    fun render(camera: ICamera) {
        if (sparks.isEmpty()) return
        val data = sparks.flatMap { listOf(it.position.x, it.position.y, it.position.z, it.color.x, it.color.y, it.color.z, it.life) }
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glBufferSubData(GL_ARRAY_BUFFER, 0, data.toFloatArray())

        glEnable(GL_PROGRAM_POINT_SIZE)
        glEnable(GL_BLEND)
        glBlendFunc(GL_SRC_ALPHA, GL_ONE)
        glDepthMask(false)
        shader.use()
        camera.bind(shader)
        glBindVertexArray(vao)
        glDrawArrays(GL_POINTS, 0, sparks.size)
        glBindVertexArray(0)
        glDepthMask(true)
        glDisable(GL_BLEND)
    }

    fun cleanup() {
        glDeleteBuffers(vbo)
        glDeleteVertexArrays(vao)
        shader.cleanup()
    }

    companion object {
        private const val MAX = 400
    }
}
