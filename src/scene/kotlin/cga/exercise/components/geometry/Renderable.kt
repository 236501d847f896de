package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.framework.FrameDraw
import org.joml.Matrix3f
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Matrix4f
import org.joml.Matrix4fc
import org.joml.Vector3f
import org.joml.Vector3fc

/** Meshes that move together. */
public open class Renderable(
    public val meshes: List<Mesh>,
    modelMatrix: Matrix4fc = Matrix4f(),
    parent: Transformable? = null,
) : Transformable(modelMatrix, parent) {
    private val modelView = Matrix4d()
    private val modelViewSent = Matrix4f()
    private val normalMatrix = NormalMatrix()
    private val normalMatrixSent = Matrix3f()

    /**
     * Draws the meshes as seen through [view] (world space → view space).
     *
     * Model and view are multiplied in double precision and rounded once: far from the origin both hold large numbers that nearly
     * cancel, and floats would lose the small difference.
     */
    public fun render(
        shaderProgram: ShaderProgram,
        view: Matrix4dc,
    ) {
        getWorldModelMatrix(modelView).mulLocal(view)
        shaderProgram.setUniform("modelView", modelViewSent.set(modelView), false)
        shaderProgram.setUniform("normalMatrix", normalMatrix.of(modelView, normalMatrixSent), false)
        for (i in meshes.indices) meshes[i].render(shaderProgram)
    }

    /** The draw calls of [render] as plain data; meshes without a material have none to speak of and are an [IllegalStateException]. */
    public fun toFrameDraws(tint: Vector3fc): List<FrameDraw> =
        meshes.map { mesh ->
            val material = checkNotNull(mesh.material) { "a mesh without a material cannot be part of a frame" }
            FrameDraw(mesh.vertexdata, mesh.indexdata, getWorldModelMatrix(Matrix4d()), Vector3f(tint), material.toFrameMaterial())
        }

    /** Frees what the meshes and their materials hold on the GPU. */
    public fun cleanup() {
        for (mesh in meshes) {
            mesh.cleanup()
            mesh.material?.cleanup()
        }
    }
}
