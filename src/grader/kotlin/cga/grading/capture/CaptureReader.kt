package cga.grading.capture

import cga.grading.capture.CaptureLimits.SIDE

/** Reads what [CaptureWriter] wrote; each number by itself is within its limits, [CaptureCheck] sees to it that they fit together. */
internal class CaptureReader(private val input: LimitedInput) {
    // The same few names come with every draw.
    private val names = HashMap<String, String>()

    fun read(): Capture {
        val width = input.int("the window's width", 1..SIDE)
        val height = input.int("the window's height", 1..SIDE)
        val samples = input.int("the number of samples", 0..CaptureLimits.SAMPLES)
        return Capture(
            width = width,
            height = height,
            samples = samples,
            programs = input.list("programs", CaptureLimits.PROGRAMS, ::program),
            buffers = input.list("buffers", CaptureLimits.BUFFERS) { input.bytes("a buffer", Int.MAX_VALUE - 16) },
            textures = input.list("textures", CaptureLimits.TEXTURES, ::texture),
            frames = input.list("frames", CaptureLimits.FRAMES) { frame(4L * width * height) },
            events = input.list("events", CaptureLimits.EVENTS, ::event),
            callers = input.list("chains of calls", CaptureLimits.CALLERS) { input.list("calls", CaptureLimits.CALLS, ::call) },
        )
    }

    private fun event() =
        CapturedEvent(
            kind = entry("kind of event", EventKind.entries),
            frame = input.int("an event's frame", -1..CaptureLimits.FRAMES),
            // A character of UTF-16 takes at most three bytes.
            text = input.text("an event", 3 * CaptureLimits.EVENT_TEXT),
            caller = caller(),
        )

    private fun call() = input.text("a call", 3 * CaptureLimits.CALL)

    private fun caller() = input.int("a caller", -1 until CaptureLimits.CALLERS)

    private fun program() =
        CapturedProgram(
            vertexSource = input.text("a vertex shader", CaptureLimits.SOURCE),
            fragmentSource = input.text("a fragment shader", CaptureLimits.SOURCE),
            attributes = numbers("attributes", CaptureLimits.ATTRIBUTES - 1),
            outputs = numbers("outputs", MAX_OUTPUT),
            substituted = input.boolean(),
            vertexFile = file(),
            fragmentFile = file(),
        )

    private fun file() = input.text("a shader's file", CaptureLimits.NAME).ifEmpty { null }

    private fun numbers(
        what: String,
        largest: Int,
    ) = input.map(what, CaptureLimits.ATTRIBUTES) { name() to input.int("one of the $what", 0..largest) }

    private fun texture(): CapturedTexture {
        val width = input.int("a texture's width", 1..SIDE)
        val height = input.int("a texture's height", 1..SIDE)
        val levels = input.list("levels", MAX_LEVELS) { input.bytes("a texture's level", Int.MAX_VALUE - 16) }
        val (wrapS, wrapT) = List(2) { input.int() }
        val (minFilter, magFilter) = List(2) { input.int() }
        val maxAnisotropy = input.float()
        val kind = input.byte()
        if (kind !in 0..CaptureWriter.KINDS) throw BadCapture("$kind is no kind of texture")
        val isCube = kind and CaptureWriter.CUBE != 0
        return CapturedTexture(
            width, height, levels, wrapS, wrapT, minFilter, magFilter, maxAnisotropy,
            srgb = kind and CaptureWriter.SRGB != 0,
            isCube = isCube,
            wrapR = if (isCube) input.int() else wrapS,
            depth = if (kind and CaptureWriter.DEPTH != 0) input.int() else 0,
            border = if (kind and CaptureWriter.BORDER != 0) List(CaptureWriter.COLOR) { input.float() } else null,
        )
    }

    private fun frame(pictureBytes: Long): CapturedFrame {
        val moment = entry("moment", Moment.entries)
        val time = input.double()
        if (!time.isFinite()) throw BadCapture("the time of a frame is $time")
        val steps = input.list("steps", CaptureLimits.STEPS, ::step)
        val picture = if (input.boolean()) input.bytes("a picture", pictureBytes.toInt()) else null
        return CapturedFrame(moment, time, steps, picture)
    }

    private fun step(): CapturedStep {
        val first = input.byte()
        val isLimited = first == CaptureWriter.LIMITED
        val writes = if (isLimited) writes() else WriteMask.ALL
        return when (val kind = if (isLimited) input.byte() else first) {
            CaptureWriter.CLEAR ->
                CapturedClear(input.int(), FloatArray(CaptureWriter.COLOR) { input.float() }, input.double(), writes)
            CaptureWriter.DRAW -> draw(writes)
            else -> throw BadCapture("$kind is no kind of step")
        }
    }

    private fun writes(): WriteMask {
        val channels = input.byte()
        val box = input.list("numbers of a scissor box", CaptureWriter.VIEWPORT) { input.int("a scissor box", -MAX_VIEWPORT..MAX_VIEWPORT) }
        return WriteMask(box.takeIf { it.isNotEmpty() }, channels)
    }

    private fun draw(writes: WriteMask) =
        CapturedDraw(
            program = input.int(),
            mode = input.int(),
            count = input.int("the count of a draw", 0..Int.MAX_VALUE),
            attributes = input.list("attributes", CaptureLimits.ATTRIBUTES, ::attribute),
            indices = input.int("a draw's index buffer", -1..Int.MAX_VALUE).takeIf { it >= 0 },
            indexType = input.int(),
            first = input.long(),
            baseVertex = input.int(),
            instances = input.int("the instances of a draw", 0..CaptureLimits.INSTANCES),
            uniforms = input.list("uniforms", CaptureLimits.UNIFORMS, ::uniform),
            textures = input.map("textures", CaptureLimits.UNITS) { unit() to input.int() },
            state = state(writes),
            callers = callers(),
        )

    private fun callers() =
        DrawCallers(caller(), caller(), input.map("bound textures", CaptureLimits.UNITS) { unit() to caller() })

    private fun unit() = input.int("a unit", 0 until CaptureLimits.UNITS)

    private fun attribute() =
        CapturedAttribute(
            location = input.int("an attribute's location", 0 until CaptureLimits.ATTRIBUTES),
            size = input.int("an attribute's size", 1..4),
            type = input.int(),
            normalized = input.boolean(),
            stride = input.int("a stride", 0..MAX_STRIDE),
            offset = input.long(),
            buffer = input.int(),
        )

    private fun uniform(): UniformValue {
        val name = name()
        val type = input.int()
        val size = GlNumbers.components(type) ?: throw BadCapture("uniform $name is of the unknown type $type")
        return UniformValue(name, type, FloatArray(size) { input.float() }, caller())
    }

    private fun state(writes: WriteMask): DrawState {
        val viewport = List(CaptureWriter.VIEWPORT) { input.int("the viewport", -MAX_VIEWPORT..MAX_VIEWPORT) }
        val depthTest = input.boolean()
        val depthMask = input.boolean()
        val cullFace = input.boolean()
        val blend = input.boolean()
        val framebufferSrgb = input.boolean()
        return DrawState(
            viewport = viewport,
            depthTest = depthTest,
            depthFunc = input.int(),
            depthMask = depthMask,
            cullFace = cullFace,
            cullMode = input.int(),
            frontFace = input.int(),
            blend = blend,
            blendSource = input.int(),
            blendDestination = input.int(),
            polygonMode = input.int(),
            framebufferSrgb = framebufferSrgb,
            writes = writes,
        )
    }

    private fun name() = input.text("a name", CaptureLimits.NAME).let { names.getOrPut(it) { it } }

    private fun <E> entry(
        what: String,
        entries: List<E>,
    ): E = entries[input.byte().takeIf { it in entries.indices } ?: throw BadCapture("there is no such $what")]

    private companion object {
        const val MAX_OUTPUT = 7
        const val MAX_LEVELS = 14
        const val MAX_STRIDE = 4096
        const val MAX_VIEWPORT = 65_536
    }
}
