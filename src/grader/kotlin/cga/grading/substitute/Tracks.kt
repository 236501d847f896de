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
    /** View space → world space, frame by frame. */
    private val back: List<Matrix4dc>? = matrices.view?.let { name -> sent.frames.map { it.last().matrix(name).invert() } }

    /** Of each thing that is drawn in every frame: its own space → world space, frame by frame. */
    private val drawn: List<List<Matrix4dc>> = matrices.model?.let { name -> sent.meshes.map { ofMesh(it, name) } }.orEmpty()

    private fun ofMesh(
        mesh: List<Any?>,
        name: String,
    ) = sent.frames.map { draws -> draws.first { it.mesh == mesh }.matrix(name) }

    /** The same of the world itself among them. */
    private val carriers = drawn + listOf(List(sent.frames.size) { Matrix4d() })

    /** Whether the place that [name] holds is one in view space; false is world space. */
    fun isPlaceInView(name: String): Boolean = isInView(name, ::place)

    /** The same of a direction. */
    fun isDirectionInView(name: String): Boolean = isInView(name, ::direction)

    /** 1 or −1: what the direction [name] is to be multiplied by to point where the thing goes that goes furthest. */
    fun sign(name: String): Int {
        val steps = drawn.flatMap { own -> own.zipWithNext { a, b -> origin(b).sub(origin(a)) }.withIndex() }
        val furthest = steps.maxByOrNull { it.value.length() } ?: return 1
        val frame = furthest.index + 1
        val sent = sent.vectors(name)[frame]
        val inWorld = if (isDirectionInView(name)) back?.let { direction(it[frame], sent) } ?: sent else sent
        return if (furthest.value.dot(inWorld) < 0) -1 else 1
    }

    private fun isInView(
        name: String,
        moved: (Matrix4dc, Vector3dc) -> Vector3d,
    ): Boolean {
        val back = back ?: return matrices.modelView != null
        val sent = sent.vectors(name)

        fun spread(vectors: List<Vector3d>) =
            carriers.minOf { own -> spreadOf(vectors.mapIndexed { frame, v -> moved(own[frame].invert(Matrix4d()), v) }) }
        return spread(sent.mapIndexed { frame, v -> moved(back[frame], v) }) < CLEARLY * spread(sent)
    }

    /** How far [points] are from all being one. */
    private fun spreadOf(points: List<Vector3d>): Double = points.maxOf { it.distance(points.last()) }

    private companion object {
        const val CLEARLY = 0.1

        fun place(
            matrix: Matrix4dc,
            v: Vector3dc,
        ): Vector3d = matrix.transformPosition(v, Vector3d())

        fun direction(
            matrix: Matrix4dc,
            v: Vector3dc,
        ): Vector3d = matrix.transformDirection(v, Vector3d())

        fun origin(own: Matrix4dc): Vector3d = own.getTranslation(Vector3d())
    }
}
