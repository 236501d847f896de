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
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram
    private val ground: Renderable
    private val motorcycle: Renderable
    private val camera: TronCamera

    private val pointLight: PointLight
    private val headLight: SpotLight
    private val corners = Array(4) { PointLight(Vector3f(1.0f), Vector3f(0.0f, 1.8f, 0.0f)) }

    private var lastX = 0.0
    private var lastY = 0.0
    private var mouseMoved = false

    init {
        staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // textures of the ground
        val groundDiff = Texture2D("assets/textures/ground_diff.png", true)
        val groundEmit = Texture2D("assets/textures/ground_emit.png", true)
        val groundSpec = Texture2D("assets/textures/ground_spec.png", true)
        groundDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        groundEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        groundSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMaterial = Material(groundDiff, groundEmit, groundSpec, 60.0f, Vector2f(64.0f, 64.0f))

        // mesh of the ground
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val stride = 8 * 4
        val posAttr = VertexAttribute(3, stride, 0)
        val texAttr = VertexAttribute(2, stride, 3 * 4)
        val normAttr = VertexAttribute(3, stride, 5 * 4)
        ground = Renderable()
        ground.meshes.add(Mesh(obj.vertexData, obj.indexData, arrayOf(posAttr, texAttr, normAttr), groundMaterial))

        motorcycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        motorcycle.scale(Vector3f(0.8f))

        camera = TronCamera()
        camera.parent = motorcycle
        camera.rotate(Math.toRadians(-30.0f), 0.0f, 0.0f)
        camera.translate(Vector3f(0.0f, 0.5f, 4.5f))

        pointLight = PointLight(Vector3f(1.0f), Vector3f(0.0f, 2.0f, 0.5f))
        pointLight.parent = motorcycle

        headLight = SpotLight(Vector3f(14.0f, 14.0f, 12.0f), Vector3f(0.0f, 1.0f, -1.8f), Math.toRadians(16.0f), Math.toRadians(28.0f))
        headLight.rotate(Math.toRadians(-11.0f), 0.0f, 0.0f)
        headLight.parent = motorcycle

        corners[0].preTranslate(Vector3f(-16.0f, 0.0f, -16.0f))
        corners[0].color = Vector3f(18.0f, 1.0f, 1.0f)
        corners[1].preTranslate(Vector3f(16.0f, 0.0f, -16.0f))
        corners[1].color = Vector3f(1.0f, 18.0f, 18.0f)
        corners[2].preTranslate(Vector3f(16.0f, 0.0f, 16.0f))
        corners[2].color = Vector3f(1.0f, 1.0f, 18.0f)
        corners[3].preTranslate(Vector3f(-16.0f, 0.0f, 16.0f))
        corners[3].color = Vector3f(18.0f, 16.0f, 1.0f)
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val r = (sin(t * 0.9f) + 1.0f) * 0.5f
        val g = (sin(t * 1.4f + 1.0f) + 1.0f) * 0.5f
        val b = (sin(t * 0.6f + 2.5f) + 1.0f) * 0.5f
        val bikeColor = Vector3f(r, g, b)
        pointLight.color = bikeColor

        staticShader.use()
        camera.bind(staticShader)
        pointLight.bind(staticShader)
        headLight.bind(staticShader, camera.getCalculateViewMatrix())
        for (i in 0..3) {
            corners[i].bind(staticShader, i)
        }

        ground.render(staticShader, Vector3f(0.0f, 1.0f, 0.0f))
        motorcycle.render(staticShader, bikeColor)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) {
            motorcycle.translate(Vector3f(0.0f, 0.0f, -5.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotate(0.0f, 1.4f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotate(0.0f, -1.4f * dt, 0.0f)
        } else if (window.getKeyState(GLFW_KEY_S)) {
            motorcycle.translate(Vector3f(0.0f, 0.0f, 3.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotate(0.0f, -1.4f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotate(0.0f, 1.4f * dt, 0.0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val dx = xpos - lastX
        lastX = xpos
        lastY = ypos
        if (!mouseMoved) {
            mouseMoved = true
            return
        }
        camera.rotateAroundPoint(0.0f, (-0.002 * dx).toFloat(), 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        staticShader.cleanup()
    }
}
