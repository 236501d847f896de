package cga.measure.accuracy.hard

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Transformable
import cga.exercise.components.light.PointLight
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3d
import org.joml.Vector3f
import org.joml.Vector3fc
import kotlin.math.abs
import kotlin.math.pow
import kotlin.random.Random

/**
 * The scene far from the origin: a model there, its light and its camera both children of it, as on the motorcycle. The truth starts from
 * the same float matrices, which far out hold only every so many units: where things stand is rounded, what they look like need not be.
 */
internal class DistanceCases(private val probe: Probe) {
    fun measure(): List<HardCase> = (1..8).map(::at)

    private fun at(decade: Int): HardCase {
        val distance = 10.0.pow(decade).toFloat()
        val place = Matrix4f().translate(distance, 0f, -0.7f * distance).rotateY(0.7f)
        val seat = Matrix4f().rotateY(0.4f).rotateX(-0.6f).translate(0f, 0f, 4f)
        val model = Transformable(place)
        val camera = TronCamera(parent = model).apply { setLocalModelMatrix(seat) }
        val light = PointLight(Vector3f(0.2f, 1.6f, -0.3f), WHITE).apply { parent = model }
        val view = camera.calculateViewMatrix(Matrix4d())
        val modelView = Matrix4d(view).mul(model.getWorldModelMatrix(Matrix4d()))
        val course = Course(place, seat, light.getPosition())
        val shots = shots(light, modelView, view)
        val truths = shots.map { it.truth().color.x }
        val seen = probe.shade(shots)
        val step = Math.ulp(distance)
        return HardCase(
            name = "scene 1e$decade units from the origin",
            naive = "world positions and matrices in floats",
            naiveError = 255 * shots.indices.maxOf { abs(course.color(shots[it]) - truths[it]) },
            ours = "model-view composed in double",
            ourError = 255 * shots.indices.maxOf { abs(seen[it].x - truths[it]) },
            bound = 255 * shots.maxOf(::bound),
            unit = ErrorUnit.COLOR,
            failure = if (distance >= FIRST_LOST) "a float's step there is %s units".format(plain(step)) else "",
        )
    }

    private fun shots(
        light: PointLight,
        modelView: Matrix4d,
        view: Matrix4d,
    ): List<Shot> {
        val random = Random(7)
        return List(1_000) {
            val position = Vector3f(random.nextFloat() - 0.5f, random.nextFloat(), random.nextFloat() - 0.5f)
            val normal = Vector3f(random.nextFloat() - 0.5f, 1f, random.nextFloat() - 0.5f).normalize()
            Shot(position, normal, lights = listOf(light), modelView = modelView, view = view)
        }
    }

    /**
     * The float model-view matrix moves a point by u of each of four products and their sums, 8u of its distance from the eye, and the
     * light by u of its own; over the distance between them that turns l, and it changes d, which changes F by at most as much.
     */
    private fun bound(shot: Shot): Double {
        val position = shot.modelView.transformPosition(Vector3d(shot.position))
        val light = shot.view.transformPosition(shot.lights.single().getWorldPosition(Vector3d()))
        val moved = (8 * position.length() + light.length()) / light.distance(position)
        return Rounding.COSINE + 2 * moved * Rounding.U + Rounding.ATTENUATION + 6 * Rounding.U + Rounding.PRODUCTS
    }

    /** The course's way: world matrix, view matrix and the light's world position, each in floats, multiplied in floats. */
    private class Course(
        place: Matrix4f,
        seat: Matrix4f,
        light: Vector3fc,
    ) {
        private val view = Matrix4f(place).mul(seat).invert()
        private val modelView = Matrix4f(view).mul(place)
        private val lightView = view.transformPosition(place.transformPosition(Vector3f(light)))

        fun color(shot: Shot): Float {
            val toLight = Vector3f(lightView).sub(modelView.transformPosition(Vector3f(shot.position)))
            val normal = modelView.transformDirection(Vector3f(shot.normal))
            return Naive.attenuation(toLight, shot.lights.single().attenuation) * Naive.diffuse(normal, toLight)
        }
    }

    private fun plain(step: Float) = step.toBigDecimal().stripTrailingZeros().toPlainString()

    private companion object {
        val WHITE: Vector3fc = Vector3f(1f)

        /** The first decade in which the naive form is off by more than a step of 8 bits. */
        const val FIRST_LOST = 1e5f
    }
}
