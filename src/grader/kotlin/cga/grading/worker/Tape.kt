package cga.grading.worker

import cga.grading.capture.Capture
import cga.grading.capture.CaptureLimits
import cga.grading.capture.CapturedEvent
import cga.grading.capture.CapturedFrame
import cga.grading.capture.CapturedProgram
import cga.grading.capture.CapturedTexture
import cga.grading.capture.EventKind
import java.util.zip.CRC32

/**
 * What has been captured so far. Every method may be called from any thread: the capture is also taken when the JVM goes down.
 *
 * Contents that come again get the number that they have. Beyond [CaptureLimits] nothing is added, and that is told as an event.
 */
internal class Tape {
    private var width = 1
    private var height = 1
    private var samples = 0
    private val programs = ArrayList<CapturedProgram>()
    private val buffers = ArrayList<ByteArray>()
    private val buffersBySum = HashMap<Long, MutableList<Int>>()
    private val textures = ArrayList<CapturedTexture>()
    private val levels = HashMap<Long, MutableList<ByteArray>>()
    private val frames = ArrayList<CapturedFrame>()
    private val events = ArrayList<CapturedEvent>()
    private val callers = LinkedHashMap<List<String>, Int>()
    private val known = HashSet<List<Any>>()
    private var bytesLeft = CaptureLimits.BYTES / 4 * 3
    private var elementsLeft = CaptureLimits.ELEMENTS / 4 * 3
    private var stepsLeft = CaptureLimits.ALL_STEPS

    /** The number that events get: of the frame that is being drawn or comes next; −1 before the first. */
    var frame = -1
        @Synchronized get

        @Synchronized set

    @Synchronized
    fun window(
        width: Int,
        height: Int,
        samples: Int,
    ) {
        this.width = width
        this.height = height
        this.samples = samples
    }

    /** Notes an event, of a call that [caller] made; the same one only once a frame. */
    @Synchronized
    fun event(
        kind: EventKind,
        text: String,
        caller: Int = -1,
    ) {
        val short = text.take(CaptureLimits.EVENT_TEXT)
        if (events.size < CaptureLimits.EVENTS - 1 &&
            known.add(listOf(kind, frame, short))
        ) {
            events += CapturedEvent(kind, frame, short, caller)
        }
    }

    /** The number of a chain of [calls], innermost first, each told once; −1 for none, and where there are too many. */
    @Synchronized
    fun caller(calls: List<String>): Int {
        val chain = calls.filterIndexed { i, call -> i == 0 || call != calls[i - 1] }.take(CaptureLimits.CALLS)
        if (chain.isEmpty()) return -1
        return callers[chain] ?: if (callers.size < CaptureLimits.CALLERS) callers.size.also { callers[chain] = it } else -1
    }

    /** The number of [program], null when there are too many. */
    @Synchronized
    fun add(program: CapturedProgram): Int? = programs.number(program, CaptureLimits.PROGRAMS, "programs")

    /** The number of a buffer with these [bytes], null when there are too many. */
    @Synchronized
    fun buffer(bytes: ByteArray): Int? {
        val same = buffersBySum.getOrPut(sum(bytes)) { mutableListOf() }
        same.firstOrNull { buffers[it].contentEquals(bytes) }?.let { return it }
        if (!afford(bytes.size)) return null
        return buffers.number(bytes, CaptureLimits.BUFFERS, "buffers")?.also { same += it }
    }

    /** The array with these texels that is to be kept: an equal one that is there already, or this; null when there are too many. */
    @Synchronized
    fun texels(bytes: ByteArray): ByteArray? {
        val same = levels.getOrPut(sum(bytes)) { mutableListOf() }
        same.firstOrNull { it.contentEquals(bytes) }?.let { return it }
        if (!afford(bytes.size)) return null
        same += bytes
        return bytes
    }

    /** The number of [texture], null when there are too many. */
    @Synchronized
    fun add(texture: CapturedTexture): Int? = textures.number(texture, CaptureLimits.TEXTURES, "textures")

    /** Whether a step of so many [elements] still fits; where it does it counts. */
    @Synchronized
    fun affordStep(elements: Int): Boolean {
        if (stepsLeft < 1 || elementsLeft < elements) return false.also { event(EventKind.NOT_CAPTURED, "more draws than a capture holds") }
        stepsLeft--
        elementsLeft -= elements
        return true
    }

    @Synchronized
    fun add(frame: CapturedFrame) {
        val picture = frame.picture
        when {
            frames.size >= CaptureLimits.FRAMES -> Unit
            picture != null && !afford(picture.size) -> frames += CapturedFrame(frame.moment, frame.time, frame.steps, null)
            else -> frames += frame
        }
    }

    /** What is there now. */
    @Synchronized
    fun capture(): Capture =
        Capture(
            width = width,
            height = height,
            programs = programs.toList(),
            buffers = buffers.toList(),
            textures = textures.toList(),
            frames = frames.toList(),
            // An event that happened after the last frame belongs to it.
            events = events.map { CapturedEvent(it.kind, minOf(it.frame, frames.size - 1), it.text, it.caller) },
            samples = samples,
            callers = callers.keys.toList(),
        )

    private fun <T> MutableList<T>.number(
        element: T,
        limit: Int,
        what: String,
    ): Int? {
        if (size >= limit) return null.also { event(EventKind.NOT_CAPTURED, "more $what than a capture holds") }
        this += element
        return lastIndex
    }

    private fun afford(bytes: Int): Boolean {
        if (bytesLeft < bytes) return false.also { event(EventKind.NOT_CAPTURED, "more bytes than a capture holds") }
        bytesLeft -= bytes
        return true
    }

    private fun sum(bytes: ByteArray): Long = CRC32().apply { update(bytes) }.value shl 32 or bytes.size.toLong()
}
