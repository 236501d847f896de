package cga.grading.scene

import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.max

/** What was done to positions before they were used as positions in view space; a submission does the same to all its lights as a rule. */
internal enum class Space { VIEW, RAW, SCALED, TWICE, TURNED, INVERSE, MODEL_TWICE, TRANSPOSED, FIRST_VIEW }

/**
 * A hypothesis about where a light is: that the numbers which act as its view-space position are [matrix] times something constant.
 *
 * @param rides whether such a light moves with the motorcycle; null where that cannot be told.
 * @param space which path its numbers went.
 * @param text what is wrong, for people.
 */
internal enum class Place(
    val rides: Boolean?,
    val space: Space,
    val text: String,
    val matrix: (Shot) -> Matrix4dc,
) {
    CHILD(true, Space.VIEW, "moves and turns with the motorcycle", { it.viewed(it.motorcycle) }),
    STATIC(false, Space.VIEW, "stays in the world", { it.view }),
    FOLLOWER(true, Space.VIEW, "moves with the motorcycle but does not turn", {
        it.viewed(Matrix4d().translation(it.motorcycle.translation()))
    }),
    WORLD_CHILD(true, Space.RAW, "its world position is used as if it were in view space", { it.motorcycle }),
    CONSTANT(null, Space.RAW, "the same numbers whatever the camera sees: they never went through the view matrix", { Matrix4d() }),
    SCALED_CHILD(true, Space.SCALED, "it goes through a view matrix stretched by the motorcycle's scale", { it.stretched(it.motorcycle) }),
    SCALED_STATIC(false, Space.SCALED, "it goes through a view matrix stretched by the motorcycle's scale", { it.stretched(Matrix4d()) }),
    TWICE_CHILD(true, Space.TWICE, "the view matrix is applied twice", { Matrix4d(it.view).mul(it.viewed(it.motorcycle)) }),
    TWICE_STATIC(false, Space.TWICE, "the view matrix is applied twice", { Matrix4d(it.view).mul(it.view) }),
    TURNED_CHILD(true, Space.TURNED, "the view's rotation is applied without its translation", { it.turned(it.motorcycle) }),
    TURNED_STATIC(false, Space.TURNED, "the view's rotation is applied without its translation", { it.turned(Matrix4d()) }),
    INVERSE_CHILD(true, Space.INVERSE, "the camera's own matrix is applied to it", { Matrix4d(it.fromView).mul(it.motorcycle) }),
    INVERSE_STATIC(false, Space.INVERSE, "the camera's own matrix is applied to it", { it.fromView }),
    MODEL_TWICE(true, Space.MODEL_TWICE, "the motorcycle's matrix is applied twice", {
        it.viewed(Matrix4d(it.motorcycle).mul(it.motorcycle))
    }),
    TRANSPOSED_CHILD(true, Space.TRANSPOSED, "it stands to the left of the view matrix, which is transposed by that", {
        it.turnedBack(it.motorcycle)
    }),
    TRANSPOSED_STATIC(false, Space.TRANSPOSED, "it stands to the left of the view matrix, which is transposed by that", {
        it.turnedBack(Matrix4d())
    }),
    FIRST_VIEW_CHILD(true, Space.FIRST_VIEW, "it goes through the view matrix of the first picture", {
        Matrix4d(it.firstView).mul(it.motorcycle)
    }),
    FIRST_VIEW_STATIC(false, Space.FIRST_VIEW, "it goes through the view matrix of the first picture", { it.firstView }),
    ;

    /** Whether the numbers are a position in view space at all. */
    val right: Boolean get() = space == Space.VIEW

    /** How well it explains [light]: null where that cannot be reckoned. */
    fun fit(
        light: LightTrack,
        shots: List<Shot>,
    ): Fit? = fit(shots.mapNotNull { shot -> light.at(shot.moment)?.let { matrix(shot) to it.position } })
}

private fun Shot.viewed(model: Matrix4dc) = Matrix4d(view).mul(model)

private fun Shot.turned(model: Matrix4dc) = Matrix4d().set(viewTurn).mul(model)

private fun Shot.turnedBack(model: Matrix4dc) = Matrix4d().set(viewTurn).transpose().mul(model)

private fun Shot.stretched(model: Matrix4dc) = Matrix4d().scaling(1 / motorcycle.scale()).mul(viewed(model))

/**
 * The constant point that explains positions best.
 *
 * @param residual the largest distance that is left, relative to the positions' own distance from the camera.
 */
internal class Fit(
    val point: Vector3d,
    val residual: Double,
)

/** Least squares for the point u in matrix · u = position; null where the matrices do not determine it. */
internal fun fit(samples: List<Pair<Matrix4dc, Vector3dc>>): Fit? {
    if (samples.isEmpty()) return null
    val normal = Matrix3d().zero()
    val right = Vector3d()
    for ((matrix, position) in samples) {
        val transposed = matrix.get3x3(Matrix3d()).transpose()
        normal.add(Matrix3d(transposed).mul(matrix.get3x3(Matrix3d())))
        right.add(transposed.transform(position.sub(matrix.translation(), Vector3d())))
    }
    val point = normal.invert().transform(right)
    if (!point.isFinite) return null
    val left = samples.maxOf { (matrix, position) -> matrix.transformPosition(point, Vector3d()).distance(position) }
    // A light may be at the camera: then what is left is measured in whole units.
    val reach = max(samples.sumOf { (_, position) -> position.length() } / samples.size, LEAST_REACH)
    return Fit(point, left / reach)
}

/** World units. */
private const val LEAST_REACH = 0.1
