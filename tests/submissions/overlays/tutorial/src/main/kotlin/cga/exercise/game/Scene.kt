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
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW
import org.lwjgl.opengl.GL11
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val ground = Renderable()
    private val bike: Renderable
    private val camera = TronCamera()
    private val pointLights = ArrayList<PointLight>()
    private val spotLight: SpotLight

    private var firstMouse = true
    private var lastX = 0.0
    private val sensitivity = 0.002

    init {
        GL11.glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        GL11.glEnable(GL11.GL_DEPTH_TEST)
        GL11.glEnable(GL11.GL_CULL_FACE)
        GL11.glCullFace(GL11.GL_BACK)

        // load ground
        val diff = Texture2D("assets/textures/ground_diff.png", true)
        val emit = Texture2D("assets/textures/ground_emit.png", true)
        val spec = Texture2D("assets/textures/ground_spec.png", true)
        for (tex in arrayOf(diff, emit, spec))
            tex.setTexParams(GL11.GL_REPEAT, GL11.GL_REPEAT, GL11.GL_LINEAR_MIPMAP_LINEAR, GL11.GL_LINEAR)
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val layout = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        val material = Material(diff, emit, spec, 60.0f, Vector2f(64.0f, 64.0f))
        ground.meshes.add(Mesh(obj.vertexData, obj.indexData, layout, material))

        // load bike
        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f) ?: throw Exception("no bike")
        bike.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))

        // camera
        camera.parent = bike
        camera.rotateLocal(Math.toRadians(-30.0f), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, 4.5f))

        // point lights, the first one belongs to the bike
        pointLights.add(PointLight(Vector3f(0.0f, 2.0f, 0.0f), Vector3f(1.0f, 1.0f, 1.0f)))
        pointLights.add(PointLight(Vector3f(12.0f, 2.0f, 12.0f), Vector3f(6.0f, 0.0f, 0.0f)))
        pointLights.add(PointLight(Vector3f(-12.0f, 2.0f, 12.0f), Vector3f(0.0f, 6.0f, 6.0f)))
        pointLights.add(PointLight(Vector3f(12.0f, 2.0f, -12.0f), Vector3f(6.0f, 6.0f, 0.0f)))
        pointLights.add(PointLight(Vector3f(-12.0f, 2.0f, -12.0f), Vector3f(0.0f, 0.0f, 6.0f)))
        pointLights[0].parent = bike

        // spot light
        spotLight = SpotLight(Vector3f(0.0f, 1.0f, -1.5f), Vector3f(4.0f, 4.0f, 4.0f), Math.toRadians(15.0f), Math.toRadians(28.0f))
        spotLight.rotateLocal(Math.toRadians(-12.0f), 0.0f, 0.0f)
        spotLight.parent = bike
    }

    fun render(dt: Float, t: Float) {
        GL11.glClear(GL11.GL_COLOR_BUFFER_BIT or GL11.GL_DEPTH_BUFFER_BIT)

        val bikeColor = Vector3f(0.5f * sin(t) + 0.5f, 0.5f * sin(t + 2.1f) + 0.5f, 0.5f * sin(t + 4.2f) + 0.5f)
        pointLights[0].color = bikeColor

        shader.use()
        camera.bind(shader)
        for (i in pointLights.indices) {
            pointLights[i].bind(shader, "pointLights[$i]")
        }
        spotLight.bind(shader, "spotLight", camera.getCalculateViewMatrix())

        shader.setUniform("emissionColor", Vector3f(0.0f, 1.0f, 0.0f))
        ground.render(shader)
        shader.setUniform("emissionColor", bikeColor)
        bike.render(shader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW.GLFW_KEY_W)) {
            if (window.getKeyState(GLFW.GLFW_KEY_A)) bike.rotateLocal(0.0f, 2.0f * dt, 0.0f)
            if (window.getKeyState(GLFW.GLFW_KEY_D)) bike.rotateLocal(0.0f, -2.0f * dt, 0.0f)
            bike.translateLocal(Vector3f(0.0f, 0.0f, -6.0f * dt))
        }
        if (window.getKeyState(GLFW.GLFW_KEY_S)) {
            bike.translateLocal(Vector3f(0.0f, 0.0f, 4.0f * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            lastX = xpos
            firstMouse = false
        }
        val xoffset = (xpos - lastX) * sensitivity
        lastX = xpos
        camera.rotateAroundPoint(0.0f, -xoffset.toFloat(), 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        shader.cleanup()
    }
}
