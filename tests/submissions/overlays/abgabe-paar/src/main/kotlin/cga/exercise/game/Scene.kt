package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.LightRig
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val tronShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val groundColor = Vector3f(0.0f, 1.0f, 0.0f)

    private val ground: Renderable
    private val bike: Renderable
    private val camera = TronCamera()
    private val rig = LightRig()
    private val bikeLight: PointLight

    private var yaw = 0.0f
    private var pitch = toRadians(-30.0f)
    private var lastX = 0.0
    private var lastY = 0.0
    private var gotMouse = false

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        ground = createGround()
        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        bike.scaleLocal(Vector3f(0.8f))

        camera.parent = bike
        placeCamera()

        bikeLight = PointLight(Vector3f(0.0f, 2.0f, 0.0f), Vector3f(1.0f))
        bikeLight.parent = bike
        rig.add(bikeLight)

        val headlight = SpotLight(Vector3f(0.0f, 0.8f, -2.0f), Vector3f(3.5f, 3.4f, 3.0f), toRadians(13.0f), toRadians(28.0f))
        headlight.rotateLocal(toRadians(-9.0f), 0.0f, 0.0f)
        headlight.parent = bike
        rig.add(headlight)

        val d = 13.0f
        rig.add(PointLight(Vector3f(d, 1.2f, d), Vector3f(7.0f, 0.4f, 0.4f)))
        rig.add(PointLight(Vector3f(-d, 1.2f, d), Vector3f(0.4f, 0.4f, 7.0f)))
        rig.add(PointLight(Vector3f(d, 1.2f, -d), Vector3f(0.3f, 6.0f, 5.0f)))
        rig.add(PointLight(Vector3f(-d, 1.2f, -d), Vector3f(6.0f, 4.0f, 0.2f)))
    }

    private fun createGround(): Renderable {
        val material = Material(
            loadTexture("assets/textures/ground_diff.png"),
            loadTexture("assets/textures/ground_emit.png"),
            loadTexture("assets/textures/ground_spec.png"),
            60.0f,
            Vector2f(64.0f)
        )
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        return Renderable(arrayListOf(Mesh(obj.vertexData, obj.indexData, attributes, material)))
    }

    private fun loadTexture(path: String): Texture2D {
        val texture = Texture2D(path, true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    private fun placeCamera() {
        camera.reset()
        camera.rotateLocal(0.0f, yaw, 0.0f)
        camera.rotateLocal(pitch, 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, 4.5f))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        tronShader.use()

        val bikeColor = Vector3f(wave(t), wave(1.4f * t + 2.0f), wave(0.8f * t + 4.0f))
        bikeLight.color = bikeColor

        camera.bind(tronShader)
        rig.bind(tronShader, camera.getCalculateViewMatrix())

        tronShader.setUniform("emissionColor", groundColor)
        ground.render(tronShader)
        tronShader.setUniform("emissionColor", bikeColor)
        bike.render(tronShader)
    }

    private fun wave(x: Float) = 0.5f + 0.5f * sin(x)

    fun update(dt: Float, t: Float) {
        var speed = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) speed += 7.0f
        if (window.getKeyState(GLFW_KEY_S)) speed -= 4.0f
        if (speed != 0.0f) {
            var steer = 0.0f
            if (window.getKeyState(GLFW_KEY_A)) steer += 1.2f
            if (window.getKeyState(GLFW_KEY_D)) steer -= 1.2f
            bike.rotateLocal(0.0f, steer * dt, 0.0f)
            bike.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        // reset of the view, was handy for testing
        if (key == GLFW_KEY_R && action == GLFW_PRESS) {
            yaw = 0.0f
            placeCamera()
        }
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (gotMouse) {
            yaw -= ((xpos - lastX) * 0.002).toFloat()
            pitch -= ((ypos - lastY) * 0.002).toFloat()
            pitch = pitch.coerceIn(toRadians(-75.0f), toRadians(-10.0f))
            placeCamera()
        }
        gotMouse = true
        lastX = xpos
        lastY = ypos
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        tronShader.cleanup()
    }
}
