package cga.grading.study

import cga.grading.capture.Capture
import cga.grading.capture.CapturedAttribute
import cga.grading.capture.CapturedDraw
import cga.grading.capture.CapturedFrame
import cga.grading.capture.CapturedProgram
import cga.grading.capture.CapturedTexture
import cga.grading.capture.DrawState
import cga.grading.capture.Moment
import cga.grading.capture.UniformValue
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.lwjgl.opengl.GL33C.*
import java.nio.ByteBuffer
import java.nio.ByteOrder
import kotlin.math.cos
import kotlin.math.sin
import kotlin.random.Random

/** The scene that the captures of these tests show: a motorcycle somewhere on the ground, a camera behind it, three lights. */
internal class TestScene {
    val bike: Matrix4dc = Matrix4d().translate(2.0, 0.0, -3.0).rotateY(0.7).scale(0.8)
    val ground: Matrix4dc = Matrix4d()
    private val camera = Matrix4d().translate(2.0, 0.0, -3.0).rotateY(0.9).rotateX(Math.toRadians(-35.0)).translate(0.0, 0.0, 4.0)
    val view: Matrix4dc = camera.invert(Matrix4d())
    val projection: Matrix4dc = Matrix4d().perspective(Math.toRadians(90.0), 16.0 / 9, 0.1, 100.0)
    val pointPosition = bike.transformPosition(Vector3d(0.0, 1.6, 0.0))
    val cornerPosition = Vector3d(-16.0, 1.2, 16.0)
    val spotPosition = bike.transformPosition(Vector3d(0.0, 0.9, -1.6))
    val spotDirection = bike.transformDirection(Vector3d(0.0, -sin(0.1), -cos(0.1))).normalize()
    val inner = Math.toRadians(12.5)
    val outer = Math.toRadians(25.0)

    fun viewed(p: Vector3d): Vector3d = view.transformPosition(p, Vector3d())

    fun viewedDirection(d: Vector3d): Vector3d = view.transformDirection(d, Vector3d())

    /** The uniforms of [CourseShaders] for one of the two objects. */
    fun uniforms(model: Matrix4dc): Map<String, Any> =
        mapOf(
            "model_matrix" to model,
            "view_matrix" to view,
            "projection_matrix" to projection,
            "pointLightPos" to pointPosition,
            "pointLightColor" to Vector3d(0.9, 0.4, 0.7),
            "pointLightAttenuation" to Vector3d(1.0, 0.5, 0.1),
            "cornerLightPos" to cornerPosition,
            "cornerLightColor" to Vector3d(3.0, 0.0, 1.0),
            "cornerLightAttenuation" to Vector3d(1.0, 0.5, 0.1),
            "spotLightPos" to spotPosition,
            "spotLightColor" to Vector3d(2.0, 2.0, 1.8),
            "spotLightAttenuation" to Vector3d(0.5, 0.05, 0.01),
            "spotLightDirection" to viewedDirection(spotDirection),
            "spotInner" to inner,
            "spotOuter" to outer,
            "shininess" to 60.0,
            "sceneColour" to if (model === ground) Vector3d(0.0, 1.0, 0.0) else Vector3d(0.2, 0.5, 0.6),
            "emit" to 0,
            "diff" to 1,
            "spec" to 2,
        )
}

/** Captures made by hand: what a recorder would have written for a program with these shaders in [TestScene]. */
internal object SceneCapture {
    /** One frame of two draws, ground and bike; [uniforms] of each come from its model matrix. */
    fun of(
        vertex: String,
        fragment: String,
        scene: TestScene = TestScene(),
        uniforms: (Matrix4dc) -> Map<String, Any> = scene::uniforms,
    ): Capture {
        val plane = plane()
        val bump = bump()
        val draws =
            listOf(scene.ground to (plane to 0), scene.bike to (bump to 1)).map { (model, shape) ->
                draw(
                    uniforms(model),
                    shape.first.size / 8,
                    shape.second,
                )
            }
        return Capture(
            1280,
            720,
            listOf(CapturedProgram(vertex, fragment, attributes(vertex))),
            listOf(bytes(plane), bytes(bump)),
            List(3) { texture(it) },
            listOf(CapturedFrame(Moment.FIRST, 0.0, draws, null)),
            emptyList(),
        )
    }

    private fun attributes(vertex: String): Map<String, Int> =
        Regex("""layout\s*\(location\s*=\s*(\d+)\)\s*in\s+\w+\s+(\w+)""").findAll(vertex).associate {
            it.groupValues[2] to
                it.groupValues[1].toInt()
        }

    private fun draw(
        uniforms: Map<String, Any>,
        count: Int,
        buffer: Int,
    ) = CapturedDraw(
        program = 0,
        mode = GL_TRIANGLES,
        count = count,
        attributes =
            listOf(3 to 0L, 2 to 12L, 3 to 20L).mapIndexed { location, (size, offset) ->
                CapturedAttribute(location, size, GL_FLOAT, false, 32, offset, buffer)
            },
        indices = null,
        indexType = 0,
        first = 0,
        baseVertex = 0,
        instances = 1,
        uniforms = uniforms.map { (name, value) -> uniform(name, value) },
        textures = mapOf(0 to 0, 1 to 1, 2 to 2),
        state =
            DrawState(listOf(0, 0, 1280, 720), true, GL_LESS, true, true, GL_BACK, GL_CCW, false, GL_ONE, GL_ZERO, GL_FILL, false),
    )

    private fun uniform(
        name: String,
        value: Any,
    ): UniformValue =
        when (value) {
            is Matrix4dc -> UniformValue(name, GL_FLOAT_MAT4, FloatArray(16) { value.get(it / 4, it % 4).toFloat() })
            is org.joml.Matrix3dc -> UniformValue(name, GL_FLOAT_MAT3, FloatArray(9) { value.get(it / 3, it % 3).toFloat() })
            is Vector3d -> UniformValue(name, GL_FLOAT_VEC3, floatArrayOf(value.x.toFloat(), value.y.toFloat(), value.z.toFloat()))
            is FloatArray -> UniformValue(name, if (value.size == 2) GL_FLOAT_VEC2 else GL_FLOAT_VEC4, value)
            is Int -> UniformValue(name, if (name in MAPS) GL_SAMPLER_2D else GL_INT, floatArrayOf(value.toFloat()))
            is Double -> UniformValue(name, GL_FLOAT, floatArrayOf(value.toFloat()))
            else -> error("no uniform can hold $value")
        }

    private fun texture(number: Int) =
        CapturedTexture(1, 1, listOf(ByteArray(4) { (60 + 50 * number).toByte() }), GL_REPEAT, GL_REPEAT, GL_LINEAR, GL_LINEAR)

    private val MAPS = setOf("emit", "diff", "spec")

    private fun bytes(floats: FloatArray): ByteArray {
        val buffer = ByteBuffer.allocate(4 * floats.size).order(ByteOrder.nativeOrder())
        floats.forEach(buffer::putFloat)
        return buffer.array()
    }

    private fun plane(): FloatArray {
        val corners = listOf(-22.4 to 22.4, 22.4 to 22.4, 22.4 to -22.4, -22.4 to 22.4, 22.4 to -22.4, -22.4 to -22.4)
        return corners.flatMap { (x, z) -> listOf(x, 0.0, z, x, z, 0.0, 1.0, 0.0).map { it.toFloat() } }.toFloatArray()
    }

    private fun bump(): FloatArray {
        val random = Random(1)
        return List(300) {
            val n = Directions.random(random)
            listOf(n.x * 0.5, 0.7 + n.y * 0.6, n.z * 1.4, 0.5, 0.5, n.x, n.y, n.z).map { it.toFloat() }
        }.flatten().toFloatArray()
    }
}

/** What the study of the motorcycle's draw finds out. */
internal fun Capture.study(): ProgramStudy =
    ProbeRig().use { rig ->
        ProbeProgram(programs[0]).use { program -> ProgramStudy.of(rig, program, this, 0, frames[0].steps[1] as CapturedDraw) }
    }

/** The same draw, but for what is given. */
internal fun CapturedDraw.copied(
    state: DrawState = this.state,
    count: Int = this.count,
    attributes: List<CapturedAttribute> = this.attributes,
    uniforms: List<UniformValue> = this.uniforms,
    textures: Map<Int, Int> = this.textures,
    program: Int = this.program,
): CapturedDraw =
    CapturedDraw(program, mode, count, attributes, indices, indexType, first, baseVertex, instances, uniforms, textures, state)
