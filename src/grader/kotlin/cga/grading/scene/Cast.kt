package cga.grading.scene

import cga.grading.capture.Moment
import org.joml.Vector3d
import kotlin.math.abs
import kotlin.math.max
import kotlin.math.min

/**
 * An object through all frames.
 *
 * @param buffers of the object; where other draws shared its matrix and tint in a frame, it is part of a larger one there.
 * @param ordinal which of the objects made of the same buffers.
 */
internal class Track(private val buffers: List<Int>, private val ordinal: Int) {
    fun of(frame: ObservedFrame): ObservedObject? {
        val same = frame.objects.filter { it.buffers.containsAll(buffers) }
        return same.getOrNull(ordinal) ?: same.lastOrNull()
    }
}

/**
 * Who is who.
 *
 * @param motorcycle the object that is driven, or that looks most like it where none can be; null in an empty scene.
 * @param driven whether it moves in the world: without that nobody can see what moves with it.
 */
internal class Cast(val motorcycle: Track?, val ground: Track?, val driven: Boolean)

/** The objects of [frame], to be found again in others. */
internal fun tracks(frame: ObservedFrame): List<Track> {
    val seen = HashMap<List<Int>, Int>()
    return frame.objects.map { Track(it.buffers, seen.merge(it.buffers, 1, Int::plus)?.minus(1) ?: 0) }
}

/** Finds out who is who: what moves when it is driven is the motorcycle, what is large, flat and stays is the ground. */
internal class Casting(private val frames: List<ObservedFrame>) {
    private val byMoment = frames.associateBy { it.moment }

    fun cast(): Cast {
        // After the drive, where nothing shares a matrix with the motorcycle by chance.
        val last = frames.lastOrNull { it.objects.isNotEmpty() && it.view.isUsable() } ?: return Cast(null, null, false)
        val tracks = tracks(last)
        val driven = tracks.filter(::isDriven)
        val ground = ground(tracks - driven.toSet(), last)
        val motorcycle = driven.maxByOrNull { vertices(it, last) } ?: (tracks - setOfNotNull(ground)).maxByOrNull { likeness(it, last) }
        return Cast(motorcycle, ground, motorcycle != null && (driven.isNotEmpty() || moves(motorcycle)))
    }

    /** Whether it goes anywhere by itself. */
    private fun moves(track: Track): Boolean = (DRIVES + IDLE).any { (speed(track, it) ?: 0.0) > STANDSTILL }

    private fun isDriven(track: Track): Boolean {
        val idle = IDLE.mapNotNull { speed(track, it) }.maxOrNull() ?: 0.0
        val driving = DRIVES.mapNotNull { speed(track, it) }.maxOrNull() ?: return false
        return driving > 2 * idle + STANDSTILL
    }

    /** World units a second up to [moment], or null. */
    private fun speed(track: Track, moment: Moment): Double? {
        val before = place(track, Moment.entries[moment.ordinal - 1]) ?: return null
        return place(track, moment)?.let { it.distance(before) / moment.seconds }
    }

    private fun place(
        track: Track,
        moment: Moment,
    ): Vector3d? = byMoment[moment]?.let(track::of)?.model?.takeIf { it.isUsable() }?.translation()

    private fun vertices(track: Track, frame: ObservedFrame) = track.of(frame)?.vertices?.size ?: 0

    private fun ground(tracks: List<Track>, frame: ObservedFrame): Track? {
        val sizes = tracks.mapNotNull { track -> track.of(frame)?.let(::bounds)?.let { track to it } }
        val flat = sizes.filter { (_, it) -> it.height < FLAT * it.width }
        return flat.ifEmpty { sizes }.maxByOrNull { (_, it) -> it.width }?.first
    }

    /** How much a thing that stands still resembles a motorcycle: the course's scale, where the camera looks, a fine mesh. */
    private fun likeness(track: Track, frame: ObservedFrame): Double {
        val shown = track.of(frame)?.takeIf { it.model.isUsable() } ?: return -1.0
        val seen = frame.view.transformPosition(shown.model.translation(), Vector3d())
        val centred = if (seen.z < 0) -seen.z / seen.length() else 0.0
        val scaled = if (abs(shown.model.scale() - COURSE_SCALE) < SCALE_MARGIN) 1.0 else 0.0
        val most = max(1, frame.objects.maxOf { it.vertices.size })
        return scaled + 2 * centred + shown.vertices.size.toDouble() / most
    }

    private companion object {
        val IDLE = listOf(Moment.TIME_1, Moment.TIME_2, Moment.TIME_3, Moment.TIME_4)
        val DRIVES = listOf(Moment.DRIVEN, Moment.STEERED, Moment.MOUSE_DRIVEN)

        /** Units a second. */
        const val STANDSTILL = 0.01
        const val FLAT = 0.1
        const val COURSE_SCALE = 0.8
        const val SCALE_MARGIN = 0.01
    }
}

/** The box that an object fills, in world space. */
internal class Bounds(val least: Vector3d, val most: Vector3d) {
    val width: Double get() = max(most.x - least.x, most.z - least.z)
    val height: Double get() = most.y - least.y
}

/** The box in world space, or null where there is nothing. */
internal fun bounds(shown: ObservedObject): Bounds? {
    val least = Vector3d(Double.POSITIVE_INFINITY)
    val most = Vector3d(Double.NEGATIVE_INFINITY)
    shown.eachWorldVertex {
        least.min(it)
        most.max(it)
    }
    return if (least.isFinite && most.isFinite) Bounds(least, most) else null
}

/** The height of the ground: of what lies at its outermost ends, since things may stand on it. */
internal fun groundHeight(ground: ObservedObject): Double? {
    val box = bounds(ground) ?: return null
    val margin = box.width * 1e-3
    var height = Double.POSITIVE_INFINITY
    ground.eachWorldVertex { if (min(it.x - box.least.x, box.most.x - it.x) <= margin) height = min(height, it.y) }
    return height.takeIf { it.isFinite() }
}

/** Hands each vertex on in world space; the vector is used again. */
private inline fun ObservedObject.eachWorldVertex(use: (Vector3d) -> Unit) {
    val point = Vector3d()
    for (i in 0..vertices.size - 3 step 3) {
        use(model.transformPosition(point.set(vertices[i].toDouble(), vertices[i + 1].toDouble(), vertices[i + 2].toDouble())))
    }
}
