package cga.grading.study

import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Wrong ways that a shader may take a world position into what it uses as view space; the right one is the view matrix, and a position
 * that is taken as it comes is the scene's to judge.
 */
internal object Detours {
    /** Where [world] comes to by each of the ways; none where the view is not known. */
    fun of(
        spaces: Spaces,
        world: Vector3dc,
    ): List<Vector3d> {
        val view = spaces.view ?: return emptyList()
        val matrices =
            listOfNotNull(
                view.mul(view, Matrix4d()),
                view.invert(Matrix4d()),
                spaces.model,
                spaces.model?.mul(view, Matrix4d()),
                // As a vertex goes, though what was sent is in the world already.
                spaces.modelView,
                spaces.projection.mul(view, Matrix4d()),
            )
        return matrices.map { it.transformPosition(world, Vector3d()) } + view.transformDirection(world, Vector3d())
    }
}
