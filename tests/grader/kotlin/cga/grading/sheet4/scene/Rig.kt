package cga.grading.sheet4.scene

import cga.exercise.components.geometry.Transformable
import cga.grading.capture.Key
import cga.grading.capture.Moment
import cga.grading.scene.ObservedCone
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ObservedLight
import cga.grading.scene.ObservedObject
import cga.grading.scene.rigidPart
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3f
import kotlin.math.abs
import kotlin.math.roundToInt
import kotlin.math.sin

/** A light of a [Rig]. */
internal class Lamp(
    val name: String,
    val body: Transformable,
    val k: Vector3d,
    val inner: Double = Double.NaN,
    val outer: Double = Double.NaN,
    val isSpot: Boolean = false,
    val color: (Double) -> Vector3d,
)

/**
 * A submission of the course, as its scene looks from outside: everything is right in this one, and each part can be overridden by a
 * mistake or by a freedom. Matrices are floats that every update multiplies into, as in the course.
 */
internal open class Rig(offset: Vector3f = Vector3f(0f, 1.6f, 0f)) {
    val motorcycle = Transformable().apply { scaleLocal(Vector3f(0.8f)) }
    val camera =
        Transformable(parent = motorcycle).apply {
            rotateLocal(radians(-35.0), 0f, 0f)
            translateLocal(Vector3f(0f, 0f, 4f))
        }
    val own = Lamp("bike_lamp", lamp(offset, motorcycle), POINT_K) { ownColor(it) }
    private val front = lamp(Vector3f(0f, 0.9f, -1.6f), motorcycle)
    val head = Lamp("headlight", front, SPOT_K, Math.toRadians(10.0), Math.toRadians(25.0), true) { HEAD_COLOR }
    val corners =
        listOf(
            Lamp("corner[0]", lamp(Vector3f(-16f, 1f, -16f), null), POINT_K) { Vector3d(9.0, 0.0, 0.0) },
            Lamp("corner[1]", lamp(Vector3f(16f, 1f, 16f), null), POINT_K) { Vector3d(0.0, 0.0, 9.0) },
            Lamp("corner[2]", lamp(Vector3f(16f, 1f, -16f), null), POINT_K) { Vector3d(5.0, 5.0, 0.0) },
        )
    open val lamps: List<Lamp> = listOf(own, head) + corners

    init {
        head.body.rotateLocal(radians(-8.0), 0f, 0f)
    }

    protected var lastX = Double.NaN
    protected var lastY = Double.NaN

    open fun update(
        dt: Double,
        t: Double,
        keys: Set<Key>,
    ) {
        if (Key.FORWARD !in keys) return
        val steer = (if (Key.LEFT in keys) 1 else 0) - (if (Key.RIGHT in keys) 1 else 0)
        motorcycle.rotateLocal(0f, (1.5 * steer * dt).toFloat(), 0f)
        motorcycle.translateLocal(Vector3f(0f, 0f, (-5 * dt).toFloat()))
    }

    open fun mouse(
        x: Double,
        y: Double,
        alt: Boolean,
    ) {
        if (!lastX.isNaN()) orbit(x - lastX, y - lastY)
        lastX = x
        lastY = y
    }

    open fun orbit(
        dx: Double,
        dy: Double,
    ) {
        camera.rotateAroundPoint(0f, (-0.002 * dx).toFloat(), 0f, Vector3f())
    }

    open fun view(): Matrix4d = Matrix4d(rigidPart(camera.getWorldModelMatrix(Matrix4d()))).invert()

    open fun position(
        lamp: Lamp,
        view: Matrix4d,
    ): Vector3d = view.transformPosition(world(lamp))

    open fun direction(
        lamp: Lamp,
        view: Matrix4d,
    ): Vector3d = view.transformDirection(worldDirection(lamp))

    open fun motorcycleTint(t: Double): Vector3d? = Vector3d(abs(sin(t)), abs(sin(t / 2)), abs(sin(t / 3)))

    open fun groundTint(t: Double): Vector3d? = Vector3d(0.0, 1.0, 0.0)

    open fun ownColor(t: Double): Vector3d = motorcycleTint(t) ?: Vector3d(1.0)

    open fun lights(
        moment: Moment,
        t: Double,
        view: Matrix4d,
    ): List<ObservedLight> = lamps.map { observed(it, t, view) }

    open fun objects(
        t: Double,
        lights: List<ObservedLight>,
    ): List<ObservedObject> =
        listOf(
            ObservedObject(Matrix4d(), groundTint(t), lights, GROUND, listOf(0, 1)),
            ObservedObject(motorcycle.getWorldModelMatrix(Matrix4d()), motorcycleTint(t), lights, BIKE, listOf(2, 3)),
        )

    open fun frame(
        moment: Moment,
        t: Double,
    ): ObservedFrame {
        val view = view()
        val lights = lights(moment, t, view)
        return ObservedFrame(moment, t, view, Matrix4d().perspective(Math.PI / 2, 16.0 / 9, 0.1, 100.0), objects(t, lights), lights)
    }

    fun observed(
        lamp: Lamp,
        t: Double,
        view: Matrix4d,
    ): ObservedLight {
        val cone = if (lamp.isSpot) ObservedCone(rounded(direction(lamp, view)), lamp.inner, lamp.outer) else null
        return ObservedLight(lamp.name, rounded(position(lamp, view)), lamp.color(t), lamp.k, cone)
    }

    fun world(lamp: Lamp): Vector3d = lamp.body.getWorldModelMatrix(Matrix4d()).getTranslation(Vector3d())

    open fun worldDirection(lamp: Lamp): Vector3d = Vector3d(lamp.body.getWorldZAxis()).negate()

    /** As a float uniform holds it. */
    private fun rounded(v: Vector3d) = Vector3d(Vector3f(v.x.toFloat(), v.y.toFloat(), v.z.toFloat()))

    companion object {
        val POINT_K = Vector3d(1.0, 0.5, 0.1)
        val SPOT_K = Vector3d(0.5, 0.05, 0.01)
        val HEAD_COLOR = Vector3d(5.0, 5.0, 4.5)
        val GROUND = box(-22.4f, 0f, -22.4f, 22.4f, 0f, 22.4f)
        val BIKE = box(-0.4f, 0f, -1.2f, 0.4f, 1.4f, 1.2f)

        fun radians(degrees: Double) = Math.toRadians(degrees).toFloat()

        fun lamp(
            at: Vector3f,
            parent: Transformable?,
        ) = Transformable(parent = parent).apply { translateGlobal(at) }

        private fun box(vararg ends: Float) =
            (0..7).flatMap { i -> (0..2).map { axis -> ends[axis + if (i shr axis and 1 == 1) 3 else 0] } }.toFloatArray()
    }
}

/** The frames that the script makes of a scene: mouse first, then 120 updates a second, then the picture. */
internal fun play(
    mouse: (Double, Double, Set<Key>) -> Unit,
    update: (Double, Double, Set<Key>) -> Unit,
    frame: (Moment, Double) -> ObservedFrame,
): List<ObservedFrame> {
    var updates = 0
    return Moment.entries.map { moment ->
        moment.mouse?.let { mouse(it.x, it.y, moment.keys) }
        repeat((moment.seconds * 120).roundToInt()) { update(1 / 120.0, ++updates / 120.0, moment.keys) }
        frame(moment, updates / 120.0)
    }
}

internal fun Rig.play(): List<ObservedFrame> = play({ x, y, keys -> mouse(x, y, Key.LEFT_ALT in keys) }, ::update, ::frame)
