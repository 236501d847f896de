package cga.exercise.engine

import cga.exercise.components.camera.ICamera
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.ShaderWriter
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f
import org.lwjgl.opengl.GL11.*

/** Walks the scene, makes a list of what is to be drawn, the nearest first, and draws it. */
class Renderer(private val root: Entity, private val camera: ICamera) {
    private class Draw(val mesh: Mesh, val modelView: Matrix4f, val emission: Vector3f)

    private val lights = LinkedHashMap<String, PointLight>()
    private val shader: ShaderProgram

    init {
        root.walk { entity -> entity.find<Lamp>()?.let { lights[entity.name] = it.light } }
        val (spots, points) = lights.keys.partition { lights[it] is SpotLight }
        val writer = ShaderWriter(points, spots)
        shader = ShaderProgram(writer.vertexShader(), writer.fragmentShader())
    }

    fun render() {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        val view = camera.getCalculateViewMatrix()
        shader.use()
        shader.setUniform("projection", camera.getCalculateProjectionMatrix())
        lights.forEach { (name, light) -> light.bind(shader, name, view) }

        for (draw in drawList(view)) {
            shader.setUniform("modelView", draw.modelView)
            shader.setUniform("normalMatrix", draw.modelView.normal(Matrix3f()))
            shader.setUniform("emission", draw.emission)
            draw.mesh.render(shader)
        }
    }

    private fun drawList(view: Matrix4f): List<Draw> {
        val list = ArrayList<Draw>()
        root.walk { entity ->
            val shape = entity.find<Shape>() ?: return@walk
            val modelView = view.mul(entity.node.getWorldModelMatrix(), Matrix4f())
            val emission = entity.find<Emission>()?.color ?: Vector3f(1.0f)
            shape.meshes.mapTo(list) { Draw(it, modelView, emission) }
        }
        return list.sortedBy { it.modelView.getTranslation(Vector3f()).length() }
    }

    fun cleanup() {
        root.walk { entity -> entity.find<Shape>()?.meshes?.forEach { it.cleanup() } }
        shader.cleanup()
    }
}
