package cga.grading.capture

import org.lwjgl.opengl.GL33C.*
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** A small capture that has one of everything, made anew each time so that a test may change it. */
internal object SampleCapture {
    const val WIDTH = 4
    const val HEIGHT = 3

    val state =
        DrawState(listOf(0, 0, WIDTH, HEIGHT), true, GL_LESS, true, false, GL_BACK, GL_CCW, false, GL_ONE, GL_ZERO, GL_FILL, false)

    /** Four vertices of three floats. */
    val vertices: ByteArray =
        ByteBuffer.allocate(4 * 3 * 4).order(ByteOrder.LITTLE_ENDIAN).also { for (i in 0 until 12) it.putFloat(i.toFloat()) }.array()

    /** The indices 0 1 2 0 2 3. */
    val indices: ByteArray =
        ByteBuffer
            .allocate(
                6 * 2,
            ).order(ByteOrder.LITTLE_ENDIAN)
            .also { for (i in listOf(0, 1, 2, 0, 2, 3)) it.putShort(i.toShort()) }
            .array()

    fun texture(
        width: Int = 2,
        height: Int = 1,
        levels: List<ByteArray> = listOf(ByteArray(8) { it.toByte() }, ByteArray(4)),
        wrap: Int = GL_REPEAT,
        minFilter: Int = GL_LINEAR_MIPMAP_LINEAR,
        magFilter: Int = GL_LINEAR,
        anisotropy: Float = 4f,
    ) = CapturedTexture(width, height, levels, wrap, GL_CLAMP_TO_EDGE, minFilter, magFilter, anisotropy, srgb = true)

    fun cube(
        height: Int = 2,
        bytes: Int = 6 * 2 * 2 * 4,
    ) = CapturedTexture(
        2, height, listOf(ByteArray(bytes)), GL_REPEAT, GL_REPEAT, GL_LINEAR, GL_LINEAR, isCube = true, wrapR = GL_CLAMP_TO_EDGE,
    )

    val limited: WriteMask = WriteMask(listOf(1, 0, 2, 2), 0b0111)

    fun attribute(
        buffer: Int = 0,
        offset: Long = 0,
        stride: Int = 12,
        size: Int = 3,
        type: Int = GL_FLOAT,
        location: Int = 1,
    ) = CapturedAttribute(location, size, type, false, stride, offset, buffer)

    val uniforms: List<UniformValue> =
        listOf(
            UniformValue("lights[1].color", GL_FLOAT_VEC3, floatArrayOf(1f, 2f, Float.NaN), 1),
            UniformValue("map", GL_SAMPLER_2D, floatArrayOf(3f)),
        )

    fun draw(
        program: Int = 0,
        mode: Int = GL_TRIANGLES,
        count: Int = 6,
        attributes: List<CapturedAttribute> = listOf(attribute()),
        indices: Int? = 1,
        indexType: Int = GL_UNSIGNED_SHORT,
        first: Long = 0,
        baseVertex: Int = 0,
        uniforms: List<UniformValue> = SampleCapture.uniforms,
        textures: Map<Int, Int> = mapOf(3 to 0),
        state: DrawState = SampleCapture.state,
        callers: DrawCallers = DrawCallers(0, 1, mapOf(3 to 0)),
    ) = CapturedDraw(program, mode, count, attributes, indices, indexType, first, baseVertex, 1, uniforms, textures, state, callers)

    fun clear(
        mask: Int = GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT,
        depth: Double = 1.0,
        writes: WriteMask = WriteMask.ALL,
    ) = CapturedClear(mask, floatArrayOf(0f, 0.25f, 0.5f, 1f), depth, writes)

    fun capture(
        steps: List<CapturedStep> = listOf(clear(), draw(), clear(writes = limited)),
        textures: List<CapturedTexture> = listOf(texture(), cube()),
        picture: ByteArray? = ByteArray(4 * WIDTH * HEIGHT) { it.toByte() },
        events: List<CapturedEvent> = listOf(CapturedEvent(EventKind.UNIFORM_ABSENT, 0, "früh", 1)),
        width: Int = WIDTH,
        callers: List<List<String>> = listOf(listOf("game/Scene.kt:7"), listOf("light/Lamp.kt:3", "game/Scene.kt:8")),
    ) = Capture(
        width = width,
        height = HEIGHT,
        samples = 4,
        programs =
            listOf(CapturedProgram("vertex", "fragment", mapOf("position" to 1), mapOf("color" to 1), substituted = true, "assets/a.glsl")),
        buffers = listOf(vertices, indices),
        textures = textures,
        frames = listOf(CapturedFrame(Moment.FIRST, 0.0, steps, picture), CapturedFrame(Moment.TIME_1, 0.7, emptyList(), null)),
        events = events,
        callers = callers,
    )
}
