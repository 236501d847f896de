package cga.grading.substitute

import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * In which space places and directions are sent: in the one in which they keep to the world, or to something that is drawn.
 *
 * @param matrices of the program that [sent] is all about.
 */
internal class Tracks(
    private val sent: Sent,
    private val matrices: Matrices,
) {
    private val views: List<Matrix4dc>? = matrices.view?.let { name -> sent.frames.map { it.last().matrix(name).invert() } }

    /** For each thing that is drawn in every frame, and for the world itself: world space → its own. */
    private val carriers: List<List<Matrix4dc>> =
        matrices.model.let { name ->
            val meshes = sent.frames.map { frame -> frame.map { it.mesh } }.reduceOrNull { a, b -> a.filter { it in b } }.orEmpty().distinct()
            val own = meshes.map { mesh -> sent.frames.map { frame -> name?.let { frame.first { it.mesh == mesh }.matrix(name).invert() } ?: Matrix4d() } }
            own + listOf(List(sent.frames.size) { Matrix4d() })
        }

    /** Whether the place that [name] holds is one in view space; false is world space. */
    fun isPlaceInView(name: String): Boolean = isInView(name) { matrix, v -> matrix.transformPosition(v, Vector3d()) }

    /** The same of a direction. */
    fun isDirectionInView(name: String): Boolean = isInView(name) { matrix, v -> matrix.transformDirection(v, Vector3d()) }

    /** 1 or −1: what the direction [name] is to be multiplied by to point where things go. */
    fun sign(name: String): Int {
        val directions = sent.vectors(name).mapIndexed { frame, v -> if (isDirectionInView(name)) views?.get(frame)?.transformDirection(v, Vector3d()) ?: v else v }
        val way = carriers.maxOf { own -> (1 until own.size).map { step(own, it) to it }.maxByOrNull { it.first.length() }.let { Way(it?.first ?: Vector3d(), it?.second ?: 0) } }
        return if (way.step.dot(directions[way.frame]) < 0) -1 else 1
    }

    private class Way(
        val step: Vector3d,
        val frame: Int,
    ) : Comparable<Way> {
        override fun compareTo(other: Way): Int = step.length().compareTo(other.step.length())
    }

    private fun step(
        own: List<Matrix4dc>,
        frame: Int,
    ): Vector3d = origin(own[frame]).sub(origin(own[frame - 1]))

    private fun origin(own: Matrix4dc): Vector3d = own.invert(Matrix4d()).getTranslation(Vector3d())

    private fun isInView(
        name: String,
        moved: (Matrix4dc, Vector3dc) -> Vector3d,
    ): Boolean {
        val back = views ?: return matrices.modelView != null
        val sent = sent.vectors(name)
        val world = carriers.minOf { own -> spread(sent.mapIndexed { frame, v -> moved(own[frame], v) }) }
        val view = carriers.minOf { own -> spread(sent.mapIndexed { frame, v -> moved(own[frame], moved(back[frame], v)) }) }
        return view < CLEARLY * world
    }

    /** How far [points] are from all being one. */
    private fun spread(points: List<Vector3d>): Double = points.maxOf { it.distance(points.last()) }

    private companion object {
        const val CLEARLY = 0.1
    }
}
