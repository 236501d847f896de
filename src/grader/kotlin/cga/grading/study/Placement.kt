package cga.grading.study

import org.joml.Matrix3d
import org.joml.Matrix3dc
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.cbrt
import kotlin.math.sqrt

/** A coordinate system that a shader may do its lighting in. */
internal enum class Space { VIEW, WORLD, MODEL }

/** The ways from a model normal to the one that is lit; the first three are right when the light is in the same [Space]. */
internal enum class NormalPath(val space: Space?) {
    VIEW(Space.VIEW),
    WORLD(Space.WORLD),
    MODEL(Space.MODEL),
    VIEW_MATRIX_ONLY(null),
    INVERSE(null),

    /** Model and view in the wrong order: the same until the object turns. */
    MODEL_AFTER_VIEW(null),

    /** By the model matrix's inverse in the place of its inverse transpose, in view space and in the world. */
    MODEL_INVERSE(null),
    MODEL_INVERSE_WORLD(null),

    /** By whatever matrix is sent for them. */
    SENT(null),
}

/**
 * Where a light effectively is: the point at which the directions that it comes from meet.
 *
 * @param space in which [light] and the surface's position are.
 * @param path how normals get there.
 * @param isFlipped whether the light lights the sides that look away from it.
 * @param error root mean square of the angle between the directions found and those to [light].
 */
internal class Placement(
    private val spaces: Spaces,
    val space: Space,
    val path: NormalPath,
    val light: Vector3dc,
    val isFlipped: Boolean,
    val error: Double,
) {
    private val toSpace: Matrix4dc = spaces.to(space) ?: Matrix4d()
    private val fromSpace: Matrix4dc = toSpace.invert(Matrix4d())
    private val normals: Matrix3dc = spaces.normals(path) ?: Matrix3d()

    val isConsistent: Boolean get() = path.space == space

    /** The light in view space. */
    val view: Vector3d get() = fromSpace.transformPosition(light, Vector3d())

    /** The same with the light at [view] in view space. */
    fun movedTo(view: Vector3dc): Placement =
        Placement(spaces, space, path, toSpace.transformPosition(view, Vector3d()), isFlipped, error)

    /** From [sample] to the light, in [space]. */
    fun toLight(p: Vector3dc): Vector3d = Vector3d(light).sub(toSpace.transformPosition(p, Vector3d()))

    /** The point in view space that lies at [offset] (in [space]) from the light. */
    fun at(offset: Vector3dc): Vector3d = fromSpace.transformPosition(Vector3d(light).add(offset), Vector3d())

    /** The sample normal that arrives in the shader as [wanted] in [space]. */
    fun normalFor(wanted: Vector3dc): Vector3d = normals.transformTranspose(wanted, Vector3d()).also { spaces.rotation.transform(it) }

    /** The normal of [sample] as the shader has it, in [space]. */
    fun normalOf(normal: Vector3dc): Vector3d = spaces.rotation.transformTranspose(normal, Vector3d()).also { normals.transform(it) }

    /** A view space direction in [space]. */
    fun directionFromView(v: Vector3dc): Vector3d = toSpace.transformDirection(v, Vector3d())

    /** A direction of [space] in view space, unit length. */
    fun directionToView(v: Vector3dc): Vector3d = fromSpace.transformDirection(v, Vector3d()).normalize()

    /** From [p] to the eye in [space], if the eye is where a right shader has it. */
    fun toCamera(p: Vector3dc): Vector3d = directionFromView(Vector3d(p).negate())

    companion object {
        /** A light at [light] in view space, where everything is as it should be but perhaps the normals' [path]. */
        fun inView(
            spaces: Spaces,
            light: Vector3dc,
            path: NormalPath = NormalPath.VIEW,
        ): Placement = Placement(spaces, Space.VIEW, path, light, isFlipped = false, error = 0.0)

        /** The placement that explains [gradients] with the least error, right ones first; null where there are too few. */
        fun of(
            spaces: Spaces,
            gradients: List<Gradient>,
        ): Placement? {
            val usable = gradients.filter { it.strength > 0 && it.direction.isFinite }
            if (usable.size < 4) return null
            val all = COMBINATIONS.mapNotNull { (space, path) -> of(spaces, space, path, usable) }
            return all.firstOrNull { it.error < ACCEPTED && it.isConsistent } ?: all.minByOrNull { it.error }
        }

        /** The placement in [space] with normals by [path], whatever its error. */
        fun of(
            spaces: Spaces,
            space: Space,
            path: NormalPath,
            gradients: List<Gradient>,
        ): Placement? {
            val toSpace = spaces.to(space) ?: return null
            val normals = spaces.normals(path) ?: return null
            val rays =
                gradients.map { g ->
                    val u = spaces.rotation.transformTranspose(g.direction, Vector3d()).also { normals.transform(it) }.normalize()
                    toSpace.transformPosition(g.point, Vector3d()) to u
                }
            var light = meeting(rays, null) ?: return null
            // Second time with the same weight for every angle instead of every distance.
            repeat(2) { light = meeting(rays, light) ?: return null }
            val sines = rays.map { (p, u) -> Vector3d(light).sub(p).normalize() to u }
            val error = sqrt(sines.sumOf { (l, u) -> l.cross(u, Vector3d()).lengthSquared() } / rays.size)
            val behind = sines.count { (l, u) -> l.dot(u) < 0 }
            val oneSided = minOf(behind, rays.size - behind) * 20 <= rays.size
            return Placement(spaces, space, path, light, behind * 2 > rays.size, if (oneSided) error else 1.0)
        }

        /** The point nearest to all lines; each weighs as if seen from [about]. */
        private fun meeting(
            rays: List<Pair<Vector3d, Vector3d>>,
            about: Vector3dc?,
        ): Vector3d? {
            val equations = LeastSquares(3)
            for ((p, u) in rays) {
                val weight = if (about == null) 1.0 else 1 / (about.distanceSquared(p) + 1e-6)
                for (axis in 0..2) {
                    val row = DoubleArray(3) { (if (it == axis) 1.0 else 0.0) - u[it] * u[axis] }
                    equations.add(row, row[0] * p.x + row[1] * p.y + row[2] * p.z, weight)
                }
            }
            return equations.solve()?.let { Vector3d(it[0], it[1], it[2]) }
        }

        // A gradient is a difference of floats, its direction good to some 1e-6; steep cones and near lights cost two digits.
        const val ACCEPTED: Double = 2e-3
        private val CONSISTENT = listOf(Space.VIEW to NormalPath.VIEW, Space.WORLD to NormalPath.WORLD, Space.MODEL to NormalPath.MODEL)
        private val COMBINATIONS =
            CONSISTENT + Space.entries.flatMap { s -> NormalPath.entries.map { s to it } }.filter { it !in CONSISTENT }
    }
}

/** View space → [space]; null where it is not known. */
internal fun Spaces.to(space: Space): Matrix4d? =
    when (space) {
        Space.VIEW -> Matrix4d()
        Space.WORLD -> view?.invert(Matrix4d())
        Space.MODEL -> modelView.invert(Matrix4d())
    }

/** Model normals → what the shader lights, a rotation; null where a matrix is not known. */
internal fun Spaces.normals(path: NormalPath): Matrix3d? =
    when (path) {
        NormalPath.VIEW -> modelView.rotationPart()
        NormalPath.WORLD -> model?.rotationPart()
        NormalPath.MODEL -> Matrix3d()
        NormalPath.VIEW_MATRIX_ONLY -> view?.rotationPart()
        NormalPath.INVERSE -> modelView.rotationPart().transpose()
        NormalPath.MODEL_AFTER_VIEW -> view?.let { view -> model?.rotationPart()?.mul(view.rotationPart()) }
        NormalPath.MODEL_INVERSE -> view?.let { view -> model?.rotationPart()?.transpose()?.let { view.rotationPart().mul(it) } }
        NormalPath.MODEL_INVERSE_WORLD -> model?.rotationPart()?.transpose()
        NormalPath.SENT -> sentNormals?.let(::Matrix3d)
    }

internal val Spaces.rotation: Matrix3dc get() = modelView.rotationPart()

/** How much lengths grow by this matrix. */
internal fun Matrix4dc.scale(): Double = cbrt(abs(determinant3x3()))

internal fun Matrix4dc.rotationPart(): Matrix3d = Matrix3d(this).scale(1 / scale())
