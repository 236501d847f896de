package cga.exercise.game

import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import org.joml.Vector3f
import kotlin.random.Random

/** A sphere that falls from the sky, lies there for a while and comes again somewhere else. */
class Collectible(mesh: Mesh, color: Vector3f, private val random: Random) : Renderable(mutableListOf(mesh), color) {
    private var rest = 0.0f

    init {
        scaleLocal(Vector3f(RADIUS))
        drop()
    }

    fun drop() {
        val target = Vector3f(place(), 6.0f + 8.0f * random.nextFloat(), place())
        translateGlobal(target.sub(getPosition()))
        rest = 0.0f
    }

    // not in the middle, where the motorcycle starts
    private fun place() = (5.0f + 9.0f * random.nextFloat()) * (if (random.nextBoolean()) 1.0f else -1.0f)

    fun fall(dt: Float) {
        val y = getPosition().y
        if (y > RADIUS) {
            translateGlobal(Vector3f(0.0f, -minOf(2.0f * dt, y - RADIUS), 0.0f))
        } else {
            rest += dt
            if (rest > 12.0f) drop()
        }
    }

    companion object {
        const val RADIUS = 0.35f
    }
}
