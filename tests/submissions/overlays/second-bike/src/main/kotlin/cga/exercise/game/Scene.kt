package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {

    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground = Renderable()
    private val bike: Renderable
    private val parkedBike: Renderable
    private val camera = TronCamera()

    private val bikeLight = PointLight(Vector3f(0.0f, 1.8f, 0.2f), Vector3f(1.0f))
    private val headlight = SpotLight(Vector3f(0.0f, 0.9f, -1.9f), Vector3f(3.0f, 3.0f, 3.0f), toRadians(14.0f), toRadians(26.0f))
    private val ringLights = ArrayList<PointLight>()
    private val satellite = PointLight(Vector3f(9.0f, 1.5f, 0.0f), Vector3f(4.0f, 2.5f, 1.0f))

    private val groundTint = Vector3f(0.0f, 1.0f, 0.0f)
    private val parkedTint = Vector3f(1.0f, 0.3f, 0.1f)

    private var firstMouse = true
    private var oldX = 0.0

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        // Boden
        val stride = 8 * 4
        val attributes = arrayOf(VertexAttribute(3, stride, 0), VertexAttribute(2, stride, 12), VertexAttribute(3, stride, 20))
        val groundObj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val groundMaterial = Material(
            tex("assets/textures/ground_diff.png"),
            tex("assets/textures/ground_emit.png"),
            tex("assets/textures/ground_spec.png"),
            60.0f,
            Vector2f(64.0f)
        )
        ground.meshes.add(Mesh(groundObj.vertexData, groundObj.indexData, attributes, groundMaterial))

        // Motorrad
        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f) ?: throw Exception("motorcycle.obj not found")
        bike.scaleLocal(Vector3f(0.8f))

        // noch eins, steht nur am Rand (gleiche Meshes)
        parkedBike = Renderable(bike.meshes)
        parkedBike.translateLocal(Vector3f(-4.0f, 0.0f, -2.5f))
        parkedBike.rotateLocal(0.0f, toRadians(50.0f), 0.0f)
        parkedBike.scaleLocal(Vector3f(0.8f))

        // Kamera
        camera.parent = bike
        camera.translateLocal(Vector3f(0.0f, 2.3f, 3.6f))
        camera.rotateLocal(toRadians(-30.0f), 0.0f, 0.0f)

        // Lichter
        bikeLight.parent = bike
        headlight.rotateLocal(toRadians(-9.0f), 0.0f, 0.0f)
        headlight.parent = bike

        val ringColors = listOf(
            Vector3f(6.0f, 0.5f, 0.5f), Vector3f(0.5f, 6.0f, 0.5f), Vector3f(0.5f, 0.5f, 6.0f),
            Vector3f(5.0f, 5.0f, 0.5f), Vector3f(0.5f, 5.0f, 5.0f), Vector3f(5.0f, 0.5f, 5.0f)
        )
        for (i in ringColors.indices) {
            val phi = (i * 2.0 * PI / ringColors.size).toFloat()
            ringLights.add(PointLight(Vector3f(17.0f * cos(phi), 1.5f, 17.0f * sin(phi)), ringColors[i]))
        }
        GLError.checkThrow()
    }

    private fun tex(path: String) = Texture2D(path, true).apply {
        setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val tint = Vector3f(0.5f + 0.5f * sin(t), 0.5f + 0.5f * sin(0.8f * t + 2.0f), 0.5f + 0.5f * sin(1.3f * t + 4.0f))
        bikeLight.lightColor.set(tint)

        staticShader.use()
        camera.bind(staticShader)

        bikeLight.bind(staticShader, "lights[0]")
        var n = 1
        for (light in ringLights) {
            light.bind(staticShader, "lights[$n]")
            n++
        }
        satellite.bind(staticShader, "lights[$n]")
        staticShader.setUniform("lightCount", n + 1)
        headlight.bind(staticShader, "spot", camera.getCalculateViewMatrix())

        staticShader.setUniform("tint", groundTint)
        ground.render(staticShader)
        staticShader.setUniform("tint", tint)
        bike.render(staticShader)
        staticShader.setUniform("tint", parkedTint)
        parkedBike.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        // das freie Licht kreist langsam um die Mitte
        satellite.rotateAroundPoint(0.0f, 0.35f * dt, 0.0f, Vector3f(0.0f))

        var speed = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) speed += 6.0f
        if (window.getKeyState(GLFW_KEY_S)) speed -= 4.0f
        if (speed != 0.0f) {
            if (window.getKeyState(GLFW_KEY_A)) bike.rotateLocal(0.0f, 1.2f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) bike.rotateLocal(0.0f, -1.2f * dt, 0.0f)
            bike.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (key == GLFW_KEY_L && action == GLFW_PRESS) headlight.toggle()
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            oldX = xpos
            firstMouse = false
        }
        val deltaX = xpos - oldX
        oldX = xpos
        camera.rotateAroundPoint(0.0f, -(deltaX * 0.002).toFloat(), 0.0f, Vector3f(0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        staticShader.cleanup()
    }
}
