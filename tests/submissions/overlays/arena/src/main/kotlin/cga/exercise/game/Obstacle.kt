package cga.exercise.game

import cga.exercise.components.geometry.Renderable
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/** Alles, wogegen man fahren kann. */
abstract class Obstacle(val model: Renderable, val color: Vector3f) {
    abstract fun update(t: Float)
    abstract fun hits(p: Vector3f): Boolean
}

/** Ein Tor, das hin und her fährt. */
class Wall(model: Renderable, color: Vector3f, private val center: Vector3f, private val way: Vector3f, private val half: Vector3f) :
    Obstacle(model, color) {

    override fun update(t: Float) {
        val p = Vector3f(way).mul(sin(0.6f * t)).add(center)
        model.modelMatrix = Matrix4f().translate(p).scale(half)
    }

    override fun hits(p: Vector3f): Boolean {
        val d = model.getWorldPosition().sub(p)
        return abs(d.x) < half.x + RADIUS && abs(d.z) < half.z + RADIUS
    }
}

/** Ein Gegner fährt im Kreis. */
class Opponent(model: Renderable, color: Vector3f, private val center: Vector3f, private val radius: Float, private val speed: Float) :
    Obstacle(model, color) {

    override fun update(t: Float) {
        val a = speed * t
        model.modelMatrix = Matrix4f()
            .translate(center.x + radius * sin(a), 0.0f, center.z + radius * cos(a))
            .rotateY(a - (PI / 2).toFloat())
            .scale(0.8f)
    }

    override fun hits(p: Vector3f): Boolean = model.getWorldPosition().distance(p) < 2.0f * RADIUS
}

const val RADIUS = 0.9f
