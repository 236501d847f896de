package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.Transformable
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
import kotlin.math.sin


/**
 * Created by Fabian on 16.09.2017.
 */
class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private var ground: Renderable
    private var motorcycle: Renderable
    private val camera = TronCamera()

    // Achse, um die sich die Kamera mit der Maus dreht (haengt am Motorrad)
    private val orbit = Transformable()

    private var bikeLight: PointLight
    private var frontSpot: SpotLight
    private var light1: PointLight
    private var light2: PointLight
    private var light3: PointLight

    private val groundColor = Vector3f(0.0f, 1.0f, 0.0f)

    private var mouseX = 0.0
    private var mouseMoved = false

    //scene setup
    init {
        //initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // Boden
        val texDiff = Texture2D("assets/textures/ground_diff.png", true)
        val texEmit = Texture2D("assets/textures/ground_emit.png", true)
        val texSpec = Texture2D("assets/textures/ground_spec.png", true)
        texDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        texSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMaterial = Material(texDiff, texEmit, texSpec, 60.0f, Vector2f(64.0f, 64.0f))

        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val stride = 8 * 4
        val attrPos = VertexAttribute(3, stride, 0)
        val attrTC = VertexAttribute(2, stride, 3 * 4)
        val attrNorm = VertexAttribute(3, stride, 5 * 4)
        val groundMesh = Mesh(res.vertexData, res.indexData, arrayOf(attrPos, attrTC, attrNorm), groundMaterial)
        ground = Renderable()
        ground.meshes.add(groundMesh)

        // Motorrad
        motorcycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw Exception("Motorrad konnte nicht geladen werden")
        motorcycle.scale(Vector3f(0.8f, 0.8f, 0.8f))

        // Kamera
        orbit.parent = motorcycle
        camera.parent = orbit
        camera.preTranslate(Vector3f(0.0f, 2.0f, 4.0f))
        camera.rotate(toRadians(-20.0f), 0.0f, 0.0f)

        // Lichter
        bikeLight = PointLight(Vector3f(0.0f, 1.6f, 0.5f), Vector3f(1.0f, 1.0f, 1.0f), "bikeLight")
        bikeLight.parent = motorcycle

        frontSpot = SpotLight(Vector3f(0.0f, 0.8f, -1.9f), Vector3f(10.0f, 10.0f, 10.0f), toRadians(14.0f), toRadians(28.0f), "frontSpot")
        frontSpot.rotate(toRadians(-12.0f), 0.0f, 0.0f)
        frontSpot.parent = motorcycle

        light1 = PointLight(Vector3f(12.0f, 1.5f, -14.0f), Vector3f(15.0f, 0.0f, 2.0f), "light1")
        light2 = PointLight(Vector3f(-12.0f, 1.5f, -14.0f), Vector3f(0.0f, 4.0f, 15.0f), "light2")
        light3 = PointLight(Vector3f(0.0f, 1.5f, 16.0f), Vector3f(14.0f, 11.0f, 0.0f), "light3")
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val bikeColor = Vector3f(0.5f + 0.5f * sin(t), 0.5f + 0.5f * sin(t + 2.1f), 0.5f + 0.5f * sin(t + 4.2f))
        bikeLight.lightColor = bikeColor

        staticShader.use()
        camera.bind(staticShader)

        bikeLight.bind(staticShader)
        frontSpot.bind(staticShader, camera.getCalculateViewMatrix())
        light1.bind(staticShader)
        light2.bind(staticShader)
        light3.bind(staticShader)

        staticShader.setUniform("emitColor", groundColor)
        ground.render(staticShader)
        staticShader.setUniform("emitColor", bikeColor)
        motorcycle.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) {
            motorcycle.translate(Vector3f(0.0f, 0.0f, -5.0f * dt))
            steer(dt)
        } else if (window.getKeyState(GLFW_KEY_S)) {
            motorcycle.translate(Vector3f(0.0f, 0.0f, 5.0f * dt))
            steer(-dt)
        }
    }

    private fun steer(dt: Float) {
        if (window.getKeyState(GLFW_KEY_A)) {
            motorcycle.rotate(0.0f, 1.5f * dt, 0.0f)
        }
        if (window.getKeyState(GLFW_KEY_D)) {
            motorcycle.rotate(0.0f, -1.5f * dt, 0.0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val deltaX = if (mouseMoved) mouseX - xpos else 0.0
        mouseX = xpos
        mouseMoved = true
        orbit.rotate(0.0f, deltaX.toFloat() * 0.002f, 0.0f)
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        staticShader.cleanup()
    }
}
