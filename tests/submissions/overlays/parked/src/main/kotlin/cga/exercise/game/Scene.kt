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
import cga.framework.ModelLoader.loadModel
import cga.framework.OBJLoader.loadOBJ
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.abs
import kotlin.math.sin

/**
 * Created by Fabian on 16.09.2017.
 */
class Scene(private val window: GameWindow) {
    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    // objects
    private val ground: Renderable
    private val bike: Renderable
    private val parkedBike: Renderable // sheet 3, scene graph exercise

    // cameras, switch with C
    private val bikeCamera = TronCamera()
    private val topCamera = TronCamera()
    private var useTopCamera = false

    // lights
    private val bikeLight: PointLight
    private val spotLight: SpotLight
    private val pointLights = ArrayList<PointLight>()

    private var firstMouse = true
    private var oldMouseX = 0.0

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)
        GLError.checkThrow("state")

        // ground
        val groundDiff = Texture2D("assets/textures/ground_diff.png", true)
        val groundEmit = Texture2D("assets/textures/ground_emit.png", true)
        val groundSpec = Texture2D("assets/textures/ground_spec.png", true)
        groundDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        groundEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        groundSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMaterial = Material(groundDiff, groundEmit, groundSpec, 60.0f, Vector2f(64.0f))

        val groundObj = loadOBJ("assets/models/ground.obj")
        val vertexAttributes = arrayOf(
            VertexAttribute(3, 32, 0),
            VertexAttribute(2, 32, 12),
            VertexAttribute(3, 32, 20)
        )
        ground = Renderable()
        ground.meshes.add(Mesh(groundObj.vertexData, groundObj.indexData, vertexAttributes, groundMaterial))

        // bikes
        bike = loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        bike.scaleLocal(Vector3f(0.8f))

        parkedBike = loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        parkedBike.translateGlobal(Vector3f(-5.0f, 0.0f, -7.0f))
        parkedBike.rotateLocal(0.0f, Math.toRadians(70.0f), 0.0f)
        parkedBike.scaleLocal(Vector3f(0.8f))

        // cameras
        bikeCamera.parent = bike
        bikeCamera.rotateLocal(Math.toRadians(-35.0f), 0.0f, 0.0f)
        bikeCamera.translateLocal(Vector3f(0.0f, 0.0f, 4.0f))
        topCamera.translateGlobal(Vector3f(0.0f, 18.0f, 0.0f))
        topCamera.rotateLocal(Math.toRadians(-90.0f), 0.0f, 0.0f)

        // light of the bike, must stay the first in the list
        bikeLight = PointLight(Vector3f(0.0f, 1.6f, 0.0f), Vector3f(1.0f, 0.0f, 1.0f))
        bikeLight.parent = bike
        pointLights.add(bikeLight)

        // lights in the corners
        pointLights.add(PointLight(Vector3f(-14.0f, 2.5f, -14.0f), Vector3f(9.0f, 0.0f, 0.0f)))
        pointLights.add(PointLight(Vector3f(14.0f, 2.5f, -14.0f), Vector3f(0.0f, 9.0f, 9.0f)))
        pointLights.add(PointLight(Vector3f(14.0f, 2.5f, 14.0f), Vector3f(9.0f, 9.0f, 0.0f)))
        pointLights.add(PointLight(Vector3f(-14.0f, 2.5f, 14.0f), Vector3f(0.0f, 0.0f, 9.0f)))

        // front light
        spotLight = SpotLight(Vector3f(0.0f, 1.1f, -1.7f), Vector3f(3.5f, 3.5f, 3.2f), Math.toRadians(16.5f), Math.toRadians(27.5f))
        spotLight.rotateLocal(Math.toRadians(-10.0f), 0.0f, 0.0f)
        spotLight.parent = bike

        println("lights: ${pointLights.size} point lights, 1 spot light")
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()

        val camera = if (useTopCamera) topCamera else bikeCamera
        camera.bind(staticShader)

        val bikeColor = Vector3f(abs(sin(t)), abs(sin(t / 2)), abs(sin(t / 3 + 1)))
        bikeLight.lightColor = bikeColor

        for ((i, light) in pointLights.withIndex()) {
            light.bind(staticShader, "pointLights[$i]")
        }
        spotLight.bind(staticShader, "spotLight", camera.getCalculateViewMatrix())

        staticShader.setUniform("emissionColor", Vector3f(0.0f, 1.0f, 0.0f))
        ground.render(staticShader)
        staticShader.setUniform("emissionColor", bikeColor)
        bike.render(staticShader)
        staticShader.setUniform("emissionColor", Vector3f(1.0f, 0.5f, 0.0f))
        parkedBike.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        var speed = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) speed = -5.0f
        if (window.getKeyState(GLFW_KEY_S)) speed = 5.0f
        if (window.getKeyState(GLFW_KEY_SPACE)) speed *= 3.0f // boost

        var turn = 0.0f
        if (window.getKeyState(GLFW_KEY_A)) turn += 1.0f
        if (window.getKeyState(GLFW_KEY_D)) turn -= 1.0f

        if (speed != 0.0f) {
            bike.rotateLocal(0.0f, turn * 1.2f * dt, 0.0f)
            bike.translateLocal(Vector3f(0.0f, 0.0f, speed * dt))
        }
        // parkedBike.rotateLocal(0.0f, dt, 0.0f)
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (key == GLFW_KEY_C && action == GLFW_PRESS) useTopCamera = !useTopCamera
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            oldMouseX = xpos
            firstMouse = false
        }
        val deltaX = (oldMouseX - xpos).toFloat()
        bikeCamera.rotateAroundPoint(0.0f, deltaX * 0.002f, 0.0f, Vector3f(0.0f))
        oldMouseX = xpos
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        parkedBike.cleanup()
        staticShader.cleanup()
    }
}
